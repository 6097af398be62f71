// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 6406bcacf1d4c3e7fce9fb0446ac0f8403b895e99f9720b7b5c13fffed06df63
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
const wasmText = "eNq0dwV4G0f699BqVxpJq4vVi3O+y622vl6Z4lLIlqtQKW5Kx44vcRo7bDssW26c+nx8l/QgOZLlMjM8X1OHoczMzMyt4+83s+uVXHj4P2vtvvMyzq5JQ+sCSgih11hddCYhM0UOi8wM4a4Bw39S/aO5mQQ/lsvR7EyuCLh3KDTPAqcoQLGsJmezWZ/LI+BOgcFN7RURWI1Q7LRDa+noAGzl/OX7o+WzBLY7gIAlTz0e2tGs54fiCGODbWkMYDI9JuAAAcxqfi2vxKDe0FgAep9V7mnbWRA9RZpqaWktL3wBovUHpoTPaZQiNHtgCIIkEIEjAb2deGTle6kZyGl+IDQGgBLTeO7jPGOGnww/K35gYPeePsWX9Bxl2i1txs88MlhMVc43Usy1YvNpOd8Nn5QNch3w+7kOvMPS1opSAHVj6LbRNK3XUJaCJ/AAsDRDEJBWEvaUZIO0BYH4ubQ00K60RnLBAt4XAxj2QcVuBtiQh/Nr7cUKuq+NZgMxtfHVDUWqNfhPv3GwhjPq1gpsAfJlO7A0LdACyJfEgOi+K/acVh6kX6fPT2PWMxB0AhTrXsEDewxch2dDRxU0tqEBv2jtM5m+hwJjtF0h24FkU/l3lze0NtW3LmxY3Dp3UVv94pbGZU2Ny4+Iz5q/aNa8+ramBY31Zze2kXBo/qIFCxrnm+BqaWtcSCI+QsxpaJpPJM/HNsYIicbitp34TmJEQi1D2HY8HCKGLaQtrURZMjlin++CQIgw4vbIeLxc2HKUYQiseDmlnDOGnf8HpI01AmosWm55N1t+LwoDiYrvj0gQsBCDqIVHsGQ5MSzhL1i2rB9IKiXg0T+MOykXOGtfs/JH+4kf7y9GHyDsAw86SCprBzvyEHmolGXGYYccbsFfvt9+ZWUjzLIjRpXZUtpHCjbm8BG2qBJjyo+ysICkiI3CqLCJEZJCGnFDSAFIiHKD2OonEY1CSv8eH/bw71/ZfJPAt9yxjrZHCtg5RhyL9FceN3Kktj16LEjjqBBji77YgAQywoQkZLxF4adUeHoEkiItKiiisYECwbDLJlAEbhwm8Ut4SohdRSlCB8oaK8snuuWGUS2qRc3YtKyGviPKarllHW8bGcOwLEplnJbDfzgal2oJuxxq8CeJrRa07s8tOsmyyrh5pGXSyVOSSWpxzo2p005IZuiEE086eeyoUzidXjdKnmrPoPEf2FbZaaPjldZ0tAPRCaDlXhMlzaRNIU/lkNXxlaJcnq4jImdoHlsmxysgbomJ0lZeUOSIc4gcqkWitll2JqfctCpPlCeOHl1WNto6QzLGwHGWF0r8J6a0quhP7biIH2/b3PnZz61fxG1Lr6m/nPpz9WdYU39Vn6TKlkTCbFpuA0b6qayqlHKEKojqTzFzelU83mD9enqZKSup5KhNsXlsi8OXn/2CmZb2oE57wE8Us+zZ8bgl8SesRtuSQDLLKo/TOKU0rhVYhmDJ5Jxf1E+36Nk/C6FhR5eNqJwwgetoy7Umw0qqanrOoTxionFY0iCWUYoVxmFf3U5AF/C5Sf6L+ib6M8fLTrMfq7CSfJ6cb9XYVNgnS6lCAV77xCzORlJGx8BxeWrlpLIFQiwsGzt21Ci5/xhT7j8uaVomsphMSpmJZ8wMlbZ5BubLjJvD2qkODaX7VzWwJepoXAUtiW5zBMLj5X5C1KUqMFQAgJnZEv6QcmnYtAhgjR490h050sKqtqTOobUoufjwqRKWkhkYg2ltYX9RlUwml0xsscZaCPTQE2mrtI+1ThWyDgagEx5IaAXA26CeUKRBtRkSoRTAm6WG8LVBr8ZJFRuQ4AKnz7ZM4WwcnmjVsrIyaSqXS1pcKRccS+GhfowUY8Z4wstp+XIvW6annxZjFbiIhfgm0hUrrVWeI1QlavHUZKZqyUQLiypDx1jo+CBXnuYaUbV6v+wxJoL6aVVNe5WgoGMDDv/AGnbXyokySeN1ko9Rjgpqj+QoDcx0ICWW3ZGzdANJaNIPVFFZK0devCJDxPdDO9FJx4hyMYSyhp42MeJ10dMTep1D11DcEu3CpIvpLlyGoGQNCx1t5mi6s7PTkjmS7nz8HP0kevOQtznPf27e6jFtfxh7889sn9CCxgWLWlYyIuubFja1NTXMb1rViFluWbRoAdlAw62NbfXzm86e20b+7W2WNSxsbCXnU764dQ65gMpZS9vqWxtnLVo4u5VcSaVimdXUMms+mK6nUQ+sb2xpWdRCttH4ooX1EAg4ttPYwsaGlnqIt7U0tLaRu2hY0VsaG2bNJffTiOL3eR+k4ZaG2U1LW+sXzSGP0bgvo170TbMayePUCrS8RMWv5y9tIW/RiPanYUFjSwO5OGrMblzcNpdcHtXoOU3z2xpbyI3RkA/dEg1/xihJU7mTjps4fkLNlEm11ZMzx089AQf3KdPrTp1x2ulLL6WX0d+Je4z7jEfEs+LJ0O7Q/8wPzS/M56wXrCetm+Ut8kH5kPwzXU//Rv9Bz2Xd7Dfst+x37A/0r+zf7L/sf6yPnc8uYJewy9jl7Gp2LbuO3cRuZrewTayfbWbb2Q62k93O7mR3sbvZPexe9iB7iD3MHmdPsqfYc+x59gJ7hb3KXmNvsbfZO+wD9iH7iP1b/Ef8V/wiLz4VncY5xhpjrbHOWG+cZ/zdON+4wLjQuNi4wrjSuMq42rjN2GHsNHYZe4xXjFeN14w3jAtCF4YuCl0Sei30euiN0Fuh68zrzRvMm8yt5jZzu7nTfNR8zHzcfNJ8xXzVfM18wzzX6rZ+Y/VYb1hvWm9Z71gXhi8KXxy+NHx95IbIjZGbI7siuyN7IndEnog8GXkq8nTko8jHkU8in0U2yI3yX/I/8vfRP0b/FP1rdH30vOg/ohuiG6PnRy+MRvo/cDfGqkmiNbE8sTKxKrE6kU20JzoSnbrp0fpdNLGWJs6liW6a+A1N9NDEb2niS5oYoIm9NNEXTfw+JvclrCZN9mebHz6nh0yKESLTKOjR3j7RhSEh8koKJlbjYGasqTHikAzR69lcIUU0ftCeDjxNn7OiOUWjTA5nAWFgpL5Nq0ivWaxYqNTcJ5Rom8mHtN28+GStbY/ps5ayKMK7c/XtxIr0OhssYFA+mM1X1FZ19xfkI5ZJO1iOdnD94x3QSja5vLaq5yJXwNklrlEaxvEFn+iR0unmdGfCMSpShlT+bHJDWtLUZEu5VioZCiTDvmS4ImUpSbbJjWhJ6ZEhyUolI98kGZY610Z6r62yY4E+NeaFWHBY3pZOOH3n8uZUFExhTYTWIaoTTd9hTq4Ak4C6JamYY+qn6Uj9FE6klnbX7h3Uy+6q7fRWYm0q4oRAQjROTy1oRNPoWjfucIXnSggSrt0BRh8OgfYVdt6RdRNAOnEHoAMQsk7IsYEH++lXZFNxHWDUMRyrOf3PRc2uMc+10hSBAG2lq09ERBHHuqI7xZ1IejNyMO+KnlQkylTof0DohuaraVYZrSUpDorGDJKTgaCpEJBxn6AeTjzdSZUW1+6GK+Er3ETPWuVTdy2ZccXaVAjOJnpScbSa59gUeBBNGU4kxSEf0XjoT09X6gMcnPN948pfeNoMn21Fdbhje7o5RL3LMZ1Yqxt2BLSDP54FUyhIClcKAbenbM0cdyLtjqa1I/e5syBjp+B7SihG1HVyStQC145ocwCUuQolzqXD69Aw0M5XupGL0rlmFxHHEXntFgKtOvS4Hzp3DOV3yoBWbTdUB0uhlS4HPUYhQ3vUrQus6VwqHGWlnQj/fP2oFVIN+zArKm5JMdXCTngepmnbcvSx2gKaoqChEdgWzAJEXHRxA0zzWjRWXYwpZTCrbj1r0Vve2kzQYb4Nl6mGJ70u8/W8axaghcA3h/XqaTAS50KIwFPwgGFw8IdVhRv/X5HfhtO4Oi1l1+yqq8Czc0VX0UiKQXZIjzyO0lwaDaVme5IKheNg2Z8hIZORK5IWzSmEoTICMosSiWTpgshPGGU5leB0TvMp5x0yDWGnqUPbXKqyemKFSyF8tktiBGaIrknaccg8sA0O8iXpdgimY9NUGwJP012dojmdWKaEwHNFLZi6ui9KUTjoS7A2l+3Prn4Ep7lL4DPc05tmSCfaHNKczjYjgqMRBPKUhhc1YNSkdE6dJLXUKSrWkSudiPrLh5VOCp1g1Ztm5IyWKKS2BGm3JmmfIKV3fjhelDorZMhHlVd4waB/kB+tkdjpXKSVaywNC2xaDPmDkykiHZU63uwH8JUdkW1UoGS6H3WZiAIOIcSFq+qhpjFNUwYqydODdAnq5hjqRh2jGeclwUNPCcWQONyTFFoSyqTihWc5VBHoaRW6X+QrIYPmaJZ20BzP7tuJhYzOc2mlBvWcwT+0u9+Jn+ZSDAEO9WV/Cr0xtBkEGySKl/8uc9SrA8tc4or0Z/f+cY1Q56ZIb33y0b385BgFeO2OrYN8OmLRBwjXOp/dW3voy/35FMssG7/yqHeOe31CCrHhVFHvOshgxgZN9folcMmUECWnxUIQfee4zyHaXTMbAQ/5ptwOSU/qRY6ieAQsKCVQKiQk9645qHHKPp9UF4bmvdohF+a/ZK64yS26UUB6UenAxQJ81KfNEKa6xOlN0J+DfqqdRh6qh1zmugVuPJZF0eBRXUFPD8Nl9LqkF/eUIVUBAn8KbqiAiQyuzCHbwgtvGvjdbYXMcTNe7r79nnsn5guZm5649L+j7k72Azz3jL2j8vRn1QA/THwHq1dh/axU513Thy0cqI5Z6HVDvT6mXJU+VOjtK6RCynfltsbgzOrVXaB28LGAn8OACsou0INxThhVWQGp6P4QpOqKDASR3ds/K0Y1rzoY84GDfmpF8M2UMrT+Y9FCwDlinocNaWwZsIGoE+rVCnG4FnxjyFgo3xtw+JThTgJd6gI+Cx0CPtU61uSKoPHzXgZYSW0CzWQz1Ep1bDV7c4RBi0JnYt0fsfmSydeFSXNq5lhWT9/qb5y84gyxWoXM35N/q/qnKAO23vq0P6defSRo5r4UQSeDYdBbnwySM2Pca75SqdO9YvYOE+QeF8bV5WnapmZ2j6lGlXuztiTGh3csh0hxjoRv4d5Hr3qtP/ezGCmSDN0sJQk2EJM+F56/7UfNsJZcpj/IQyXaAo+fXX9x3zYCfaoOpcXDtliOXj/oZ9Zf3LWZnFnhGH0pZIKriVuS/u+WjYMcDeR0+2x219r+klqikW9So2YEI6yqLrAPhl7ZC0Kqyfe5xvDBLLimY6BRXOGIgmsMJF3LEQMudSxo+d/OFfeGN26rLgwkFVMmM2PiMyPe24p5eJrf8ffZk3dhPsE7EL1qxZ9+sGPJndU/Xe+eVznt/uqBd+nA+8CLz/+xYcOGx6rXn6HWSz7etQbgOm40n4eDZm8eoQxrPCKf4oyjy0oOQtVTG1weYNTHDN3gigAx/LhXYf5asThUPYTD1W+2a+AVomGjwi3WWimDCMoBSNUwc+e43Jz/5l+ux3FMgu3O7xdcqrqpZA87hUS3cvt/0BxcBZdv1GjQN8IZrjxBmns9ZF5tHeGz9CqJfF9voLbPVl0d+OfMGu5F31e86Pu/8aJgS62mVDl1guvrysFcqhzbEuWQgHLvBX4/ZaykvNUpqg+N4QUhG7yqbyp9F/P0lif/OciDAX8fr0XqsMTvlBGdBod85UzsK+4REMcb/J9rhZbK/P6p7+0zx/n75nxigzrkfMbNuUIRSlG0pkqEx+IWtTukL1+cJPlHxmkHw+HonX601GvmnUXTvAMMbvinpMYToNPr3xt4kKV46ZFTd3zhq2rwbaA47wAn+CDOFzr+CUFx7Pgrh2NCD7Qj4CPGWo94ARP8yFsvPkiuVhP82Kmv3HZH5lW8VvVob3142gkz3/sMBKfy3XXP7r8XhMy6lxvsl/ne6nweujZp/dku/bCy/a7SqRrP6FUa8irRwABSw0zkbiHU24J9+xcaTtPS4HQ580LnKFN+SOb0L1KfVQ8B/TgBc2dU6Kmu8L/coYND+J29qhv0BrpVP5Ao88/QE2Psq4c/SGgs7YIvc+egktHgnzrF9JJX06f9+SJcXfIBghdPmqVElEst9k+lgRYbLxALmCmYmQzoDlFIDiSVuiO+QZLUaEmSEppFlxEfUo5/ZQ6b33xw5vpCfyGzceDpGYc8fYUq2YKNbVe9f/V1Clzy3X337lxyqwK3v/FPnMN7AKbUcV/U8Z3H3RfGXvEXhPZGbFnliasvqQb3qRPuzc+JXaPAhc5JO+6adJMCB7vIusppWxUY08f5QwBToWIRTtafx7zN1XXoIc0HcdXtJj5eCuDJD+F6cc7q76WNuqZeNZ2Atfdr74K3hPC+9Onqbx0tVcGheerMNjv0opbSPgpqt/hYDJ8PE+9rQp+1vmynUlQ64RtKvgLhc3Blwp8MxJ6bwKC451q69Nl3pqnEjPvz3Bv2X3O+SvkZmZ74GVv2KGz7ojf4iIcf1Fi9dgAbKFqz7tBrdtx8HRT9lP6xYn7oZcW3+3c//fdLB5IagCce8rvv/3gs35wf1n7cwVkstNfXvnzrIJJfjNURuHjB/yA0f5Ecs9+Ff701j5yrU5riH44KW/rcr4Hbm+zFXf+fmq8Aj2Q50qyEoq5uqQY+39zJ58uqIzP7MZVh/OlumZnMLcNj1M7M84yZmW2N3u4ax8y4zMzMjGbW540/IjO7St2tpzH7zWt1VWZkZMQfkVB/lsRDeut0aHERCSPlTjtLxbewNlzbLVJ+eisq2OrplVgCycumcTQGV3mTsXNYUhiKFoGIvYaNoMj2IsAaAArbi4BxQCuUB8ADdFHeox9wpPI2o73ItqOf6pbtLX6ifXqWIt2wwVWbZ5dwMbE8OCWxm0jxJSk3SDqWnKgYxf4M0s/BV7TGGWghJC1QxPUyJJMvI5KWkbSM5CzrkHa84kXHGkNe33zixN9gzuwnG1IEzkXH6HqZY+Yr5Bgmr+gJvJpNFcOZguKUxoEFr6hp6gzWyK/24NH4lrlDqLULiJRjvquedrZ+InnkWSkmrtLH39eeOtcUPGWD4Orufo7+WZBQXVL9pNLYAaC10FiKPtdP72BIwyuJONuQA4n7pk98pdOg3uyUVw+N7Z1wcLoz4N50oMhAfzkduLfug+iJWnpGTDt8rVa+sRkSeFEJMVuiZ47Di0r4rqreHDzAP/LXqTPHZNuCDTkeOfuogKpKGtsDgQ9inBniBNbEABDLrJ3paFZJ/L3BAU1yQULwghIjwMh2EJZVRYLFujzLEA9qAFxyLgsWUxCcD2QhW307U6HA+uHd/yDNnXX0IfIzIT+dmrrE28s2GEaeouIUrCQfyUzybXcsX6GUOS5M4keZSTQToiVx1ZjOX50jVVWgHD/JgrZzR9GRJ8G7U7pT9fPYgnRC7q160Fzq22OgUCComDmZc1gPSi2Fakr6TimyFqGylDGIFgw8hBkEjwIYdEKAVlXyP2+mOzIFry79z8dyzZMfj51Il9RPprokqdYpwX1uEkUsjyJAt34OxAl7Vb9IrsBbJgdYP/8QBnq1ql98gjU9YKhJAzBM8lFTIpqgE9QsN57TOALp8lzcyeXL+PJRA93MpimKrJLITilLOhLeuKJVqEHv3o+E+n++5Gf0RDEDu9sTFT3p2zBOWMXW7CbhOf2WSh6vX4yJYG0b+McF8PL6FogPympf9swyw5CST7mJ8z8dD+ro6YwOoOyMREpR1WbdzZdP6WhznSntHMzasf8/EYIIp2fFfY9vBvboMd/W28E1pUsjg3TpN5PXBR1+sPIUDWPl5d+Bw8D73uzvvs0fCWJLEGU++LmENAR/2PntQe23OU27oKtovff6h2bJEteUqMRin7jyxa4kbF/JeamO4nTSaVTp6IErabcAp2MruvBN2hw6621ckxCdM1IO5KwodxkAbTICMZiAY0Q+cxX89oTJdO/P14EUu9Sv/Y6jCEL9Y9IpXf24XLmsd+Z7d3p27Xcbmv/l5qZYoFFyGS2NI5d67W/8vT9+6mWbbWT8rj/5oz4+xWZcSUtqeRckS3JFl17d2juZdz6NhnNbbc8eoZCdXXInc4JrxtvtZLtdcZRkT3hXu4qKDz6VKrYdNf5FiGy1NUWGAv0BV57ebg9stVRUbrWVW6HwVMTFHnATN8b2ZEw7d1bxyajiN1kFKaip9Rb9x1sZ6rXcptalmPJGCG3j6lUsvi3FW7H4hVwcyp8Zy5/oy7faCZn1voBaSabI4JBxY7t3XD/tLpVNqe1+EQxoBGSWS7kcXT+pWG8yTLqI2Swb8xjKPITXKTc67cgTRQhUNPLhHbm5jaPwhMA/Ewz9SVwxcDw/oOg3uVI8+kW5HhM+CA/zaL7qg1HHP54RbJRU/GWs+ENfUZLPr+wsrfvkc0Zgvp7KHeHDZOgdzBv5PnX5mc373uXxm42ORwA4ZHyV90l/AMsldbOF8VZW364xFXWJnKFFTHXHjE2nG+V095aCIIXMfRVdO71xBof2xzcdJXfyLRDjM6qEDjmZMqp+WSm7GfngQqScigPpMuJQDMwwYX+fHN/mmSPKfPBSGg4i1Vrelb0oxlIowT7p8wG3IOQ9Tu1Ba2261WaONEkgQQUgY/ncpk++0XNcFe/rZLv6/dTgmQj+xH+Lnow+jXMywkzY15R9Sb67l4qE/vCoq/8mC0LT/QzO1+T88U04XxNuR+GYLBmcsJlO9U/Z7O7DLJynzw60QLXseVim39Ga3mGZBaHZPywzfOLvLI646Kfo0+FkDsu53n3oleJxJv77gg+9st6hF57L23Rw6JXyoRcw10CKS5w5fRqQu5RM3qYPFTQmPnv2z7vMwvMu5GP/uIt3jEtOj7gjs/sojIMaz8GEsjhfUsTsdXoF+lIPT69IF2nC0GNdqXix6/wsPc2atwKtZJjTiP0gs6Gbv6vbU6/7IYGrVzBhfayfNIGzflGrcV6MMfCKX3zKz9AxDgZm/WpMNjwBmXiudSmqTBizr7rk25ieBOuOH+Rvj+I5DTy5clC8JcWKWtSvQRfek9uE3e32Kexu67fjZr749VJ8T9pMzrGyTmErHRqceCIaOBV2yf87nOx3OMRP8K5BgR9Jd+yK+uVowqyvVrlsehUJ8QVkWkNSrcWjTNqNgpo11FlHA/larOe4oFl9rc03nML7brlT07borvvGieG6puyud4WDBpLCaV+b0X1G76ldf0VXTEnoI5iJaEOc1S9h/A3byaMih9X4gZTALnrqyjWXf3ZEzlF1iZrU2egLnkEKsJLnaEtfWaeuJHSQVFDJCsiMxrCZ8kKaEu35FFvwz1bQuws0V5A2ScyC7L+A+qYGxZQf+eRZ4nUSol9Syh4P8GmCj8DrQdcaAU8H8DTAszTFE3j1U/moQgNEOZcxGy6dYqfVJbCtfjM6QXf+VZueT5Z8CqUGrZTTDBI119NGz/uko0965pOOPlXP1SqFKxrxVIhnQoFUM9faYpdzJWI7wuYjxraMsS19bFlB0VZiNvs/WuP39izs4h/KjZ0NIc5QkkmxnYJu5hp4SfeUdjJcXY7HVR3lsimUTAGFB0K5DAV62lrxkpqNIF+5YpY/SvLHSv6Ukj+zAP8UHqjj+JgPsF00OlIK/IbzgbU4X9twZorl5dYDS0efNpSS3l5gzf4Da/uBvQ2EeI6SjKvfxr4/X8fUtaywteSEs94B65TsU9nzLHpOVSn7I96lYiTlMzXoOI0H3pmhdxlAw0CHOAKYYlhmcr/R5hx7KMz8mHdaQOPgr6/xZfaNawRE1A4VEGN54V3MPEomomQCSqkz/SF9Zt+z7vufMJx131UwmUMAfODUxX4r1D3j15Nw+TfxqmTOjC7ufiX1y5hgQfZ63/h+0UsGTu+mkgtZQkNCMVNCw/Bvk0c3hlX9Qy66jOjarQSil0dFihSZ+a5aoNvrDMnpDLV85AZ3GOs0yCkx5Jm/Hk14xdOyvWxojYhf3irY3eq+OXzKrRd0ZairdL+mknpS0Ao83MlMSO/hD8i2jDqR97Z/6g/uBj9U95OnLmbfUPi6v7bRueli5yAP5wDJQu+G1g2EzB4QYOHL9wsBjEAn6Gzg/n4wsntglJEVhcT8xE//wd0iMM/5lz81e4fdtwA0QHQhNH2r52HZG7t0D+xysrrcN3Ywk3uBnUPw9kbX7gfdbA90MSGOptXrlDK96UaHo3fyLcUM8w7c8s2GLMrhlxBGfiYhhWEmkRcTUHY9tnHFVJbg1m+RlCxxluABbxt3Qr6rsMgomROdjqe7s9XwF4xKg7UuWAtRmhyPgIM619TcsBsR5fRGVP43vMV62Om7JHWLVdIZXgKsiKkr8dIpQDrfsGckTZpSkWJi2YfxradkWqufgjmXVCXyqrxxFmfahh8tWYPp9RiXNGy6MgiiWxLJNqKBzHeH/YjGQnGYrWAmHAUMcT1cL1hCcNV3MPW5OonuCxjop36DR6BzEUpYczX8tkzxLUKnNX1bbd9WluQ4i6tiso0mowYFYrJL5YHYitm+MVhkmzhPH78beivN/x+MBZ3skAZFY1/0OUWUeXyv8CeTjdaErA3bCUU/5JVirLnMYSmJY5t2f/g7/JZ02v0tX5BvP8U1ko0Eoj7PmZ1xsus/OgSu9O3JG3wX/vsIALsguRBf5+h7OyNZTqzCObqmOwrFmAegnQIgsgi2kY23PXBzpNUBJJXQ+FIPlBSgmGCIYHQd5Vf9yE0fQWerp6Y6HQJgfR1vdeDj9VN8Z9MmFxa72+SCAuBoD07C+yBOZPDBeHgh/zeIFk7l1ZhjeJ/eLkCiJM8PO+vw/b+cRcJd5GygxU+ocwkJAgEQEPCAwAKJAukGeLQcyeRgobuEgSGPDzw2IsLmWMIELDWPg5mlsLFNXY7rJcbBKOeN3Ns4LcalYlwB44qhccW8cTAMzL/Fydq9zsIITpU9kZHOB10fOXAydo2YIaAw4fYrOgEpY0lE0PpfQEsu3ezyzn0MPaY8c6HuAZIHPHWFdrEIX17vA9lfwqFJ6buXjWn1OJX0hl3ByYUSRQ1xmIX0x4Sk4GGNlD6HoOFxcB7NG7IHIs1cQE3xXTvNV3CNrpTXgb0AMDyHvrToxLpD+qrq1TDjS22IvlVDqIafN9GbxgQwN9qr6oP4NRS2EdGM/4SEhv1t5lL6wvDLZL7AjRmnTNIdHUrVT4JWxEf7eQ/fEmZv721hFStqufWgoaxa0rhGrWYUOOKGIy9QOTgNbQ44Ia8spClRL1T37jutO4Wsnhs3aHaX5D5QiWak6c4ouDfxu2MNQC2VVBKewxKX2zOot+cQcrsYicQHoNoNuPQ8HDbVJ5RSEfEFeCcR76SPtx3ibT9fvIcNzwpvwYJhH0BCGpaDEsGsHquj45l3OvXuuExcZkbcZUdjcd9UUXgfzL7sbOzj3qwLLvDQioPJzkYY5jsPzt07JT1pPmmO4/JIm3i7paFlmnK+mVPirYz15aFPF6Rd9cfqi4LBVyMCso/6r7MnoF/9Xd7SFCSFGhzEd4GsXA1CT+OtbPWNmIUikft7/YbIdtVt8i/ICf12HBX8WJD8P/b26ql/5cAl9S/yxXd+cfXFLWAuCob2PveLbO9zv/j2fonw+JrTe7Xo5elYFPJg5FeXnApEpicHqZtJfG7EtqmIe2p84Zl/zPwaN2/DE2R4fBSejTL/h+c7jYT3gh609KAHPWj0IAw3BvSgh+jWqa+EW6e+dG49z9AhbkovtsIWp36Yf0fyCnnWl4M+5V/Jb41/rRWvuNkrIVI/0z9kmu5213aaiFx5gf/SJ77ySpl83eBt/pyacsOm4MpsxRqTKFPFV2NX4+VPCp8bmhqHLnsvwv4E6iEhv0WBOTUPl8plnbma3vX4aZr5RC5UYs5HkxNu6nJ6rb9aoDJ9QP83vgo0ZXmz7l8AuuVF4jkf8ARPbKK0rVzx4tWZO67w77KepletV6v+bfSTUPbmbpG50OkKmejvzi9ZyqKnAJtf7uoDp+JyJ1sPHp9o1SXV/03ir93iC3vVjU5f8zDwAJdc1an6z2VburOqRpEKis+UxI5g5Dcpj/EmA7vDj5Wmv3P1OttiJcsy8tvYipu1JT92sp3t6BsnqRxuJa50I/oap0FM5pjClSzoCpzpQC7BJT7rdGupWVS4VE5qLekkdai1HijHJVCUyNaOlZSCZ4FaSBeOBfFh0b0NDFrMoH+6Cx2jwgRV0tcyLTA5allqkB2boe12JmqX2z6+NXDHA3CLZeCOgrKRdDkWWwoRWWd79wILjU2w3iBAbTXwuop6A1wjyOFD9QZSrAqC+KxDARXjQ8pKKisDbIXjW4HN/32K/4L1CsNB/gRASVdXYvpxxp/VFBODJ19MSpT8ZcPN4A/ZyPjg5CltSgwBGDklNZzUmqShW/5Aw8iVAj4YaW5H51kVU0FNWfkBULkU96mrGnIm2DOx4MjIEB0NSMSAJBpQNSUq/WjCmCykQ9OUQLPXo/RELZJeFwZdhNdAUKD95GC71Wn9F8JM6nAE3W1eQVa7lLQ2I4x4Kr1ZrQOIkDS9MJf9vIJIumzQooQV7E6C9XYkqrgW5Xybi4+FKMql4chVog8a+Fb6zUWAUbNRLo42wWg8a0OS4/W24nFUcC3KuUXmSglAtqvLst+lJbksdlnMdVmwlvkuxzJqAhAQclSxRpKVG1NST5z3eCLQWe8q15MW1iZ6YFIFOTcBltBSsAEcul3TrwKpnMzFL1kSv+FwjsFJ9ogf18b4VQ47x0b70dbycBFu0ifHuj9gGHGfdMejlEdigcTFH1IoUYLe0DuNBUrTCqPOoBkqW19BxYqHNjdMcMMyRcihdchwPY8pFDWG1TaVQbGRtKroa6i9raB/qK010AdlQW/i01WWXsgwCAWj33FfDaJQCe2HzdxfBorRsuX2LkmBp0FuX/8VKjEAXQFDyD0p4mmrUXi9wPDcgwIa734AO8JMVnlu13DX0m08ZKn+Jlfj43Gn4Nf01mJVTzsthx38cv21FDm8Sd5mnaJiR2fz0zanwwPeGelHNTnBkmN+pCro4lWXPSjl7KHNXQLRqznwKDZX41kDEZm2I1/RVqgKN2NoKJuJn3UnKHeVH/UtscGK+pywXukDuR5UoXhZH2NJFG+QG3OESqQpJhs83XBtSl6Sjy2kqD23leV1EuZkNm3UlG4ihuV4c7H0Rh2fby1p4udwpOoKo64BmXQHSAF+Mybgi6NNBiGD8bHil3985cjdFZfLeCvxNebDjxwhkJdOIWnxg9bLJo/uiiGITpcsxjZvR8B2RKi2FeHKSqtOI/vSb0CauV3RrPyldDSC/4POBG8fHDa3citI5xXwIjJwJOMMXbRjj4SWKWy1wzQm45ONmsAozHnQh8jacOoxgZUTN+bzDbSduFL+ZhRdcEmbUquCMllWy9auke6MHKKL3KWO0MdupJlUmFM5pg3mWv11ZKc8RUgOYITS9apMqigNf32HywDRBhmGwTRi19h/ySixu4IJE29VSKaqITul45EkU84Nj883TEMypQzoGAmc0peWBF6RX6n/+EqGoyN9zNxkj+tjgcLC/lWTH37KVcDQUv+WANKYclMuccalvSnX/8EermylQqLHjRA90dpq0RvrWkpK1tRY3AtUco6YSFcpico/0UDB2Gh19ykD6MzOgaa4L0349BnxaBjxa9Pz5zBNNStToWx8359ECqWNNqR95/uR5juX7fyS2hmrXbI739BOdv47DSf68fidg45uFG7U43dup1y1800NVrSCVjQqHWvfSofWv66aMdl2bLMVA5FFFUlOinJU4U8185NSmuU730QdNCNeiljS5Xjm0mfjURm8QQdQCuXhQx5e8AV4eP2eHpbwsNyPhyU8HH0TZvJvkuHtRje+ktNYSzpobPG4aKNd8YmxIokxwnv0o5MUuhJX5cmWlCjnoa3wVH6sg+Z2ZY0zpjuhu4S6ozvOnk8ajAWnaRSSO6TmFNrrrpvSrEII1vhxgBTiF3jGJkgi0zqadyvPnKD4Ue3qRlPLFLDaKZoHw5+jWz3THKTrQ8gvlImAvGp2kP9kX36yPcQ+N5pTebLfKJNK6w4h5Z3lQE+Wp23RD2qxIKgWaWu/KGnrDrmD3zxRmJERRWe+8Yw79Hg3OkVVurPw86A7dF+12R6SSK0SynWzOhvjK9ivEExYaSKAuUAfAZQxYV2+C8eNs8bxEA8Wu3SwTDBYPl9cMVjsF2WwzOG6zriWp6gKs+JuXL+EY+sABhIGFuO/KsPswJqgj/Cp8IuXJHAAz61Q5MobKIUufRz9htvjTnIkYcSIjepO0a5xBWGFKU0KS7xN1q9hlhcd6omyY2xmVujeK6qx17GuYJlYVIVyrFBwzo1ueGV36VWtPSO2jNA+CLUWZliYQUb01qMVmBGgHsEM3MEo5kGd5cUNjZVvJa/mSGsj+7HsgsRWP5er/Dh+FUUvYM1oTU77nBmzBdYlfitAVxIkw7h0atXLaYhYLN3SwDjrn99wiY88lGoRMC5ZLie1lnSSugFpxiVQJD1LqfRdtAbVwrawJD4se6sWincDA+gu9IyKNKiSvpZpgc1Ry1KD7JzxdiZrlxs/vjV4xwN4i2XwWlHGBQPajEuENtsLLTROg/UpQtRmA7ezqDfgZSGHD9WnkPL56Fh4HQqoGB9SpqlMB9yM49tduNnWimJuBQPEnti3NLWilfSLcW3qO7azrl0qqNORBGkRZpq3UfgV1q5oCsMcusAg6PLzeaPDLysz6YYRFigs/8f0/IYTpFsaH8llT6mrsMXMsY5TP9i0Z1RFFoCLF1ohazQKQaTBXkVCVae49WIq3fSo9L8RKv3fV012PN3US+j064VOf7jQ6ZcvodPNkE5Hs7a8k2F2CV/Vgx7AfProfMOkD32N0yDnZpLgoSo3elBbrEEywY3DNRO1LCbSQzFpOvbS7QiM1IPaEu2kMnFjh1sh01FSS4dRE2pr6VAk923cLkVirVSKYF9HvZeOYpkxBfPoIjJvdrG32UeWYXpEMK2XY3pkDlNpJwgSpgUbelYgebWkGNa3E3B/M72VWLSCenKIBFcgJqpQSmUVmkBn1AIjmAAVtBbR58Vy+lxH+jxFM/GhYI/kd1J7/Dnp4SQe8ucVs9rCn/uGGMoFSQt/joSPj18pMyXFQv4cFngUk5kFqRDofvhgFBbSY8JsQq/LRLqiFgn62BeB/rcDAl1f3V0vBDppnSPQF6VK2cv1NIzSdHFGJdy+n1bjqIaroqbc5aKJHS166la5vmAVcp2HoZHPicmoEYjG0kR6RT0quCpoAikeZ5liqEnclFZZGDjZ4g5raR87rKRDGSzFrAdXSa2AIum8GgdF7Se+sYhJ3tdrPcGxIIHMh3buW6hzrpGMEeqcCudDMohcuSxyPjLJsshJlde0mDinGEYVyFROK+nrQVxfzBHnKPH5hkEwZM6R2lKzF3XuE+dBu6hzYCSYN2OD4kpgBGZD9e2YOxiow2q2gDu/PnLnkGEcCsC/hDv/u724879HpcxGTPk5xUWRO089d56iIBty57yso90S7vz3c5Pjbzou4s/NLv7cfNH4c3M1xx/F9uopWYOwgAGVCuHP5QagD/lzlHOM9ubPYx/5sj4kmlWwiAO+N4FuQNNyY1lYJzEp+gw6qVnMoMfm6FtIT3S6jEEvhUEvEK8Bg869xq0UU+joNIzzYp5Cx+SCiehBkULvoSAU+jy8ZaTQI1udR3JaKPSJGwZUmgPpPoW+CPJRD/KVrljGoWuPRSZzWUWWUo/MJOXRqpTyoHSCL6f6qM+iQ5dLm5wnPmoNCRhbUE60qcwaEBi5CWwuHUIk60gW2fKRBJzH5IjhgToq9bIKZahKNkg9hk4e2PJ8kD4TAWI0zJwJfJhlDqyZy5zJIHNSj50Wulzvoss/tlKqTYO/8jdHmkONYWrUT7eqK+ZI80JIc4FnjjUvInDztDlg0qico80RwBz3ghlYHXxB3ZA2x+QptPmHcqHNDwtlTp+Kh0C1jDYfL6DNJiCZK6HN56kxop4TJPvO+s43tisgySaeJKMbhRshycZEko3JuBqbtslikowGP0gysa5yWJkny0gyYb1Y0hXMU+/fHRkAbPiiDuDMIg5wP+5dvqd7wq3uxz0+EqhA6o0CqVcRg4dE1pIIGvM3F9Fi41PCSkpUoPKqk00V6L2WlCjnccVW+sSmMGqra5wr3QlL91UkzD+Ye8LcgDAnNZEw91w5fhx0VSTMRRI5RlPn6pAwrzeaAzIL1IEwrzD66zPNIbo+7AnzSgSEMD8UiN7D7HOjOYlX9htiJswPN9XChLUc9xVO2LIf0XJBRC0S1n5REtYddocCq4sJ1DyoU1edcYcf76pTs+OkQ+4wiN3DEqmaUD7Q1LPRvYrJthbCPAJYCPQzAAvhootdOG6cNY6H5dBh6UhZWTxS9oErRor9ooyUeVwBajiFuH4O1C/hwDqIUYRRxeDXMsYOrnnoVwNbbpgtPzjRkaNuq8iWjzxbXrFR3ROJ1UqP9uf/oU3xQGcU2XK2Yp4tN54th2ViUSXlwpbDOVcN2fIK7UUosuViht21DMXDwiqw5UWPLb8+suXSasCWQ4lny9+dG030mVnCmJsBYw6thtSBncRXSuspU+ZQaFxKX0KZc/dOR9GiTeHTg1ojD1y4cbhmJpbFRHooJk0zL91a8JoPanWfF8scbqVbLqqlx6gK1bX0KKL7tm6XIjFXKkWwr6PeS0exzJhiZnexwO5ib7uPLEP1iKBaL0f1yByqps+MZVBD32eFkldLimF9m7tcpEVvKhYVqCeHSLCAmKhCKZWlaAKdUYvAZV06hGsAO2wLLUzst5S23J0JqsuoWqIpqr1D3RFPNxGJjN0sb5y6sIErxUnBgzfgoz5FXkx5FAwp8pSHqFDkRhrKe6mFp8hTnuKwcldCkZdQxBT5CEIjVzaaC/Gu6W6K/KTS6vh/svcvgJJdVZ0wXudZp+pU3Tr3XX3rdvc6pztJ50kDIemEQLqwwcSAZPzryMznzEQTHL7bDZMg8jESSIcEaCBoi1GTEEl1XdSooEEQL/JqEDUqaKs8ojJjxIBRUAOiBk3gv35r7X32qcft7jxQZqSTW2efvffZj7XXXnvttddey3/luEkBZ+XpGZ5QhewWtXGqnqZq1oTsdXlNb2wDtfT2NC64JwUbxLqZDT8cLEIYnhVHTxrzylc83U/SirkAUhdhEy0gX29c+FVTKh9WA1a+NaVyzVjra7b1O16tZWd/qUIDU0Be2/EatR2LwbpHjMZm9yMGxO30QAwQnevz0ixj51piGn+tGkv1MimeoWdU/N9vDQzCsoNaWhkxXak+LGDU8I5BdhO+NcZEbkkkc9VbAGn28p0/WR9kP/5Gc1tAQ7C3pzbx0td4vjjwcfb7qtYOO3Jnse2Jvb3WawoPlL4vpjg7Kbu6yX21w4dVDdsqvMOIKiyX68qkVzj0E/Ks3TM4fgPLCG85ikrv9AJ13wVfDJ42ZtQM7K2JqCuN90D8VepVEM1AnrM1R56DBt4r0JDv+KvP1vGV5gOsK3ldcB1wl49SNW/rw7Z9+lUvQJO94zv4cK1BHerIxReIhKja5x7DCxwuzmR/Z6915IHNddRazC9tB+774/R3nvXPP7/29OG+F/zE0q/95m888AE2C/i9Z33rLXe0v/vi0kLgXXDl4YwN3vPK9/z+75/xC08b7jvra6/47UNvewqMDd5y48VPfvCD70Twqn/82Hv+43/bhe//f6+8ci79qR9D0IFAHYwEztDfMH195Ie8cpOX/ShAWoS3yVpRhBzzZomJjuQxgAOofFVQG+OjidZeAYVaDf7BuQ4I5W2wQBmt57Fq2MXreZRqKR+EpRzlD0bcwCQIHAwvKxpA0WNym4ZR9dfxLP1Jvv5/3X0QJjz6d3E80u8t0/uHP8LB/gP45ZxfePebUVizx5mOSsrgN5DCEc20il/ecJ37q//JirBriF8ayKOrj0wfiT5qA3JfNDnvkJrIKo9MH4k+aiND4IIGdtpXNAx9/c1N+op49FWe2tffkr7id7yvkjK4u+wroC8eYW7jkaVH31PtK75p4ptH2OV72E8WDNHncUrxbcIe7Hvhm59x+afan2EXV94d6+ltnhdcW5kmwyHj6rWf+P3/fOEff5Zx/vO3n/n6z332P/NEkcnwiq++47v/Yutv8Qz6xPd+iG1sngHDmj/zIIxsXs/ebdTYp7OdGVEALL1U7eRzXnFgoJaBnJFMQeUj3JwjFNm8Fw8HR9I3oW2jZKDw3XdFcKQIXbLY5Cwd4x1e/F1u3z9zS/+///ChpQMf+o9o6bOl8J/mOYg80mMJ7fv4nkMf+Kt/vvP97OHlHe96/1v+NsfMfvt33H7wua98E/cdDWeMZROv6c81xYdKBB8qx3dPVPrTGhjSxZPwPlhlqvRIqRpnvr0I2LtW1cyr+t8CtMzL+XufL2bSHvJ5i9G/+27jBaaki7ffEKo1OF1FLG0oAwcrRIj748K3fy8WlVHzscZD2MH3PHPL0t6rcp/c26AIbfjogEEOAxj8cHF6i7GsjfZeWWkNBevsdPAtb/3Qt/yHv158xoBf2UFDHQ94ZvjuZ//DD1790I5nIOedyQ199qggbiySh/+eU1fe/frrn3SEkHrw/33/7ZJqUk69v/iVuzKk3PUzDx+ppNx/5Kff+aHr/rEPW+rXdG+tpFz893/0D92XfAIph9/9t6+upJzx397z8tYvvB0p915zzf9bSbnlo//lKy998BVIqb18+75KyrO/fPDyv/riMyXlfccWKymff+1rtz/j3bGkHPzLP9vrUsJ7npe87bUf3CuAWXhLJeU7nvq+l1/xn9c05eDllZTotH/c/mPtcG/F50SeyJK8zyYN99nPB+LgwxTCb4WF5pc2rR0p01uMlOm9RMp0yCBlOjSRMn0EkDJ91JAyfaSRMh07kDINqzTF4qHFToFmarY60G2pOKzE8qqGban0u2fsBDv0Vru+ow5MbldLvhUuKds7fEj9w76QzSW73EfKS7DD3PmAVB5xJoDqZerqgu34B5S/bgXV+OyLJtbn2NumZfcms9+W19w1YiHcteGQ2Qeq3wYT+LdhBQmp7tqa/YxuTtT6tZn93b1DcZbJ1nWH6V7x2H527ZYvYdfiiRdd2GTQ90N/wr/Zl0UHoA9nCkjlB0f+pESm6a8HfnJdfG1fNgjY6RzqUg0WvA52ifO+NTZ3uVk8ghjyEcc7LmTkF8nyUGosS94o3yywqAVP3iJGePJ97xhP3rPV8YR6UwkZHPqC8IsvrjWN3nsHsw9mSj1377pCYd9DP/fFP3zO913B493U40LNrlS+uY64OsdR87YiVRzSI/RYIqk5yH4Y5SAqkihnDFqzKx+N9BDpqVpFvo15cjwQ39SMeRuHr2XledMFRewnX1Oz6mNnZt8Fl+04e+71D/4gueCVPSmUWkMcV1E6zMVDG3S+AFZsZ60ctlHhrxrmcj5LvSVLLT1vuq3O/iFgwXnGnVz2jxrrjovP9rzSpquHn5rxlKOqiJ6YK91vzCek/xXGPQXZBmPIpu8LiinZg4qzwKWMh/vw7xxEG8zu+nZkJVUKKDw0TU3PpunzPH9KH2rZq15lirtQ7EG+zRSX3YB4bOpIeuhrH29E7KhHNtfuO0fbjffN233PSLvfumm7XfF3jRaP982L//JI8W87ieI3xorfOC7Uf7da/LtOovijo8XjffPi3zZS/PtOovi7R4vH++bF3z1S/Ec2Lf7MmkHIw68aKVzfj+G77GuG0L0x4F08PF460iN28I2Qqggc7fEM7fmWKbQHgixM0miNQiUoGnHUR8QvVCLqa+ViVkTmq+Za1fa7oyzI3+L8FBoqJd7tNL3CUIaOZDnipHtZU0Fnbd9u7xcX//Hp96MCCjWb5pI8XoWQqASs8LnxICQOMCHomwAmQPLdy9w0t2yafM/bu16YvTQK5lJm13S7rRFhpaYQcj2QtUNK1UZm5ejg4X1zzLhvBDPeiqwnmpWjxeN98+IPfnRkVm5a/Mt8OYnXeTlWgb4frY3UgCVVjD/fbmqgKefdzJ2naAbhSea520xhlDoyX0erxfvm/doY6df7TgJsd48Wj/fNi//4SPEfOYnij40Wj/fNi39gpPiPnkTx94wWj/fNi7/pY9XiP34Sxd87WjzeNy/+zpHiP30Sxd8/WjzeNy/+IyPF33cSxT8wWjzeNy/+3pHiv7Bp8QELmv/zCBsSVmz4/hJMfWWvMyJrNU/Opp1hoBckSBZwVTnysuvVFwWFVd/ugXHzpc7J0jOc0ZlkVkTWkjGXaGPe/VUq/X7ZJrzRW3/0VRXe6PD1GnvLSOyPmtgbp+Z98HA19k2IffTc1dcx96bs4cZIt24e78CFnj9aia+V+NlXwGVpgqbqHRLvhDXeO1LjT5x8jb9x/QlqzGr9L3Dh2IHdgrzpmdwE+SD3FUlr9vTZz37qJrTsJs9+/AeeYz53u4OammxKdvkPoGDdLBK/fhmvqo6qbuew8iIPTrKcJz4h8jhjVwtbYOV3W4SGL7Ike+P1irM+A4M89tCfbSi682lb/1dfx1NGkrLbrtfYnWua9Guwu5+9WWI1PvuUfIgG/bAeIO3WJEyod0l7gBPGAPbpPi9GEOvrQ6x0pedYj4Tv0P1emd032X3N7mv22/wRfj3eqcGaeFLUifEQHgI0BbsolMZU0/J0+lCc/ZT2A/scVZKDo7hU5xx5aJIoF/rZW5Cx5W2aRPEz/MmCY2xma/hGIu8Q5OjXcNB/GHHaZDPvb8fDWNpCY1XX5OGUC0AOFDBAAVYRJ0JzI1G2iB0a3+h5wTTz4OZeFfBfHL2YM8Cunggu8APDzXRXMY1CoFhgxwsslNo2V6PaRxQr+EZWHpSG05yJ7fTdGCGU47zfFCG0FowDcmkNhWzEmOOe07bdhkFgitQaG3JAawMxa4VRaA2FNQyssqRV+NDWWf+eqv1pHIqo+BSOLQJbQaAV6FYbWTic/cENxgq1nECp3xDXeGsEhMwNPZEHQ53jQX7WL+1l/2KpErew1L+tNnWzNgbSgOwgqn/8R69atxu94QlG7zWPcysUj6UdWbUd6ydox8/BR9IUn/hSO6iEvRgnF8VCCCYiN3wyGDGGQu4YMgJgCKE2xH/lEAZ2CCnUM/m3HJJNjd62jA36RwJC0KQItbqqYy52v6CpQa/Yohdq5ep9fNHSq41SaF06qVZ2rLkHihmmqERqUDjggbTsDjRoRdBQ7Zt4Va8AtyP13whUd95QBZXi2r8pqH7uhk1B5ebYL5w8qMIRUHmbgCoYB5WsyaOguuOmKqh0QhhgZf9GwBrcdDxgHUEqnJkps0qyQsuK5+mKB6P1FwR3ITG9IWnIcT/vS71X8K/8GRDfxaS3YS2ll9ty8d2Jb3EBcHhELw36vAH3qAFHFAM8mbbc4qHmA7lqzSaARQOLKj9ggR035LKfQXPEnVVaei5L+60DRU1esXtQF2NYbLHKulW38NXUO/4SaECaBRyaQVzDLR48WsVUz34WdaCVon2ECytdSJYTYEcyrVwgj73G05IRxSMszDKGtaEmc+bde3w18IVS9VaOWRwa1v/dQ1+DTBwQaYnJMd0FgIw2+ge9NW2zNhdUVxp8J7Jwhik7/fbDaXg1F4bnFeZ5uXnqeURatfXpfYs8ZlQnqV5JYLF63uHOZCYH90lL2W2eZJ6ZedY0Iyxf+GI4qA7JfDFHKc3BXto83zzrX81KC3IHgGuLRaQdr+EY4gwG4oIUQPr4r71iAcBruAy08CbEKG5I7IJ+OEMztPBfekiUi82xFWD7yJr73JIMBlMSNV92hr83n8GDGytqA9SScaMOpfi7FGYf+nuvWZMWxhRv2rgFMlXnM6gZSDPLrcxnDe5QyxotmtnjA36z/BV6rqBa4OIXpIdcw5vyhbHWdwA/HoOsf5DW8ow8WngvZGtzeZ3mUa5evzvIM8pAJWdUQ6MdjHy5AetLD/4LVGW10b62uFpbhJmZ8QMgfa/cIeTpbVfr7/V9pgE4yBHeXTh2dXCje2vHIhWBnrl4a7kqQtrrIBU+SS/JoFbl4/iZ/kac+HIRJbg2kqdntdSOLtttAMb3EFy3C/PjDse87B3itKbO6hV5ooSygTwJdKPxABu9SxwSyo2a7C7kh2WzSwQQq/CHwW+s00x8geZ5vNl7CD0S5ps61DlQZNnDiMlnoX6Obs+iFs7BpvFzT8+aADlG+LmhWJgq3wboutmHeHh4lIG/zwxyNA7gMhy8x6Dg0lwMdXCrx0O7nl3U9h9gqBoqXRO9Zo86/GQEmcEDeJUFokNmW1fME7d+ngAx67KvI7VTDQg1g0bMSCOAC9QwXeQqmU+TIvqeLlk13fzLDb3sq8hl+z9bMQUmj9nT/TBfQDwHzvdD4C0eMfjI9y1zVe9bVlmH8ziZwlP0HDUZWENKjET49L18hjknFvK4sQGqm9daoSA6Q1HeYbDP04yiG7dxTp0rYoxVFQeQt9sPxOaJaF52ZMA8DBg+Chkc8kkyfLeQGIYQwCTCKNZQVYrdwQQHsLkGJh8aKRg3RzzvsfwCitozioFVYJcFhbKvKTYxYEOOXEWiy1nvf6QGnwfA0WrsHhf5pjKSXOQ7NZIniN3+z6XHGilLcOROV8hPTKkAa/a1juWva2aZGEXCna6odnF3JOpIZQyAnMYdA36oaO7vZ3rr1IOtOArMbTh8iUAyHA5xQmAWMp2PTSP+vfmGUkYIKvI+eRe68hEJ3jblNNlIipGe4sQVLIOKY8dK+6gr7eMSfPNmpemnaV/qJ3bAZWBZ+1ZK+eeavLXvjX/zK4N/+s3DT4fyVPnCNxbbwoDIilgHu5L0Ua0YCgQ3+HaUBMYASIeZjFJpRrkUA8eiYyAJMHaoCYYiz8BhSFH5rFuI51wwccF5XbAX8Il0IV+sJE79ZA7t5QbKoC3gtmuBwWvbwVuipXLwFnXwKg0CvE1VxSKCRyW4/KyiC2qTN2lRpmNTCqMOiB9mn1WpxuzhXi9j2pReSCNuR/fAWr6lpF0obAtl5irou/MViimj9ADMGFXr4OKlDlq5mWcsagknaqEMU5XLKqdqVixVvMAD/Xvs6X6VgLerPLKJzGeOYKotEXM0Tz1aGg6Y8iygtIXqNJA9RKZL/Gze4ebPAjLHBDLdZxWLApkOxyaAdfdZeAcVWkK0dKRDSwr93pXFci/voDbiAMeajwzAfFC6jOM2TA8GFw2pgy+5dcU8fzV/hB/oyfyVvXVMRXdMhlDA2jhP56wJBc/HldwSo7+3DRoYwA05BmZRRBshGqrsq1qp0k7MmvYQf6Ka/kuq0Z/wUENlpV05VAwo4XY4gLvglb1hkbj55YJX8exqyWA5QcGv1GPsP/BXcYt2MHCErN7/sr9mLt1kvyoTOeDBlfdhzh0WW6K8mG6ACjmbkOrfpkifpddrxfQVx7ft8SVxii/NCXhpVtc1ddCWgacz/xZ+ouuH8Wyw5gqeHiu08HOCN8em8E5kkOayTouEweNTWA5Q9vc3SI/A7gtTUOdNh1f4eN7uoakqPoy0czJAynmWbXbYnjfxgCinLmufNpJLN3sMP9VuoLn9+/21vqft0U2XGN7MW9qGB6UFX9Ydlay/bVylIs4TUkvkDi1lEHyAELpRDWrBUHn2ZekRCitael2fuT8trWhwdhUtWH2UNmZZ21TZQME6v+pgII/50+BazDBk7wGX7ylUZRkzo9LS0ag0VIcJAOaFYAMOqmUc7sWYHJDgMVwtYTfFL6A6NtlX8IOr8K/WROS7Ssf9cqrDWsMl+mBAKar5cIZWJ37s4Qdw58La8xS0UsQe1Oxl/yCACQXq99ZYjUaH/kzui1Kie/08RNO1C/hcB87RdCg2a1MEFZvotD4PGZS8UZ8KBE9xz2IdZAjZP6HWqegi9+91lifl5aMh5rvB4fF2IRzotN1cdQhLiDup+ZpTqzn+Z1iGJk7K3Gd/7XvhNDefOtntxsSKqiHtVcG0Oe4JVQZ8mYmLOMtLjJOSfk2dmKviM0TK6swLFbAM1FdvkD+IbQ8yGClRwJEPGSlRJIxk9qAI1EJIeILNawm1FrRJDRrrDyRWhbc/j+ymK0I+K0xHkdhKne4n55v8YF/FnB5KVD98OE/VR4iHpGVfucG46ESDrENtD8utHi1VxUZ/qTK29/tBKATZwU9b6M4AjDU1iSkiFE0eDLKh5eb6aaCmW/TCaaKGW2KxGoL5LkVjjCgUSIHF5yyx+VpWqHrlkEDtrOiOMjZif9Kd6MQpgLfJKUACvEB1/FfKRZMppwBFolvc0DVooishGhS6BjkR5bc5DKfStScFEJB1+YFduDrWTIzsJwD2/NL1ujMLyoWRvPRH/NCI5ix7P1gukd9RiUBHhNS+3U7cs62mAphgJGK5NBMz2xPIMRQM7Oli4vc3lrDABrpvzlXuCQhP7sHFo+LlKPF52S8jRkSWkW5xbl/mL2+32z+J31ONflMZTdVo3eioV00gMWq3RXCXLUCC9D6P/eeqU2Bwsvsu+aX33falT/3Q0/d97KP498DF2atvsFoz2LKLEC47P9hDErObauUxCEkY9AL7LUUUi9BwhCaYKWjPSHsAx1g8zJdg0sHNrHqsP7CGvM9Wx4BZUQcLIZJbnO/9wJo1CakGacpjkstdByjcqDCsPdZFfR7V0o+EAfZ31ZPlyJ7/mrWvJnxqHuNBeR2xe/IE8hvpzVTmpAtC7/g3EHrZcoLN3RDZUL8rbJa7DxD2DL/FjUBSBOfC2HhnnzaIEslXIqkuCTegk/0vhIynxUJAubswhhJJJW96BZz4oohvlb8IjI9VDetSLIVnr8KYCiVAQYqyEWbQKqfzY4EibA5b8gh2oU1ylNVF6HS/C4kz4nYBucoQOTVrp/ptAjv37vvCf9jY9urP/8HFFGU3KGERob06rcyKhnalq6Z8ct8afDwcFKEI/XkDBt1sLLiwJxeqfi9OhqGB2wVbhAUOzyPDUkdufQBxppme6Ck24HLRPO7fEjAOGsGE66OC6EYBUVRRFEhf7+MqqCUcx2ojtIg8sMvDgsvehQF9YFEMvYib12A69mjybgoA5EsogPdybsA+Cd2N2b9XgsCGPQg9XPP38IcJwgLxcysQp5DxDBD+Dxv/yPeJJuGuZPFP32C4fcp9PLq53lDOcfhyzHlx5cIuvGn3Z374f/7g06HteOb/+9bTz+xdwWFvgy8IPUK1l4EHaegrJ/U6fKXY+CL7FaV9qguTvducqgQiK5M4CiAoA6EQWs89ZmmIJgCCkhuer4O79fQBAAu6DLBjeFf7u2dxlWdZDRunBpJ+uNG0C8Os7puurY51veJRGXVlVcFuYCIV/6uCIcYpOc3RWUtFrLIMdTHmCIesfu+KeP/Cz6P8bPLzo/xM+XlnfU3MYjwQrsFfW5uDX+CtzgyO2/nZ4efN/lqe8XPAz1l+HuLnHD+PebDPlc9z8B4ubUFmAVbbRZTLMUuaCVHLHDwcSRVd5A9ZyIB1TrRnPYrdThFB3ILSLq5cEGzUsYIdrec9lBG4XQJKxMdMr2lF07INWfNWs/fgqd2i1ezX8Fb5/iPy/RYF9Zap0wcIzzZjj3kUovrbo2Iry7A8WnbVIz3T5Dsj2grquFEvVtw90h5I3aL7ALUrSARU3GifRxCKDijjHlja4GX7vdr08uBSm4BvgRHzJNkx196HjCuSuFFfQ10IdkTIOafZIOp8v2arac3ZB7R4CEg/Wgci1N0qkE2J60yJm5mIU5MJzh6DmFRc4R7GarZrOCy2DSF4zxRM+Qq6fG+QM9hAhPPtiL8/zAmTnjt0HbatG+aadK7lE21THxnDIeX7brj7t1+4+7/dd3HlpiYRbaet+Lust1HemLMZvn3vgLhJlfxo4cDJb4YcIddMOR/uKXJzyeDVBy2s2+dxa03kUQOOXiXuTSauVYn7kIlbcHElKNMpcc1K3IdNXGNK3NKUb7tT4lYn26czj+MjnUaaF7JxrFl1WbOAMHW3Pj29SpPtOZMqCE7T1Bs9m0rTi2UfotvFP5NZ6r4Ki5oKUjxzIsTMjh7NIF0ak/5vT1SxJzTRSO7jHyp1WRe0xpYYeybfOE3Gj1hyoeBAYY/WfwJfTdXPrj+cggclPHeZZ1c1zLhHWD0pAGqraEZnl/CCWAS+E9q04vB/Q3aEComBr2T8Fn5mP3nIQNuB918iPx1Z/qvKEsy8l2Tle3VTDAaeaqbnxiC4L9s8AaVqMNZg6jGiAPE4AdnO2hM/wBzkJQbasfjEpkhZag+HGLeoBky0yZffLpihSv4UGuEjlIpiPLDOe8rUgdcCIQDQtWQRxKsW4h7NtZs8e+z+4Aevw1fIKBs2f29VQQNiLr1BJp/vlM/9VbBwIsIqmmp+27goBwkqW1yk0lvtZks7nfBDEUz7Ky6UceoITi/7NJgzNZMZSwOIiw8mywUs9BwsTrXcrk6Q71Q39zH/RagZcV0nO2CQvJSiA2i30m0AkOprXI2YM9UDmroAIA9k9PM2MBjclCdtFIfy0mT0CaEFWR4APwrFIVuLAqoD+trPW9HPvIW6LsFJdB3GrajNpLSuB3PosWzpI9HCkX6orM9WlGhJX5FxbCBXozpIqMt+kIDZx1fZUQBT/VPr8CoJ4kyOH0yHgdeYFBdVpnYAWeIq+HIKdJYHMsv7ermnpujOidYHurqfjfsqCwiQsFpA7lFX0YU6VROeEqbkV9VTHnrK4+v9AJOxvKmFtjg2sFuIwAqrhSzJsbLgBwum0aMMBKthz1QkCH3a63AlxKemswYDUz/ZEXRNyoZVMk9RKUI5rb54glrDUli7pLdGdWdGvtpRC3IpREto5fyqCr5DlD/WCRBas71Rotj3L4XARttuiC0F6hy8YuMmSD8ds6GN5nVK6o55lTOt6jYBZ3M//slT70/PmeWzuYKVb++WqQbpZuWaJNxM1bL3CU42lTBeTu4q0QYfpsTUHAwKNq55j6c7lWERj9roANON7QVXMSQpEShlSg2FZ+CPsYUbmoJSbsTLF37xW//8h25mvrhpJGO6nDXltuXGei6ov0+nyp68jcdZ+QwelHdUupfhsZDP9kfPA9ma0Hyw10WEOIKiOYgVF9aKRfGdpmpS12G85zGiYmUwowVmoEc+lAHq4LCeP1tTWgGmCoCgGXIvgzuoXXml1kjagPyN9QG/RFe1PVpUMSPMs2J/hnGHiI9/Skoewr7MPEMix+lVOODhnQPezZFnVKwMjYPCyJjkexSEN3sKw0OeAvFaBeLVCsTnKRCvGgdi83EHYvx4gHH4SOH4nRU4NgHH5igc1aEscFwQ8xebYYt3hbFjAY7W3K6wZGkgM54uLsIyUjUEUobP3bv+5oeCQqh6vCHXp0PIKPZg7mD9DykUqd9uLt/n8FlrKkzP/jc280UdVSJWnOoZlRTE0JpMBo2RzeWCxvSDNRPZFDYgT4UZy1vWsa26FxVvPM5TNYaRUQcn4DOgayPabzyQM2Dlhu4e4gxWq5nRe47uWoGK4bGPVaatxd/HBygsNQLG0mHO2F8bzWKOxTVnx7Um69cUa50PDepwvpaoxGAizKkIcUM1Y/pJXlf9OiHbarnNI5/HSAChmDYcZO8XyuWpl9OZNfLkrjs22XXb3ViGUdVnO0AkqZU6NAd+AsjWaYsqQgcuxNAWuCjiCdjhxqBgMdyJxyJnWlLLbhVA0wJXssT1daS9QPU6ta+2pqJnpKG5Z5tTpxSNKw8KiE++kdeWuNeJLJZ6PHzkr6u1Nx9YsYTOLFEHkwaAkkHrIobTiwXbp0WBGFwiCa9lId5/hdo9h9YVBHt1q9tRl5ObGYYD+eVQDHOoOr0MjfYrspGuChw8ZRTUpjUYmGWal64qpmU4A21zROXbqiB4aHIXnio4SVNmBFrUdSWBICQYo5Rb0THr+eiN3GUX7KKLl7VlCD2IZpagzXhA+ON6JZugmJ9XC5GzT79soU3h/vWkv7y6WlEmpRvr0mxaVrNiqlDFSjy9AYOsS94AQFLW0IxbXZqAiarkbpEyWj6ipcwibZbL6Q5ykUM8K5/BIEBmNKNmxGWHm+hEO+z2twugIGUMWEgClSljmCK67dJvplFLJGkB/33DUMw/e6wU85sUc6FKMTW7JZgL4wSz8Pad/S2rn//MeSsXi60Yr+zb0Q8Oh5VuLqIKL/tbvfFGPgx55YtG/0sYatTgD0+6QM8VKJpaUiBHWcq9SL7Q9yHPCv79utDxZcBC5/+WSTq+zJVsqdDx7iOl41s2oeNbJun4FnRmywQd36J0fNn2qfv40PHFaXR8YRM6vvi40fGFR0THF11wYZyOb6FZWp6g4wuTdHzxUdHxxUk6vkgLoOMLJ6DjXcpocZyOL3xd6fgbH8/rb9Dr4LCXffoN9rIbJHG5V96C+19lQu7JNnnsFtxv+144Td+FIMRfs/ouKgLRfdDbPL28LIal7/LkjkM2kMI0w6Ca4a0jGdQsiW8Nk/Rv9iBN0APJABpRerUodF/w17AY3r8cAybNuq821iyJvWc8tr97tKqFak3dTSuytSxMqySZiHTygm+ka/GLtT4kAXJsB2kBAuvpM7kMrDHm2pdcWedXfUJvVAJ6IT11V5XIM4pavykJL/SCScFVRcdJZEb9l5TnyaHaQKicvQPOYf97zIAG7KWvCPDi0NOpVb2+kUTX+bJL9OTP7RaXSv1L7ZA8RNb1TPHeBE8LiRBUvEX2TRUoN5Z0nRU1WlVKgd6iM3fVckSpLUsf+xAABabAKBDmIIO7cFBYl5svs/z8KD/nppdhFnZPPKVz9W1PqRFU3KpXScioseTzEp8v2FYm2konkzM+oQqQOj51Y62ZhVSdxSRGIqc15YntMgSfpCyWyhOgVJNkvyXjCl1e7JGOBpgTdwhOz9MieJCZ7G5pUkMLet+SK5gaKHhqicj0PsmkH9ks76tWWqc5pGm0VeKj2Urcm0xc5uJUHadU4gYYtUXZb+uhjkRlvyNkoCVqXnXNlaxN1JYAHfnHrWaiO1+5foBVBKi9BH+S8wL8eXFnj0doRoQSWpDxGFodLDcM84z80JDWtxa1VOMaw2b03XmvZpAYe9TKEskFI0ve1Q6SL7vNYos6+tJyFofFSva79sSXOM24h+vRIv/X5eLNNZQlgGtF3H7Zr4esgV50932//PvcxcOHgn60ln0UpUFi3MUX3QrbsdLXOyzzcnWsR13lABPDny6ieAj3NWJomr2o7RtiRVb9NEiKABTUoeKhyLXcAoZa62i53TYbKtGm5QE8VwDVm0bd2EBPZqcMeKi6O+31SR29KTNj+pTAzF6y9L2VPtvzplM+fOnDmEqgtK6qV6rT6YgQsyphe7MnVjye8U+f+uQ/3fDFn7v1qNGCENMUbstjAlv2UmnGH6jlTPRlH7+hvDuKK3dBdt/r5TzLcXwPXrz+UABmMgXd9V7KWrMB1dBakPYyEwXmylkt/d163OG9Jiiv/3Lf3rW91yt7bQ45N9lmJliPDgbQu8PO6QoSLTlcH+2/XJoAvpZ8cCpG0zvK/kr5FBxZZYCTTk9YQYtwDzqmEG4xpZg+gYfz8Dl06+E8ugFI82tTT5ZCtbmYp3r/mEMtbRKfmIbYU9S0DfmMK7GDHDcGENJuMDGP5boKtmm6OYllLiK3urH6NNe22PfyJVrQ67a/WgJy6OBOs4NimZZvL5Z5klHXWYwfvPvhednEcEtkqUyws5ZGe9TkFj9cC2uYbFL4Flp5+HPiDFfiH77Py1dETa3AqOjtSf6Gc6WhKHRfk3v9MJdzD/KQvEjLjAOvYPzEbEI6+eCZVChGde7TXF7TvNpJfIw9tQwTLrUFetdVbrkGuK0nIQaovVXo7DZmYDifRzMH8PyeNQFhYMrrqHLvww1fd3Hav0C65te4m/mKnVMrggjVTqcmxna1BhpQs9UG1JY9RmDNSCYS7fPnmfxeIcX3M1Q6Wrp2U1/QCKlttHi9MtszY+bp6yogZBqzSj4uRl7D3Xux3KddpR6iGNGqsT207hqFR9/PGZjqemcBYCq4mPcCZYbU0ycQyN4kpHkV0+mL3gfSRcaI2vUlRW/Km7M3fV02HH/pNhzd6n7j/hPsN36sntnLNIlh6Hzz7r2cQ1PJjbJO+75D1PHuKSdYsnegkpIAy1bMpKVi+zqPtE1meseqo5DXlU7iDE8IAjw7wuGGIQiVLwAWEIQ2hRu4rr2Rd3BLzC3O1TtyJW2YN7RhgQKyGY7BZPjMehGpFmm+SJExxh+BguhRfZVqdAY4eL+djR8CBcaoRlcxUNTJ6ko1VkABE1pRqtEzs6pLPVCNRmUC9caoxjx/Qz3B3i1AyoahGluogeQFikapRs1QjQWhGjH3dhFHX6NUo1FSjcZasaJUYxW0YgVUY7VCNdRjqZ2+baUaaZVqrGh5uMlTUo1u2b+VCtXo2au8vXGq0XNUozeFaqxQU6jGijnhn041eoZq9E5ENXrTqMaqGbOGvm4FhExjto5Tja20OoVqrKJ11yg8hGqsoJGzFQndLM3R1veKjiSt6pNt6s+ZS4gUKplgPMyjEQJBUfrrmwoBmDroRdfbf6xiWu9mvLAuFR567xUxanRPc+J6rCTrbvkXbrBKOxhbNEXVlFoFKI5TinngYmh/ovcEfaW34TPJl6tRLyRyeZPpZMtuZW8vI9Uok6+fI0MelpyhY2nL0MAwWCOp5c15Zw4KIsNA1T6qhvy2Gftcup8G6dP9b/Z7wkz+bdI0fi5LghdeF5TXJs6v3CaEbOL28/kZsYmS86u723Byd8vxI/tb3QOHVqQYIk74gHr/8DJ0QQ8RR1WOn/XyV0XXtmrzW/eiKUgNVA1g/Nkks8nYvp/9PtK1aArXsMG8XO7cVvCyaRTj+wcJKKi0XDZOen0B0801p6X3ituVmEB3wNSWK8MsmhyRtDfBu3Na90CRGZ2oUHWiRm+ZNLGVkqF3TbLXSzrUHOazbgc2p7cxhfkr5nmRVR/TM3h0WE4uV9zKRWhInXW5g1eqdjEW7zYAq+NeQh0KdNkxVcHOI36//XxegkAQAncdlDKo0LUOcMOk+RSiM4t6Y2NRzjsWK/1xwY64jBVXhJVIqkONaknGJF+2RRRMsEeB0im6YDeacsu4o9umJmK6HHNEgfWyUZNwfQ+dQMmX3EaLoqgvtw9xW4/40YHSPj8Ig8X3g/UVNUh6FU6JHBOYPTxWZgWThRutSXr2B4jUo5A5QYMQte+m0DJD8r4H7wm/J0otgfS3CKTl8AkEMKZ5fIzvpHUGdxfMe836Pjm4d1g0+UxMPfJFMvIUGZe8nSNApY0jqjJbs8yX7k9lLPMEjzBvgLObHeQte6+0Qcn+fveF9k5pqteSLlds0T2PRO+pxL6pjKVK7Ds1lkmHoUFOrt86cmv69iCATeipZ4UeA7eIQJ6yz6sck+0lLeUxnodwFi6381ZBZHApIgSFP8sdCeKkj8k2QnJ5JSnPB7MyREL+YmAJbnSVusklSyRT0N5cgStGXMNJ8NhdNEZIgu+C8ExUeXNBFfUmcr2lCdongrCAmkAW9a2p6pkiXgjkRwcz+zvhWGOgBCE5KepweUM+YrqEFwaUKU5HOMFVFyffqUDEXXVBkdDod9ali/q6XmnyCaGRg4H07T57q6k6PoZHFwreD28sYKRHrDUlo+/qxsU67QtVXzYoPcigIOiwVT970HxmEvShxYS3ui+nlTS9Ja7IE7ZVb0aGygwPC0eOoIn+veqhTzK8WTMEI8p2yFBL3wDl6Niunpm7OoRba6UDxKECM8arDmsiGrScEFKdjyob1GBowWgBHnL5CRqT2e2oWe7w54lgCyYy59O2NcSSkJPlZDV77Sb7I1nr/z6I3Tof2lY+cNbX4Wqks+0erHMuD1jHuTy9Mjn1hmQeuduTE0t9XZohTZJrd5DIDcprjMO8gaVRL/9CPXGKhKmM09uXYDBoIjIl++2l7OAHrW5QPMQqxLNrfTAw9yW/cDESvX1Pln+fZ/mj15L9rTVZ8wVcQPrCWZZyIn5PNfpNZTRVo5V26q3QiQudeidUI8dvhGqk/Z6H1N2Fvd3zeMhVdBHoEX4eOSOx5iJWP6Mo+4Tae6uZqD2SWWN121rN/MlpmTUWnHxYNWw1xqqqjp7cJrhW7GdJc/SutLkiXaG0WnflTQdayaTcCidfJsMw+5SR5iL53lqpGV/VeEXb1DvoenpgwkFBYNsR4qG8GnBdK8uB7qFUqOhfH2b36HKHJQUCbcwDVO2YuACVZes8Dj7qKlXQM/yI4QVjg/FFgMqoDzF1Lbo+Qosq15qYD6ih/Et7/PRxxO8fUPu8cjhWsyf1R4jL8CqX1ioGR7K/xzqT/oRrXavwtX3+49i4R9uuN3o+JDGlqAEm9Eok9BQ3qXblCHHiI9ZQrdAOKuOOuv3yU7/8tIiELMESm1Kx6/R++sT38Ez5Z1EATafSlOaxpZJ2lvYQ86C0iJiHwGy8ij1JBO5EYISYRi4Yi+/nYCQ5trSWcQxYxlQ0trRWObv+C/JE7VQbQ8yTpLWBOQMmr//AvxgXa9mfVkxmJLhAG+n5UJNLa3K5rheJ6xssIzWUOlVPTyV2j4t8UxlJEhlRkxIQbvIObOAey2CY1zWr0Cz1U6gdcl2vc7R0DGQjlSud7vBS9UtQhOl26O4uOmCoKNDY3bS3rxulEPGjSxz4qD10U+st0PPRQZMS1NLlQxJsWos4ibWIY4/UmsYiTt/PZ9CVNs2oP8/WBKDSMSjpWGLUA1jQaBjO7Ctuw0vtnrsWDqItfLywj4kwFGYxxhZQGqRHoDgdX8/+Nz6Eo68mMBsDmwrTrwaFANVj5WFSnW0x6+XniSsgepG9XzOcuR7AA65LoNngz8XzZTCVp2aXWCp/FdUgtTwYVG81OMryn/YOB+mrggB3zMppRmP3chMSc+LT74xFfEcsU4VDgl4BB3euQTq0qG6zkH500QSO2cC9NvAAB/rX+0/1NhadTKBuZAJ6eX0Bck1Z0prWI7Ma7GxVj8yFg0Mstof99nPbASZBdq/e2qFW9udKgZTPMjXgAzxbMNGDCzGkG7Z66lSG4KCZkxN3zyfs0zRD97EsXP2WWrkXbaD+H7+B5z/irZX7WOKzz5iX2Nqz/zk/VPUGD77KIPvaBSje3QQUHYRkxdBFInBXWmoEPy2LFEDJJdLJgs0DLvXEP0Axn5zxRviZ11zImaApBgaRb9UnyltDaqxsODYzuGh0CRySpiBgtxGHmNtDBe9ZhOEI2QtwzZ7Si8at+5b+41++5ZeCP7zoSoCNsfpCzonRxTadASh3RtTAUpEMUeiwwsr3sr9QDFe7SyHAHVZ76cBey+4TvvrvPC+6Vu6/LOY+nkcX5boYYxe4nexNAH8eGXbxX5ymmwr13JpZJowHamV/r+kpaF1e8o6Aw4brTx8AxxwU3crC33fbrfj32xeXOpMX7B0MKSpn5pDiqhrq8A5Vhg+HhRjtkaLgpHdQ/X6Y/hc2dG/PWvV6qZ0ovqIxUEF2lLDOw/Cqmor33dm0M9UD1kAt6/xrWfMfHDq+HfZ/Hav0P3vD8VuxRS/ffQIvDMnDv2+cGXnpl/yofl1gzL+p9X14Fqhd0lZTKzzDjnkHuKz7awdwFsDTV5ZcTwwK4YFlUNw1GjKGMlI2qPqrDiGyLx00txWF6mzoO7QcaFq+GYo5vuhMpmTQK9XGtW4jlAdM5lVySBmrssxAL5nqqpdMvmQUi6RzotHRodnsH98gLQG0TbhN83LqiGXHFUgtvuNu6vCv6Q31gLI/uE4vUklHzO26uf7RV0KNchZxs6V2Uv8ujuX1E/eaGqC3L6Ho2UhK/yhq+sZoRMR/MYfDa0OdClhKpixHstiMTvjCO5L7SvUDjA4GZzfvi/qjvCAk+s/K61NtVjZGZKUq07JT9CibBakqr7aMUbpWqbRhc+5hh2IzSmhhwFWJL5gfo3HryphxwcwFOy44C4xOqcPyan7MDKs3yVilBkYpcl4O8qXpNyxccIsLrggTv1T09uertJhvpYV829TKM6dxLc2nbWB1lmgVU28rMGTbxhDa0LOMbLQV6jaIhT7tLDeZZiBgXsq30ZLoJAiuLMo5Nre7BzRYYlSbw6l3vkxbONTlUJef80McinYYs1b4bQufis/kSF9htB7kK9RDgcu3lmaWAJ6ufa2xQ9QMk34Wljtplmlt8wLlSDJYP6aMYxp8cRMxM9TJ3oip5MoqZsSs5QznSi4AS9Mq8cxJdtVKL8UuqbxZ3FeE/1IUNgWlnbGspfJW/6b7F2Wv3XESRdnnHCcP+o4HTobqzywSkECjSI5kvIf2XW2GAd8ocnmcVfmG3X0o/01xuSGIZUMAu4/8bg3Cl7sAoL1m1pSYqfXYTgAECx/DptYSB25fKvV7ZB/Qqe4D6m4fkNh9QN3uAziUiCl1tw+A1FJ2Ap1LDcsegdGBRk/bg3PbmRNz+iBtHJfX8T2+NZ2lGXD+2tt18rO/xDekZpMQmRSZu0+ubWPcRzLHz9p4u1XQCxEdTJpOdX/gpVgUUFyeVepzQLxfgDinZy7A2rnhaMHJWMEx9kMJuuDsOacS42RaDeyHGkamfZwBqIDfL8EvH1m8M/CrK48RM17bZfUnwwg47wuDaxU7lqqWUz++BDdHf4UWoScUYbOoZ6B345mIwaJjS+RDU6MhAr68qWcg0OiHtoUlvTho4+LaUBXAIcyMFb418DPT54AivS4KHRW5ZtzHaRjS957Vy2el1C6kpR2Afhalf6vZ7c/Z8r08pBnIVWUVDVW7s4PHoh4XApXmoKa7ToEemqrFywWKEEiQOWFNTooszkQA9BI+GdKSRpZyvQiIFNE8xnte11Idb9TjDpFMjDtAakqME2B2gAEdynQwDR0L8KaHKdjxJs7EBsXSPHsMpmSyakcBxUXGSAaGDtwagJf9tTaAh94ixqv8QEnhyPVlFZeWUc/HcWPlOsj3w0Tw5Dk1BEq+oYe7VPuwNSLfCNXKip1HyEte9fhrGjuBDaqXfUEzwADZiDEquVVVdbldxOu5X63Sw+5Bzb4/uEicGrrTFjWZdnfoxZX++6PiUfX6Xe5Lvr9yEQ6bHgekito6PhqWbxXFISltvQiOUOCSh0XoYBhWtkd3QEyS/bFuZgkW8PQFxYTDI3kgU6i6oeHWIaq6V7r1+TIzpksdAT0Hu6EMyWa9IA9nDdER0wf/CPkn1wfAWVquW3TyNQxxzdB2xa86h9Vekafd0bD2A6Fqe0NFIWlZKO0dUGhaiKZ6FA2q5hsoHmlajF2ybVqdQswsfdOTKbQu5taFkI5ii3mEwkEFkuRVUW89fQ6UiTf1jfFPb6juCZVoS6LvbMu6feEjvMiCPeq1+F5sUuIG9/2LeOo2fVgEuk8HRlEIAxkUwABAmecY5xGLp5IK4F8gMqLsAZFLvxUSqrBiatKpJ+nduirLz1Uzihehkybfkf2oygTUIVt1B14Asvx3ZU/z4PTRwTj7Z1Rvr2L6Y3Y4UBOmuMrIPBTDw+6a4oJaujpKJnQSOV07KKjkVPmFGuWkCD7Uu/jCZRaSU0ZkR4frg1tRnl/JMlmeD+uDWl4mirqwSoOfJ7A0CjnMVf2aJsJUzpmGmcETAFBoGA9C1h+F58z9Pej7gWNrs3J97yd5Ihg3B9YMJh3zBuK4NrAu/K7Wba8hvS8h4h7LCn9BuVIAHHcMZF1BKKTIhBKwgV4Kf5dvNsQqoiT7W8tMYEK01HsmR99iFqHWWulKc0SNCNPqgNZXQxMhRRQvAjkHoLCYyFa1aKCRZQMBtqq3/ndnf4ei7YWEiEL4DpB7mokqM7pPIRjgxfgBfFCNjRH7RVV5IQ8VB6qcWO6cs1JvwPO8l6s8Q9YVM0UhuhCAA8YiQuFPCGe0QHt2UIpLAtlP4hdbZObvVfIWjCYFSk0unyr/DVnVHxbA8HyBeb5MqdAhj1TjTi3SBhJ6NrEWXODNTXrSRd3PVhsql4BSG0IGFg+U8QA3WyWpX1LQSv5+IoJ/ALfeR4BFMcn+vCFdlWvl9wuHmJTcIYrXWs4SQ0kzWlOLUtRCsbhYC1EVnxn8vYC/rQ5u8EmRERc/i/AL8jlq8XZbLuhgxwi2J7uUy5h97jV6zxeICOvRsfFq4IvgdEFufuMeuVh58KguThU4W2//gbXSftYiNaSxnMDFXNpbI7YkGfO5XiC+oG52RvdRJvlmn6nIoSZY7G3YxHBzCxAD60X1yx2ka9TMviyzZVGiuJJiQdG2TfEB1IkrYMrXt3gEyu2uDkHwUmvapQY+PPsHPWhx6HlX7C1fN6mlURP779Cv9kQP24NOFGznSj8oxEhk/4jCnBGxA8ogan7y4LejiNWiHj/AoQpPF8ICwRshYAHkYXbKRMKL/T9dX2JbqDDw1LxWTbEN5FawLShRLShbkBRieCd7ECmF8sXKJXsikKf6frXjCfvuaruNIpViNjHxwv9BITfifxQ4tE9hfxnqlJf0ULuH0fRkHPOoQmaquK6I3TKI3QYCW6QOFalNZ2DnzCypitCBQ2hpdkebnaGhuI9D/HcZ73XUkdOcrvzz3OZ8QTrOIT2wXoSERibAsnRM7+JDlghpDeT3SxAFhQwKmC/4H7Swxr95iCvaa+7dow5h14WRoQUKBRYhzV/Soy6opRGZcpInSV41qUkw/DXLYFo2+ryqSMqJRQqfV5gdYnqiSfru4AuNqzHvtstIWTY3+nW6yCRxCFKjlk4SqHOU0yTVXe8MeTpNIkp1mujEG58fMYZAp0dACcYoKK8Rpxx2BD0OO+wvyeM/RfU80MENFUWlAVI6EFXdBmkG27oiNugCqU1dDT1jBcGUAWQVf1QULV98j1rgaeU4OIuUFgriZP+sk0DpXws9DqCgg4Eo4rUcaMaPGbVvINcjSsd6HTASAYahjZB4uppBKAIFI49TihCREUKziPwxuVpEklUiSDMg+KaKcz1S73QYS4hT5TlDbXm2rb57y14pruvgKVmWnojIO1JFY+M4DUtA9i8qKJFyYnOHSLse6TDqkaABsh1c69vTg8/3ui6j3hpPA9b1P3gxYHngnT+OSaW2gz3+DtyFG6xYuXGZV4J6lBja605t5rUTWlMTaXJnDXv6/Xmmk7NNTRlejAXk/C2ppEX1FxcxNYERMTUwPflNFzJQMKyfAASWkkD2+O0D3O1ZFn09t+1BWUB9wcX9iF2+gZymlHEHD8h8MuYe53RdGndSqGOm4NQZOKpEHFOgd9XAaXhVJ2cYxJwHEQBvmVmZIC6xEijlFY0viFdM8wXhT/iC8Cd9QXCzq74g0GLwesf3BeGrLwj92viCcJ6KuIBrp/uC8J0viK/p9sL58ZjwBeGN+4IIKLEuPbI/vqHqCwINCl2DJroSokGha5BzpfF/Kvje8djAd8frHiP4fu+1Ar6fXU3OuM5/ORNr8zdTuofyqiodX66tKSEJZNLrZrhCYmUBU7bsJXmsK2zdaUUkeCTC/VNdLA8iIhNVHbAE6mcUwbbGzLiYjsZkLmaWZ94c/6GsgGIRWc7nTQpwbif20pRSGo4x6vsvLRYhxVzsBwd4/V8EY7Dch72uFIu/nB9i8Wib9XgL1fjiF+5qyQ2nQC5+uVe0IbB+5qsuDrnSOblvTnMHcl7vMS41hFdxF2ENoa0cWpbQNg4tSmg77k+9GCHikC+hHM2XUMHN2yGbuR1EwkXnO+Ul15dT5KXQl1PlZVVfTqN5ftmqL7vkZZu+nC4v2/XlDHnp6cuZoKLmftrpejkPOoq4pJafRWcqYPByNu3Cyzny8gQ6Ay+75eWJdBpenkTISMWTKZTnuXy5rHgK7ZaX8+gceZ6PyD38w1svoifR2XQWYi6gJ9ITELhQk2p0KqEZ9GQ69+HPelwmpyMgmZ4ot9wu5xo+56EEJJxF59N5HJjc9uGLs/FznnyWFefzZ7YFIZ1HKIbLRzQKQO2naO1PoT0oW+u7Quu7gC5E3FMkjjtWKQwfmMIQbQvbicJq3BXtgXx4dfFEZDyLztbGI243N9MVVuNEyfMEzuMKk/UnNLceA70isgOLzg6aUwZiC+63bqEuIhnjOLLlq4xCdlWvWJvxvZqfltPEP+40meFKOv8Opsk3p8k3p0mQYlYEL8q343Fp26PtmBLERWyjND/DTImMC5w1U+KMRz4lsuqU2AZUPpO28QzUKcG4SCTov4VD2yXUA8JJaBXorxOGm3K6oP/pFq+fhBeL1zvlZYedC/P8ssXOBbz07FzAy5lmLlSQfNcEkp9aRfLTKkiuaLBb8ZmxANHA75UKftvh2k1nYaQEzzTODHxokPV8JAuCfuqd/+Xi6h+GHXjxRHqKYO/F1b9iDycKEkp1ijTnkY09axLfzZyxWKO4/2SD++eOoOv59GQUCKx1GPYkRVc74RT3p6ArPVp0PR2YebpF1zP6GUjSNkQyXhiqrvpcW/QS6JmUgiJa1NrBaBjy6OAJ6nMm0OY0YkpmqO8ujtoiyHR6SVXP4HJOFbQ6lc5QrNgtL7ssjs3zy+kWx/BymsGxCvLsnECeUyrIo6A7Z5IOKojOUWqngNmtUH5CSb+UbujYjUKWo886OcieCiCeaiG7A1LCHXQmIhkgGpnC0+6LCv5hcLENaZXkpLQAIM0JGWjmAfjt8lqdYYkNixs49jXsv0CgAlW0tz0EJfuSQIAo3Imo49MMvQeKC6l1PuGf9/fq4o1hhvpRvw5YQ70IC3mPs/HbKtZHJZi5ovXV+bnypPwpiq25IfX5+Tr58j1i2mQHNvg1Hd4aiMcqHqdqsae5VRF5dPmck9cAC6hkOoMfweiieeoISlB+lpKQFXk5W+moEA7G2DPtokmMtqe4RbPGC2CIp6x/xVNpt7xcROfI82mIfLrBHLdoXmwXzb0WVU5XgqNLFJfJNGXTJdGspHtG1tCL6GklybhwZEUM6ULNqwulrdGQuKfS0/Gdrnt0Me3F24X0lNECNBVkzhWwS+fBBZbanDtCZ57sCgCF0dQnaLQWcBILog8Rt9kAzqd/6XnxdeSp9DB4qW4GfRzEBgdUhqdiOU1Q0aMKwicEcZc46Z443Y3l/MM5eKsp+QrNWYL4HlPZUriWHbwJVTkxKMTtUuel7upyiG1uReJp9Ht8CmTaUmQVfXx87ts+qTzmFx+BH1QI/Sf8oCIurPhB7R6AgUAR+F/Nb2sn8Ir6C5/4+U/USq+oL6l4Rf15pHAkP85wTlGvv8k5RT3ZKp2LVC4ve5WCNLsBzwlHppC5ZjciacyX6asRV0vf7Xs+hC9BRfgSOuGLRIdwDxtxnIIqkvFALToMyJGH2ng0238W0kWYp8LUimwlwINj+YGcVkYailRDblew3CKwFQSmAvR4QnIVbCJ6EWe0coJNgXNGO0VypQCX5labulkbg6rg6gQaD9e/dkzjwX88NR7+3PfqJ4vjOnBFfDxvv/HJe/s9ka9fFFQvDTgWCUU86pVKYhlaHDhKJVX/vhh49e+rB9ej4x+jKerRV0cbYirIyTAPAMryEeoD8I3lBlb2sde6mREfz8WvE6x9n55UcloDYnAYSt57jVCaA3itXyMMhK+rIegbUCUoD3toTfzUjiCUGn4qWDSnCmr/FRNPbNt84U0V2zbeheZ9QXUKsgcFkoJquO1010N6M4BhyI/7kdVa5fPkoF1AUS3+y6PF433z4j86UvwDJ1H8Q6PF433z4u8fKf7BTYvfWrOXm3jGH5Q7JQiZK0urOss+aS5LfPwT1x9CEXpfYivMzIb6cfbbB8c+vdTzJy0NwcPY72jDsjeiMrlEWhPsUQNCP4zYUXO73+55BgI3GdtEWPjgfgWvfDurpSAoqlRCO65ZFFzy8dfhMgxUHhT3qtdQfuRVx7+G4tfSWUfJ+rULa1GaLshkaGGYoLpyCGWINUrVUVP66UvzxGsXIz+v6PK7R35r+NklwXPX9uemT/ypYVXSeg0EZnf6Hzdxfl6zTrfU/bENKUMtL9kb0CoN3jTuU/3HxZXdKxWAviGoWpAvQ3O6L7om9goRSI9QdHO2pksMwKnKm9J+iUCI41IdFKF0mt/D6OgDywaiQxMFeCA2/R4ecVODAbc0BrBBJmVt7PBj0fe1SPXdJ0Vqb7LbdFhzD+0QoFbQ88ZR9Dx4YvQ86NDzxn9V9Dx8AvT8Oax8EwhiT0CdazQ9LAqFvaywCQCY3KBTV9ZFgLWsThHxX7mWBaXfevXynf0EGlVEgt0Ua8PBXBhkjFCrqzqWZQyYYNiY2C5jvq5aPr5o6XIlhdbP02/VUXiopWPpQiVSg8IBD6RlP4kGrQhyqJ8yr7qC3YLUfyNQvekbDVQ/dlxQ3YxUIXrPBzs33Zqssf6omxqZ/OIqBJ7ypLdoRVplKVry4uOlELZEpztPoqdKLea43nBq+/vXXrOfc1U9fWpSq3TtCRaxU+uz4s8h5n91ISsqx4+89cmu175II3RmP7pO3foN3qkdQtfUvh7uPsAdOnIhU2ZKPr9sUggXYVgptLcaiabO3oicZi3P/lQZ66d5PizUe2i2lK+cidJbQcrsp3RtWQOpRfGW3pKXfrcUfp90Ux3P3Cvh1TWAo+KNUtzd4WevBM8Sv3f4AE5BZYlkVY41+5cmsjjeW3ssq+PArY5H/t2tjsPJ1fFksOgZXjANGwItX0ljgQas6bA6lAgsSihfkzyWkfsZN3I/++9u5O58dCM3xrD+vKQ/d1OGlYQzXd0vbCuVHOwuYV11Mm7Ks9JjGdu3u7H9xX93Y/tLj8vYvkPSv2N0bN1WRIYQA6teWZ8tA3sRfi4pqSz504f3MU/dd7nh/ZV/d8P77n9jous9lpH7NTdy7/13N3Lve3QjdxLM0wc2Z57Old5fJKzQ/tIG4G4ZZRIuyc1XdAR2Nc1IZ49lpD/kRvrD/+5G+te/vnN0VUavO3WOPvbF87fcyN39727kfvvRjVwTm53fldi3eCwfEHCK/jNv33FigwLchg0u3EM8uuriPSRxgJ7Hqrje1yurKlTHC0XOWTS6XxcKHaZyYxt3U3Sptbrt5cmKYI84ZLdG8X2z6zlaSz/iRdBt9Xk8PWdM2CGLXILcM+0OdeHzLepd5BGeXfNM+mrWFG5ZUG8IVEDTPH7juCI2KBFThIc2rr8HzeqfqzAyeZ1Ht9CCOui/DLmvVQ2Cin3dy09yztyPe0lwP+D2ks9b23wGdR/LDPoDN4P+8N/dDPqjRzeDLjnuONpRTPhUnHQkQ5zAfn0o4Kfc+N3z7278/vhx2T786Qm2hpfIhmGf7CB2y95BDzf0bANync33DuFjGdv/7cb2z/7dje29j25sn3I8DhRixWwK56mDdfQxSdfuc4P12X93g/W5ry8TeZYKRqcvgY/51PCv3ch9/t/dyH3h6zty6mo9+zrJRR9wI/fFf3cj96VHN3JPP+EWfZd/tKO8y2aU8qD/WEbtH92o/dO/u1F78NGN2lN51Jxil2jXAaBGwc6HFcPCz/5ZC7dMiGn8S6f5DEWu/rEJ096I/cjU2F3TIlcnIt1Q9k23+nj1cZJ3UNXmSNsOFTl1ySXooSDTYgOcNibpbzwrgX3qJ17XenlwXfzyitHCY3waHWk9ahcLlr/Q25t9ijA4N/ETygw36jMYeBRxyo0+F3zYR/h0fsJwDqIHHkdnLngLN6JiNkkgDAdDRX2fuP/b+Ec2u2ky7Ny77wv/AbF/cDFFpTsZ3gVz3XmC5yE/b6Bub03LB7yy10jXm9lr8cyxO36whpT6GquxFi310XNL8MKifQC6t4ck24zAx5dL9xrToUgciVOQvQ4RsL2Kb4EgdYphCjzqHw70ziWCvgSh7j5PbfGhtxiIZQ78XdYreGQulR19ikP/VHwO7y+W+x6suS4DO5f6HFD1wH5CYS/viuHDxWcVW4wd13m5SeMpDGBvIuO2YNKm2esFOCH3DJqg3YqFVqkrX5JnrVjBZO0RP1r5qr8XAdgQ0J32ar/Ot9poSZ2eEjenNBI0cL7SnHV/KTPLt8Lsp5aVFdvxWCgIgOLQap7LbdTVvODnDs4Z0tZ8Jy4+5NsozHfSdrTolJFbqQU09k/FrdQdrCKYn0Y7OcCK+7voVN7unY5XDgGkuHvGr0w7gwNQosf9iZ352bQtP4fy/AkiRkFn5uAg8AkkKvXNQG8PzCIOlmc0xvkO3G1uHe1QZevddDrr1p+Rs5Y83w44Mz+XzsmfwiW/Mj+PnsjdeRKD7Mn5+XRuvoeeIrUtQzbxcC2o5RfQ+WWYtd3L8FMpLMMsl6XzESqeRst4smL+A9DFD+VlL+2RZx+Rz+Cfh1MMBT6nC+kCxH4LXURPRWBfmcyXUIpnlnm+CNX9vdRH4EJk3EsR32IY+Fzqlzx6Gj0dKU+jp9JFHJgU9uATqeAi/S4ons7f2cqeydVLOXsJ0ShBol0bvoX2oQL9+i4fX0On/xmIvFgjg2JvtUhORSYuee/UInEjQbuFr4/63C3pyFMR+VSNDIqLqkVy75CJv7zIFWkvjyzjsUzn43E+7cFjD/AB+H4enIKc14+hBE9PhOo/48OT5PkkerI8+ZKNPM+lp8iTLyliAu6mHbpinE67gLhn4HEGnY3H2XQmHmfSOXwtiNH1CTBf/AQ6C9/xDbLRu6inuLuodnL435wc35wc/44nB26gFriB+iw8LsViAUTHxT+dEKfje4QTuX51NqYCPesAitvJdSJ0FmPwt/J8OJXnxWmPfk7Q+Jw4h7H/VIbDWQyDM7n/p3Hfzzbz4pl0Xl6bMjd2BYzMlblRq8yN5ercMCh/ES2beVGrzAs7oKHigQwrUNrE64wr8VuQGzj9889+3v0/9O7PX2yfxdMYC4qnE08MILwaXLTP4hmcKPilRQsmAmE19qLJKYJmcBKh1HKaPdVOF8SW7aM+PVWni2bW6F2mO0+Xau1MeapWfaEUqZGjaL2LLkRpY2itqHt87N6Fxy56JrD7mQa7zxPsPe9RYvk5dDpQD3dFGd/Owhtuw58BLD0Nb6fR2Xg7m5GdgOzfis+/lZ5l768WuL96NvgjoPQInp8rGH32Aa61XwPWMw7u5CLy/MnBXoOY9GRG2yR/Kp4grJzxSUA72s0o+QTu1rn5E4Gg6HzOFCEPGVGXGVHPBzNYQczlCmKGU5BQ8c+R4CriPbUkpzp0lv5WMYCjkcp5LzjZMcMo7TGjtEugj6HD85mTowawPsmOylPodBkqQH43PQFvfGMQb+fyuGYYVnPb9Wz9IKeCTnlRwT/2titcWed0Cu3gG+mgHgz9kLbjgtN2Iv2ox0PH5QrXHSqFUWrCHnt/D1daS4oyp7EHETt97SVmt3nol/h263mw4AR24AyM73l0hiF1T+R0fjyJH2eAJiLuyUgHuoToGrPe6PZ5yIZG7zaLQv40Dfj50818ys0S5OdmWQzyvgb8/BlysR44E9JudEqvK1dXeDSkqC7zT0ZEda1/CiJ2uQUfjeI5Z1b9b1EEk8W7uIR2yculhgR+GyIvK9ew6qr/bLvqP8cmnytNs6vtt5zMcg6K5liES+nbStq1j/oV3JQO0z7Nr8u9rfWJWusldBm+1QWbnk3Pwds+unhKIZaeVgrZYZuuC7gs/m6Nf9p4IaCTOoEcZXUTCHMlNHNlt8yJ3fb+/BnGWrxuFWv4eaYuaef3+WL5fiYNM7twQV6tLD6JE3apfcA2LhGfz1l4Cp2/H6HLepgY6u/vibRIbTqfN+AHcPuZdukdrxcL/0B8+xofsKL7njVGUNm/5ssgOuq4tTZ8t7qVpzVEoIc20tpMV7f/6P51DCh0gmmCp3RciMH56OD59ExrRfPoFphrW4Dv4wVahJyOW2gtvsEWHixh8h8sJ/IT93C/nXwYUMym7/upA8AsKXwWjJRilXyYcoRL+JGN/+L+oqYbf1xF5Po5IBt/wB3bfpU1cGOpi837M/Fo5Vsgd0Oo2CLxxTOZrOzvy5qzZSN/Ltf0ZFrI90htGDgKaJWp2C3BAYGYdV1yFM5E49uP0HOHEijiI0Wd6hWL4g8v5Beiir2FUs/z8ZIUT2TwYtQxOtp3hnigl9tl2uqk9/cysYVgis7PGS9EaHGhEHNZJTDDwN+g5FFpwi7OBHKnZJ3L9oH2zxRUXeQJHD8UrNGWqwVJzlfkM83YVSIbR1v/WedTyNEoYpmTKKY93EQY/R0ae/ue4k7oPPpz1dpf4E2xyyIM6BWw6cmIfbIVAzoUWaGuyFUA91KaskWlKYsnL01ZgYyoo0KVeVoUoUpXhSrdUqjSdUKVLUaoAnPV898Uqnxz3/jNfeM3hSrfnBz/N0+ObwpVvilU+aZQ5ZtClW8KVcAtU6fHA2OkK93HRbrCfDfjwOK/vnTlm9KVb0pXVKxCPm3lCfAsxrQlI2B54vEFLOfRlnEhSo3XyGXaZWxvxlSryEzCNURUBCluM4pHOE2OQtmkHGVJtsXwY/ftkKO0IU5p01bk2Wpt9Ec0o5oh2KdnX4MijYIgUztMKbSGFqQ12UD0WzQ5rCQn1WS4we9/tLbmSrXeJuGpYK9+1sRn+yY+W534SqKzSrR6bXBKLWX8jap+wioyqohzAjNVE86a+8HxzVRdgq9Vvf1AeZ999YAYjHD+QWHbMHsDmtJJJ+JvQvwjtHd1HCsB/qiVgMBaCXjN42yuBNQGk0jtOTqDJW88gVvnP41j+J6s81/ATpzt9ZVG6XcVzkjjNRmNN6EstaE3iPF7e1zU9/cb4maodBA5hC+N0ivfIG9wCXfG4ii1SRH6lOIBD8pIUKvsiAnFKUPUt85FDweotk6RmaNFwC+dIrOv/sC5MStmMYhHKhFz+/4qzf/y4a/9HYeDI9z6H0Pr1WcpOOZgYONsW8uA9PAw9w3PQ0ER8UIWiMeiOv7Ytv+80pwFtJOCC4I7Y35qixfE4+daAUeQWltd/YUdufWC4C7k45REfFoiZiNWKHC/1bJ+E/k74uGsI728suAFOhIc5UBg3DuoWV9CLRy3AHKxQPNKLhoUUkJzNDfgXnLvh+V4vG7v+kNBsYjc9Y0iWB/wW9T3+4z8PMu5Y9FLOY2il2QfrVo3dI4VKVjPAwxWV2wqzjv/YEuyQ1kwH3AQ6TKQNMttkY94NDFytDQYWnT54KDw1fHzcFAsA5LI2NKMeZe/9tUbtJTRHQ6HAkW4116mlPOYcTXIlN2MN+fv1QMs0dxi4VIltxX3w0tgVJ6Vd2ghr1uvUJ1nSraMIZ7p1yPY7lzuxzoxzvPv1BEs3cjy5MHkeuRU5A8WUuMn4dqIp6PPz3l+L82BPeA5f2BCKsOpXscitp7SUpK6ikp4yN7Mwxz3PYpFiy4+Txawh8SbU7yxDjzvP32tSDb2/fkPLfzit/65zw4c+RPe2RaN7GExN9bkDx7gD+x7yu/3Vd5bkLZL59wUzNslTaDGBrtWV9F8bJzhUKPqwdsTjzgzle8HQx14cYhYzLK0txw6mY1tmuVpX5bwvVz5rGASPxlJMUJBxfdqB48OeZXx9yjDGp3JeIb9uxjz0+zP1BcOhQrAEIBe4LeFNQw5fON52QeMoiCtaUKyb/avz77+1p+85mnZB5GUz1GIFMaOgUch9Cqzo/oNxS5OMUZryrQmGKQRLd45eMmf58cquII5NH6RH+cyq6BnBxbgdVpml+IBtcZhG6iAbrldgZuHdUEJi4WuRx5DAtDyJqFVhQ9IWSv7kHRjjo3A5DEee/IOJ93sIU1B10V0LdcOBXd51KUM7nH2s/eo1guLlTUFdfZhlATj+9mf4zv5quhhFq7qScBWX5wkQV4PNg0t2kYLSNlOS3jAUHpOW0vT/MTbztaBNSTtxHrOG5N7PRM4ZgNHbeAuT+Cz2k94CZ2cR/kpME0NeO2kfC3P+rD3VOSngaLlpxofToo0MchEhzcccDwdyyaBTjMBy95yWowtUmwPSTLh+zI6TZ6n0aniOpJWn4PEEPsZTx5H8b2EjunjXkTg+OcUzkencNEDD80ZnUuKYmib+Jf3rGtKaw3+VFoFYKVvHToVp3KxfNbRT6jQ5xDfbjNfW+Z7VcnYdtph1uL13NOiTkNLaBWEX0ooMspQmgeASHlHHJZV/XHniMmpwKOwloJXpMKTGUraSitgDneuydicduKhLXhoZUxPzTMZ0+JEY1qcQqeccDiLxzKM04fwNDuEp6Hs08ohLGjVzg0q0Pl4v87aU7nBZjRj5ZsCDKOD+sss1EPy2M3rbRTQqZyx4oG3YNJ5yEO6pmHcMJcXzOS9Q6bsPL8d4jedwJi0tBO9R604dT7kyWgvUTf7dcM7zmHTkuOxUKyg+SAltGVNv8134H0VIVKCEIMgAP+UAGznXuVK6U4GK2IyCFEIQmw7HkKsWoTYkWd0qpnoq4//RF9VDNn2OGJIYTBEsa8oMWSVtgHE22kV6NGBI7Qd1FkD0uPRKVGEOnaqK+G3qJIBVYT+A3o660nnO4OJOyFlnCoYokXpBAc1Y8BPneettSJ3M7t7no/+A7zlFnRZOCb4vvXXsLdQ4PO1gOwjsmaYGF2S0uw3dGXVyPHVFXv2jPzn970fQLBrAPjgxYh5cZ9PoX1aBrVZpoRF9bAl7F61iajGttIt5FiMp0fvWhvrk0avTo/OphXSmpI1nRLXnIxjNtGZgH1rGMDtcDDNw+ioK9x+2odPrBm2kNzgZ+OyHnbkanIPZsLhXYDww35H/xCtzP4Iv3lozdhxabtQ6Ma+H33mj9yTX5/stR7K77+YefbduNZFNQZOxQ109nEpI1Zu9RLhalVn5YKABTmQUJSowD1UVrNOgYoLAjBM6EikW/6MguwTKPCC4HnmpC3Q+0+B+ghLyAf/nn1SaZFYuSsSPPbqrSWTIZe4JG8AY56Xx9ok8hm7b6UGLoe9FF43N0w/tKcaGtjg4CLez8RoiY854FNStSmhlV8u9ie4YjFvoVM6Im/D6pjsHVLIGTbWs08pnCQ/t9hfK0FI8Trmm1ZiqtCyE7dXCSgoHWoqmgRVQ8Hn1xwahGty14s3sf2DPl/bR8UrHJ+V8TbuRLIb2DF/JCbGH/R8SCIMpt47Z1FVDXfodfj+PdDx4coO6r8HLz4/sJU60hiVSjjq4BsjCGvsc0wyKpDzyMduvLLhMMFde9eVOXZ7GZfpjqGOhoA9quwmIhAKCC7vVbofZH+CfFpx38Ncyv5UQMdp3D8H/8/MtKPrPFwjuxbPumz64DSv8fK4NCjilz7DAV3xP87QWMv+SpEZo3M4KBKh0Vh/GnAWAm+wmg9iRSw3C3lLBCri7zmgBmQRDUgnhkVY3hVjvBsRGMzITnijyNbLe2UnkhwkmC7Pk4YWIYUQ0MwOiENHHMiOIPLIIA+RLcnnpCH5vDQqX+gfU/8Ms/w1zKvqGof6eE3iH7PGddBjFn0coWy94C0S5x6W4op1Lk291RZLWAIjnM0IPIiDXUpEJUyd+q3QIkOnh5eurPtbS4yCoMeyvXClTG3hSTAZt0OVjIgfYZFbVbICPqGH0h2oge0g2pBbbTtpNT8l2AuHJrRCO2VRrjAPvGB25QjsNFrOI1oS1/BLXKmssadxJoqQjqynCRw4V4K1NVF/oX2fTmGlsV6+C2syDkpPp9M5t7zpSYKC3j6LMziVU5CPH+Rz8c9D8eyYhrRp+VlmIOC3CU3AUGgrkK06GnQaN7J1w92//cLd/+2+i+0TfTMV7/kW+8QJxell9K/bJ6LPRvRekQ3Zp4KHJOWKle9917H326dL+YGrg3Nev2X9vfaJFJTGaQyH08rD4g/aJ/qC7qPVCPMD/6ELH99z6AN/9c93vt8+pQsfece73v+Wv82fbp+AHOLf/h23H3zuK9/0Afu08YcXf3fLwPvnp9unjf///sOHlg586D9+0D5t/LO/C/9++mL71Hj0AaoHZ0808tpP/P5/vvCPP/s0+5RCPn/7ma//3Gf/8wfs0xb+iq++47v/YutvPd0+bfwnvvdD3LgzPmifNv5nHsxmZ2evv9g+bfyl0rjf+KB9ukaeQzyenpkw9smD+e2T7DaPxifh6eY7it1TEp9Iu4GKp/PA/R7X6Jt4++Rvvp1QwMPfwSfS59AZhILOINb10c8q6WdQS6aBbAGexChc59c0xPMscOr8PJOfGT/P4Odufp7NT+Jpl4tsRZiIJ8ne45oiejHPZ6f/CbLG+p9zQwkUoVCzUf3P06nOQjSSDzmY2eA81TU0HBbZMJ/lNLJp/J7RdrAkenp/Ll6S4ilQGz1PRapoF9PajqFo7C6MIpmr2PfSU1Rt9Nw84mPyBPPWko6aIx0ouUo76HzOBIic289QZwdncB3K5QxuGxUUQm2UVG000gbkCeXSnIgiaTklQu1VMzQC7IpzlXyfa/U1E/ApSdkAtzGwp9+7QEiYir0SjqB2ohVMNJWLWagstgu0lWaelUdyUJZvpUjFtg1d+ZrCZKGVvhXFXh85vwqHWZCaaDzYMr6Q7fEzYrPy/ISA7lpKwDEd4lfY8L4RT2M+OuAWI7xaxC/SI6YiYg7mZSgA+zEkcwpHvQSF9IM1Pv0+z79a+L/gwHn+Ac3JB1RrOOZ5AYPk0+BUKT5gGNyGcoerupTvPqAHIHksvnLUFzSWI60caaoq2xCDAGicmjSX838KxV65uiFH6z2uFVkUptqvrrCM+LoH09nPowQ83XdSAp7u2ZSAD5fi+dOGVIryhZX+a3Afmv8SyQ/5pcwaj7zKCVwRSGuC7PP6wS7/6hxQbZznn8UPCED5kWBlPs+/CEE9ntwjwS8geK4E70dwN4K4s449B4IPIXanBA8iliT4ZcSuSvBBBLsSvAkZFiR4CMEWghBuG0sOB6guaJp9QZuK/mgiYvX0VRs4JbZRxiifnTCyWRT8y3A6Cjpcm46KoygYV1AwsijoKQpimBUFI4eCjHxAGR2kA8jksM6jaDrWQRyIHYlDtFCoTYlogUG0kDxFNONrKQCiBWYjMologX4VsIDpuIjmKaKFKP8EiBZQUEU0T1rjVREt+AZEtKCCaH/zOCPaL5y8Z4VwxLOCt4lnhWDcswJ2NQ+Melb44RuqnhXK4+gIW81/I98KP3LD8XwrHEbqo/RB8KM3jPsgCKs+CMKT9EFw9WP1QeCNaheEVrvgJzsNX070QzlG9K4L+M+aJ6mN7KxVmvJslabs07e9+rYHWHoby27wvCDYJbvoXdhEY5/GYK5uwzMc8V4QYM37CGYlcOLHdW+qu8DYiZf1Wk18weYfpbqjpaKOx84iUVs1cvYtu8QmBSgW9LCO0tPbhkXrgoBQLqXDIjWFU5PiYdEUWUxXI44UTa1yj6nxJ3SfTuYbpOKhBbepPRjotyk1ENOkJmJoSgktLSHWEmzTKLUltLSEmOLpJYBH5C4nVkjkjxxvqnwB0l0vTXnsZiaELzAIKPYABWD9rrBnCc0IRqIxOZpXB9zQRgCZMvKPcBvj7CfRBMVBn7JBNaaGRqqcX2n8bQC2fp9Sa+LT1mafdvI6iTRhRhacGWlxMWvaDHr0XAy0j1bX0dmXAdcoO1K0RkARUwtLnYD3CEZ8MKTWelUhpIXo1oAxofzw+xXv0juKtOw8ZymagEBE6Wg3mgONmQ6BtAKBaBwCzeNAAD3NE+l3PpvKiDNMGoBJg2ZJYGAv0cGGI8fCqmMRPku6HQ/zOR5TmQOCTVneVIFJjEd3clq61w9eB5tCLUAzpSa1jhTzQ4pBRI8UC8PBbTRPHLFAHC5a68DzIaU8maTaAc0dYRDzQNxhdVVwzW8UuE2KpLOqvgEJ6Gh6XLLwz8er9KJNAS1wBdKLAYYGFnHb3JgYBfDYjI9MPDEyuyx4R7VjGn0CVEO8jAO+A8BD42AS5hcp4BOVzHb6e8QMUcKfRDyNZlRdMCAOJA4JpKGtiYZuPhNEpqZjO6sVcjsixn8PJXel+CN5C8+MUOmRPKXFvKHu8aHgBzZApzV3++o1oU2MyDwTqK4Th58vkPg2xvpIEd9aaioIEY6gSIP0hSNFe8ggb2qvMhTDE4iRYGyARwewRW2giOY9wWAHmGyMUgNHehYoRYRMwHEC1DwOAQK0dCgvymd1mBkuwsiEOp4Rcyx65RFpi9QheRVZoLI4WuBnsAxK0KUoPt1i1q5AWA8kyAwUTiLkJoB2g6/Rcm7VBUDWMRd7m8bykmtZs9/xA6jalYvxoOF0ekQP5Bb0A3pkopV4W/ZmFKFR6npyYkXQnJoR2tZQWVNeQlNB+3Fcqipt/JYnkpI3GLmbgkn1cjIGSkt8rRFbtDwqDUrrYuYT/13ZK1q6rAsoKOWI9Cqt9JZ4jZqy4rQJ04PaWFkZd7BVb4rhOJQcMcoWkTlja6LndvuuegZaEhxcQ5hwSJhDnOxBu+rrokLZv0XrCDhQVaH8+c1VKP9VVTlvP0E73vT4tyPjdmRjbaJqm37qBG36jdE2BRqt/KRUwvhRWmn3szcitfD37ZazNSUcaC0Ebz/+yVPvT8+Z/cBAiAscMOQRHgQeVjsUoP4FPPqJdgiqAIxNfU8YeH9vsFegSmH2M8LC15jahsA65FMCwefCOSZ42QkK0497IdTy8CdAUqe8MimwR9Z3jzyI5EPylD1GahED0ykE+d733vd/6o//7No/fdqVEFZRzPivClniw9edyOLBGxRUoy1DXVKoLrrK9kRUr5SIDMpJa5soyuuqs4XvtWfuxFeg8wjVEx9h7h+JI493H2GV2B0NSmIHMLOQIwDKlMsEVgG/fGPWLXJ2DqOKcsodRTwopLOyjTiCBQWkz79VSVIdAAafKwVSfTC8o0gGed3gd3KkSCi+ShZ3UNs9TJVaHqB1d42DFOrxcwhBDP6u7F0Q7GUMamBI6vyunI40oMkRMRh9ZKoJG8f5KMT+fAO9Q/H9G0FY3J4m1T1NywxrUrRvy2fkikEqI4uSEFYunQgTNmJoUPsImKOQZijiUBctvQ3ZM5OFW1TqMOdl8KgT5ciE8HQLxdB985lHXvPmG2PlBRpK4SlaLyL0CR3PYwDGpACAVH70fgFDXbMLpDh7guz1MTYgT1LFZK+8owv4c5q1jHowKDwdDt1l65qFLR6GDWM8yBMkk9F7MQ2KUJSOOcpTaFND1p5OdfgSqLW5AXIDOfZJpFmnjql2QWXLm40wpciUUstkYpT/NxXKvOUbTyhzx3GFMgMVyrz75IEVVYF1tLYJsMIxYF2MI/hRWA2nw0rDuhACbjQNbuF+Bp1oJcdCegC5CtzC48ENQFXYAHwtBV+ij1AfgNv6ceH21scgzDryDS7MelSd+umJTkXVTkUn2akrHlOngJCjnYpsp77Px/IIxR8rH1PRuJ6g6bIQSSMQwzthy/883UrPhhRi43WrNJmzOwbpSrEk/Ugc7AYjFMffZBL54xQHB0oPjs6iO0dmEbcdJFSFAv829ObnjjtvDj6GeXP9BIoFVRQLThLFXnZSKPYrJz+YMMxsRvPIh14VTRlMzRNAr88N6IDzYq86+JDvhvPXRobT7pAi3SNtMqD9+699odhL+voO7HuPO7Dv04H9js3Mi6Mo9FCG88sf48kLUreGcWNfl/hYW1qxGo6cC2vp+/0gxF7AmjzHCJfT6LJ2rTwwI51YOBbmP1aRkrXBF06KAhzNQ8hZORWPcRoeqxwKHz0HkENgP87eRJNWvwavqF/qXVMu4GV6kE81WTY6CAQGI/U1+yUrjK/Mcdd8Po7E/EZ1/FfO78TO7+wufK49S6TgInQNmuhKiAaF1QZl79AR+WLYkG3UdaEeS+Bvcoc4rsEXAqqK095LFZC1jaLutC1yrt8p6eWN8o1Yi7KO//Mmz2AnDM5bAsVWqaQ6GFJjvWg7EbJeJspnqK3agHk7+2WFIdhOSL6a6zSD/wYsw5q5lWbK/dgQrKVjxdtQLV/IO7r/hJJrVx8ZBYYVa0moK3NqxhDM7J2ojl8DFgEWbTy61HbbpZkjRTY8gt7NlHVxJOvarRdz3JUBt101LGCxqj3RwNR9NYdLesPhOmWUDdC12fXKRgwdeASZsaNNVbmNZtwQAT08GFqH8iyS59eqfUGyT/Nr1NZQx4Raruy8RSmQIDUiImeZCwWzgikcMAKuter+PX2b54WOCriLrSo8g4pt9i5Auq9bnBgqfQmmdIOp/m5ZsDncF0cNDckvjuMzkrizqDF14Vilht4d81BiAmFt9itSjYe9OROtC2shPxooNnauCZ5Y3Weja2b98Mp72KPHPumkMwM71/ApAO3j0zukG15V6RsLAjBugoE5XUrscxsGP/aqQ7rVR61n196Kd4Z59h5Ukaaf8wLQwujaihaujijLqwMl6KFx1CFbNjcBnXw4r7vYRKZlpDigJKWCAA3dMpaT1GxCY0qG/JDj8kEFF4dHMKfjgdmYUjCRQT5FLhCQPOZM0IvCiQxHeJg8nvjB+B+suyFuQfJAGQIh8eDEVIYjHfUDJPkkjjeyQgRpHrQhZI8gtwuQClGRFlUWo24Gy7HBTXar3252B5zXsQkoz1fc8JHbyK2zdyuRVn14T4b2h30v4JaLv4/Cv7DWQgvV8Yes6mfXWm3PGPMKVNqtWxqeYcgqDZQ1HDmxx/S4EAgNuUCEQolo+bpoBarRzm35VbRFC8QPeFL7bb8mj2zD3MHn8j0t39us/NS5JQEYy8r4HZVtnLAybU+a/lcMZK3qHkUdrvhG1AiYmXUdSYkiHPmmKl+GR0ZcHZjogCX4hBNc8Zi9qAPj8/gUj9cDnvdKxT+Ux/Oxy7P9rzCzn3H0xqddB18vpwfJ/6/tocxnPOlaHPihLbOvQR4hMPIhYNNNpQDcgeH37I3XG9zJfliJQPrfHw1X/P4JrhisoGOL8TbGF/en8cUFPryaeeC1R78BA/s7sv9C7UrPNUtgzpayu83E0bOU31ZU+Qsv8HEh260do/evF2Ri55HS40wd/4SIryFF4jy9qO0hh1SlYkuwzfipgUVEyrSb3DED+izOjOeqVnKRQiJT3aqFom7diaMdeuM2EX7T1+tR5path1tXHtWNWKp6+eNCzx8V6/oKYz/7KD7VBE2VEXJwTw89zgcOeoF4RY4TOEPulccMv+mOGVRAOH70EfjgySduOaEC55ko1M5EwpbHzF07Dj5ilz3CvivHHQvH7R2H4/bA4HqOwQVpLzlrH4om09jpqNwux1Qb2y4/0nqtnEhV3/RHNmDhfnGgFeo4xkYFVIeCq4V3oeR8kz/XBae62QqlVDxCfbhdNMZDnemimHJ7AVo7uaf++ccVO3QttDe/MNE0wvng0hyeyQH8ccdUx05wTPVG7K6tUQWs3eTbm+TcODN30TIk7sHPuftxmd1qtf6Wu1EWGn9bqrCBnOpXmEJFO7AUdTX4WwRg6SXTLtxDk5vUGOu63vmIiwbnFu9Rddscj8IcHKSv9nDlc/wEevXSmcQ150AN8sExyxEQUGlK9SM1C7PzgdBvuatY5MieoXeeiBPU9kFgrv3XSZOLBNfkcDoRqzNm7MXwWdPsmzwZfix2dRSTYpAQgk6Kbpj7mCgwCYxNUSJltJXBmlEFeCmpU73ylaGUhDoYD9RfYGuSZxjrTO59QgFLdCaaGBaTM/cJOyQD2oiasKOgt8UUNBF+/BK0AWAaWGfRbrtulTnaSl9l1KJK42BWiVIl1U1p3iz2TjTLRyYZNXFKx+n2lA77iqC8XXjXRUPpAEsAP/bU677/LQN277XvJz/+rGf9w8x/v4h7lRmqr3f3Ith+816stP/tGBicX+CPwenr+Km6rGqVF5F0N5buFpkK6/ShnTRdjpnsgCihy75BJcyz0Gmghm463XXywqpWKav65M9/4uennHUgz4Ss6hPIy23jxydqTlr1MUxDbjT/h09jRc1+a1NJ1Ute2G99veVUv3dcOdXvKLF8dpUbqZq9CsrTZmClzHWHiXrELMfHbgfh9oMKUjBAWkvFud3vTnduB2iAQ30muFipP6zWH9o1GiQNFDbEJ2ULKJI4VIPVYxOuzLXKsWUty5V9t+dPyuvcCm69WHP/GXeDMf9+wahvQSe5e5QC3t+dYGVbVU62NcHI7i4Z2TD7fXx8Ar71+N1NTr67QLxqd//q33ICGnGxrpqBrqkBZCCIQEhXbA2FZq6YSRrrV3jYt3DaYZuZuV+3I7eTn7nnbSaucdzyNJnNNSyS6md6ml34DFzd3UJJDaUB2kH/ifza350zn6UqfxiS5ypK6I7+UiHqyMwpxl4B3xjKPX4EB3K0ItBoP70zCBOjwzLJlaFZTjA0faIA+RhcmVr7D5Sz+rRyVn1fOLhn3Ah/x+cjj5pDxV15ubIUSaPxCUVrgBVIpipOXq20TVH7f6E8Rb0WX7EqkK53uyLUyhQGOG9ZrboiNDQ1ZQQUnsJv8MeiH8B4DK4ei3XeIG8DYmBZ0PxL8xT1gknKY/AGCtnRC/jN9aKl4l9ZarXTav3Ep1b2o1NTPBLdOccg2ItXkQ5GxIn1fuhUvcGLui3Z6z1P5WlY+Hm6OpH0EDzbvh3PeFPryO2/9dThVVZZ0mY5xlmGeVgx+ESBsIpe1fBVEQ3BVALjMGvWh4UP8A+KatHa7PQ3o9gXCxLcIscSHgyFJ1SiArHgnT92g4gFGV/vhIQw+98yd/oQNGhiqnzKQamKvAMUwsCA8ChKgX2zO8N0vbTXZoWvq/7nn1/38E8/TZRQ1KCcHKvtx+Vykc3h5lHeqGQcPzZo4nbihoMf1TeO2LcPDkZOAxRHpVVAUapIMkVZetJMwODi4biZgIFcF5CObKwjPDyiNi4wktn6pDgbXBZOXWX9VNBpE/qerrbqWtUKfAKQogb4shC2zPIM/aOOMgXWdktE/Iiqtrv4P3T29h+sHbrovvNfmbfd0URL9hFppVljevSzpjt8ouBaTrOUHqFqzFD7mc9KT/O5ssCLj2Y/I3g96/JnbGBOM+jJwHoxS23iP+aH22XCl7l2G/5Pe69Uhe4EszimGdzKgEEMMWU4hjuWEB4M7ZyK0zf4KucIKid2oTuxMzxxqGIAFQ1EyhF65mqb48d8xK1hHdJBQSbNghdPT9w0HzOZtpRAs+AlmDiUCzY5lAshRYAtSP4rpQjhxKGcaxh/om3ibK5N4Vr1DA4Om681tMUMbjBUDAUtGaKxVZqDuCPZvfh2eHyjH2jQIzLYOnJ0EYIp/MtxVvX+TVhVX/0wv9+PArOsacPY3MaEjZCDjdH3+xt9iJNFYs/uqXGh1pEC2Q1wLBYVn8eqv9FcM2YsBuBuEcdoMkjXCLuoextILfeHRQBE9dkKiDPIoovWGHEyr3vYSEUM6kalEZg+8wNU723kIdXzwC6eIEq4/Ln76g1DdyisWCwx+rR2f1pEaoek2hQfi5LOGGkRBuB2P4TkDLQdFVnrKzXwWHgClCC6Ys4zcUBq4MiXCT6SmuTl/uThaguEZa3cQYPc+VRHU1I0MNUGuo+odSsYMuZp2ph9KviJuA5ZwWJq8jeiIYmS+a1/UCCv181hgJgb4uPGuI+jczWE2sZRcAKVXsZWAYQUWWUk9HBDjsmMZg35OnMa6Y2Ps4TT8sD9sCqd+vPjS6f+lVrxmRO04sOTE+2gNznT9o6+H3pGZaYdfOWUmcax5Ux78Ndr06bawd+s6Vw7+OHa1Ml20K9MNtp8sh2+ePjIJtvXatdMzDYs/JOzTZdwbcvEbCMz296hs63KSfmls3iYmuPSEPf1nHVo6Nisi8tZFyuSxHbWRVNm3dHaZtMunj7tABEpE1bxaLNpF9lpB1jahbuRvtPzfDDDLDTz9r0c5ml/6EY99q2VxojWy/BFlfBle6v8ydRgabdrnVdj747cQ0Wj91S97BfQEgxp9sNWe2j9CNXkE90AcAR5iiWccNv6I1G980dU78JNVO+8cdU7aIs8NKp69xdu8+222xGm+b+R6t19x90/f1YX+pMG1TdB9aiEWJ+bEGL5VS1F/yS1FK99rNq94ajEz1dF2Ef1ySuC0C5CGyDB6HP/B5RwG3eFMfaabiaLwh3DWbRLgC71ofoQLOpyZALpdg0Ey2jRBWAVhLaLmRq9WdhX8f5zqqJatXK3qagWbiGAVZvJah/v0qzuEJenZmJUY43HGaX/rZZuhBH48kRffGnKF7/Yi1auC14+Ikm6Fxudqjxgw8kDZJPwNryrNECTZAfxLgRT/eLusS/e5764233xEfnCsDtYrPXje8Y+/qj7+B738cflY7DQciESZYgAiTBRE4RWEWog1EWoidACQlJlhlBLsB6hNkI7OYTnWfyUI6UZsF2lkk7nRUVGnQP7YfxwFlWuFnMvyudliJG+QLP780W87lLfp0HuGyNPOJtaoohmXwznmzT3In7MHdgv1lb4fX4/1Q8Uy5CHgF4sU4cWQfLyDvlAEd/yuXL72YxqDceRXTwo3yKdy1f6Aiy0LaTOWvZ3xpx+BvMk8wfWKEWNYr7OV5WwY8hfdBCUT4sI/FuHIlBoYxBqBWDxDwhxQ2siTncHkSm1aW4t7/UFLSQzZvcDqBrFSnTeBk2TxGK+D1rgKl91lddRqzszhFF/tHeZH9euiVinZi79gbNShpVa+Lu0h4xqJ7culpQpXZMjRtywn+Huz4E8moEtYD8rg6kpsbS1TYrETXjlkxAdysVGfEBz+ARW8orttK1iGjjqZ86G8HbaOpJEgBMGr/DNBfY5gGyOlizQ0mqNaADBTFflfkqncsdnWYsjFHfQk/LUTyvNX2o8dxk/FqmD7NKmkAUc0QRjdWyGwcWPOWuNHqYKRcHEEV1Sa/PLBorVI1Gieu6TIjrpMesc+QbUyreSw+NkzFbYDPBfJwKBfqvFXsV0qyE6bzVEeYphcJvUoEy/SWjWOsda7If8B+63qUbna0oe2jJXZS4u9FUpcQsQEefn5L8obyhezgkVYXCozaV8VsnR/WPk6NOOHN3vyNF9CKYO3339+MGxj7/gPn7Qffxl+Vgvpy3ph4duHv3wIfehJsmHNyKY9qVJoC4HzLSTaqTXtGTi/L3avWUsT6A0TLh8HqcFPngR+yNouxQEAwlizmMOTNkiBwyEI0pxyK5UQXYkRs23OrC0jDkxp2K7FJGpMRJCyzKK/YdKEqX0SdANr2qhQeXDEZqDnDpBfExK6QCo8ByoMLeK5nD1dZRESklFR+uXcY/0RvHtHp4UYXQ70iG+pu6hco4DJUONAri852CxiqlgCFY+i/iDgHmRle0r5semFgbyFWuyfwumKIJtF6OFAeG52zzJPGFUYRZ/Ss4WufKM5oHxq7So5GxZyNk8LZ+YnPHjdo8hAyc8jqzJzOTPp9M0zZSNkLOMOthCzuGiCMrDKFHM5c9hiup8tRoPPW4nZJxcCCkZk3BmyNiSNpfajrRJWEneLCjaLC1dqo43YS4Vx00tB/ZZB/aZUbADa7n2lqFoKa0KRavAYBk+bgx1m6WZSermT9C1mdynxUdJ15hqVYgaABhVALhMSzwBIwCwBQC20Guh4w4NFx0atpQm9zs4/hJ89NAbB5ieA8zsGGBWBR9xPoY24U+xa0bK7NEsQ2IanuZbAZQWzcDO7mweQcwCbxDT83LpW8kXjNpGyxRZ1JzD6CoqMYIyshFiaiZmu+Uo1OZ1BX4gPMCUrQaLtgu2zAND5ksMAd2aCoO5MRjMMwz+JzuofzRzEsiCP8di9GgOc7KFJXzZcHgB2DrqjM/K3erNICC8kHo00JdMvRroS00cAhCOfcy8zLcb8VWgx6wQ3CujAXm2hyi8jrMjkXoqsFpMunICmKmdlnsZkLtJw7s5TLTZdJ3BtmSmREyxXgzUdRBPN5+OAPUiLZvpOC+4lk6bdS2Zp6OzLmJ865CSfiJfZ140OvM2x5z5KiOB5ivvgMVA5VM5jPXpmiYo5KbcrFn66lj6uLnIA+wH+64fzGO8uYlzZniWdcgoxLUeonnn4awgftdr52Zp8g/kHZAQsIFqwsYujYaTXkBfFszelZqSBfvX0hrgX/sjt1/8aZqxgTkQ0wEZ0YwN9RDqMo0TJt8c6QTuSEdkoU4LVqUzPnbjEMdwIjKU4piwFMcwgXDiGNmQBZvXEmotaNOoziuLfbz9ctgvX0TIV9F5lUv6VZ1XTJpInGCpXfxQVezlEeIhadl9FZ1XvUXpxCeQTU+R0Pw5hFknCWs9aiziSWjbQ0nVBz4JaKvOMYbJwXr8rBAF1d09oARTKKxUEqs8tkaxVFKFLzb3Ct9A4TtymBmjKQaiTskY5ttUIOaVj1AfNfJVFuZnX5xQK9Z7tBMgdmeX5530JdqK38pa+oaVeBm6/Li3yb/ODOuo3OKWMR76JrwrD32L46FvRjA1mg9jX9zuvrjTffFWBK3cwohIxj58m/tQk1REUn4YCqthZQ15bKUPeb0UHySlbKJRSi6aKugwjG2rlGO0S8nHTCnv6JQykEwAidBsVXQwJx+p/GKBd0Zoc5Uvpya1yafZFxWLByjl0CKz3PuLJWq9qKgdUH2NWVBSWsIO3EgzuAcxUmKVL9wl64QvGyMJ1vR8qAbqJDt6VX5ecDKGGug6FzgiY2jQrJj7h0Xa2T5GUr+xcoa8iSokPk8xQyW16Pbh+cU1ZItrSCz0sQZnDrJgJdQVd62bsAgrvMYexHRE4GrzvMI8L6cU0MKfTs7amphE3KIez5aJ3+vgZFE4OkGtKqNQM4wCEhEmw4bUDJtAJlwz7EirZBJWVCSiZsmo5riEFeUbalUmwbl2FibBsZ6JgTHWfu6kMAj6cjWHyYSvEAZBw5eDQbDKzl3LIHSNs0gH76aDd2MM3gB0SnUDLbk7hX39CIPQAzUR6MWVSPSZGrlPbQAUHCxZxoDiMQa9Zxh0VCpYBTahZawYY222WiddI2LAJkVcWenMmxcteP5IptyL8lXFK5U4csORUntR3n3ksoJHISBYFaNrj1pAUKPuFAFBc0xAMAt6O2vPK9tuD6J+M9pK2xc40NUJX6O0HItaRSxQV7AnOplngWjxiFigDci3afZkxAItFQvUxsUC6JU0m4nSLIgQt4pmq2KBGmrRgotWRSyAlbehd7WZwGIcW9Kf8h6fEQrkXcceRg4ac0BXbMTEUg/mt2OL57WVU7GeVrEZWzYfbXl01GaZuvgTWiNuWnl/I0hLC8rSxjK5GhSPkxlICWoqJVCiIUKylu6QdQRrTkoQl1KClREpgWbKaGVEStDCJndW1dl9jBnVufRZEBo9L7Z3KiJawJA4olKrEBWQFWktbSmFBBrOJG8XW8AuNa2QoKlCggUH/vbm4O+KHGTBEJ2UAcaPWQeB2BhDVUyfJEYqI6hGCiHqKiHSKzyzm5OgZIwEKf1bU0Ik5/Q1B76YmmAHOKN1CdwsRQR5RUyw4JByWamoigmaRkxQxcwtDjTdMdBEipltEQzX8VdueLGSCYGchqkqJljGXjimrqHMUd6anndETCBsj+Lm7IiYgLGNZitighXLFOhmrwrCBUqBK1sNHq0Ivqg+bokjU/s/O9b/Oq1CRNB9dDOySyn+FGRtAdisLv1thku59Mc0+1iW/sbjvvTrLVKQc06rrv+1yvq/2VRVJRSLlhzQ9T+eOhXTKVNxgWIzFetmyqWbrP+zlUhK8xqmHDBNpp2v0642Ou02x5m6TjglSnab7cQDHcpoUdYCt+3HnGu4OddWn72UqJygIXlikAxq6gdYPNHCWR0msHxOTtDjJmhTRQC7nXoqJ9C1CnKCFsgIhKGJtk5tSls5QVBxEPDzIZ+gB+xsbPoNPyhGEHSR1MZmiMgEDsMTSozyzFr3Q+ShWQ1qDNdhwTdZVzV4ZzBYgs5mY4Kbz6FEXfEXz+qPB76/T419H/so/j1wsXishqrSZTxS+774gr849CsP3vf0qyAwiMU+Xmtj/Q6c9FAqLq3bG+u3l+YOcdVPLqZhEGcQ0ukUiRg8Ep/eojONVot39Zg4RBxIrDZXVtGRuqKPcejXSBv0Eq76oYDaL4I9F4yoU5VVB5hFc1SDyDdqSzdbaxWd50AGpZYu1AaJ2JvPvmZ5KmjmMqKI9VMmjjLMggUMQkQ4ECfkX8VokDHJoqjNBZU6UcMicfUqn4qqQeXtNfeDN3J9mC4mgjrZ9YiC7jQ9OvERrm8eT6ARPRKBxvFFGk58dOcU8VHwby4+ql6Zjo4n23BXpv/BC0U88UqjHgjKW5mawoNF8syg9HR6QHl9VN0SRNh44qyfL2Q4NiQ44qfVNeknclGG+8NFnA9bp3bxgHlRu3jgwqyIFpTEifQGfgRNKgFNujCl+8lXq5YI8PbNRQKWZjcIAyUgUbutwecA1DSwhjFr7r7LF7xATUJZqUxQ6kQqlnEbRBPvn0sD4WfXSDYySoRiphayJ9PbxVTfDwOeP3UVu0yEIOqyHrIlY9lqk9kOAPdwXUjIQDktwuxfBMO87CE88fHHPaCXB62/V+kkGv/kYWTNvopfpB0uDYF+IfDh5t/2NXJ+Heswe/MAN38KL5EwxB8MyVMT/2pthur9XdBq2ACC88vdvhgDhzxdkrKN66XZFGSvulEanr0HMVTn5IOReKdB8IGQSeWLcbOrLhfh+MHV+V2bCCRHeTIPQ6jLYtbdgCKLAEsF91ikRd+JGxmYFDfBgizad1O0lt2IjIjv3+SvSZrGH73exh8ciX+TxGOHCsRlaNS458qjwYIH8u7S/n0IOSX27pqLPVzGXjQtcreL/HAZuXNaZHfa560pkWWMNr3Oo/qYLp7e/6+ps/c/gI5Q/veQs7xw5gz4+vgGu90NY47bH4BxvP372nqtaWr+cDL/9+aghekfef7oHcTYuTXtHwPltSIZ4CeH0KT6QwG63KUYSPlTVwklX9V8MFih+TKbrzWSj7GIC14DK3b7l64/xMXDcEEMJH41cFPvK9/vqXmWe/mJwroXBPd4QjhrPobrC/Yl45eHPIqrV/Z+NY6gkwhjMUFVuOxpDhkbrkHv2xzzMG1WMWmyAxv7fuvXNt4YP3AeX+t/svz7o4sHxl7JxrDPAB58ktu8XnGbTC54Va+MP7yXXPDK3kN+EYAUXdKTq5W1b+sVPjpZ2lz2QdOx3zPmosLLzHiWo4kBFnsaLyNvunma4AXkEZ7PI0+8qtay1yilAZG8GjU+GzgnU+k7NfYl5KvRm8v1G05T837kwdOVAggNucfLXis0pq6YiwRrCwkUGKW3nGklH0inF4vw9b1enmgpueOX1HbFd5bv2SFUoKYpkHI51id3ezLiWYnoZ6vGlXqAHpQHiG5Fo8jdbKu6BFar0VTTnorSJpbFfbfdin9/zBxjk6L1YfY6aYavSCLanbcDbcQdnIcF/UY8+f0gnp76HjukS40nLvjfgBLUXtdZeucs0KUp1cisUDBppPSqNR6FWZChxZa0oar7amtTYu+ZiK23PdN831gOSLXJcjdWc950o1ZU2Yr8lefjVKYy+XWyysIuNDh7I75awaQ8Pdh9fnCLj6Due4ND9iXD+ujJi7In99sXrJx3+vo5LykDX2K7eazT/l5OgomwTxtDL/f4YpP+v3//526/9dZrPjBgI5Pve909P/nLf3j7ReSCYLqP+Uow7sYTk2DDr5CL+/wKufgyv6R3RCEW/rBK/Kr67mfXjvpijMvotN7qpLVTZp/PxX5EstQI4XdJWFVeJagqrwimfUl0k1N0/BCFy0NZOUG7mnJMMgc6SRdAunT0fhgfA1C4uPgjNzrv7wzDIig3G/se+rkv/uFzvu+KiynsIfGtgg8D/0ARbUyQuHiExNUdiatXSVzdkbj6KIkDUx8yieMnSByG0xK4B0Hg4hMROAY79whgLscA7B9uuVzW9mQLcNjPA3cv5OD/szc7fKO1o5b9qATVtF8gMW9CjH6KWVAd2WptFEoBoH6xal6Tp8eixvhDaEmd7jSMoDl0FCVcy35Mly/M5i5Q1zn4xPKhYgAZnzxwkzHQ4bzZTkbnrKOe6g0vvaEk97756b3SoOtdUcmXU6RCgRh8m95tOCRPmGetb2Czfwve+XkYT082r4NI5QviqKqJcKjK1ZHlYnGf0mcaiX09aKNhYVvwAMOs4Y8eQt0tw8b6VW8RFLB/o6ahrH/F97zaLH/4fvn3OX6boQjsZ97B2PIzo3iDBS1BPscRH+cqY+eAVTRPhOCbeimE0oUc7HDEwGdGDw0pGsr1ogPwSLRAEY4H3hZRShzuvy3iEUJGKOYiXuOE8UVcVol7k8bxVPDfjMdRn5IjtxZNhDc0vEiL1LyyNxAHdNW72FfKToSaKjQRA0DFgt4yqWz0gV7CDqLIO/1iEc+kWIKjr4CarkB1yCS8G0TNKm8DP5Xuhzq43MBv0IJohfNr+BLePDBcTc2iL5uKrGsORczrlXVBUUrXaM44SqDOWi7HDWsoDAvpAqOrY/vROIg78B3nUOiDRs0DxmJqbzVfRrzY3FuFfqOasBCY1QpY5m1iAwp5LofbtDSkxXWgwhyqgyYi6rv989cfvfu1X3nzV7niTUxfBAkOIOZRbaTLHXBDtyKI+pCNwj5kPNdFEzG7TcyHy5idEzHdia9a4zH6ahCHJ6edxq/3Q0xd/E0aLgyfcds7P/fRW9/5uS+ztCDh14/dKu8QHmAjEgHz3TZW3e5nNx8ya5R6L/T1ZpxY4JDDTjXgBSX6kbuK4HWUZWqIYWhkVMdsJtu5e6WkmviCBKcSM+KNU2k2RVGK5Z7V9lveiAnDTtrPjO1KP/vkjcZnqrVheSyOgtIRpoHGbkfFPFVXUb/NTLr6YIl9FijWFZmVCENLTnlXGOIqksr9Qevkfqj8St3ZmnAzFO0ZHmF7yYY4vYdzhxQe2CjYNm1ilsvLLyYXZGdaCagbBChu+qqrI2HICW+reVNnR0qe2pSOKNVbZc3Shl9LeKicH2pDus3478bIL02iVeIozUO9SoUbUvyuboSM5xMLBshK8ejgkeUZtZSEfhl7V5GHN4bDMRgYuyqn7x3SzDqcLrqdI/kVYTEqxUoCfXrpaRFKTwu0lCbhz5Yi4MhuuM5ze3YD5sfVlBw07tAXuLXjODYn09pgUipgoBAtPrDfRsB2R2lFhVzwqh5S7xiu88Mn/gNJUT0Ghv+cuRsmoNHGJmqBAcc2ddFvoVmR4teFcDaFnKqoH0RSr8CCUiqFbDKFRdPwYUksm1RHZXr+onXo4m5oupLLbtEW+TCaWdkrYtyTI9x+sbwyQuZ9nnXIj9GxHcOCBJHPWfw8yzD3HNxtqcux0O+wMRhnKMDdR3/G9fy8+nz/O1Fm/+M1dqIHupEHJik7379Eku7WJGUgmfipp4vvzP7odcLOcGVF7GJUToJX2Qk6ya0Mseo8WWd2eLlEToOLlLEeBMierrT7HqNHkHfUgVA/w5p+TZH1QOFggES1MosOXufIA0Dn+Whj4VaB2cEbz+nzmhiAyaGsx9VjNVt4S7H4UMykE8vdiGu+Fs3dSrO30vzQUoINtuTXMo7wVZA3z6sgLdDiEc7FkdArFcMuWRuDjtFu2tO2WvaTAJhYc3CUL1HKl2fkMxjJ56ne/4nX4TblP4Bm9H8U4f69+JXe9rI3K6WEnGkh+4sb5YXhrd8jOvuyRvK6JSn9z7we5ZnvSlDotzqWJrN+qSOvCf0/Oei+zQxOfMa8ZZZG/09jM8vIYUh3VV27Y/PDUh6TVbZU51b2WjupJu3wAJwSwwHj58Fg0jD7NFqmN9HJy35NzczW0v/H86Y6p/MgWwpwtMYWqEV+Yg30r0JoKqGeCpYgEwXUfvsN8qljpq8PvGCa4WDDkv34jc48nPMZEckBRLkhP7sWQWKBPV0Evk1t3ds7mqPpkgpUeURVYL3rrEn2n0B2vVfqA93wqmKCSK6hmk1KoDecUdaaKCPK7x7nP3OXBM9dE39IaLUWolbB+wz63ZeiBaVHzUiVoyI0Tn3JgaYZERKMGAHOPjf5NrWKqFIZZM8jftrzTQ+b+KjKGaQ/HKgZ0wn/H3rMCdQwxFSPWbO3qOS539LelBspMr48svdboCR6XoRUWBJra4kUiZbtWkmU8ICeoSdXKRp5QE1464DhJzVyIsMJeq8ca4hHB0ZJlRgHNiHQBE7SBLX/aI0Ct/BoURtsbdsoqqEVo94SdK/eZdzWms3us4WBNeukr6MYqA3VGSwnEtWyUR1ULtbZuUptpzpldS3CciggMobn3Hjc6we6qyRxDGCcOw/VP0BrI49KazZ5UELXrIy13DEIMN8mppEDK5ELrERO7dvKFe6yME5mtHCntC6hwLkr/13ZAy4MKBpWBXkYdUu7v33vYCjIsLE+KMs6KmW5/SdFNvteiAEl8Et7B1eyHQxMm6Ehnt/eR8yLizr/CgfG7aXp/ZzaRzUrV+nj3h/Za1w+3QwIe4zzFSJI3rDwjqAiGVzFVt+BY6TC/t48tPx/WQZMaf09E3JZKKMjw0H2IZH+xJqPIgeFMi0i4MJR+xmMAXOioqzxDOMzyGAnSw8Rglv3/ae/f/DD21/00x72BEhl34bD7Oes9Q3il1vF2oZ/25CCde6xPbDwRlZeznub5hwqVL7mOTObx/yRAwdVHk70NMAYzFGp43tkqodysuVwlaLs15BQ6FDBXgpPEtFYPcy226DJzGXU11gh/Tz/ozx3cGwmHgy1ko/6a9l7ndCmZvcLu/da1BlcNJyotQjv2Pflhz/+sr869bNsEy2qInMhRrqv7JmYuy+CXZbdFHNH3enEXK1yMPlhkfu80vOnLn2qQB7yrl7XQFUtX+CNN4Iq0tIFcUHvSCal45qsXCHhtGH7Wj96KXnqyOaDN46ujo/nyvu+8bKvqZ4vHfVc8WrW/ndwWm1pqNt27C2RWLkFTfbMCUGIj5UBwYBTwAU7+P6w5wd6hiazDKZjUQlO2q04HIZJsNqNCER5gmz4Riq54UO5H8IlKeCjKCD7GH4p2BiCLa/YeCy3z0yMNvTt+R/7WH9oyMA7cMTm65leVfyo9ZS7rgdL+vVULsh3srPSddJA1kjfSG3/vkxJOD+XxaJ4v2KCzJGBEquH+Cdvx+Z+oK8KLYZo3WHkqHoq+MveNDUTBQgOslTJoF9Tqw8jvUIEBaocoG9CMitSXo2UCZVcNjYI/Q9tsCXQKFVeRRMP+yxRS7WHCrMhec/PR7Q2KEzvCwMV6FdwzdNU3aZveFMPznycSHASIXALB3DFc/To7C6vCPT0x8jmb/Y04V2elcwfxocP1lQWfJNnhcEelIS10Qoj7Qa+PehlvwcoytlcHijL9D/IG0PK8/wXAL5aasU9rzmNi/Q0LmTfiOIM8ypz2AdSoAd8KKJVmniisHIw54Ee1rTH4DVHufWXmYOwUFf/lq7+sTKrVpId83c/padjO/XMalVl2wv80PMM4+GYJHR/DUcbEvw7BFvuWAuCAhRH7vwsxPmZke1rtYjKRqO0/WCe8Am6PHrkpu3Zhd5WD83eCiBMxN4yGVshLlH6cCheSIIpWAaCc1xMCyymBcfDtHAzTAtPBtN0jhr8OvZqAaOe/obwUBIp/OL9rHP6wj6UaxDRss4pomcpCobcEr+IGPdKzAvHME8/iTbHu8kD4UeId77FO7dJcniHjdZbHN75I3gXPkK88ykaxTt/Au8QOYF5WE+moZ9Otccf/fz0A34QypGQLJ5/iPHNAwDtmJ+H8vRUISnBS2bWy1hN+opUuHqinjhfWaMuvxLL5iaTrHwy9XA9SckWfOwicDblCaR69Vpfh75qmcNuqEK3jLpVVQ2drmc3i5+/RJmze9xKeQ438LY3a3kmguWCSbkakgtehWPJOnH7cRyZPJ6czh+9eozTebUnRm0t1oa6e4/EZpS5myNb+1vs9NG9OD/C7FblQvVL5DQCGHkVRUYIu6rUu5PKi3OVb22ZP527yKobxlFe2N/4Peb6UVyIDKG4CpB2vBl1qkKlbvQDqDjt9Yw9SfA9tyl3Tfjeqpf67upoqfJUdXH2H1B/TQ9pT69l4hzm1ULNdtVUosEI9wNvv/EZte9o15BllXyTZadk8cssl2OvGKQvELgC7gxLPKTfCCtrXkSl9fhQZQkcj3CAKEN8cAXMeKuRbNLb0Zan34qmZxZy5Fc0SLUmFCAhNfRpFDiBHRXqFqZ/GYzrFux2yDZNfYAV6tAYdaSjSCY4oGI3xK0iJHE7daShVIrPoGOq1wX0Z3UtO6KcgTimMuZISW5iIrQqN1V524V7v5f18LZQJmYikygTD4AGGwNwel7PdKkA5RkKvuoBcrZeai73z4Xk8a2aKIKn7KfxYqQdLdBYuauGHbjOMMDUetj8GZ0FYtpH8heJnHauoR2UyBmoGpUXC2x3gIaoZx24RHHeWoGnqtdUeH3vEv6MH8hVJxS4phs5ORPzVaFbqZxxMSjrYpqijf0FRRq07mfNRmS322os8o+bYLXsT4QQbJsWiympWn67R7zgOha1g+FjwnKHrudOUvP/ev50t7kMblm+0LpfVXGvLB2la4oNXc+MgE2XbJ0Z7jp2VSbEGSoN/fnQa1w3gcDOv5ov0jpdVyJGGsE1cz1B5UXJ/qKhJyLJiKZvASV7XBWQueXMKyA15C4ShzlVJiDc/BpXNxRz6AB5+tLAC1QFGte8tB+/lIvI7rQKZIJExpxWKaGV/XLD7gvRTFXAlAMjSvtyEUS+ROnks+3ynso1+PW5Qm7ECIxHKQyx5XVqcl6zYDIcpHH1NYpeyjjkv1Tc/wfX4PQkZtH5Mzzy3v6aG3GsXXUDVZrIQr3W0gXK1RnZLWKzUc1yTyY6MFUwlwNcIsoLjDZVpm4We/wAy6EP0muSq6Vz250Ine7vxImzhFZRhtli60LHP09Yy37OTsdMNFwzYIqMgrZ7ZCb8+SO6mOBNvZjgVS8meCe6mHDds/VSwohTtzqF/a+O3kf4+Rsn7yN4/+b3EX7hxqn3Ebxp9xHehry1dOD78XWl+s/uEsgO2+XIScXHFuk1MdSpEAXytgDQyIaOcfUAgpiw4RqFMp3q17BP5yr+1tmJpXh5qAONr6P47a95xnWvvgH45iu++Ypv8iB157LKD1/xDSHFNwkpvnmkhEuy9fhRYtzbr32aV7Mmm5UySB9kchiRtpstOBb7P8i4yttv/EY0rvKLN568cZVfUmz8KRhX+TfARc7wr4iL/Ikq9z1SVPwrP8Jk9fB37SZg6ioyLigv6yttxxV1d4sZIhGW/q5xZ4vkcqMDliMyfonhX5JnXHct7s6dAAzRicEwHQS8zm7kqXOzHGDPwj+w9y437MWhidO0UR+CwYbb2XFyrqoqABUGN7V2G/K6PTXjHtzAXYR3IQEKRwFEeVDePQ8oxG3DCVCfXfX5hB9BP3XRa/gRqtkrFifymHHjmMeM8PgeM37FC2SIp9zdrJ2Onckz6NDPwtbxz9pN+Nm1mkp/Q4qgJWSOLjxU6WmkTD5uMvlqDYhdz6toFoCVHNm0z9T/39iX79Ivq5cIyXt092B+5cbxezBe9R6Md5L3YF75qGxXP6oWv/vGfztr26POVDzxA3/jmDOVX75xujOVEK1MjmeMe8xjX2iNcf8CnFMIPHSvrqyjHin7St+9PvHeSFeqS3vin7Z/nUyul/LTf8k1ZqXhn2v+39w3Jq5TqZouVQPYRSiR4n3//yXjYuEKbJ22X+ZMYJczK5AbS31ieL30GuTXg5F3PY6NRQU/cDLtRb4TN9m2lmzJrtXbdBSu+7aREfB0BE5kMf1REKxHlvtm3286LYtjfkmP+uom8iP+mjnKJymsLrvkxOhaN0TycxQeL7Bjw99lPdHkamBgVCcUiqVq1NOYABJ5kgdDoC+FVhPn5Ci1ImOVIZrGVozsHPAxhfxhApYn+4wwH1wSPivaFPJD9SzaY3oWKKxocftQjF2Pk5fKmhGqInJY+j+tHrl+KInUU0rEfxY27jKvWw+Oo3WckZ/9LZqq92VH3TIVUfZ3SFOZ3V7shc0d3Ev4nBJg05P+GBfxijrVKyrjxnSCv2939MP3nfO1M8/ExfRSHjv9EoaIbp0LsYTqUNV1mcEgrYs5gCPFpjYAUtcGaqxnP/5G0aIvb+6bA/68SXUupzx1vBJcSHlOO+B67riVmnrPXkv7ftd87tY61e8YUh176yOmyIomavPIep4AEyI9jsTlZCBHhHPzkPwLRCEnNPdEQ4U9GJgRrYmHgr64WN+5phMvewCDoaMQbzCSRFV4RycH76gK7/oIvOsUTcA7Egk3w7tiEKAxAu9mBd6JhXcyAe8GbmqMwjuqwDsCvBtDrWYqvCOGdwSGagq8GwzvOk9ZcWMuRBL+M5wudPZFhVz/i+dgH6CormZesi8hyRgV1I3GXhEog4sCRKvng5gG+8ZPDHXZ5BR41NQy/x5lqomIY+4SekWZsqYC6zjbkKQQSpWDN/CqKPHZbcgkI69J71L9SBP7wDn6mSCQyaWKkdozie/zYXb5jSZYvUj+z+pF/p1fkcI5nXWnyfHBV09R8HMQcDqEsdMhjCd1CF26pIJePsJKGF0gS9QPjuIDPYkIuDMf0lfZcIk43Ro3EVEepMMhBMAEs1I6ppo5FCEU9AVJyBiySVwskio8QnNQQf6EvmDAjfttxQpxH4nsHOInBaP6gpGTRX6X50/zhdH38tAcZllWGi+JuM9PEQRspO+/ceOEv4xvVM+Df/DYPA/CRfVJex50Fi6uCT1zw8xxYaEjJqrcqTyZmAWqJKjPA9Rktme8qg0HhL8ajg6HTGatvazQSgyjEzg4OTplwN6/pY4D9+51Id/mXnl5bOfgA06VSFtoDHne9OPHvagZ4bq4mtcjhL9QCX/a2fyUUlIt8fZKiSB1h/Gu2TRJuIdbKl+8beyLgftCkvSLOytfvG/si7vcF5KkX2zIF8LFygTqS1NKmppb44CD6dEoVLGqGi06ctFLmBMskj4R/7HUu2Emf13N6mt78mbLM6aLcMkMwYMabMmBAhw1oHS1YRqK75PkJXnWF7PMKEYals9RBwM2jxjpQb6gZlGbeuC5qM5X0PhiGfFdWkZUggqRX06O+l++WYKIvV+DIQc/rUHBV7XYtSYkynmQwmzn9yXiv8t6FggwOBarpSEYahcnC5BgbRGT9/kKJdSl7MCaWK9c5b+tm9gZ2yaGvgLCc7pZdqLtec6VdFEJd3YPreq1U5+YsZNG41YqtoGwQS02wRKYDKPYmVRD6RTTCn8pt7lytM8dK1CAz3KSZ5bnqbYEPIB9FjuI0x/+olfAZ0DLXp6yz2InKjJf7fkW+yxO4cqLU8uEX7fP4jQkREjYy9eKvnKxfRa7uCCuhiTtipXvfdexp9lncbpL+4Grg3Nev2X9qfZZnKFpxZl0Joe0aGX47LM4y35OEYfwkGDrI+941/vf8rf50+2zOBuxH99z6AN/9c93Ps0+i3P0c+no27/j9oPPfeWbPmCfxRMAZaQcXvzdLQPvn59un8Vum/L//YcPLR340H/8oH0WT7Qpz/4u/Pvpi+2zeJKmAEZPJu5RpcHa5Gs/8fv/+cI//uzT7LM4Vwr6/O1nvv5zn/3PH7DP4im2ild89R3f/Rdbf+vp9lmcZ1M+8b0f4oae8UH7LM63KT/zYDY7O3v9xfZZ7LEpl0pDf+OD9llc4BocEY+3ZxDYPoszH/52RvJPesWFD39H8VTaTk/FSJzKg/V7XJ5vstln8VST/eHvyC+iiJ5M+CzizyL9rJJ+KilqStURARFJ0I5IkYxKlKISgciiS065oAtNRw5iVCA38GSGmXabpxlCqgwYWpOPDRhheMgMBhnQkwE0GbBSBYg5EZUg21ntOwnIqgCIKGcQINOZnOlMzVRJ3wbyDKLYBZk6M6CKyrUn5kOVTOe+0uicN/J5IeLiLaA4sNCy9cVyto6ttmqJY4edaPoCjcUXMG35NC64oBZuMqitTXoaKM2pxupgsZ17ymN3EUngItomCYdNwjaKNCGCOUddbGmrtoG/iYSmBbLaCDnnJnDR2yrRX7bREV2EwTPRWBIQzfWdaqJpFfvIVdoKT5hbnQeBJjPG/ZCPFNDJEHwrTnmLp4MQC5m/GAln5XvxoLxP8+o6R4j+Mxh+z+jX4c3qYnrGgXy+rDzvls3LV8oO5FttP3XBaIKyW7dXdo3hNtH8mkABa02f+AE4LyJzHjOUE35Tl7uxrARPgyHvFxc+nwAUhZj/YkxaJR9l+LAsWV0g9CN4hdhKY4mZSSQe8rKclfFcZHLB4UR3LJEjE+BF0cfa3JbW+lQAJxYB+EUDeGryUia5YnWADzO3srvpUW+Nlte4fjF0y3r6UBLw1X4tOAqEdFnJReE7IQ6peWKMsG+YT3E2hXriS2E+kCvH1U5EPQPpz6CnKwOaYaHMaBaRs9RApGNLKvzI3grPw81esgpcu4qn8eTQ/VaTZrDRMOYlezQvXE2xojEFN2Erjy4/ZE+ViJ+RBUUB9eSsU9S+YT6jWK6gSwvmjiRjlt5QhQ80cbOTnyrPWn4mJ8L4sBRCW/qRYFAhDE++yMO9hVYOUFdRS4aNZ+Aqxc43iQ7XmcLLL4IBQkbIMIyXkqiCRwVxUkzbJFIR0SaBVVEkpVPzSMhCAshvAZC39IWNVw9zbeoijrk562pI+9kFXSm7UpiuLGpXtqCVhpnrEsBPhYDcthg22gVPCkPnF0fflYBU2+naWKA9hWnjAljABdIRFsQFTVgrlqihb3pOKRosMBNqOWnZzc7egJ2IUSfkzYndxV4m1x/IaDX5aHiBWzK6T9MLZx4FxgFmHljvl6rwonoW5v5M+jdhFMFrAi7QV00SRlqXFqg1waNi6bFY9/fHPL0EF03hSZsymSPCk8wzM8/KdlAktzCyqUb5E1w+ERlwKNLgUDaFDESYdwhFhpvSDB4dWJiAlZ6auXFkjdi2zbahJbHUgMtiMRiRC71uUItj8NiP28JqgVXqCctiKWXxXGqPEWcAtxndbeoxY5TP9BPXtjbNUGoky1cW7R6Xi2I4kI62zUn70BLpRnZH0VEBQUI4+s1+XYRls0eKuX0/ePPFa3/5hN8huS41y2V2BjQ7GNIczfFN+I4vY/CAJ8MC0IxckurooWmnlNNBJClllDHUObIOoKgbnnT0dkdQq1399OEAlwtha0tEqbFoEWSUZh+x+nlACk/FIoxWuJQYWMUs3+zQnSnI9EV+MPW+pq+4rNeMWvwaWAM5GhYxhzWQo0ddsJ+d/aZeRRODlHlcvbwRUTxIfy5g5Q3dDX90bDd81O2GJUl3w3dX9s+fHvvimPtCk9SalHzRl+KoZqZE9jYR9WEB98hTd0e4ViRRD3rEb4F5ewBvVdNvwbogK+7luPHsFciPFUQqwsGvVlbURaVRBsdJUHClTHzJqg6i9YqUAJETQ3dg7o4/XsVPdqDwAV8fDv0w57FwXi8ngiQ3+3iIf+tGvZEuYCDfdNG1CQFJs3nLJkLJnXyuChWoSbKozG18gqe/0kig38p/cr0x4r9JFy7oG64y6AB9YWyA7nUDJEk6QPdXhvSws7j1gMlxDAslPjrPP/oTEjVdlzY4pqmE8L2V8AMIawM+UgaDQz+JoLPc+sHr2HO+xslXt1TCd2oY4sqPogRt91GNRfCwC25I8G4TcTfYPu2xdA0zUO94HPIQxCSCbTl9AT6Uswhmy9V63gXByyhwQ9WC6vNLKDAGGq+u3A8y+OopL6KWYmKHpEWdqfEL+jIMFBkECTDSEoULHQEFekHiCgT1BsX3VI35ZXlDUj6NlAxB3BSxivMPIDYRLUEdQN2KUEPTcCla9WrvVr1aPirLEzwu52J1NvpreN9bzkVENNxchJd7199kXeYSGJjqXEyQXwCW10GdrhL10HjE6li9vGXSNF4pEvLP8GvvxcR07ikxIyMjkG+6WZnxOMnslDmJOm4amVUHfZV2NmUwoI+Kfo8CBUbWPWoaw/ICXAUTALA7+20hnS1tf7ucrDNodx3tbqk6iMIlxXALR65EJtmMyLhbHeiSCO9u9HWBax4gUQqfAcHBr/bO0guzOH7rK+H3RQbtjiLGc0/ROFJ0RldDSSC2OT50axXQADY9MtwOyfCaDAeDAda8oRyk4UoJmnLIJ+GaCAPJdaGnSpfMJQ2/osqsVjoU6JdOGFpf83BvJvsdvV0kQMZPd0C+u2Mpc2/jjtIndG3DHTO668GEE6yNO9zVzcGwcmV4wHdQvWBSJ0gPR7qqd7fqpvFq7hE/FvTqTpbHeHRh64dqqrUXCqFYkNAqZpuefovwFvrSNehLg5HUU7GPootVu+Gf9UOh2KPH38lxriQ0YGiLy8Wzi30XTmITLIWX8CO+sHax8fJftdqpuuBp9Y5RUN4xisev0sf2Kn0sRuEpBTamIrycescokLOtEXOdwfpQxBaA07n8SPoXM3T2gLjgkDhREyaJgj0B2Bc0c4bMepa8G0FRpT+rLGEXQmo/bFU/aKFujssYEwHiP0SvZUvqDi7TNyYC5lk2G25N8gTOorRY1wize8SesKw8RLVNrEtDaN6gOlpoFz5+8+T6X52QY2ADd9nAUQ5gabuZn1igbpcnf+Lr815ND+7Bs7rYHbMl3G8DD+qnmH11WFaz6xfVtE3WHhnF2R8ZQPQPvsp3Hu1424wIbfa5fGRL2u88FdvM7r3F76uV9za/Z5X3GX4P3btw0pHVItWzhf5ByufcGSqSGW/BlHEKnC4gfzFPDThOLXwxZkdNSnH+/HG0Xvuk3wVkMrTw1i7zALnlxBSP/fmCnmEENKOUt43HotLhJSlaNvxdasou3adl7NppCb9Fgm3qFtlmL0rEihFd9qhnt6swhSH5VgipZTTEHoGVfiziwWIWPJZoGY9l2oLHFupCBNOlBdBBmqc5/LEe8izUNj0K1D27chooS/uzqP0JpMmB0eHhVir/AGIp9lfiK3tqEyjAFNYUcilkl5lFPBatNZIlzO8lI4g5qHYfefCugAOfOQxVPkc6WFZe1ynvrXQm7q1gU1Ymz0xLbpfJ7WnJrTK5NS05LZPTiWRqarjEnewP1CxunSe8Uzt6vycHrOHIAavnDlhVzU3ZgoC8DRF0GE3vCBIPAHRkr4gtrqGWAW48BWq6I9w4YvIssIGVevWstnS/jZGiuj2t5fXKOT327AGtL2xo9rvozCC9VuwWSHPwkcdo4wnaeHqyW+3HOG23EUmFgruj4cAUULWAVl6/kgUgfbHnTV1Aa6DIIaNPRt6LXJvEHrnTctdVUtfLrr23CV9v/BH5ukh+bHyRvMYLpx9OYzz00JUpJQcQJl+fOJU/QPwjcD1QBFYbQY/recaF+p79ntQXo/MG3ulXml6v1IA8V5XL93ASJt9z1YTzagHJaF4XDVu5jwsbnf0fIl/N1x38KhTj8xSoYq726Y2/oq2eaVtwfFx0sJ3L9uez6kMiog4XhwnXps5+KGLPUwg6ALns12qXifw5VCX1JTDay6qp3uVqqStC8y0U6yZ0hSKtsCcqfu6SYbG6v8i4goyHZyv5B1Ajji6kD8V27iIml+pF1InFbGsHIAvCC9NNvIC8g67FwiFnz4WW4HbqXrZSCo4yeWZCArmlsTXEt406tEKraCA/e3hmv2/oOMNEPeDVacsBaSmSUdocbaUE9VIHQl9uu0fZE7wa0nk/AAa63Q+1Xl+r9VBtyxAsABtFz5ZF02TR85sXfa0r2lFLlCvAbxOYWhkUDEmmMOEYANnfr9oqi2q+yBMwZgLQOM+kwpXRLqzgsUIZ6smMA6i6jkaGsVXQ1VV7JEGjEmoAVRrU5G/ypjluhg6Pfu3rkI5irf/IsDabwNo2sDaiNrA1q2Br++uMrf6/LbYee3TYusufiq3hY8ZWFD0VW8NvRGwNN8dWJb2Xet4rnAgeNNlzs7GIUHNIeNibaIFRIUe3Qyefn1oSIDW1pPC4Jf1u4PmTV4MVoDcHuuuViwK3BNVtr2Y4VM1w00gG6F3CjIQaoG1Z0xKIfdfU2Dunxt5SiT3qLnTd6FUqPuRNtuxllfRrJ5MPVJKvnky+opJ81WTys53fBBe5q/LNWZPfrFaSaTK5VUnOJpNrleRwFMxOpM23tgOrWue2Jtkn1E0P1Z7f9gxfoUcZkVPBlUOL0lIGK/c6m8qBsanMH6leqrBK725GOBECszZi/Si2TJP4pS7dsaoEunoVXp1FDfMGlJydyWiqtzUlb1Sim+T4PoLg+8c/eer96TmzT2e7fXzgssdoqzaqxjxA3GENtGhnf2KtTmAniunSqFpTm6k6cFPbiyPW1PKZimRBT0I4m9OyLjIdmo7M9o3sZw7K5lSvrsEeHGpNFMPlAhrFcisTsLQX3GalCFGfmKt0W/xw+nKCOK8FMhABPHSGBV95SrFaM4BDJq4L9og5N7YPNKv1/Kkw1nnTLqfzIEnzplpdDJAPEUnl5Ke0mHoMno4lS3/D+uapA0ljKQOzU5bTO9X0jUhp9wq3vWo/lKFBe4fUIjscqfagQ3X9Grof/wsp2Fhhqzzgjzqs418dq5SalbFqEr+PjJUJHr1ogHGTpowJc7Be15X1FTdXl/WwCvTy+aqUR04dWcgCewrAYjmLD6ju9kXHKpI5HXFrlP/gD/5/9Xc+Y33IZ4TYV1CSz+Lerg5Qv57PmuOvvrXrC+8ydcXNS2h+A1ItXWXqVru66YSAgoEoVuCKWdkQ69JnBtJYms/+t67hevjXwk9WoCqEErlTQHVeBXSDlddTZMWskx7XNIM443wX7BkaLOJy/wzlqhZ1ggdnRcYWVpcaMOKSsiuUwOtPrDcdRzqjBRSj3Yv1SnCcfeV6eQ+cVBPd9dWmcwHKEIwN6VD0Q2Hm7HtwIUXPB447THk6VgTNuDDm9sgYBhVHizAR2pwQzO7by3jqGgykbMKeKJoG+DhLSjOMH+n1p7d8o/+csNSuJSZbopdHpdmWop4n2N+zjbe911gxXoVACjy0B+40wQGpWd3pp3p5s8nwwDkutsjPaXtw/RasyaUXVORLsE2RqvM0ceodEz86KmaArm2GoCfBWfMNJCdaEoLzArmHF1TbJF9Eg0yThLIhdDmYDkxZT2taYp4ZZwQPBfDMTF3hmPXSQZr9pdCIRdMplLFFDIBfyu1fhJ2V7FIb9zyOS6Gg9FykKd81o1WwpmqXOsSPlXJBNBfNuUYff5f2rPdX7aN2OnvXq8fyYs72ONCrfDBLmcnYhZO68KjKy1bkZa+EuwBul1bwWCEf8jFuaen7FozqFpSHZbkphyAIrUJfGEpjTSVYBj75VrUqvA0PVaihYO9Ub4E5a1HcFVCdEBjYwGEbOGgDD/gmcK8NHLOBoz6tEgGMxVq+g+vaySO6Ve6U4aXvi3bZzvwUauY7aQed0q+LUtI2DgGRVOvnVNpOJnha34PeDT5TzOGEAqJGCCUZtqoQltNpTglIkA35MK0kX06nVpK7ULBh4GKpBJiZoqIlcNzQLJvT3Kw5apgZPoXnRV+sOHF75k7UFrSDC21qWxhKyL71OWaXspO28nYEepZl63aeuHVfP2Cliu7EI7zT4L8Z7KbWmne1VP7Oy3vclh0WUtRFFYDcWlU1aye/m1bOjSX1UP8pXHaP2jwZWgZQpwBQ1G9dymHCNoWoiahFplaY4xu4U1i5S3cbk5ldcLIM+HXwOIXqDLMNLz9dA35+RrC3RDSFCZ2hIELwdA0aqNIuWqBlA9EKuJrYMDeNZk5/RkpTaDWLleqgKeDcwI1WzJP3NIGVqxEvRV4dOM13KuWac7NW0IqSNwydViOoUNYl34LsnCKxLma8nB4HAL5T5HkKLctzWWToSqCAG4scDCytqvUPceMD0F5rUYvjbg5E8HBToNtB0C2TFirHJ5pMjoqnZjVqpLrBzM/UD/OzOBvWp+JszjV9hQJHmWd0VrlQnUNnEj+e4BaqVbdQbdlkoQIyYaEiPydZrGaPs1g1yFMS2JlcrGaQhs2EWaxmK92cKRerWSKzWM24xYpo9rlI09E8h6hcrJ4wvlhllMoCRPg7/mLl8k5brLbQqmbU1SnPy0WLDwQZk4BzunrlLmJyCSNQNG7/yBI2M7mELY0sYeeOLmG7dAlblSWs+LouYUtUALiL31zC/i9fwhbdErb4b7KEFbqEFVjCClnCMPmxhM1sFLtp98QSdg51AL8n4FFZwr65hDn649ayiaSTX9QIixqREXbMcjBAUMh13tQN8HH3TZsvSW4tmtG1qEMRycoU68r0f/wW6hTdQvFjhc7BgxEWj1Mejw3VTg7snLqhWpELBzn17BrVRYS9anOKrmGUI2JyjerhwXiAxynf3HR9PVasb65Y39x0nYPHTnoCHjv+Xa5fe1GNLFBolCFZO82rqV5fSgzSF0fKdpS5KzkdYdO6p61uO/EEDZDnjuNv4RA0mpfpkSj0jGPf8XM/51ov6UsYzqdKI801flHVu9yXd5jKSfTkNQBtVDPVCMG2vSjlqdX7QKxIJ0b9OCQk89HEPZWyigClEcmja4wVsrUNFW7aMzTVfhHNXlWZK+IjRX1c9RempP3BABaA6nwRxpcjKJTllcrAecxrASS9Hv89vYy2OXt57O7i+C3PZcXVCqdCBEs5oxml6oqNniNcPyLjUc+L6A4xPJ9vfFOXwA4A5D8eATLiqJBuiaZbWoWIws5AJDhpiNROGiK1rw9E3LnlJHDSnRAtfE1cB96DLAV87+gZ2pesiev021m12t0/E7xTa3u5Z7BVr4fhoD+wyuhWL1CPxasH4dcHgQ9f1xUDo6E2UA/yItX0Oks1qXdR1P/adiiotV6qhxRoinr48dhWSgDf4Y6jjGG03YM7npJtCo1DiuzP5Xy2LqNUv7KHvOSJ8pvVcQmhreoTW/N7NbImamU1QavUxH6A4jIpbn9/ELyQwuxncJYijcbM44eaZJVq1U69z7l+2dj2iQSLVGnVRx8ApsIjDQOSsV4axGENvxb1KwtGiYDQbA5wrPlAD7X0k7JWPdDXtmTS1OydqBldKw06x+lPhaEOgWdVmY8F5d0eqCk6gEbk7E9NBGrZB9QHRf9g4dSD61APLlg7mHsi5l4jPfWuGOkyt/E4myw4QtH6u5w2dABtaL4Ns4kCtVyqQeAWG7iTAzgGu5YCaEff6Kl97AfN825NDo7iWdWO3rAFHLOBe80nD+B50GlHY0hKzXU7za7AiT4hY6hWuOvQVERXSJwsiL8u8pWYr/CbKBOI0wlIZVBo0O+UN2wyDn00KN183R1UxgF0CDOB50FRc3alAKu7gzWtM1QcB8mmCEQMw1f1m4tsTp/V6bkGjADOD85gIYKTrey67c7j0sHA6Rx4TufAszoHVdWCBPyV+mGk1HqlTkEPUtHX0XW2UXX2KpY9Y1nHY5wWq+lDX+0HQh3dOIMTvd42A5nrdpaTZ7CjoJa0RV2qFamaWUpLAWprTTJoso1FR2bUFm1bkvMEZ4kP+LJ/7HDwXg1maFwNysxCFOZ0qzIvzcwXlHAtKmCWKJbZiIe4G28hJAOaSKgFuqDG6/k91d0Rlfsj9IXf54j/ShM2Ke4vp2rCxvp7n2PGTBXRzXXxeMp0WTHWAPCsTUnv5avEWy+oa6HMBBZrujxQwiQvqf0walqLNXWql8IBbtQYF5nSMn9p1X8XzY0dNFlvlXNVeGb51mkWa7bRVlqFovx22j7FYg1Nt1iTw4JAMcVizQ4kbJ9isWansRyyfYrFmlNc2oTFmlM1rTgNuxIUPWmxZpf9HMYw5CHBSYs1pyN2wmLNGcezWHPmphZrztrUYs3Zm1qsOcfZLnkCcY9cg7XJkxZrdk+3WPPETS3WPGlTizVP3tRizbmbWqx5imvwaVRMsVhzHltQWYH5lfPZssp26tF2jERB5023WLMH2dXgynbu/hMIn53Gn52mn1XSC1LURNWclQApQbtV2qGRBqU48ZQyZNFlK23lEGeyyKH4g4f8dzr/uYEnM8x0lnmaIaTKgKE1W10h+t/uKeZtyACaDFipAkTuEJUgo2rfVwVkVQCcxtVtI2Q6jzOdp5kq6SuyFCyI2UJaYNZ43GKNoal5UwlqDkN/dXEWv0AJCH1KW8RiTTpqmaam6Qs0Fl/HXvsCKNFQlteoo35/6QKRDguNudcverBHUzA2S2A7rUjCAyZhhU7ThNNSw9tqTVu0GbLF7JnG6dt55AvJLmiy5PNMkRo4zd12S4Xjs6USo5q57IP4FnFUQSuVqC6iTgPullE7EbVCxZgIbguEL1tozur7to35m1T4VVXZYjHlheVK8VQknJUv4UFif+Qi7s1FMHqT0VPpogO5L9Xli9KQfFmamG+RHuQdrDNYDJyRG12FlsR0jPYvX6A28eMCa5kihxu1mkoJIHaVxeMCmC+FCCuGB2fAludrxwmyxtYUfJQx5LbQWGJmEokWqCxneTwXmVy7uYjFsUSOxC10uVRTo1lpbZPUExrAmxjwUhdGbuqKydKXeViaECM32RpXTqm1cFMzwqlm1cLNdmPhpkYcEgxuYhCbxj2MsXDThYUbPHyMb4qoi5B+EV2ozFuLPGNooaFXnJIilbPeUsGrf7Bk4xrOzqqdf9RQX/LKaPV/HJZWNcWYWo1tymud0VT+Vg2mAo5WMfVvAh+aVE6sUbfqzKo5BsMX6lxe7aHr1aOPgpVJy4iWxO7vt15YJLoRa1BCDeZ57nMXrJHSOsBJYI9gqBp+h5pg9zyI1j1GeDivkvvVP7gf96EcJ9pSc5ngBH3VyfQokeYVwmQPyutLHxyA+zcqpdln9UZ2SnVUsvkH/sgH1DoiXrz7r8TtuIYoImZ3COSqjUfT0+eUzoHyBjT1RDEzT6t+t73clznjO8wKKeGmGHMyAK2pK7ApuHBrDQY2QIIaQKK6kwB4G0WrYm7Yhu9iT8it4ZDCW4dy93ij4iE5YDHBf2fVdQwbNkN3YfKrHrya39f9Bf9QKBfIImORhRPEdjg/0DZrH0adGg+rd+6plt0qu9TrQmt2Qnly/jr7UbGbHHDozRLyKqKIlrlQBzYVTdKhioaACELx8IhUKz7BOTkeDirNUD61Kpr4kchL3MU0t9/BlvJ7NvNQoDez1x8KAAbe/30nR/Djefq43IosSuXswAJ9L/Y9uM2MQyFV7YQlF3xXZpGCVYH20h7Kjsvt68VwFSFSgj1yXxOClobUkzd1dyFGiLM1XT0Lt5kUWVXTXLOHcjjXkgfqlgQlmvOvBMkY5RbV7ckRN6bNTW7zypKoyDEhToYqpp6DwWZAqRRbNMmTg7AauikHYR5J3POeiz43RK81+1+gC3pZ0mNAp5Tk3F8FWVMJMHaPdv/jZKfoHn+OQZKgS9GC76+q6GZFU5JUSRc51UcmgwI7M42gpmjqAt5wIqT+GCjiRRJ3WF9UNNVkUTP7O7TZNBjfoslahJ5zJmSrqU3RBa6giECoMsKg1eWtxZtCH1ahJu1BkbH7HJOanapjnIxjSQ6HcM0WmpFoCPixh/4r9U7ptXzAvlH6Nawm8wg1RkxaN5xJ68akSWuXLqkYLDRAlij7n7YoEchVm6Gm+UPieKB+mOJatGtUJbNOEI+jfKeDLcl/jWSotmefR4hZUfgER/Nh0PpoDbgXQfSzZzPjWMEuigjPrnkmuJ4vM6GxJrdo+Zl9TkqnBoDe6O8RsdW5yMYVah6M7qi1bs79MuS+Vpdvnv2+Ilziel3tMgCgnzqj2VWjTX4t/ZezWnWV3F1bZ8QAcjRH1ZqDXG4zv9oXveZAP4XHQLZ9JFfmY5WZ6JhQDLTLG9UrIHXcCjGj2FIpzzQ1aM/oirtP2+gdfyjH+W2gGPvgEjHaq/UcfwYtu1HDHbGE23nJ/jxD7Kt8PbJH+AYNz2luPbS3pZAymW0+wAejKhfYGvkyWmTapB40LBGrc+aW2H8suswvGxoWQ57KNGwFadzOtiFey6ZXKGPF0C6PlmkJtEvj7CE+XwZ8LtK4EmxDpIq1PHZzA64EhTYu4a9y+K491E7jvH4sN5YRJQfukzmaNRljsbvJBRQ92X7o66v01ZkSiAHimJbAxXJL7ZF8HTuMFRRrUQBRlSN5IUddhY8cyXt6JO9Vj+SDaXIkHMm/GrwIQoMydLgMHSxDD9xoQ/eWoWNliIfcHs3na2JZckf1aH5H35d1agfOdPMdVJjT5lPsaXPdnTbX3dG88bpl0IjqzhjiKXbz0Bs5blbco7oTevVGzptjNTmYybZATQ6iLTicr5cNqm/WINw38oAt2LtAXnniBs2fsC1q9rGubWE4IXt5OL9DD+cLTrCt23Hi1n09wZWaKUA5jlXNrDBDXjc157GWrFZuT8H228JLZYqA38g5/A5+N02dH0s6BW3YyaWfQp08oRkDrp3lEX3dHtFjC4hpj9V+ZQPS2Ykj+oy6gGKAQ/gb/Px0Dd2o5/GCaw4meiCPLqG7dXMq74BLu2iRthjAjqg8ZAxPdyxvCpVCimRk9BR8bghHWwCqf5oCzNWKt8ISDdc+zX0q9TT/Zs0RI3YG2bQ2QQ1XpRavREpLdpGOVI2Xak/dt+ApBtoTS8FSHhI12KnEzIOiNBaZiqK0J4rSnihKe2OK0qnwykOxseXIfNusV01ONorSnlWURuGqKK1Q1zXMrWcd8qAqvSzqaR0eDVWV5scTRtcxPFYrS9i8KVCXM6DXyHI2e5zlrGmXs2xyOeua5axZakq7fnbL5Wy2XM661eXMaUrX6RytQmyRPIH4kVTWtWVqT1/XpM9uSUNGt6QxctApldyrNKcZ7YKW98zixp9WdQ8T6rmIytqW4JHYJW52ZInrTi5xKyNL3LmjS9wuXeJWT7jEPfCqcukqQ8fK0FENndRSuPJ1XOK4HSdHs7kh31zivo7gSnVK2CXOrW5aaR5rof8Wq9usrm7dzVSmMwDwCXjsLJc2XeRe5pY4bb5b4pT6uyVO+/kolrgbpi1xbvRc5ZOrGyqcvrqhaY95dTNVTtKpnW71m5o+Uv6Edtnoeud0qI2BaiHk7hLxcTZdulpN33G5ZSrTZeocCnS1+r9lBwY16lj1pxOjP/347Mh2cmDn1B3ZKXYBo9joG45tzShx8YqQ09YxVaL+uu7Yvrlj++aO7Zs7tnPwgDZ1F5345v5N9atRGwYCy5CrFm8Wh6oa1eP7Opdx52TGib0eat9Eu/r4+z4EN+XMbyhJVBk6VoYYuLI8YbdYLPST5wplmh+7ihQwziYCijo8hlSYEQVqwg/1fBDj0YZvAfV8gMO+Cmg5oCZgEEsLmNFQ1cQuR6b2PC1gagc0D8quNZYlqtMDa2nGmJFZML2n9AIUY5rF8yEZayVEutwCKe3KIoHKaBsRWqRrpfYh19MUOT+giBbAD/D77PXO44VVzk3T3/Q8/1o1AZR94UZVFfWt0RbV/ghGtT98cakOfVUIe4/90/WHagBg9jf4mjx3jglVevX9K/AJxfjXRh6pf5zqt25WOxMh6m41j7WyAK0Q9bvhlNKJ/XZ4VeVj5/rAs75n+tT/pRsPinX9N1wvcn+Nz/5BTwEqDup/BJ4NJvwoWGZIgRtYV5Q46o4YGWxSQhoXXmbiIn490Ifrchx7X81va8b/pLqor7qfbIly9yd//hM/zyfcvhi+9F6i3rSJz2H7n0AKR/LjEzU2VakuG7OPiYVi8VoTnGydoakzEbX9iuIlK4V6/Ze8kAtQfwXyXURB6StTqlF/ssn55iuojYuGpDPp6aFseYR4SFr2e2jpip6IRqLOiTTUZTUJnJuJTpr9jvq9fI3Hlk2DayfMi/pyQiwaA+pkm7GrojeuKuMUYx3DqZr1tx9lt4DLA8+HM+UMqv0IdIdH0DGnQJ6OuOEP0id53ivJO109+YuFHoGbdN7nNwstr3Ttmr7Ws27lPXNMc7mxScxUAkjMRMXD7MDKwbBEYrxB0bqon4viqFXEl27KyWCg/ZApEV1ZBLDwGhL8nq8Bl3pFaOwU+vo9dyN9T+m8XTXTjRZ/YN6BKGLezrNXUOBfkcuNgB+GuMDVjaeDh4lnTKrpg4cLZatfGFSgJcV6ZE16+USigSehqT6lSFzfhPKVgNyViixccHqjN2Jmz/mrMH4jQ2MEVqeftWK4UxqAF1HolUeIgzQgaIIHt1VRFfOihSWyzlozQI2+9wOAWuC0LML05jiEY1NoUTtCE5vkGHoxu/p7sjcbdflP/77etVAL3yHVN1F77xoD3ruojiIyNRC2Ew9RHSerGhGJnVoYx6YGNDKgyRL1WXf8imugOm2NxVGIXBFDEiHjETZy59SR2vNWVW8tua5lr+KnC4SxlWRvBiwkOtcsudy0kFsQqxIiDqELPLKeMKw1e35KdVQpd2f1rJ6KFMODXgANnG60bnqwdO2iRnY76iwiQuaiSRE03rBd1FZIQTmUB/iVq5B6sp/CNyvl8toQvSPXpyJCHeXuiyLt2LSupAiq7f4yOSuTWwpk4JrVrADe1LO3qG0I1FuXHLKymyHRqETuhpSfcJ7yqxBfKfJbUPkwcKowL0LtRF2VyJ+rIwY6AFBTA+0BfIx/fSBPA3CAx6vIFspNkNoRlJmIgZdbYBkuj+HRgllt3JHKFJBodmVCirMabhWmZuzWymczedOZ7turA0oCJaxH4K4EjsL9KVkULPr5jlj+chiBzuMkPLIT/nBcznhzT8i/rCorCTV2wgsyGBFgbR+AxVtyK6Z0dGvO+nCvkMGDPUB7PcEwI6prVMidH2cRm5MP/7NJHg4L592dkn3/6e8f/PD2F/20eJosX67srRcRYobOUcUdA44buh2MJB+5Y+hYTYOgQf9QvAYjch/5EteZfUWvS/D5RSw6GORXPVx0z97HKvCN0mr38/auG6Wq0Lkw5AKh4NVQh2Ag+eqZS0BkeWIwmm1qy5oC4ZN0duBax4XIKsD+mL7k4U5AC/jWUsR1wK+WJ8bmE3SUElxcGSuJiQBagSVmHfU0OAF4q3cM+rskE9yzxGNG7wLGCkVALLCw28lYo6piL7h1iMcVRwQflaGB0MI6qe6D7sMl9yvXsNbDZUsu2DrIw3Jo1A9LLiwDeVA+43uBXmkN3bdqZgFkYYFaYk9/tbJKHa2NWIN1t2LatVKB0ydP1JtUf1NOnfqfeh04VMQb7U2PKZAm3Y8k0d/UhbEss/z+3DXNjlTjNN+XaNX1RCdLI6ReRQXl416gKnrTllhf+XBoQQbKxNmFkyEjbXj+xz7WpyB7tdDtkMIy8qpe4UBKLnhVj2WFUfYafCBrd9T/4I1Pg8ZnSP5V1sVexNHxS9cwaGVem9OTnIY2hWibMp+VBTu9vx7UhZJQbaOAnmfVlqUVa2JEuZG7ox++75yvnXnmldVLT67pQaXpQlzcHU3wxSGPaqWfFKzjvukQN0ltWeSCV/XYsY5rC8XrCuEitlmODtV/INhWLmffk+Xf3+NyKAVO05PrueNWqg+lGi3t+5HjDkedQlhhpISx1xQ5dO2s81XSKAX0AQhVreSOcIQ6DyA4ta8WlfOyKgTFK7xNIPr4QxJyLIZk4iCZjEAyrUCybiFZn4AkkLd+AkgmTPZHINlgWAJ+KdWnwC9x8APcyMuZnGG31iQLPmiGpZzgpbo5hJIzSNEoVHFngll7qjHNM3D9JlyhUSqQLfweKC+/c0Ag6F2mEx/crHANG57vOaacKtRL3TZ5GyBLFaga0ULoyFtJne79IJa8TPcWSXmBsyWhVb38C/L6WiFIPgXl9tDRQp/8Kg30Xd/8yjC9+aEgvW6TfY3Xh+F5frBXrCLswQ9G/+o+40HvmsLT1vg2y/WcxXNZvN41aLh4DHyrGKHVrQ3EBK9Do6s08scBOX8a5NQBkwJQgeFAsFBeZs2k8Oz1hjoHYNFNH+99NTeXwvLlqp5BmdDBTAj+BhilyuDcMUzPqRmB1CFZU7BjkD6Rf7ovm27/GfroY5DS8xiK+CC7SbDUz/5RTVYrgynwNI4Q0a81KGHiCvx/9nzdmP9/TOgk0GTM0u3/S5AFGNZJEcG6+gUkTmZ3F2hrRLKBVjTWZO1hecU/oeZa2qn1h5A1ZV/T5XaOC8s+KkBOsrcI6P+X70WTMibpxj+7mxI1aZkKnKQrI1q8gdPiDSa1eF26pGLSnHTx6FVnLfsXZLV7+lr2kL5CCTyQ/URftfQD2XJiPxdhP0dgqYRuBZJZt/3Q3VWnl3pVHnGBqNfiEWLjIv6pAEoP38FzgNx452a9D82iSJ2TIXse8FP3J06v1neY/V8xuGiCNMDXPgRSJ/ky7x+WzpjueIJi7lW4G+yqqtsY4IIgXppewMX3uwYd/P5b7Wbf182+j1nxNcVCJ84IIMvYi/0S3EpiKL6KLCBv2mkZCMnsK6tlcQwpiTQiSV9g0JbQGzzwkUAzVHiCEQJLLX1ABMcjzOCSJsoOXGCrLB2ySdtG60m/lVvaz0wfuUkVOZ7WhAIQAvbo3liRiILKzi9M/ywIG9fFwoo5uYlX2iUAMy1FKWz57eDnrRjFtCpAFKOguqeUDHpfJdRL18KtQ37G+4J/wDZNzqt0QweXJrnV/m5IpjODwzcyYcybxMFbXo+gEZy3qI5HW4R7wS7yqhczCHL8YQ5XJ83bhnmnamrewx2dPORn5qJTF9Q9V4eyjaI9BL/q0QwhVENpQ9SIvYDHD+K7/NcbSTpxizwEMmofoYA/Xr8A7cAns4jflaeaoUuzR6i9XrRZCoVRlIs6/KLbHjiv0F1bSM0Kd9EU3zVF1n8aJpK7ZeRBw/3PaxLpy6bMShfMpsxzlidq6SL/uClQy/5EZuDWabH9riF/T/G8CccZ6rSi5XxW3KCH9m5Wn81f2V2doLZKfcncOMAsZi7LVJG2auQqfKcfilsvt9zJHi1n6q3e055x++evP3r3a7/y5q/y0Jd+N3WHpzyHCrpVVG52zvZAG3isklS90yUOXKnOT+Dk14zoYACsfKh8iY7g/Uvmfd1dQyv0QptenYNExp136JiEHMBY1uUJPwF0ae5bR2O+jBCoP1rJg1ptW1AWbYyQoBIOJGNVQLac3h2EIo9xQDvmu7UKu4AKMoVG3O4LJos9FYGCVwVASJ7rst7kUuMn5iiHxvjfCPRKWTClqm9QXkMi+xtyWib3x1zFBTpIIV9TtkVvaNGxsIvV46YyYM6C9hcMMpH0FMGRIlw3PhPD4XDdMI3cTfIgU69pb1XyrF9rfyE2E2/g9SnVeE6OVCRHimBdbulEFFRqwNqKillgAskZTnTHgHRCDsvncXIsVsQs1S8C/f3HjP6hon8i6I+QOF/VWaDjmiejsyEoZ0OCVybenRL7a0B7iiuHfkVDEE+MBzePh/n2NLaumK+C3zHMb0zDfBRtMB+VcKAxDfN3G55SL6t6a2CosNJ7fP2mh2juFTZtQS97p9CX+3wvqFC00PFz4Deym149helSKWw0wtNFjqeLJnk6l45U5ekeSRW4J9lZk+xvRHbFK1hH+mF5VXaNfMfbRbjk+wF87di6SPMFJVsHLS5gsWHrImXrItSvrMcUts7nVv26lBuYQwoxFMVP8kfZutAtAD/jhzC9hjOYx4TGwFpBZARkd3jE4PPxcTmejstALJxMg9VS6hpOJ9xqcCY+KfQNNyHcYUm4Q6BvOA197/X88DGvdHK0Ng4Bzq9Ccu1pDJZ9Wk9RKwhXqD3U67ljPYym9RBFmh6icA5E03r4Vs8LKxx+qJgc2V2FGk5Qx8wQpIXoum+2KojjPZ7e5vQxl2OEIiH2QfYjMhXsRqfcGQR4BTqDzZWr49WdgbLBeuDi9gn7wEMfq1kmun/U8kOhbhTg1xIt0EZnP2qkCsrZAtYTW4bDr/53sGX4RBS0hVlzG4bAEVScg4daua/jLD3Gmbhx1oy53F9YEzQ2MTHHkLtMXIOnfpNU56SzJGkn1c2BpEmCIGWPltPfdsBENkQOQl72MMgXthH9zL2m/BpqRdCQ8/vbif8u62myMPQ49VRvxm93Xtn0UFFseMyUJD9Czhm1oa+fIaccmnSYH9hEdQazEWdFnKdMJmQ+MpJHJ2GmNrI8CtTBLjywiYDnLLjVdt9nR6w+gRoc+0mdJfgEPpTgCpjDcPLoSUGOflkOQKqkOWQwE/pBT21fOWiJ6QuUM4ce5nPgstw2KgvkEjZ5sNKBXLPk8fAfoJm1fsww8WBXYc81a5SVHR3QnOp5jNkryCpMJhajqs5HG1naNIOoGaO2DfAAMoCLscgXUGrkgS6mqUKxrIyZ2CgdHd8obZsWC6KhG5fd03dKWMaxWcp+fHyTdIfVOGGzXwpQDzPxoqrnO00+q5K8ezKZKsk7J5MXKsndyeSkktyqJqccW+nfJzwvutYozlT4cWji+MpfVp0VV8/oXGysHpMF7yvjqjoOtRIXhC0HlY+H/JDz/8peYzg8QvX1IhzksbAjFExkkE+RK48pAndu1s4YR5t57Pwhp+m7PC+8Vh2TZSBUTr6sx1Vln/aOTlwDCc5hDllAR/kxxFkkv7jPigjtqezAJLtmHvLWQo3TYIfgcnCzuRdIE+pJ3PTbTEQCUfpXvBjGbdVeRwQOuAarqKxEd8WoL0X0O+DH/bW1kTGBwrJ71UN2GESAjLdIKpZWkvVhIedbotDUkLNmqUccXufNMduSdaoPRIyTUpi3GOBtLrpFLWXG2hvG6g7FaxtccEJaoMhX0NQWtbGPalOqPlzByD2LY5s8aK1nyoD9N10kawQi0GdtJot+6LRTJQlFoyqSDacmQY9NaJwq9KsRBOh0aFEpyup76d/4J69UiDomlAqLkGOdUiHXdgI1QlTgWzVC/wcraoRf438eRz7Iz7pTI7zj1U6N0NXyiBQH9z/+KoODV09TGQSwsyOvnlQZHCKulv7Pqjtypw/6jLf99J8+fPNX7v3qUzEvfaPstzEseHXqOlmDhNS6oyMffMWFpWUy5wW2YfYA5LdYztyJhvf4asTcCqyZ6Afw1CJnV2BRBGuy7VO+QW2ihJrF8M9WbIX12IaMslVIEfIL/3tpL1tHZH+XYeO8/oN2bfKUafVIT2QyhE73W+f7CwixEBLCyUrDApkDgKjtaWB6ao5uVF7eourhgxSugj1fz51qbu2oQDp9PuC8if0enVTCUIXAHGMs1Mt+TjsMttrhkVRiZ3DhVU53dPklbX3285UdthlTtXnlWZkjf9BXOmJZc6t15asK3tg5iw9jIj4ZvkMrxenRg9dXTo/el0eJuDxsvFxxGj0Qe7sHF8QgSGyxos++HAe3splwkQ30ZRdys7xzzIUmScTttyOY6hd3jX3xVvfFXe6LtyGIHeygqSLHg7HcJ0uwqY0k2DDrHaBelerLYhOIEX5zbTtG7MG5vjSOmmx9bg0lzq1lb0M60ElxM2cYbeQt3TiL9kETCJz9AhKn8b7UGgzVGFvC+a0dqwwAtopilIJfbfPDUwNwM/zX4aKlBZQqp15kwsTiI62dOkZlqvBKC+HgKJADZV2Ci+fiGrvPARxQhNXjg1orSOGO3E/H4720LyCnevZl7X0ftsMQhYCkFU3hvJvZ29BxlCMW+Mp04UPEqbovM3u9PKq3AYYcuOah1Yd3m/K0YtQ11S2ZVKyDM4MsgAU2OqaOpnLzwEAPyQrsitUtiik7zz+Y0QxSZgDZkiXuoLJOPzMGuoEsZW35LA5iNrzc08FQyHMtWEcwQiiHwrVy1u+1T81JoV41+nu9HAPJUYFG6jrMYx5gzOcwP0fIeq18/097v79XzKsSkhbZBuIucDnc6TseXhAHy3c8XHj5om3F0Yvtk0JUXyxxA2DFV3vO84X7LJuXzhQt4K6YPexMsZ67BZ1w3JTHhYRGB6fj7Pf65KNS2kLLNAN+78D+X2UEeHgBd3S+5HEpf+PRFs7vX9Mzt4bAD4iud4XH8qzaXQvAooyL59pCmRwZ1fMOhRyP/sys0QKPwAvf/IzLP9X+zMX2SYvc62KRlmhp0tTvVEO/MKO4PGnmF9FbSiO/H7RPvXJESFHTvu+3T5diDPu+1z41pUCTBBIty4XbJzJMAF4Koy2chof+V5r2fb994tMJK8D86VRTv5sZ+t3MzO9mRn6dsdcVAHqikeMmfqca+N3MvO9mxn03M+27mWFfjVfAL08x69t7+NunzIMtsFq7ygZpt1KXtsIg7TL1phr6RQGE7JJ5iVYIn8Fo6ZJ+VknfIkgm1+YONhVYKLvYIlGHm848s96PPNgCdtMiaYaBfKPf39XUXtnMbcwXlhUYGcY8zeHv0qLeKzJVOZ3NO6PTd0Z4gRkV7PPzujWelWLaL8SkxqFt1xG5WgiofFFmb0/bZqL1/vkYgZOjYNzgXtLyzFwNeVLjm5xLKQspfCl9WTri45KlElxHQNFvVD5JSKkji3FnlHxYcUmmTanD/jvaoRTQWpjVNtk3baP2qnXj53/0rYvpxyL7nFIxVuyNwsMasVf01VnRWm7PeNW2ZD9Scfu8a+9w4LxNs+JpiDOcJkAwIxfSWHBETZEeza7193K3Ah2g3JcxnbkMA0VzYnB0s0GbxOZHP4hu7JrVsTOsy5bREh7w8i3QldsyCSw4zjP40H0U+NB9RPgAuAlkihkjLJuHlHYGRglmOQF3nX3hslQtaIb3tpN017SmgwVX6xUwODASz2bMQG4Otz4DyyEdCxkuob2nmzrGxHkmSC3PY7iPxMJ6AVUkgpE+Y6Rhf3SDOuv4knkK8m18FuL1fdrGk7snokmBX4yKwAOji57gjw8r2C9W+Du8BMcEt10WGE20HHlVOKpQVW6KG22Ai/Uejb5GuVRq5D40TQhwRq3BmrYBzW/WuBfX8ar9AH9UHW8fTi8kN14BG4WniWrq67IdXR85wE8YdkFRwRVUrqN39u2zWEJeG/0h+ywWQX67oC8cIHlbGq0GRNtVk1Wroa5QanyNwObta/avBv+pWKmsXtY/fIz3UGrguYRFKkY/mQCEwAVbX94peyhQDqmeN6etUPlysBfzGPe5uVcdN5HRO19fZT+TOJvUQFVlkGVazYx8lC+PzSWdAplOAVoGxjvOqW+f1cgP2aeAWgGps0ZgBCA6y9u42JaWeiMZJkOmuyPZB70yz6QFSFTONe0fvhdwhLytjc2C+AHxKcs7x4FQaCDUrPQUbVFOtev6joEWlCfdQJDOUR9zdEYldeKcbIYBMg4Ox3a7FfmQJ1I+TCR0M7O9zDOzPmlnZT0/GuXLOnm0EjOFHLHEgZJzTbesuSrECNWiJ6M00bfQlLKBXLOybeqUN3J8wugcZ9JTB/jSUUTPfbu0zknarMBslublOU/bcJVlGy0AaAvGXxnEtlnecvvaRMnqmhJ+JznXPYU2K5ZlZDd5cr9LNxjBS17M7cTyjnUTZEu3IOYk9w5qDfJWdUsHKUYLomc1amsOPT49qR02Jba/54TaYbucdtjPjh98XOj5o9ph9gBC5YSaoKnGCnlVVczVXqg2MAoFF5ddD3EAesvQUKHYiJAneaRCHh9npZeiEpxCw1QJd1NUjzHreeQOP8BwwRDegsCAxceEm8BTE29L/zhJfUjs+Q/3U+0zcKf/7gKdimYxiNr6iuZNJNvgWmUbjCZBV1sl+rq/ZXtEdTGp4IlCZTJN/BZmiJ/YzTYxS+DTwbHELX5toxhq293sDM0oDcWVRZinx262tT6U7WzRxF62Se3qXjbt+3IbrcKMtixvrnvZBlA37YeC6Q2K84RSwVRzU67FoR+1N27gViBvypMwBfeV+9vaHetFButBg2KWAnXSSq0jRQsv2fDIsJiTI044MvNKsQtAFhF/xz2AXwv+GdKsvjTxMhjmLT1IAorhlGL0AIW7hmJTzdHCjdfhkOaO8PetfI5Ea7V66CVHHUVbpSty/vXQz33xD5/zfZfr+Zcb42MX8zlRBQWququt0Tb4lSqoVoV1MbfuUjKqWKJfP8IgucApmOAQaG59yA2cy1vmqEwbKSbsqYaCr+ypeWKc7ZwsRw+fDZQK6+k6UN9n9xF5S/3oiZ/1PKnEu9xzlQ91i8YuBuDsw34nY5DiGAotGwxki9DL66atM3qLgccaI1NEt+4Lv+N//sJfPO+TP3BVW4fJNKNeJmAitdwbslTeWoTKYbJ5RmZIKk63XIYKRiiqk2ccVeKOflLlxX1pu+Ct6CH7KiJsrbuxqRxcUgDeoEq7H5yk3VNi+7sM9dxR6uhmhT3JxJ0Rz0nxQW7dBzh4G9UBr5yBZr+ipFtPx7z+IDiwhuVZVPjfjTRoLnC0+CXEUy8FGBUafqbf50PrEU1S0hdY7YryfDlESH4SUcVRj2t5ZDNQZFwPQCNJlZ3sdVKh6el5Y3rJagPi/Sdadf7B90J0/V3QrBaTXyoARr53eXksUfam/qTMua4yZ7FuJaeOMQg4b2IE0UTSHI9LmnGYoraoeekxtfmEu8bSuqNeIeovVDOC5rpxoqMXXq0LGFV486cJmZNSyFwDY1OzSsl1pHDFAjDrdzGQh56SdQvUpZbOVPFFAaBVGvsvCX7i8mw3lHGh2mgs2uoqNkrtdTFbJ6PVtxY5/vjH/jHEAv+remRI+il52QYiioptCzwM9mHx/prPRQh6vkdy6uES/+BdTcugR9CLqImqEP+USXpFd9do3nPP889FiDexe3gHu0djn402PFvDl5znX1IeEJI/cpTonV77rvNr3yWh4PLzg8u5lntrqIZ/XcVfQBR+XdSDiMKvi7rR4yj8ugZCK9q7gP84+RYk4zf7NfvFnYjCb/Zn15uodyEKvy7qqEQdrUYdQxR++xsi4aeamP/18OsaJNZ/8VtGTRyRFTU3oI5j0xEzLNt/AZlR+mKojT2d9QXNVJ0VsMU5NlTA7rJzMdSTXIG8O9TGix0BWIYZK926U/G1Eg+MKAwDZe9VsqBtFk4RJOfuG6rqwu9DnjR9Jtqsatel3RYRGngKQzkEbIkknx/WgyhFElfSwG/xgpI6uWNJ0P57r9VTI1/dR+aBjYOmQPVMUm+w/b5y5IZ8/aLnQ1PE6WBGxn0Fyg5V7dLHw1ePpglUZrC4IjERp8fSXqQmlHyfam5mqpUpeqUUZh+u6mKGpS5mKK+iJgBdTH5UdTHxUoQUj+piPpOHqDTQEvXv/nuzgEV6qh1BiU+bKq3PPoKq5cQ62uz+1q//e1DG/FhYdaBT1Wy3rUUYpcSqwxAbt8muFAVeRsbptTpKg+rm1dfgowXc04EVjuBAqZIZGtcvmdGbTDhGtAFUc1ZxDofvuqg3dA9rFvZEVw98nuuxr2Y2BifMmpEMC3/Tk9xUlCrsqhqI6HrKce70RRb2jCitrrBAXcXLQFUoKwe5Ei8KVXqXDYDYdH2NyvU1wPoa2GUuNRe0BOct/xUZUeYCd8Z4/6AGcguAgrIqLS6R4ihFhtKPE3ZPiTPKYaGuzGYoPcUVYXhZrjoq1hQb06dRJUg3+RxPOSWWZ+uJdSCha3n3uChgT6kC2a2oIa5OaimGhTPYNSEI+I0ggDvl8q7BvY2q3pYilSjMY+5nh4SEyvj74GvuaeAeTn0N5lcgWkblUfUtc76RffhGvoL8KSK1gNmBq8knPA96GsBKjDr8q8jHJYkDqk9zr6fPuzQ1uBPPqmfkgf1+wwbuNp/cg+f9nvOMLBSspQ1LRB3qnsaakLYqtm8EmuNd/NTecu2IAy1lBOirkvZdwdq+2b8++/pbf/Kapxkn+KHNpBByxzcKJv0o+zjyqlLD0WhQNSfCBbP9AqTVeM+o4DROkFOsYg2Hcdf6kI9MqN719Yo4K8Ac5T4Yx05dGU9Qhw2/omzJhg3kjqeNSfbCkIEvLOCPoVIlyu1vy4OqOhoF6Q0jV+wPzo1e9f5DXWNQ3zHfXOVwheqrh9Qs+ziyasOwFFijC3/BlhI/4UrZkFK4nrIFFK6nH/Q8ax8nKfyB0TPkKb5RmKtmGO8jhVO0Jb9iDuKI24lvlsW0siw8nCzcc1960wvfLMsw/V5HAMj5y4rIv7C2zA8PynsRBVhcdOVUAwjvwy0e8dPMP8vG8VMEwnSvQDNy2mRzJfNFYfYQUtP3+54/ufA5F1iqzxdaC3P9UCgBQ2HEVaouWNj8I9e9vvWFv6oO3rsQrKIXYOREnUfa7AtF5Z8ufpa5wa9Bg4Xv0StdTNXxk+1nEvJCxdpIl0OrVinZs/Iyuz+igeja47n2eNqeGtpTO4nG6BYfJVlZZ7gJRH/kEKJ+3fPh50rApVitRNN30qbA0uXQ7AYrFwB0ydLLQ3CLKPwm2o/FSrRTgtKb+7BqRCWdvIqJdq1DY3q4rvOmrEQpQk/SkHSPZ4xsnb6XL2mup9/FWDFFmgBBuvEJyFcFlaAYiUIelsrEAoyDAN+YCOEvQn/G0Yl7net+YTYH9YdSfpY+GItIN9BA6D5nF5IdgoAXIWdGkYSvkHhPUy/LOxKb3QP8FqHCj3/y1PvTc2af/v2AtgyXJhoWYtCUccAerwm2QLbWdRUDiEO8UBVyE64aDj2RLH7iKYGsyahcEZpxNNBmtJBVjdiTnrY3RcVqLc9MBwNKpYuWMZFe8sttmN5y1yajwFyS70hOEcBSZE3PIr9Gdk2kO2W/1xywqPF8IyaeQZzDwVnpWgs8OfTIaQZXZ27NZ1PwZxRLI9F6ivjUg9OgUKafiNlFmqPQ1KrM4L04ZaOM4zipo53J3ih8+RzNDWh2HXlTq48XoaURA8zoPNxftbZmBkX5r7qkWdEKmVgdxj9WYy+MSm4l/G4fl7mlozd+6if7eeD6rIAPh3fkESipFBJln5JC/OcXMeaD2OeAUa/Tv+dHPvwPux64eHiVTLr01zwvdOuLW1xwiZr82zgK9rp6my4eunRU1g0Woep30fG+UxjqtaLAVH7kVtgzvBVacbBmSKEWPh5vP03YtmzoGe97xJ5Qm2sVqBBy+3w3Ow9HDNypVeLsTwAdkY9H6OC6rHfxmlqJA6bIdrh/j6Jcfd/P3n/JOV+DrT4MENOdaN9tt+LfVy5mf6x3JqlebdW2hOYShl/aQYxKkgD7d+GajPKndZSxr7pTDuc47U5/zZEFSeSZI+aka9UEJRCQchr6tmUvj36MHg/E8nzSr+cNveZua5QjmqbamOYHT3IKqvzgQVH6l0m1Ucy4S1imhq/g9ssDaONucbsR4fcBXo6P6WUptboxUiLxHK2Tt79gKkHNy3oFjiUJKpXix2FGvfUWM7fRjF4Lo3i9mMGRygylsNbRoAR/+JLwLaaih/PTTA/f8jk4vjjAN8c28nk3H1TxIsw96IjI3GhxecUiOI1Ayi6WcMwp7VeqhF4pWXJ9kzQy0To2MFGwDMzggs4ExLqWRC1j4i8j9lBEyzY2IK70QaDWkgIPFY0WazZxmYaS29DI0SZkNi+w4JE3oToiaAoGCk0xdZBWVGnPwzUulvcXRCl0XjaKRVocHiGfFoAcCxulWUyeXEMgU19cyXsgyx4tUEfO/juIBYMHVqRZdGWZ8HSrL4s/zTIq2MIeVBUbT0ZHhktnOeqWFDRlzjUlM3vaae0xDZlDA+ZoQW3WU426XN953BaQXOuROW/YQ/w2f9LuW+OWSqo98FscAEWVpU+xgIMQIx43G+arZsP8iyxj9ftR2JRD3vBaSxvCkjYYGnDItztNfDui3+RZswB9P4+tWRef+I/NCtf1W5WZg/uyVv+gooE/1nxSfXGeYQ0Vp/RfJiRPr65SouZ4qE0xzaxR88CGqi90qHMAd7Pao+t0HomSFpSc+GMeclXPQAUxtfImZjmiUmUatXV59r+U7o1IXmDNs8PtwrW09tpIV/p+9dg5gyZmZbnH9NZbtrGhbnPoBoVV9c22cCogFhlTbuMcraNGUou5SnfaFc6zTR0c/vOPquQJsDeKeT3Q5GQmQ8Nilub47Hjf97zlL8/de+lX/z9yQV7AZrK/lrxzcAazRn71bqsSP1cff/m1Dzzl++9+LS9d8+vckm8/89V7z3nHwxdTe30wuGPf//zLy1/z87d89mKMQnswVPtDKNV9h95l2rxi8++HlVYMTej+iwfrm16wjTC46hi/ACh0QTEI/Wo/0mUvYKTWcyMfRwEtXot1ekDCTd4wd5cC1U6DW5UTF2yoXMs5uIY19abxQMCxbd4ryU1CX85DG5y5pThMrZIz4wW8IbwqEEpbbvmrhJoD2MvRdsbk4Tqo2n7ur6ohJYpkF/+nIh+Oh3DMPEAP7hhamd7q3vXyruoZe9cHzAE85BlX6aEK1ZXojVg2DvQI7846Q3h8VxSaPngUglkW3EA3Akud3PUMLP0Ziviln7j8nKe8cf6/MVMTl7uw7l65UOuVV1YpPqKl4SySi6mrFbc6hYr96C7/wcJvOnIBV0YB9wxfoePgrWtzEm2OB02/XI8s0o/U6xC2QVQDZChvvR30S9qm686D3lR/ISGvNvdzEiFwjw0ctYG7bGDgCRev1BXHZMoKaWiMpBzzLL2M9fAHvNHQ3WIVGpNNo5YJWkqUSJWZeQrQsBimlA5cKUVriAX3mDek1MUiauDxQpXiJm8/AQFSPqONtWHgISA4CytSeFNCrIeguMOOnc1uQHeUUI8r4MyoJLmjIJFqxAy0QztXYIZllbDnAQnghybh+7ZVWnMqIDTDBD9vWc073ZYqc/CAp4Ojb/d6OkL6dgxvA/uW8csx+0L8cq992c0vD9hrKxQ/x60SYNrNCMfZ/1bBmb5nfyZvmpbpytCs6LqYezo10cBEpxKGT1RdB1q6Woi2sQ5pC9fG1SyJCuZJXpJhuV/FdqpjuaO27lbbBnr63sV7MsAXM+rjbVSfqcMargX/6GRBjsjqNY4q/yg0FNbYflca7oKpdLEt6pBcLFSMhgXGVXvATehyGkfPmJgJ7aoMyHXM2GPhOWpJ+R94fmy0LVQRzhne9ikQFiNUsY3eOVbnT4HK03wVY4GUiht/TvLMG8VKzoXRaLieNHlw+AshgWJZdoOa6zAjVbPg5RJwP7tisTsPxozgecbgsd1U657aWJdMf9YL7WZMOqU3CkUhkntTdsNqDkmXXWvzxCgUN8jP1bJ1g11ZGXoqbKLeYU/VGlqozVW+UtdCpNqbjJhQcmrn2lrUjdWZf1IpLyr1rYv3pAiqTt7LMAU/AxJsLIbBUDHgf6sFy3WcFxFlflEdq2yMg/c/42v2X+2GkmZ+rfb/6+kitXmGshUPXoeJ7Or83p5e1jWtKnwKVC1viKZCn1Jf/IrVbx+Ckx8LRuzoxqO2tyC2yP58mnEsZ1Xe2d+qO/tb9Un7Wy5dUgH1R1wNNFM6a+Unn8EnzsbqXzg7XOqzwZwJ1nFmXt61349fKf3Za/i9CD+XrO1nQ7Vr/EeRuO5BH7QocSsTwVRXcinaIu1CXF1mKR5hUXPH3OMWWOvZu9UEWF7HCCF7XufnuAXW2B3B/ZYXqlpqVUUg1o7WUXVolAKMUwO8NSmA7PRrrK4ZwKiGehJBz0OQzCZ0BFi62oVyghRAlEgce/ulBuLqmHoM1fuqegNRqTcQ4VUtzUJvIEKE0xvAS8EjO6o38O04Rz/kmYP0uH+fPaWMkSGUPkvz0XjtlnQq+1xpzSnezJrTZ/89KBB8IZZj1HKKDjx3hFObwsnFWFcF/MBrHC+epaosu4CdYmMABz9dQEeNnPAX/j6qVVm3K3AsVBEbstbeLZ6Ym41M7E4WT1O4/1eVFIt2E6zqHUa7WxK8RQCBJlDkjD58AWMGgzknlftv1OCA9iGCu4myUYD6sHrmFUHNypzr/dHF5QYLBxLd3pDCDbUQuc9eqh1Wbb+sZ38rVdVhmSfs+xRitUXN5wJsx/16WDBYX6CnWlIbqAXVDfd1hYSV37lcEesq7sp9NV2lOXhspFfoxy3evo899brvf8vgcxcPtV9G1vnb/F62NeS26o35BS7LXn2LtEQKs79DLiX0AGn2AN7NSkgJUFvXbJ1bLTz6T4BWCfAY+6Hsi/IF8BoDAB/h4YHz/D2V3u2t9A5jCvipwJrCy3rn+fukau0TStidfcmUGUEMp02V1v094pVg7dRjk0ixNnRaB5rcrSSvTia3KslZNZlK6OL3BdmXzSnmwBvVr3A0yhmZmhILqnZyChZ/Pa5ggQNZ63LfKVg8e1LB4qJK8t7J5FolOZywEuUa+BavvHGR/QMa4zxVBHC1IJPJpHAs8Eh954UUFDWTyXOZnmltHVANhnWARvoF/DDkoRq5oVAzF3IaCKrHAeSf9EFwZxSE12K9q+zKqy5Gymh4Yih9M3ChG+7EEgZYzKz5RxbRxMhqjbuqQtx69nm1i539Ap7DfX93wT9/9Rnn/OPFA7Ehe8Sdf1oPDbdlNyHnEZxmTlqKDRQExv+Hm6FFVPEEUlf4VpomTHsiHjW90f5u2k+v2s8Gjfetcdy+NR5D3yLrmyMBNiSkHXK+OerIVgcWeMCCsX6CX1ec+IbuKTY50tci6RV1oRIcQJ8mMfVQ5Dm7ipWFWAyHFaqfh3mCynx3U+TKIr6wljkYeFTdTFAsWvER2PJd/PBRWsXaIKejaIKUue/xG+ge6Dz8SXQlRBxaQEh9rkloQU3ziNjlIa7kpdwLaLfaxfUfVb7GHyrhXJiYa0Jtce4eHyjijdwz5lw6Iy7EfIox9u7OzohCgl42GOb8U9WDIe/5svmVVVW3UORVzA56mjAk78i+X/nAVXd/8b//DZ+DfZf8+xWnhyByzXU+4Vw+AMsP3y9njpq697aj6/tWBh7//228RvN1GhGg+VX7z1oJeRaJPsc1+0dwyjmBJ7ahQF4Koafj6a4Oo21xMpzEyZAghQpvm0BFH3C5sjfSoGkV55BZGh2dqjnE96pqlLIcWamCteCg/8HsTdaNK3xbOr9nMIe3YR2d6dEvBdPMAd0x7KSmULUuq5mLEP0KjjyiioaVcuGTMphmYAyVKTusVs9CRImBRL0G48OMORDcOMgI1WewN6KFCVwShbZ/sg4YW3lgtGhDZwMLO98gmnTdNWlYzlhoi3hzDNNy9RHTchwbqWk5jDXV1eibGCSWLZponCcV0b6HMw1PD7nqk+bmIhibQ0lhxdhcZI3NoXBhae5QRWxcum5gcZM7MK72mHynNb55C6KKAbpQDNDVra5+nUKnq69bMDRXNzkgYNTQLVBoH26TFJD62cm+WHFYW1dll8haDVMPoc703DvUW+31vtesoIY7tDdn9l9RE/ZK1w4UUfbPEoERsQq7q3CKilHXnXqeqC5zQ/Xqm2qbG2JdFPKiQpSVW9aMQCLRKZctsExtPHbGkomfiIRkb/yajFH2jXTpr+lOOBDlNPEEVKr5InI8xuHl9duTlKe2lZu1rotebsX5XkWFHD2M8NiD/kJkfrUcVgAdDlCI3VL2IICDQR3Znigvn8je4V4I8rN7dKACVXPOG1os5GbnionlBc2RpxyzaySmBfU2jelztdjZrpmkNleI+GLGmv7g9qaqXT6zkXfG6IfIjmPKKBqhIB1DQBy4Vb+afwBgahljE/kcbvqp8fQ5DN08D0nl2FJFQS6iw62bg+vVysWoIzhoHeSd1NaUUWeI2+8V/XCapfmKZeBMju3mkDxHMzLkAukmDJqhaQuM/uM9XeTGLJWiMVh9khGJXlTE1b7LxssS0KLjKnXBK3uFgyO5IC8fWlVHXIEtgQU+sB/kWfeF+bJUyQPScWxK0TE3eTPzUXR15YsuddASKVN7ZrycF1swvl3KAKplQGwZ8VmuRu0ZjAv5HG3JZwJAfFkgPQCkhxjs8mUggATc5+xpsI7CyH1M6M0o+fd13avyIhjTzOk4Vdy9cTy3bx1Dy631aIu0Sg/bO9IIdzJVPV6PUXWsN23H6hESWyyP17J8xNZSw9ugekV4SrV3UHZkOFkh+rpAW8Sm4qzOopV+xIcqPUX4VZ1I8xSA3m3l9qzIWlEX20gruO4eIdTrc8mwPMo5tkgSrcC4zLb9+XaErsmJYAUBt3tz6nEo5FDB+LmD/3Zi7ZhyG/0Uvjt+OYWEJ1aXrbQDjSsiFQWETIgI4YzDV3A/dko/JKY4hU6B+YpTSTLb19O4fdu4feaS5CwlWqDYhLtaZFoavkKOBGe5Hwlws4gkXyxpl0s+De+VfPMUmaMEoBjM+eziuGQs7nSlllBagEBCdmhzdFp+ispT5Er9KXR61dQVv+/id4qRaGPnxNKMElUUpv4KQJro1PwUAgZbbcNt9qoJYVAKKgAM7ax2hcvU/mpv+FWt90gX82qHTqrxaCwPm2v+I255Sttz3PpjtHmu7Pd73JdQxihyjXcjhzjXCRn70U70KmMYyhjGZTmXczlmZKvl8PowUc437hivKAOwA7vHHbQTVo130hbr3HoFA99gGCwdkNk3r7brqafmWtBtLm9VVWtE67ViYgA2EVWXkr/QeSjqvBRX7Y505MITjC2pbWma47oBmzVZ2EB19HTZNnUJb0tUGrNcQBvbtADebmFE+tQq/WC3SI8ERpLTMjmdSFbYGR6EkgOG+SDmR5jKIh7ulXETf05GUViSNbzzki8djkY1lyKaw1AkhnauGcZAq6nUkEpxOfd/A+xA1W7BInjDKwB/G+c4BZrr8SrPa9qi8xedd2kGVeZxZUjQMrFS1Kmu4ZlZv6tE3q3fGKSS5NMMzeP0erGSvGh5C738rWzfPJp7lbQZF+I27sjeIIv9il3UwTjkpCjPKDZvrwZusRRnHpDgOcZJCIHgL/DfVsilZH3BeoG9wRaMZA+bHLnZN76oKBqvEougd2LRUDhuD0AndtCKovY22pnPlHrv8/hiWzlBGQA4CJ7n0Z7R0ZV1kTruUvoYOzAHeAGVAbBZAKw64aiHuJ5Mu2KHxmkDZR7QSh5LM2bRjDmK1qSLeM7qdiei2YmFuFjLF2grStxKZGfHlhLJt0ybA4CEJodIvmr6HDirMgfyHIrw+MIgao6hmLP4OlPB16mIOjMVUee+Dog6B0SdG0NUpSVVRNUuhNKPEUSdVUQtDIbOOgwFU1mUGLqDCoOhK31GSv4ji6HgeRZQ+MLxMVQHeiutruXbFaBbDGezhXbSrMXQ7V83DF2pYOiswdAdwNCdiNupcdpA1Y6fzeekGTv0HAP9g5rhDoueK1ITyhipaRUxq0QolagoaXiJpQvTsDQvk/OJ5Ol7zFr/Itlj6hVk3WmasyIdmZ1cLD4phDbggJ3hi6LU1wnPz36dhxYYTTtFxWPezchtTDZmxC3JfL+DpWxNaLsFC0UA+uhmEGa+oiokEuphOz6PhXe+ssQpQHaqeGMnOruzOiVRkN2Ctxs4e9e/SLQKvWkOynCi+jzdpimczoWgtK695WnbqO664Vk/b+LxgjxVw+qN4xxKNtmfQ8WmkPnOxcj2uiqulQO2fKZ0yzyzIcxPkVUEkvmstGhmVIgLfy2jQtyq7hPAPgfvnfxTaV+bOiLEndPq8ja6VKEo1LFC3M7xhbjY/LHzTSfEbVN7UyFuh4W47ZQyt1srhbdDmtUP9fxgMKBs3G31EWzdKpvE3XshxZ3sdQ1kNyvj+YKXdxLwyEbgMQd4VH3pZBYe2fHhkVF28vDIGB5zFRlyhyxbkxwdolHtCZEy4JdSACVmsIibo6Cewo2gWMwHQUDxrHIWgMAIMjEbVwHpIwZc+18NcO0K4Dwza7LqaUD7yFQI2oaq8dxBwbgCPCJ+0pw9DfAmTwM8ynAOMX4awOAAXK7sjTRo6tC1eIpBa3LIo34cUuDO1NoUVY7UMvIrh6SYv1XMyahjG9+ebHxGbW58e7PjtU1RrYa+DZhOCsEr1aSNXnejao9MnPMiIRpQ3cZnHN90faBoCBtuXODV4JZKXa6L9qsYHqYQaqD7lX7LTSwVxeNGk9LpFxVMINulPsuQu8dpMxQf2O/iz9H4trPMVkXd8u4Mt2eAN/2nVey5tIfzwHkKnfaFsgGjbUag9SLZFla9Nd4belHlQNzXL/QYpjrU1kN/EdnjtCq5j/UgY+LMznsUZ3bh5JldWJmloZ2l4fFnKTf25M/sQjmzo2gquY/JHyH30SS5D9Xn5ibk3q8cS1M0ndxvDo+oCg89d4oq8IgsPKLjwyOi6OThEeESwIgP26BK7qeeIPqpnqxV1BTec/Hw+SNqIf+ymVoIUk6sFoJMJ60W8i8nqRZys+81JhVrdB4khbU6x9NBvTuJhN4epBnTUzFyJIQL4ThXgxVF/ivP1YLquVrdnaslFKJ7cXmJ2lUWcWX7Tbl5w96LiSGdVP7ch5M9UWbz5UCy0GNH68S1ISZYKUIGeYR4SJo5LkPLrSLplAOy7xWDHJvb/HOGt3BIbc4DQz0PjASVI3dW6s4CKzb/Dnvqv9c3vlwC8bOpL7moOqCBtaoLRtVDqoi6PeMFVfIq5pDn/Aiq4rbLX7E8F+Ixct8mSL9FumZsHqlup5wHWtER1KykQhexOhaRfjgIwMwHU2hqEUzTNELTQ/TUO1B4zN4/ckqKvWIMyhFPpRyxo6T/SpRjmvZD9Ci0H2DJ0aJ9fFzth2ia9kOM6XBy2g9V2vX89K+acUMt9F47ZqM3qnpxun/MJ9OnnU8mTZLJcx+CZo8b9yWP9b/Fkmf1tWSPTdUuRbvMkNe1pgfHavqCq+lBV9OXpSZMEu43bsVh07tLm6VnrYlcpAhhZyrEHrklVyCq25EZCqBTYIQ3yekBnR8QQkYTM9Ow3qsBR77LP+wXmYoQMkrXTFoCjweigN9HY7EFfVjo8SzNQJzGgzJTmgAnsWXeoDaOtTuYkZ3xo7AZdMszzW739RQ3yJtVqGlnK/ClTMUuzVRpeQtj0KFoij7znFjVjghPMs/MPGV4cHPquaijujeexQWYJE8ANFwoy1MwgAo6trTBPYNEHZ1u4DEPCdRVooWVgGQn6i3Z2XpPJZY6uCYF4Q/XkKJqSjkGj/1wbEupWslFjbZY/ruql8+WKgIAYoNLETmjSI7gat21DeCepbp8fmVRh4f1eURoGdW2oeX5AgAIB1MAHz1GYDX/FYHV/DcA1iLFBNMGArQFygjMePbrsKKTfVUngePhF2n2SLFAC2UMH7XPrpcbK5rd95/+/sEPb3/RT3vc5HkAF3Pufr8UGzpDRpBmCpTdtoz76s7wRdxJ84MyhuaPrAvQIBWj2dENR1CrXf105vXE29fd/vOVECeqjtQ0+ID2L9Bs38u+ho5x3cjDr2I+R3b/WP7Vh4H1GQ/RX7n9ODPuiUH0+rV19p1nSW3obgiF07Yx6t3fg49oZqiuuIZHgHgMmWtcU4pKDRCKpujiFOm0IgQtWkaGKJ1jaoSWmTvyad4xZGbGSBUPQJ44p5JGFvrl6Lh/qWpZ8N+y2NLpohznSmeOluC3Rk5EFgX+W9ZYyOznIfLyX48r6OarFPKXPq1Kq7bSCvX6CQTGUlq+nWsjSKZlpd9Gq/BPUoR6vzI8HHIkXohfDuqLHoo/EMiLnpbfG9BWrQCOH/LcaPJvBxO6SqtyNJlTDGM0xn/CpOMERfO+pwLga6QXRO2cCxGJM5jqHnXh5iCkWbntKbjV5aD2fSve9ufb+MPt3HGSHsGb1Pa1R9kpn2iiU4DaI+8XEdpPtB3out0cnlOHlmVUtlcA5iqQ4leBNwjpYfF4sUsodokWFGKJeJ1bUIh1GE/ULw8/ZijDd5lu66XyFsyoFFYPf1t1WwneloodtGO4LodiWx2pPUUvRHf5qCJvi9wYiEraAS6s3cYpNK4eHilOpVOH+Wnu2x3UFTxryVpbbF+jnXQa7UDu7Eixi3YxTTh9VIuFSyRRL+DMp3KGkmTR6XR6+XJlbx2fmy/p6NCJAK1pJdlC7HDR3JhVEOdVgcUplYRTzDGZ03BoUl3aK355Qz2kkRJXuSvbUXALxHmH7BF2VPQUtQbdF6KgBvQb5fNCv0sQkaOg4iRK0COnrmXozoJ+N7C/wfyL0gbCHAE+StDXSHhB0UgExWmRpi9Q2n/BWnEGddE9PjM8E9utZ4GPu+zF+VlqYf5sTu0eyLfQLIzsh3C1c44YG8ifgEWWU1/JhxNAgkyGNkFZu3W2ZfkTdTrlT6KYCjLRtSLHzPPtzCuejLnHXZiiqHMuZiInEQLHEMC3RxHAV3e5r9w/LX9gMx/2QEIZZmeBFj+Rngh1nafQk+hJCJxHZ/OyeiZPlHOYAj8hn1d6KwBzFgJSnDYqy8eH0UKcVi0xWMWMVpc3ucz87YjVIJMqHUbCMN6rk7bDpGqOCfCMiD0zCBkwf2iblqnkBIWeVxIDMsSFVrUe2o4I59oHdeKLpxBxwGaezLaK9uDOEWEstT1S91bXH61a2/H1rpu2AqF4ruGxjdpApnYf4g+ZMG3jroQW/81As01rzUkqhH6BIdZbSyKd5/wx4VXK1Eopr64CZDpL6CzhQbQNZIYV19QXmfpYkrnJYIjg/ykn22N8pf0FlFaorcioK9OTZdF8kl2h0BLjPyqnbW5doidLk8d7jZVjO9CZnpjnkJHRdjRVTeNp48CFlG1b4hmAoG+a5xn/ZyCH/Bx4ylNsBej4IwXQk2nV+Ea104I/lvdz6Vw0Bc1DqxR0283KuqLafGML61Y0uc11PeBpG46ZNtylbcCtTOkSZwROyTqJUV2ySLcIdmGROnh0aA6POeUh5snDmsxGsEQkJ9dqmRqWSrHLDBbxtUHL+Sp40glyAkBNp0jKeAjpMwFlOHJlNiokpo0RVXwLObhdloU2rZp0Jr4ltckASwUbwELM/60KAwRLCyQqORzo5iuW0tBKvsRlhcUKilJuSataVWyTKkmqPI9WLfKwfgHymykWjmFRSE+RrBmyanJWJmfK0AEjCB77uGncE651qyAaLY03JDQNWT1OQ/oveDzasgowubasgPyEjvxAMnqS8GmbZiWPP4i0dtLa7cRyc71KhLaeBBHaprwipoafb+WaSPqprifH6tI5n/Mn+YoYhgk3pTrbKlSHTkB1QGbGKI9SnRXEAX9XaKHSvi6y/19FiJR9F1KTh/zweRThEI88q125Sh6j4aa0xFEOBNKSNhREsyMEgky+zJKqc5VUgWbN5NuVLBDzgLKBY/yFhx1ojHIV+XkSoDzHk6vKz5dAxnCcEbLEUKNclFst5u+h83Sgi/MkXiIvoFwjuaSn8H9PRtIeOt/kPB+vF3CsvHLhYDOxEmE+blful2LOrt0Vzi/jp+3feQIQQG27yhKeos1EscQNSArbAa3BlnOudk9npHbZZuDg6IbPzTKdHCeeaanUjU9GqZrir+68senj8QgdW7I6RjeUMACxfUUm4unyJGpyOfU8VAKhBZKZDVuPMxvcTHji2ExwyE7jG1mO2yo5n8yQ1znyRDNHlJq0TfPIzIWtx5kLOg9SimQ3oF6WdWerL4fxkkEzGyK4xqXGR1hDjbcFL+0HL857lFLXrIS5j0J1GyJCkxXLShEsFWFK2B39Ub+y1z9mXwjYYF92Y+T9R7mCRwyNGEIW50NS8ESgg4CCm/LpIgJ/mpyB8ik5Z2XRIiivypKeUlhsH5dUODRVjLMNsCVPR7nJylIit+BOtG+ycFR68qVvz0mnuT0+tQeSKebt49yXxzCjtQCGRhUIOuHcCG/WKFv8cSGxVb2M+2KIQl8GeCHzchgvmXk5iBe1ysazbxv1npWHmIvYHoTmGNtYCCpW8bikgK2eSbTOc3CxTAog3NDleAruPznPube5buZ5SU/xLJgIgBL8EyiC0nY1NWhPX1ZlWaPtsqRVxEDqRVR3dAbKOzD/qpr/Oyr8QbkrAZiN2Uj+JL3I864trS+FFNwhXvgGQ4ogUrrijqE4VvAKTnQHtcPsehEgvxPXj71XADZf8PWYubFGdZa9IIppAL/F5u1+vBWNyrnlup4k1KnuhOS9Al8r/spn9/n4HXDpB8Saow8zw2tyd7P2LfiE6mo27t0wTiwx/6W3xy+PtnFEnNecffs0/ZfAD5wzi7ucbUSrpflp68sCcMlehZ62PTH4CEe71t+F3DmunR4c8vkIDkEezgeV7urL/UKRkV0O4SK9KB6pBWh3DocmdllT4HYMAaT3MD50i3mpIf8BvSp7M8ehCYS+3eyvwcEFGq3Ggu70sxvQUmeE/ka8Mt0vm4t24Blm/wwZvLZHJPg4QSAf5k242H9BYqFl/AaqwIcf99Q/Xk1NcImxM375EaS7Kl+NKpHmfIK4+rQFIU/WpPQPYhRR/qrUN6S9OFeOdah15A9sDIe4YXNb68CG6LfqCF3jvI1MjpW+vsaccvAgG4SH5adrKRAt2iLG44phUWdkR/B5wwE+Q/BqDobSXGMQkuKKylq9dGEyrKinleHBRWyJdNW26bVohAkfQrjvsSO14LoJZyrOc8nr9BNx3KAaLOoHIQ/0HntY8Y+COQu/tvjwAJwUPyc91gjF544zbvyAV7lDDTsxX/D05PreYXlyffQOBI03nb7YjDo8kKhNLIUONFVNg1bCRxHWg/Cby2BwjwZHfOkcq3x1fyX8oIZhEO12G+TWHCmD97rYQxJ7i6ap4x09eZeupdrNB1w3pV33yTuyaZIW9YXKF4fXR74IDq1vAgo015Umn7k5fb9n5zTD/D7zwmNZzul7NQ7E0Zs4MCzYQtefcQbUD/OdgMfv47nhKRG411MiUKFEd3lVUjTwqrTosHd8YnQLbA5KZzc3D/syYwL2Beb5PGNr69cvzp3VWrVxyzWM9iyvl4a58hhAqotNfYrVd09RZwWgyxG9741/8yuDf/rNwdO//8LasynYfBlgf45IhiUxmHT/fY9jLpLgnyG4R4LHEDwXQRwDwYoYgl9A7C4JbiC4U4L3IkgSPIzgqgTvwWddJZN5rDVm7tMFV2PL1Zi4T8HnBowQYr8gez1md56ovVoUx+Qmr+PxsrxRXUqZ1CduKeU3WB9oHMFVIYrhQ1UBjKTCd+tqfZ1842q1uq7Guq4GZzNOKV2u0liDEczjwJuhauac4dfeO3w31lIfi6hf8WimiPSgr7IdfCEETsGmpEQ7j25teCj4C172BvTcGC3W781GHenfU+hCYmw8whp+eRHjE4mhaMEJKdrhny0n7gPrExTt6FuPR9GOaSohfG8l/ADCSjk+okGZJT89SdEOapx8dUslfKeGMYM/ihIQ5NZorBA3F9yQ4N0aUaVo6JqlTwPXTaW08o5smqRF3V754ujoF8GGvE+naHe60vDZvy+KJmwgMLuiwueoHIx3jtO12NG1OkAVK12rK10DVTsBEcMcUmg8+/88enaT0LOYjCHN50HPSxEIPpgREBJX1JXiFQkpsTsCzp8Sts8fG/rwRpRUIS2jZAXzeSpZ+eHjkxV19/sYycqhXyhnz/0/O0FWNu48Hlm5W1PVqnolfL+GMX3fVwaDgz83SVYerHx1WNI1PNAwEOcjdzoCIrHKHbngXRI8qhFVsoKuWSJxC8IVsnKTvCObJmlRN1e+2Bj9IrhL3qeTlYErDZ9tTla+SVa+SVZ+ZApZEQRC4G0InCxZOXxcsoL5PJWs/OijJSu3xCxgiEp/leMk5Voz1e4oJ87B2ziYvQn1rcj00EQ3PV5WmR0vmZwcV4/MjcIfmx3hhbX/4RD/eVW8v6SK9nuOj/V7uT2wWCteIQ+/SmC2h+cVmq3TYbci2xNQKCBSW1PvnFZwVL3+0xsaNC5i54YTpohRqPncTdrYCAr+GHlIfTTtcbdYitiaL7qIXBDaqV1Fw72CZU9gWH2nhP4O+Ha58QMFo6sIPYTISySYcWgfQmiFThb0HZNlFL+TMnvLFRyWBdco1g4F2c2Cz/U+f34Y453HCB6UYILgIQk20LXdedNsBPyqOA1vTTGAiS1A48qe7gWam+8F4s33AsDiqwrfGPIKMaq3oAV4ewF+rhJlzFiFbJuSGRRzbfbjZooF/O0EH+8uVP90NGrG+l7ndKkyP0GBPOfYNxBRhL8ppR341j+JDRzlgDDFhvrdLk8uJNDnvZoe3IPniEDClnC/DTxoPj2ET28JnHNfiX2fpxW9S5/wFozPsEK4CXd4ZKU5OLLSXH38KfcySwIgE9xtiUAsxFmJQKxEQIm0WpPg5y43cyLQbCdYpEm54qq2PVNYtbRnybhjKBRKZmh0WojdOlMpoPQuSbgFv9lPjJFcNbumtpf167KkXUJ1ryDfEFy1sTZBcM9SCEUGrTTyFq+EG292vKrVAs3wrmqGjZEM2gDr7xj9KJ0p3e37uO8/YRBSLrl9Uu1JZre8lp8QB6P54rS2W0RDCteLuLxnyG9vxnI0KOpXWsv669mP4U7L7dlP4DEsEo6Mh5SsU71i7XUACUmNZ+3Z37L6+c+ct8IubsoZjGjnwdF981DACtbn+YB7pN5T0JqQTN3hZN2xXMOkeLzuEHWHtu6Lufmu7vrmdfd9JX7u+urv+rGaL1TbCf5e5wkiuxUALALiW1Ye6E1WhCBVEW6r6i07VunfxfDhB+176Oe++IfP+b7LmdY3kChZm0jqwhUQaCDk/yCKSG5haSnXh9IqM5ISvozSG3IxVxmjLCCnGDSbm1zwyt6mSwtoKA7DoKOOZuzm6m2RISZbHa1Zz24GpN/8EJNl9tZP/HdJr2hhfrWo/m24yB1ThPFp4Wgty94IM5DAMnVeTX72w4gRF6GfD/zIyXSP8X2nxFmB/DLnBT0uDTeGcOyCt5QSw0bsNPcD0ADSMFfsCIH4+YTDnurUzyiBISf+pKUhoQ4gTAnmbkgJyECD+DPIr+Pst280dumr8j81rfktX/vadV9T1xkP2dWkSf4BXMEYWVWy24AcK2jQvfD2MmInoK1O2+QWgMNLuLLAT4Z7abBP2xnimd1RZJhfnNK9o4hhYXAgBjGIoweU8siVZ1wxx1Ts6Byh9jpXFxP/MSZkb5YZL2cTBwNl0ymWet2FDCkQP3v4MrhZtaXr6+ZYC3hdUzRRZyEVipTwoJ7MzPnHRzZzvjlz/o88p7w5iiK95viKf/VJn5STPiwnfW1ywtvZnrd0Sueh9j2fUWDkHUqUt0imCgRqpJSkhTbVs38CXluCwD1J0JPA3L5MxJ+PokmHmgdoRiHsT2ybKRC9Al+oDWaogj2jTGIAdnfBWCXbdYC9Llb7AA3c0jIh+GPBi/H/4mbrCWjTHMFGbAtEqVUhSvOWKC2AKLUMUZoHUcLdL1owROkFmxCluXGi9OAIUWoaotSaIEpXS6mOKAm4HF1qlX4kWsaPxKOgSz986BHRpW/SpR/24Mno8aZK5ENhDJC5UfYjVD/RHi7RDVz6qTBUkvMNT3BCQ3Baj47ghEpw/hd6TamAKwW4hOQIqanyLoHjXXBxtFPyLP4BhV9d4ackI1NiVSs8seFnvEOdNOGY5QZmk9zMnCUc81VuZg6EQxzgz5+AcMyOE44/e02VcPiOmzkB4QgeDTfz94zoL+fUXW5bL5Jkmuq9SrVoaoQnMnqQgOnrIc8EbjEB7LlFVH0tiRz8Rk9LftA879ZkOMoclalvmAwP2IKOmQAGBz5TpameNPUZ1/NXGcsHsE7fEyDlJk3RRkUm8GBoAvdzIP2i74WTXgWMKshbXjPNzV0osBzxphc6b3rhpDc9ly6pYBweQQXgPuBHL7sDmdWxXEQ8gvoqbpRgHN0e8vpKCDE1IFlnMaj83ufh93lr+43TxLDiMc+Hx7yueIWxHvMUbWI8So958YTHPO5Q9kfqMU99GiI7dqbcohGPedX95ld9Me/RuHZkXfrJ14yuS63KulQK4Yp6KYTDCqUy5MoiVZcVDN81ShmeXaCKBq4l8jOV9WjzpSo0S1XdrCv1isUPbMfrmJu6EOnsb+VtBJKiIcYUEjJfYrHBIpe4Rc4FuYgEDU7L1W0oLUUL25CxwgAW50jKdEoqCyFsDiZ2GUMH8WhTix+TC1pIYWVB+4rng181SE9u7Ugwwqsq+b7zjtFDptvxrnJvTZJ5+VYE0z4SUdvbUAeElBKRN6ynvIbaVwG6kG/564ia/7WniguJXuEM18AXgssLjHHIhpxVAKd8VbWS2/O6y8WCgwMLhLqCjVyGiEM9gJ0t4WS3KMF3/ho+FcV6mKj2ZSrrZ/M4jvpSJhbwyYdnl5qMyRAyicPG7Jhxktbc5cP2soYYJWSq6BrarKyh+J5asoYuaAjnL3JZvoaZ28cgSg2wxpD9kWzTOzBOVpfP+mQv55+4VC7nCKcDXMArtK7JcaG67yNf64n5kbAfCKkpA+KBSQqoLpJLs/omBvZQbOPvAIlwr3nuNk8yz2zM2F1fXHHGOe+hxGhFHeZbEdL666BmAT8wa9VpfjHLQJhVuxV18aNpVYfVdXNAMxJLvtitaAqYU9RFMxyDx36xuzqDBVMrLYulNhuBaKNcTqloy3DrZdqhUXkkbXUtDMTRfyCFXFkEsDE7iwgtqdrCmvQAZxoglS3hNmCtL/vfAGTV1TTBWTJM+d0hnMVAdhpXU0sW8gsE4TzwCEhF7BWOCCGdwV5Zuw+GPnh9nFI52y14hsrmARVR3D2eForYljVAkb0XbXMWL3xHZANHekXz+EoxBWY9UJU0Vt1oBRQivWJ5I6ha3gh0fesyeRXdJlCHUcsaXITjhrjMdTUq5E+1qtFJ9cRoaiIMaonJDeNnRk0CeSVEWtn7hLXSzsA2rOYDfZsOidBBIqJIesrwcBAIjyiETgCBKgywzAZqU+qxACIPQNVf7HkVZzyhs/yhrheZNSLvRbhITx4cOsM2VxftBXXghisxRUiJKbBvjScHfwS6BGr6x0IKQkdN3+p7/jR3ilSz/kI9fKdecxB749TYB2vTYr8wNfbeqbEfnxp799TYi6ZF7naRtzmWbKdsttXp5q7qZtsMYiV5tZrsjMFxanohA8laLxvxBJn9FKrSBE1VwzDefuMMMj3b80Y/remnhh/zkLv2KHM/T5tlnfEqGwhRTSA6EKVXcwhf1MRdVa7ik/eteWC+IF2u1YlveoOHkktXyIFyrOAppeQAzfCzI1YPXvlQYGI2VHiY70pnxoG8ohPcoABzo+rMGC9cSTjqzPgihgVvD4xTXz7e/LK6BNWjQD3+4Fa8VYiAj0o2c128/ppH7rr4/0HtzmgdOoTVQT7GCxqrztw8/vk+fcnwkpmXLl668nJ2jbCJoGcJDfg/zy3yl5MAluCmKNMDdmodDaHSOpqGRRLQFwoNAYOX/byMFbavd4r5SExwbO98bGh1qvvoYoLtHxyr8fOj/KwjnZ+Ifxc/G4rgOAcJ1gCfps69JjrSFDTF2GKBS+2SaxwNYRMmNMOnMunisSRgO0pTfISWDKNfgjeCzp1g0Ns8qT/7jLtSMJKW/YISIRmqwkRjiIFsHDQEaG/RwmNf0ZZWaxnFDLw/6idFRDP4DFZbXFfylDherkHxM/fEWX8EV0MimURzGd56YpoKt+OBWYf/F2pS0FN+CTDSUgDyhnbobTKDWwBBi9q20/vytjQ3b6HhLXokzb3469LcZLPmpkZgopA96xsAsvXjQfasvC3N/caBbLwpZKkGlYK+0NXsLZgraNtVenvmBdwCHyKgBBec4P2UPBTJzIYWqE4LfFXnKdXzrtPEtxstsGzUPbSj+s499JRYrBO6KM7U1A30naLllf72VP5GYXqfV1n97/dGl3+hQI6l+DWV1IAeTY09OjX2XVNj75zGQgGwU2Lvmxp7T21qy6bGHp1awrnTsu6ayFkdDkDKwXkYxQFvw2M5ofCunbowYN3E6pj9oizA0DlEZIjITCPzUPVgLp+qdhSJ0/OA8NxNAZaammrWYXlJxOG7hrtQ8hFlMDXCLZ7ajNxUTGHVEWOW10RiGrjlcSlLYWBuWV1ENI0rpKaaSRQSgkf7e/MUU/P72p41nGuMJjbzGWrKJ+q2S++OHMh+Sam/q1Q2CmIrnVvCHKwaSae07/1AnloZmml3YUR3TV0vmmgudtzWm6Z0EMxa8twXi+h7RqwvUAyAz1DNHDbgN7vLXBUUQ8Ja/kVTJ7ov7Iq01bnzalFrKG2hptnct3lj1rmDN692wbDLKeDjTJ5hW1w1eYaSNjF5BvroCsIgJACnevV04yhjNqPm4NSwuwMu0jSlQkCC9INeaP2KGA+zvjBcqMALzLsnVpkh3hWbzbr4x0ImIb38Pr3KezV/oZ5Vfb2y6jtmU3axntyPlgq0pLrwKHVSEej3Ipoi9FarpwjKxqHw1cYipCsVWbjgx91zrx73gKOpeu791dcc33PvRwM/YzUtJZrHPJUefNQTjhXBDaxNNVECi/eL4e++R3XsUHMeW8bCvIE2IEkwWM7+1PCBLnNaHrU5azEDfs6gn3h99kTNKlbheODsUbpPoRU4/pVKyhm0LcMiGlcsbfWMm1Ebj1mcca/J7AQwhNOWdXeO+MmClmpr8nmS6KOj1eULiJ5oRbGo0R8dLaRYyt4hdG+ZFsiGOUSLJrxE82V4kUIR+s/iY87D3xwZ0OIREVvrIFKHGrALlRjjoopILUS2KEUWax7LsLPp64IIFp1jTIoppyZVS+d4a4Fv/2Ul1UDziulFmS15rBSa/CO3qq3xQCdy1T/AqIMvJ9cKDPscuDg5KbHMs5LrWNG9Luim3pFjnjzOd3KtJOpVt8Opa2dLbBDFMh8TYaLQXOPpqKHWEcR0fqFGOCCbhOwR2BRdWcz0ck6mtnBNbZphsZEaedE64xRiU1BbPV5puY5jEAD9lDyzmaiuqJ/wvHByS+WcYSfaswAzB0JRT33Jww2AbwVhkiiLUvZO3eYitupomr/PI7uzi7DdU9P5SjlkA+cn52t+2asZA/nYiLV0X5nIw+0yvexdyl6RX7WZ/yuI/NeiWu8+AdW6mYFbtT6PrfGwCMSJ/eCOPETJbqAgEET0qA+eKxVkwTqgsX6EautC60eNDdcq2vbINxiuu5gAn3PMkaFu/Z8DucSm3gQ2pE96WIJ4EERJ9CHHgIc1AhzNvryWPh+lTb0D5Bs0UpOEAFo5md8jaAJBAiJDqQWMn7z4eIFgMSmlIulTpRYjhFa8Y2J+7TX7OZcVVqGVmtRywi/+tsOyweuZV8++pmdXP+d79ZPzMiGe2Z2XibDiZcKr+Jnwxv1MyA0D9TOB/riJEaGGgGJFJ4yLOUeJUKurOpYZE9oZE1JsZgySQTB8fNFSnxNSaF1QT2ePT6GWHgOkkcwefYTyQJqZPUr06jKhJqfRN0F18qDqq9jU0EfmBE2CYn3isL7CteFhcT9Ji9ro99e/Sr9HBpWfPULZ7L/MtTyzN4ogOuO/UMLOIsp85dhW9dobFwSH5wlAcMfVOCg6NA/3TUM9moZgHtx89nExop4iyblGIg/CAmNNo2hln0ImioUJvYrbi+xR9gnE5q0UOid3NsWda2jcWJ6+d0jNda7T0xsRbfJw2WQGj6uKzv4iAyM+604xBdduivjaBxcjNys9OX9srENjhlv/MkgcuPnr6rSvC/vtUO95VrEAAILFyWdoPu/QLFxtUgciDeO7BCb01TB0Ir5awUUsupvxqzRP2RpaNaO2itn5Pb7hgFDLRIWdOF8+BKqZSfAggi0E9eAi5GBNV7k5SrL3jxzz5Uvm7khUzGhPubp+64U0+1wDTgvkiOYqCoRVp/FzpX4DueBVvXVsMg95pSurp/FB0JLWlZu64Ny8ZoQqtKTaQB0VBCXUwPcHPezGBOZNjHPmPMxz/NXa93nu5QEJHkbwBQ4MV0nwAQuGRCUOtT6/6GzIPiDM34yqFiSukNAVXc3+QcneweFNAMYHYgWgq7YVLUyowy9A6np2FLkVbTBV7w/ZmikPdp2tpV1TdHkw3n79SIYvc4Yt5BK6oj8Wis5cWDrI6Yqb2F0+mr2s7hq6BrU6jFhu2R/1iTMjaDcap4hn0dDhH3myUfDzGRAOEdB1dPcn/cTv4fn1fbfMak3DPCJOF36Rn+J7GqUyy7koLCf8a3JMbFjOGI5BUB9YzkWKe0UHtSogMn7c/vnrj9792q+8+ZVAjRI8ByPYTZ/RigqfMOjZhwTGirqLBpVX9LShyzN8w5nTEZtUw7xHiUgqVimBQGWraGeIOT5PdkWLTOrAmsSysaoj9l0SGyJ2HrHqtJ8DQjiwZ5LoYjs3iU10Qw6ErVEskfMcU9BaAdywx65f5Y23CkW49lvm18hCfIa2240eEw0TVHDTMm3JPiy9jeG05c55wCoWTy23zIuSWyZIkQKZTw8yTkbImNyrKVmyLTz5BnUehwZtsw1CSBsUaIPqtkGdRwamumtV59G2aqttFUIjrZqvgGnmZBoUO9jEmzdoxjVoptKgFK7ZtSUIVc6WOlUfoknVa3PLBSMXbMDwe2m2v+IWlRWleoWopeg+fYjNW4PfM7wP8gZFtHQrtrJzFOj6NICPYkwNmcm8DPVDK9Xv0qLZ9NOcLKe1clzcHOIPVMdXoYEe6GzRyVTEY8kBpQqwIiQPUMx+HUC7Y5h9xMgOUpI7sUPCyju4g/c7JmkOgsx7glyNkAV5TjWl9dTNfgM5qi4fqUc5dFlupSWaq9BIJM3R0hEXg+qcs8Yh/1dEYDCgrDcYcMchGRK1OsTi/mzCNK3FNFQ9BJvFDaq84AXaQDs3hHqXUWBdoFAptoig4mPI8izo8axSRmao7N7vZ6PIMF8v90oNsahyv7Bs80Sgln1AFZ/VcFoe6c3LInb3ZLF7e95UeXXdXPXGc49eqL3LM+9HbeCYDdzrbrXKldD3yZM/8fV50FyffdAbuz77gMl4p29KOmQDt+DTjYpKbWBVag+FuIYfOpVa06rIBO6ygQECYcUbaMR3K+37wb3kglf23EL6ELb12uPEFJTh9cLaLvWBRyKcr95pT+yddr24zd6UydNDdKAqggCV3/ey95psg2gtN1Khc82Os7z9fGZwidp62pNHeOzN9Xb4RyLw91rdm7UcgKgSe3sZ+zYXKwcgiK2Nx/QPhmvZrboric21Vm3T5bIj0G++c0RFO2DsWytZ/ZCM9tGR9FgYzAJRJwVxpbQ1NNLWyElbYyNtrcvOL+l7lIi0tSEy/7yJGpDkJK3QThyTts5gre5Mk7bGVFdpa0gtcYUfjUlbw+nSVijnrWliPqeOrwn+r8DO4zFHs5RVpa0JhLIISBYlZvaKitGhihSf5lT7YQZINtu/KTK2K35TvxC3RLojnRMiO0/8PDraUHiXGhJSQH474ykD/p3FyyJ8OYFS6amJ8CdSKEtmJ3o/KilCDoC2s2mOWawMc0gq5lB2BgjO8Y91/RLiJCKDt5uMGuaOthLKNiLb1EKWlnWzno5LFdPfs25GRaCqtB0v4tJv0uUocgUTuTZ3Pzr1g5NyRYoPw7EPT8It6V9OVe7XyqRQ6Nj+FkqFsrnVzf5iaegy2WtrW9cLagO8Q6WzAo0QneMQ5KQBig6LcLRwaDWfqPh4rHiPYFAyAhAjCk0tfgv9C/NQ1BQAsNgCLKBYQVbEY5VHEE+fuAHRaAOKCPqNYLc4gIpGoTsujF5KI3Mu4MkzwNORpt37i4bNTNxmKzJ0zMCbHwoAzKbq73TFhsaBIu0Tx1lZQX/nGrmXi6BaEGdfNtu2GFMEBwW5KkDDVvdGHpbcWvYmVA9KBik8NTecHgSu4Gdvxo2xC5yp4Sa4A/6RSaKih46Vn2VSF7yjzWpdc32c8HTyhWCvbco87tp7L+Ym0AI3aQ7twVkC9IwxcUPMWnNeaetsoc6WVMgEBX6L5gGUecLRjBNbdNQhXyFnu0VbhRf8kGar9CYPpaawWgcKb9thbFTVx3dRg1JcCmtQB/d9sHKCgDagfhGpFnq+yK9D1SdfgNhIjhlBaFT6oZkTfmRGm3xFFCvFlxN+dkPwUfCwCrfLjetc1st+22lb7uaU1gH2GQAJ4ZJqzElpFAMVMvUPm3vqv08oZibIAFqro7EgqJ+3MPIzGBLHDS4HE+wanPf1aAaSpWUjv2rshe/oFnxHVT16KjCVt6lgzYzBmmEFymHl/CY0MAdb36IFkN7lSvKyHd0Yo+u6ww2f7St+FXP783kBBsWC3HI/T/upB5kZ17lgcQt0nge/Oug0P4JY8HqP5WEByYxjaMCsNiCVQoumCiabcl3AsSEM0iKy/rN1CMb864YUj/nXdbAwIotwmM9UIVSExr/ujCk5HPevG5ykZ93QedYNKTyuZ93QObIt3eka7e3NvOmG0t2AKW1Vtmqc6c6oM91imZYHFYe6M+JQd2bcoS73n2bAv+WhcWjb1AOtNjVkN6Nq0qASBwT7VValeZouz2HkUXMeI9lUmFNOnLpZ3rqCFplqRVuqqZrT6NlaGYHtyhZpmEZJ0FacqF52sYKLJGhegnqn5XqQc/WoWclSwpamAFrdlqGQYpXxz8yAVbaysz+fE38dBYulWdmFekB8du6IR6I33oDF13DlWzmgsyMhX1x8XFMA+yVzwYjPcwFzMKNUQvPqezJTnRjjH0TQf56hJZ7685mWV/Wg6xA6pAyM6Iyo1B3BYLaV2i7w0sKjPDOgaODsZVN465AWlFcDrc50VmZozzwe89SEEfmmenykhERjdQ6POfKh6ONTirfUTtrVypqQCMO774a7f/uFu//bfbq+Gyqzjeq0PMy3l5h710VDDWvLCp6UpMRGdJFyCp1MLy+oCRnFDs7wimeJG5pXXlrxkgg3jNCGURIFlXnIFtQ/S0bGRvgl2e8o4wZmJuE1sfAZQpUmBsh1o6fjz51UIreK9yvyWTy+M5+TkvKmDpU6hODfHeg4r760Q0T2sdgBmEM/2sIaw4GdUsZ+AlIbCoGkmWE5DsUCxmWa+bNWTzIPGUTm/j0qa+vy3ax+g9Kc8tE8yDG1MEotdXgg2iLLqHHZ3QDKoxHcUhUtX7dco1KMWWrC31LZMpvKvepBQsQdQzsFkYCN1NpYlzZjp3gbhUaJA0IqiKBmBLG5gT6wzzS6o1qaaCdTXPkalAr5laynlGnOTMBKuajg8KuBaTFzZdHq5RmKJw6Eju94ma6BqXyqhxMH4GUR3nyAG7qDdkKkIbHjUIzRMA8tWWiVUvmm0gDUHrqxuBUWkTZnp2pVrAZja67lU1jaZTvsFU1zxZq4cm4BdnMzdwghGAwNGnCPE2W+QGALQGswFLGZE2YdHYAADEdEXUNp5YBzdmH0aaBa4/kyeRgb1dhQLbRGf3dp+9RnZYhJhY7uCy8rLwuTvGPHIT6VejClpfsBX0WeCFmRJwWYzMGIjWh8yCTH6FfgbT9ExRG03E5YzAu0GHPc30FALzxAumtist9VHo8jf+ETP/+Jmhwwuw5J8wPd53jEf3y+/PPIx7Xw44xLe9lHUUDZwEffuuxjerD7uaghan1mlxJXdyoH/f1FXcFvz8588od5IkQnQhsaeNQKqES5eVpVGJKL0G7wsbRbPUzy9PLFRt7Ray4Zu4TJZxG+0cvn5NRcPHMuVMqDetaz8kUXA99gdfhWjI2ApY7zOIpwVjbPD6EGEH009WUAYx1D/nUqli7Id4lTkTHD6kDKYl+46+W/K3sP+UUDJ6B8uVFLZ+T81SMoazDiu9Ze3Y3karpzQRMZP+MxWojv5yiTdnOY+ylkXmuAucQMr7p70TITLTNEmaTESXSRFoHgmDtahRaPiiji4mBxwzUZkBCgigNivG7aYFrmccFeAPNiDK5yGYSWcMLaorSsTeX4rbFywDXLOiDPefDaWGVE/VQPYhM+DMhTvLRU7S2V6ZtULzOK+iz/gLQUS8QVs1T8Do5RoTy1nOhcVKKHA1jmRItLPxpf9nzcclbxm9W8JH/0YEA1MIxwzhtNK6JRCVQ48qpf3TNRIqwG3AaPV3pJUrMdnSyc4X9bERE/IJinUJ6wdcdUw1VcCTKmgtuvNEODmqjfDtL/ZMy1HFaqCVJXI69qBQ+mYslnWlmDGcfCB8LwT+LyiKIX1TYKfg4KvBzhku+MvPqoVpgKWuzN1hC9ci3C3VNvQ45FARLdSwzdFiGvq5rV2D7KJ29sH+WufaoPfqFH5FdwxTf7qEQryf3xfVSkCSe5m/Ldbson/7i7KT+l2BGDckM1xMmjW9EHA4pdc7UtR/JI+u8sMQKpJnoNkCSaSeK/n1m8k4BHPAKPREQEFXjEFh7x8eERU3zy8IgZHonbXVJEFqWSo0M0yp/c9/hi6WbIXTDc+7l7hVHeKGx/vszN9d1kRzFDtEmwGxjHXYcZjKFMMCZsG+vpDz/uWpSJuS54ui+6vQFnq+hT/t4J9Cn/KQji6+rXbqZwGJSKjF4/OABuQLyTEv/xyUSkOweR7dUhGNmfJ5UzWYcMTRdMIYUe0eEll0rp+rBoOninFUinDtK4sABIt8kn/ruyh4jBEFYNLHhUnd+y6wt7h5ylMYAqlhjjGCgvIM4uVW4VihTBtSTk5Z83Q+tckzuN5hYx+yhxM/ge1RYzos2DDScvDVhCatSxdaGG55gaEgrXxJBozJe8s7HqsunVZRu2vnZZX1vqg0TQ1NHi2LyFOFSPRRDjQWlZut4nE11Cexs3PUVuMYrBa2ODTzeJWAPAtInCX/ojwWa6zO6GcmBVkiFFjJhjdXyxxoWXmbiIXw/0oYmK60hX8xsHZb2qKMIGqgjb8qGm90lmOD0Wr5OvxxacSIFwop9ACoXKkbKmY6Ta0n+kZwbi7ulk6wy1TrR3VMua9Su9/kteCOFnHtmJECF3RddaTjqqutae0bV2d/hxfKoPd1E3+7gcNurtk0hYb6ShLr1+PqaF/QnlkG/zgkA45PJSL4YwQggmSiJ0CANrk/JYTXrY7F6pQIJzVSjWQ30PV6Owwojuhu6tdRsEVi+ym7cGVuyG2bXFuC5VB0rVzUWX9LyqKqUglXa5ent+4jJC6tQ8ZRMCNc2Pjat53jNdzVP3MsmEOvL7Tl7HFuipOraKapM6tsij2yCnZqvIFyjyOTXb3x9Vs7WkOTakOQJxnqZwG+IUx+BZYI8pAlCKitpteDy125ijgvJ6eUu1bxN9hPJAWnbsuGq3f4DUR6l+/ofj6ufoTKl+jpcx9fO909TPC0xRRpS1R6GDrrq+OoxVXV+0RHV9H13PPvlIe7a77FmYfQoffx168r1V8cNjsRFRhMZKhFgSAdPDHznVaTcnXSO6thEv9EKZ7yoXDux1x/LGldx3lKevT9gTOoBpgBkXMzshmG0SKMJE0vfsT1SPTYhrrNTl9nqQMuVbuE4sp6nS8fP0WqjenS39JELWSBF0Jup6LIczQtnlJwjuVNuLxktAS9UpBG4ptcxOqMA2RChYAJIA+gr5krmECbkBrM3mMxTlHTlA8agtg4xk82AHYDCiZUzTzuAxQx3QUFX6DKmOY3QVR6KX6mbY1yrhXBFGV3/qqiKmjLdGbUgjpM9zFKoLRkTPiHKmwKSok3xAM2tFur8w6gQLOOHiLdUiMnb2r+VLYgI2xesyC9u7AoxiC1csWanF7MkK+kkdTm5g4/pVvlVwTd7jfi7u5zLhH53qKCDaD5E/QL0N/aG2OFpbKwycttvI/f0fWtOopkTV+rF5Jy7oa7XLxLtrKFmLgmbhiCHB23N7xQ6qa9aY0MgVfdkp7AtXlSq8eoqFNUo4kuaeu0KES7wyPCm1L1uhGZ4BOgR4duRCecH9UOGeRzuhkUvLOJyZX8v+VGcu4IHiuxTRjgMYyAYU1qVYTOaZ4w62Hqi2jCF+QBdlLY2Utbp5WddORRzcd1TsTLif8iiU68r5pc55t+f85Ekg5cbVppUClhkUN2NQTtkHSgygsfHXhWc7RRjEBm0DIhDeiPg8B8NoXLsEOjsv9bxXGL4jcFocpjdFhAaEJA8PDfDsRccQnQzJR3N8lDSdMa2NM6ZH4IbWv9ZpMUTVC+p3+YW7fXIWgOAuNljVRNWmyVQrY6Gocz/0U1TtGe2nmmX2ZNvez2BuKAKhJ4rUgFMdpu2O1V7I9xv74Ush3aRIrtzvlNBZHOqq8UlUAHPIejBjaCV4rC6WmT+XZSYRVTnIyrBxFIcuRg5tyUOk54gouwV4RNnPYNUAL4BYlGZsynDSZwwS12VBwMNYpAnUFoqGhRmUi9MBJWpfpSG66gGaQRzgWP3AbB/0IzQvIq1Y9ei4eU5GfnzfyC+Y7htZLatWPc1eXcRC7Zyn2Sucp9mXPWZPs18cNSURV82MGij+xVRboHW5pTpibLTujI3WJ42NunRJBSAfcTXA5M5a+cl9zvAoQyH7rDM8WpexVcMCGPck+ym1Biq6lmig5lP9Q1gZvRfLPPhbNTM6gjORu7w1amY05KYNpeBInXAhe17nJ4WjZkZjp8z2S80I0v3V64KKHq/ndpfqGW3MzOXbnJnLDWfm8l0IOgm/7vlYdgikAnk3DBL3aQEdy2SqYspTzEuiXBr3YaxPOYOwNMxcQ6hZKZevGpsWSDkU8lfM+aVsQ4fSs2tsxLpGKehIq6Qz2H2puy18WHgQT0jeQq4zNZD/XDlQbWP5wZqkR5lSxSqSd6sVfGrlMXWMcQPhWlC4yuMtYbcGCNyN7PJAFo1Eqa1+/SXQ/IRuFM7X56itJxrQVqHZA8i4Vxq0iBbsypf6nsjyu/y3RS5br8imlGF/ULSNF6nbjzl/j2uZk5WtB+bAz2vIy39buegVbhW+7CgNZ05hlbb2E7AHUloeczUz5rjap+3kcTvXCnj52c33N45ihuCF+OUu+5Lxy0Bf9JoHC5W3aQXiHp8U9XHOLVt/8YpP5It6Rs06xrdu8JUVsOcjHjd4hlFPejEjt8lrcloM1kfYHfANreeUq/oKB7Xv2/C2X3zGx9zxGenRNlqheO3RdQrXwiY6Bag98n6hT+AkYuG+abvOz3naIqMSVwDmKkB5Yn1bS0axwXixXRTbpWWFWJJv4ZKWFWLzjCeqzsGPWVrQU33gYwFqk8p0aAfYQnhAuWfnnoC8ncdT9PDznLiBpEbIKKcYz6J4+IseFQ//k6f9zgmbWp0JmXI6PnRqUV8rSBkKbT+dLDynChXZAVj0PYOQJKDcwSHQIwbWi+XmyA7y+FXgxgFwVuhQRG105Fw7uVnJFu97GZqI2kMNDmU/Ka4aduAIiXawxlGQGukc1WVUQJQ8Z/HkP/iw7VDZamGTWt1uhRQqA5FHeFXGZQ0K+s5DRlX+l77D86KKKcBY15C6GqmKzhbJfiDUEOIIkNAmhrJqHrApquONb0Xw7NrboK3+Ne8avOrSwo84+1zVcGBcGg6M8aomH2A4MEaEMxyIF1hzHjUceBms3t1tDQfG/dutsagYGUIZbjWHo3Z2pBvZ/daYKEl1DI4JO4J/+SjsCP4fZ+vv3WnMUjb2Hde81nN881Gvwjj3sYsGVRcOmU3GVxVRrx59fYFmusIZd3+e2gyUi8JquymP5ZnkdSDfhUARkS3ciWfdWqOPjTV68SKgtgQhodIbMwAFT2l5fsFjnIzATfDNY/FNKnIwcZkWQa0t+1t8a7LaTxs2B99QEc62WbEYniJ6Q6JbOD7WgwRSd2QlORAbj71SL2onr4N6cLv/V9XpQJFmf4eqxTFSkQ1oZt/Hnnrd979l8DmuY5bS0ob5UPbvG3rCNU0nbN+3X/bB37pvW7yXDzfmsr+V69yJ9o5gKhqFuebPaw5wHQsbRdukXM6Mb0Ovim5wD9s4+RDpAO6Nbux7+cIvfuuf/9CN1VqLxeHA9bZta2BlmfZkNM5zHVtNYQ8aS1A8kL4x68UtGbrPUli9PlIsUbb+5kqNfIUsY3vPhd8jcVSzsDFkwGfE74tD2xGw6lavTAYBe6ixwWHbXVy56zoUyPF3Ze/56kfxAWMpC5HP5xXo1fVLr8l963rIF+73QW/M+h0ct4oPPU85yIdkl6KG77L332hKxMnLkhsP6qD5s6LpMcfB7IuoWnqn130yhHwuB2dnvgquJLEPmREI9D48D3DgagRw1Mb4dbR2GVqKlnNn+0n2YwctXpy7ptCwOtLr2XuQRhHS0KeHXg+54rsES2tCfi/BHgoC6WCvklYrj8dHWOj7v/0GfPOOyjfPK7+5fPQb6YO2rKYbUj/b0BbIa//jrx8vi8qyuuP197tqQYv1bOsihNUiw9Ei3/SoilRAimqvKxDUPjv0alfS7rKkXRMlwVFjhL2C7O+zL98oRUDrVhP777kBDXuz3mzXlOxLZv2rWSv/04kLdSjI/l42vhgEb8xa4u3TrCVOxGJxVJkyJNBTrD9j5yhWFL+g+0S3I/t1b+QLdyrtYW6IAVdnPhCxX5gae6+LVfuDEvvxqbF3Ty3hfVPz3jWR18t+XF3c+a4TmMoOBv/i+wkvdG71xpo5ai2uiCSs5EVt/uoNtdJYUh7rPNf9Lxa0PFIj0kXdltO1m0ezc4RLH9j+I09dIRXKWlkLcw1tTRPlJ1CHTaR2NbHv6k/EAh28zSCu7SNKuCPdvEt+/WxGvqgTMqfIDGVPbMAj4kCE8zwEQBW1LI+wLGrf5DZfqtWa9jTRSf5LXe1M6NDNmJK8gSu5GbpsoQAubbRfaXpP4Fe8INGIC2cj1FLnwhXnv1yDXjHyhGU1die+DCQ4z/+ek8n7D/ak5nkQT2Wl/29YaQiPs+rmTmaEAxS3D/BA3apaQ06DxNfiSg2ZYalgM9h3cGV7/LVfePpR0U/a5OaClk2+Ogd1WjbkXuFwVC8yJHqRoaKhRImr+Qgl43cZ6uQR//HOwktdm6e1JhcciKFUFcE3Cvf3e37kw/+w63v+jsEGZSXcJyNLj/z0+6aTFjKLZvaPGIOSm/snvKHeMbOkNb1srbcTwOhVidFr2wEUP1OtB0U5sVzcf6u3pqydMnqyIj8ImpDXOVU3BOD4GDXi7EHh/hNtG/YyKgsN8SO3mJLSrBwmOsbD3ayFGQKk6NEQtB1TRjScyOnGC2k4O8rATECgI3Y69fbsEWqtPxTkWSo14QJtJhMeZGLW1Gqbm0CNXO78zhpzf8SBy3rc/q+UPj6KppQErsmeL3H2WQRBHLkKSIHauEHvTh60rxnK1kOOmG+Jr0krpEaFnDbloE1AbZL2MOR6uO6Rz2lTr9Wt1kvUQ1dYZNqytooQcVXCXEhucrS9iUw1yNTRwlmJxZ54YU3EnjMbYLudOwXYGWipQn9bb9syQgrs76+PA19LWwC0ZcTQOSzOYgOQfC5WZOPKQmtDqcMgEQV1PUbDaU9mbZtrWPWUdT/6Mvy8BPgFviC2/TiXg65u3ICPQdN2kdgSpEUIHxee8+Ji8cLaJVDcxbnA1dcUbfg+l9o7iKUFWuzBSTrCnf3wkR7jOvReeCLL/lkniVbJA263QguGUYxhs6l9QOSFbYaRWt1EF6id/R26rKq0X5YbRWq3UW8ayKeKCx3cN5tTXGwrZmapuYGMgipYQ1qYm92ra9m/aNBYE1tF6HQ/PD8gzAjFl0TxReAJW8AYIEcBzuULhdpDKzAF91ksV+NAmiZm+y9bFZ9Q7el2nqUQAKJuNleRU6czeo75CBy1k7NYtFNqAQXOAFsXBBQcquiqjSwHoJY65+VuhyLFohPNMhauQysLtywV7WcYO/VKA5Zds8HQrxEttzgyO5HnMBBzJN3slGOhW4asmNGdwzx33ZpCWsJDATDD1oCLTG+fzuFtD37OLdI1EAOZgKiBUoQXZQ75hvSA3OF4sXLfNoVEOZXrqYAdvuWH+Wwid4bcmeYGOvGQc2vnVZaj60Ko68KUjVfDbLraZtOVARHdpgtzbByRYkVNofvKHGKCjr429fUr5jUZfa2PvKKFZiFaVfONn8ALc3Hv+sT1LP9PpCovPRyH4XUhrL9VnVWF+qmYx9IhisycjezmLjKbO4P1IXJ6skPPvvRqjTmYQVnjDhV0iZcYEOhM/Njv7JuVjiMgrAmJI6mikVsyMEcvtvfKLqa6mJFwd2llzYvcV6l6AVvDfYiqB4VhWcTQ3agd1yxUHfuDYgtVVxKwipU8iVEU62eSBSczQoJB/g+Y28Nte/bRYqSECFiNULU28saoPaBs6n3hTo8a67gD5fqIavMIZyej/YwgchjpJH9a6Z0qvY120h2rUJ1moF2ZVZKz8qS/vJOeqYLKgpiYxTJfuvJJEJITYn4SrwstQF4OpiAdzB56jXNz+LAeCQowVMmvrXuREVf9IBKrmqzYMJm8r5J8yWTynkryRZPJZ1WSd1eTKax4unqLVzquyb6Khk/apaBAU45ji8JlOin7ExRq5pOwOXFnFITXQpA+dlzIsJ24HuAcTXGhG05dHrchjHDvH+FysLonwDBSbHn2YJJnjygYHnHX6Y4Ox7j2gIJJ/jxQEBhrEE6UWEQVSxd1hW+laXKolohTN2+0v5v206v2s0HjfWsct2+Nx9A39IQ8qO7IPVSyHdLth6dGoevAAty/GO8ndtqKE9/QPZUdGfpaJHzwLPObA+jTJKbe5XvxdOsoTmnUbXwKVa1Th6DGonqdIr2BoasbyC/HJWCMEqNQh8KMqqjopWZfU8IzVoUaCY+t95W6VhPpSVFsmagCJoqsGwjzqR6n+KXngeygnHrV0Yh66YV0tLqiLjtFvYvmqVqHehjRk5OWNlXX6op9nCuV9Igmmy8sVxGU+g8qaWXbuHLDUcHMqFXu4lQjEu30nQYfWg/tSafi9N88/zhGnq9/bfUqJPY+XI12DFySQtuYu0aGa9cKTyUnoTH7fDjwommjXtW1N4rpkWwX4xFd+4iPcjgWsmKxI7df22BOBGWehKoHrPaIRtoQqca9s0XuA1dhW9jcXy1tC0elbeFYNe7/4oZS6Xmk3vqJ64XyEFo+qnUfM/Xen3tGRI8iKazo28doblXfXoV7VZPDoZQqgNVHDboyNzh9+1j17SMZKD0iC6qa0J9F3lr6msf5sg4vlugIBRyoXtL5kdce/5LOo1Ssf6LnTdfPhQmZ7GZFWFXGNSj++VYYyu2C5NqpiKibj9BwtjrBKtxVnV8TY3V/AZMIxJUafNqBmO6a8VFPdZzPgB5RCKsX4nLxB16c4xXbBeOiuHJnCLtLFhZsLsKDY94XgKeAbMJoDeXA6JM/cRMRkDvlfBkfclZaMNrJ0KZ8rWIRQK/gpGyd10U1MT+ry5AqL8fkaZMoVpMURad6/TCbasalOWHGpekaOKvWCIY5/1TP2WhGrtvNanV5U07CKtftZux1u5njX7ebwT2koumu2zWpuel1uxm+btdMqTP1+mEmH7rrh53J64cz0v/O9OuHVbWsWc3krh+eGB6dEXjMAh6dCjw6Fh6d48OjQ52Th0eH4TFbEcTO0Gz1+iE+neAYmoJMmCqDIVxKX4HjRqfbaEL79g4g9h/yOTNb5NaLbG0rX0Xf1F/KRlHffApUkbvjgjOPUfgNvN5M+D1jhd/+qPDbvZJvWbBskgXLqsLvbFz47TN8+Y8pzEwV5lNawxnkQp+0x5vOLXao7tAVNlAq7L83AhWPONW2ujPZakY04MKmjCOj1EQL9aofzm46g4EiwSy1XYOoPnSwgFfzQfk6ovHKyKGraaUzeVO9i0GFSZnFjcIm75Simdb5sk0LCGQ7hHmEik36cEOsZSQUqynNB1R8oXdE50DCrUsnYOGl4zYN7w29qHpp26xwWCSC8avasPSBSyKTV7XjR35VO1B2DAbFRq8mh0IbgspV7apZsfKiOIXHpw3c2JO/mhzqVe1oKq2Mx65qR5O0MlTzFye+qh1oJkcrTwyPaAQewb/a1fWgMm9DCk7mqrZvr/mXbvyHz09Plw0yWQed6l4HrPN/h32up/9A38tuABeUPu7ObVSki2lR5fNedXw+b9LhhTKi1ZuQn0PE5g4vbva9xsndfCxC3m457yK+u/lY8S3ij/sWwXnrg8r/Q3Zcd3JK3G7GrUfbc3KVRcLQa7l5w/L1MUWWr/exT0X7ydebCQoY3TV41NA9YYQM8gjlgbTsize4G43BxI3Gdyj47smC+nXBiKPbSPMEe3GEjMZ5uD5XV69xiexR0FTdPOp/FnmK5kwcxzXPD8LUalsWdkuHcGqN6Jqb0U3zzlMzwqKuvWryoxVNL8F8oUcOgSJhbOKKtsa4eooZOaKntqmgqRAC9OzH3liT0okmyS5Km8R1amE1LQytTTXJ5TWljzSXoIsQuhbIR2Gq0Kz0VLGx2knXTW+im3G1m6ZtUDrNPeHv9Xa1qbMlTfCcuieaL3oOrlOamLhEjXA6IlJKtQaXnTsT5/xFQGm14wCEg2igeRPwA+UYJK5nLdvXdPSbtHKNtDVlpIKxkRIaAu1/JQ64ryqgJj+7EZSm5WMom/3lbxO4hXolxYiWX40cWgReX+M+iEXNTummj4dkeK3o2yg8xLzhtdeMjmkDj051TFH39TiDQ9iCLJsY3+YUNPbALQF2DcrwmIR3rVqdfKHjiQ+njrmJ5VAm2TT3WLtpplJ5itMQeQaUuLZXMDbFjG0iaXasWyGKnNKtJmXmzF9rb1Zrt59mlW5py0N8OK1biA21W7OaDS0fbzDNuMrBlZnuBVSf3i00YrxHySY9SqUJVNce6cdjPUqm9CgxH07tUWJ7hGzaf7R1skdaBrZJ2iOtfqxH2qeJUVLQTycus3kHcyNVoEot6HEVO+yI+FV6mVYHC6Vwsss/O1aKK5t/hdVXxZCafpA66gU4TsyedPPZU6vOnvGJhk8nZo+ZD7Vps8fNKQuK2sjsSUcHhfNXZ48hPUWqhql4yrhDckS4N/SAqY/uSEJDmQ6B8OSoXI8aTfTrEK02ZwKKxAarL1cXWpZ8NTnX6+XjWEhRCBtkno18phJ4uYDAg4Qn7uNiPPVbQEnZQ/k2F4mStsLtYf4kjNWctv6hISqgJb+6dBmDUpEul4nGqveLURKYKhbWqSGwyBM0R5dycEl4RKNrri0iniSF5YdiklXGVMt2q6ChiIljSUia7hpJqZToIQ9YNc3UzJNUOhSMtcV+ptt5iyXJtIJdR9wXWo350MHLdXXii5HGa5vCsY+CiY9Mi0JbTTD6hTY0HO1Kol0JK10JxrqSjHYlmBw1f6wrQfULZejNh2l6txdEgleVTQyQONCwrrxqRzUic8igBzVIC4u6RaoEMRO1RbkP/ha1rlkrERDLoJrcB97Jd1jhfNwFa4yU0Mb85s9071UX3IjwHjHW+hSbhqpYeegFwUn0RHsQohG6DkbOIJ0/BV6hXFgzfH8NjLuSl6KO21iYwRNNrlOEpuJTCkfa+Oe+F7n2GW6/CMHvR33/EomKiN9fyrRsTbQBVMEmZstNff+FeahtIRiUe4OQjRC5wtJQPXmiknYT0nCsGVa0kfG1uhvRyWwO25xrpdoEfoVkLlPV9RHgckz2RikdfXMeqNFy6YIy4jEaKiRBxcz6bfbD+FKvwdelaLnOW3qLjG11en6H9Vi3Q7ZDsZSNmr4Nx49qsrGuli7US+oH/MCX0wXUO7obcLMNUh5pZ2VZUHzRlseFT2oRSmII2VGUA43ekxd00lQ0eDSLAkUKqmkut/lylVYyEVJ0CyvmlNzmFNAfr6ioV6sar6CIK1Wg/FKzS2ebFVco4EH+9cpY+tt+4InDSQrcnrEKu5wxQA/EYZ6prrMQJ2aBjNoISkWoHfTWuNbH4bAe6gbaDHTEZTZgxQComsb0XNoTX3MVDX5XvPCt1xU9HzJU3gIv0JbGkw0cbU6RjFaFWgA8U0daTig8DPgAVa0sVPxtXFgL0z9KglAkAn0vD/wpm/yZOIrGtvi+DqGettuG+BOrb+jMfwFF+l5nehFV3oD8sc1vghhXkVhk0IlpaojdRUD7cTjWpmiiTXiEpk3qNdtxAqreo2kutyl/pMHCPwSuDfYrpS6R66yy/qM80HhjXU+9ak+1dcoD6TGeHupqpYaH8dzljtgxra5bSExcosmtRTkuy9XgsodCnzE5o2rPAQkHVF/zJvaIWfvrelZ3y9jIN5FWE2pHJgfLnxis4+/zR1Es1Fb4o1APqzIkZQk2xy/PiTz8CrRds3wFqIO165VJQoQbGZQwkS1MpSdFbBkCiErF1HpidO5DEorQcgA1l2v96jqYYgLr2it8jK+DGwgfI6y9fId5F4CPiUZKaFu+JcDmsSW8LaSi3AqshKBL3L5Oar3ux7khVr7YXPPUYIB8nf6I74d6T9vX5dYHa8C+QLl6vHpmiDy0VZ3QFCKSHrfTS5IDL/2kug5y403GIh7NqrGO5cPUUahoYjnDC26YR34eaL2mFZG8RVNa4Z9cKxIl/bYryhCmb67wfYGCpIKmFBjwSAsLf4SuhlPWy6KOWqRbfm5EwWpSh5LcIy3yuk2LrMuSrg5vOfAe34+ON1pq+Zyhk8d25DCZACVuF/nfbnRT6kDyMcghzhuN4+PIOHWZR1tWHUO3OxwfQ7uqFB7G0EP7Ammfghf4La0KjtOqYFqrGH83aVnDjqt2RzeB6U95rJ9GvjK+QCWzD1ELJRW4Yc7Kh9yr0FieUQBGBJhDmApqwQ+zxhAyVtqMiIQ/H2XfeLyxgREGFQNjtk3PFmWm9FdO3vzjsVpp//Fdn/volinmH5Fnwv7jOzkvg/LWd36u5aw/Hn5t1fqj1fWJVNtnEzfr/buue6FYkvn6ulv/0dcez+7jm5BaS//7o7GO+GP4tmodEb1x5hHxNm4fsT/V8iM+fIymHzGCVVOFKNLaKvy7laTN10F1Qx1e27ouern1K+C564moKdcVNI8sJuDIWtvDEsjM9gnXuol/9hkF9qKhsjtE5SkFuJuNPJqaQ3Fx10hMm2NWNaYfH5Clbk2ToI4g8UVH/Z5fJzaAZItMnY08G3edNisbklmqjbhOy5zrNEFQ2EQQm+u6I6V26R8NznOVY5s3t0MWK5o0qkTpIjK5pVTDor0oTBEuu+CqxiDPUq0JjcmGUM9R/WQ1FDNHC85VCs3CtYF1tNVBBmXfICacQdOWGNHGeqrWiKwim25bYFCppjK/+i5EGKtK1LUsUAaMXeb38KUjAKpDNcwACU3PXOOyqp93B29ywat62iTnlx2AMep2KPrcKS2ZtS3pXLOx+SULzicegXflW/CgfIUyk9A7YRWrJ1nFasqF/qh23cDbV4XeYiuK79EKD+KW4QDDmPHLFlrFyxbkyfIaHrAdupTP01YxYThPs4ILA+DCkPPXypeBDDUwgxEHjxIjnVlDdFVch+qgZjKklWsfHD1buXzl0jieZofrGEFuuUdbpVUqGsqkEcNRpxi2Baja133tWD0k5tu3jNey5YitpYY350MZMJqs9g6aPTKcrBB9XaKt6i5U5/m2fgRzWDolSaf6AiC8mufcnm1y9l6X07ttuGAoCLAddkiMveetkkTbwL8U+/MdCF2T76QFKlBPfgpt51DIoVN5Bp3Gf7uwtVZiDzS3z+J0tnZ0OQWEJzbfOZ2GxhXWJNXVFJS2qq7gfuySfkhMcTqdDgtMZ5Bktq9ncvsK1UGFs/45WtQCufpaeLVcuNTwFRzOOH2bOsgvapLPl7TLJZ+G90q+BbIcgdCehxfys3CrcizubAr6D9QAfVW6ZY6XcfDM/HQZp5rYtzqdzmYbUjAflfKbz+9n8Tv5SLSx84BnR7xGa2FHURiIJ52Rn07AYK7bgwvswgrddmJQTqVTAQztrHaFy9T+am/UbpW1rXVKtUMn1Xg0lofNNf8RtzylHfkiN5jRRgVi23GPVcao5hrvRg5xrhMy9qOd2O7GUMrx1QmQdp/LMSNbLYdXsIlyvnHHeJvKdE/jt/w02oUN4S7aagV529Rc8DbqGq+QuMEmYO0AHOg2l0fUcfcvZysUCNbE1IGemYc1Ej9KVetjGdXQ2nljqYxXbq4bsFnD0itUR++k2aZ28dal1CLnEto4Q0vgyZaqF76ECCmFaVMNybWR5FaZ3JpIFmqWL5hlWQ0ZhvipiTmiO7I3yCq+TZbefKeOG8Npwd4C3GqnzQJuAc7xo/4SIVlL/AcTwcJlESgeSt6Ktmzfj/UftY2TRR0IoqW1fBdaoZbdTguA6afRNh2cgnblHaVNMPeLL4oSxfJMjOkuiA9ZX/GJo2GpqDSSP7qgzYPIz7sb1p0RlKHtiNsuiFOcpnHSQB1J2mYseM+hGbxWrkkX8ZwzVyBobmIpORU2nXOUmNNOO75by2HaOn2YCoHtNoX0aWYoFkjvVY+NWDGnA6TjQPy3044F1id1DHv8sdAu5UTwWRiKr0izCm2lXTRnx2LH120stlXGYs6MxWkYi12I26Vx0kCdfTSXz0szTlPJFfoH69an2YHYJjWhjJGaCDFEO1HqTr3xqiAyw7G02axJFaCGh91XbCvnwXadBwWmzS4kqpVOLOMdxt5Ffs45iJ1GBejMSw/QHDOByImGLuY+QAewAV6juwJc2a1VO7FI22EFdA70bW6EkqAzu9R+6S70Y9eIQ/yD5eXpv/Q8f7NN+LMLvzzvvJx8V4Im760k75tMPreSvGcyeVcl+axqMnaSegMX1n/s/XFEZmulfZKfeG3FYL8rKBwtqOph++zq5Rw7yijWSNDFnZ7dvKZfnYub18UvZ0v2L2cPYHYPOghKEyelemT/KJ/Lkh7j3OtJMMHtag02RKcap9rPgnrCZS/O0az7ecFCR7Aato0xDl+ND3QMk5ZnhCfuTuBcyETzDBfeLibl5OaFu4un8IcLwh/GhCdOcvDdbn7iC6JpZjsXOSXjHHjW+rrPSNHFjDLwh/Pg3xFYQCK18mVq513yYHLW9B3eb3HZ3aMlmFHNV9giXt5TGCnLjT36FurBTqr2BQNnnoBXjXoAXdHrPxiIzHYmX6XlfCt1823BXkN7e7ZCyIl50mkFeCHDJ1BPK6DtEvFFY2kVlC7DJ/NEHLCZJ7JpI/KetKlAr6QtqH2r1q4Vau1oyte/dt6JXA2zttv4Adu8LNUrVrVVq2gRvuHYCKZMc7KNwhemsfhqhXPUjZVaXom4jlkRLWBsCGcX+FpY+1rZvpy24m2sieBqtvcxuhmX4OXcOTRyFSRotR8YeBVlywrGBg4+oI0T/g+TZzf6CZOgXJiHpQbDTD3UlufUU67QIQqRvO+gHWgIGoc2CWgFisiyInuvcRO7W9HgVYDFtOCoaQFJC6QvnAeQRT8KgL6woF/uHwzWcuzW8ezSFnluoSbjecD2UbCaBkZd4jIrIeE0uJi+FGtJ3sN2f2IiATpTZiK6e9g3k/agDTzgmcC9XjnBVvuV+cWt3y7rxipPMJ55bpJl5STbDjAQj0je40+3E1QwCGOV8WSdETxYyQsuoVasqBVoyaY19ASrtCaSmhaoZ9FkG203FVJtDFnAIiFfhnyanJXJGRHatBVtwiCQCI3rXNlWQSgqJtpRM+3obdaO/gset6b0ACJtygqmXM0SAm0KmaZsFTRHM718JdgLAE6fZdsqs4yOP8sA5vGZprNsBXGgEmrAmxqMtgm3oZ4T9f7vmHlqtBrzC5mXcBbRy5egMWd3bz1qPtetTrmdVNg6gI2aJ6bDYsx7ezkXFsB/UU45LaAL20G0e4CMpLJjEYV9sShEHMu0JJxCC5qQLxADgOaQvJPmTe55vJ7CsZoH2+arQbcPX6fsq+JBZZb2BGdntZyc5ifoajnPdNRnpTsLdvQd5mFMt246pm48s7HxdENGY4OFuK2Sc57mzUhndqS3lSPpGcxH/dNHVEczpUhYF4plokFWoOEahzPxmQKH/tbq2SCwbOmHPB/ehfudnJm4kUthLhi6YCTKO2IK+sAG2TxXsH3eYRHCBbcPDtmvuoeV2/3X6Q33EZPB1lywkxqau0pfvHidon03bjz5L//+Ly982nDfD73s93/8zJ/0uZJSaqtfwrbEIP31JGxe570S3bBmnGFGwh1hkFo/Xs0De0Ee/C7CXfjChTcCow6ghzB1deSd4JHJOUb/viF8HTyIX73s3cxuB2cME88JWE11wIzNYg4Pdyn7JFGNYTU/oGbug10mTBzumjCPFr7kFqkPxpb6tqimTvlKS9Ov1Jp4WyQU+nHq7mvyqLPIvOhQIBIivHWpI7crKWNhfme9zEudiqtlvfoa1GpXP90I8n25l47Vt5PP6FnEQY//OL1yaVmOI2H4uXI3mMXEM2pak1FxxLzdDGx83u0XHYiWZay4Eg3t1FBUOuBuZT8FkKtb9lWauSDQfHCBUb2gqluPNnrN1VEbHc7kQAaXYIuZSodnqh2eGe+waY72eSbvjPV5ZrTPuLZeuR/Ofe5gm+1gIz3OTY85UQCiHReUqjldbVj1bimWWgTFEXZCE8h4HDysVfEQoGyVmEMmTEIdWiWmqaqK4lA1ejK7FqOYV5MufONi3iTeIVK8OBgiMZP+XjMOeQ+a8HloUu5Di7qY6jqa7u/vvaZomMwNCvf470r4GVwQbCTqnuWe9VH3LB/Fu7pn0SS5gv5xBNO+JAr9kZHfj99LjJ9xYwat0ec4yVc02dwh1zaFf03BraIhCNxrA8ds4GhiLWq3lNi1sY6jLh4bv78HAqCGrCkZPw821iQ8K9u/OnWwhms81VkOgkTyOYiAXEqmOTwWjshhFgW0MEBoDorHc1QXK7+WvWhw+2vcVnj3aJq3e/E2sG/H8HbYvh3F28EmzVgtkxl0Y1HlyHXefPGA8H6gv3et6pDF9Puu1AQGNnDYBg7awANNCzYbOGYDR5siYstXUGmXuiyLRGgnQj2zC5ylVbnvqbznVgsmfd0G+CnsUoHdHM0JG7CN5pGnFlQ4AYxAcyTXVupN5qr3swo452kFrerh0bN7wUSSMoVfU8XkClq8ZOblXryQeXkAL7sV5gy2yssAL2ReDuMlMy8H8VLTIcloC89K090lbjU1pCfC2GyjOaCKhLeDf9sqpGQZ2XjzAGZnXJzyQe5xsQ3ZADwDlimIz+cp/Dn//BOYy60Ib+UwXqVuhCehBhzKF1MR70NEvCzoQ128YrMJjN1Ci2CSDOKlFjRNM9MUNk0z3RQ4TTPnFDpNmXjUkV1Kh3x5+oK1Mdz9Wf+GbT2GUMTxsp+Wpa0OCS7BzxizmFSzdGEj+xkkU6N0OfE1JvMP1qmBheLLeB5kZZIH6gD/6QGdHxBC1parhtWWK8Kgw8E6bLQ2oP1yM3rJxAlzg0t6Fyw6HtbwBsI3afguhA9J+Dz/RjWoHSuOZ78grQ8oKV20OH9lu/Gzp4idv7Jdzl/Z3sfsr+x1Yeip8LBiXrtpmb/pRBPW7AnPLjUhKNMLU9lbBMjiyWXB3JYFAwglSNxgz/I2NStOP/A1Tn84fUFDDMSMVCuWWTEtGzbMsz+CtU7Y5EmoLp8493snLpHLWed0DraARnqfDlewjOqo1hOLV+LsHqmJeSP+TBz7UQNHBWL62Cq/NkpGowVNeLhUQq5siF4e850GB8aXASMVZANAR5gg+9m3IJvJk92mySklWi0vxTBpDhllqzzLAzuWHdE7ZFwhrxdEgFSbZu6AfRR4w2sxyuBnz3AIFK1Jo7yCMyF2l9stIH03NZ25gGNABf9aoIPdCIROl8nZvpgI1LIPAGy5uBHd8POIeEU/6ouuE8+rW0IKpiASXLYMOIlidsGGZ0Shw9LChq8AHHsF+x66y7ghXH9zmXhwL7nglT3HozzEmmq3c35sqfuwpQpxr7Tmbtw1QN332MD9NvAgB4T54Ccow8flyZ/4+rzFl/TgMJ4W7T543fnBId+UMLCBu8wnR/E85qMNd3vSBsS+ROs5oMVdYb65XF8zrbylWRMKqhiOArogbdIz/r0lFOPXfTT1CxJzDL/ZT8hpRMB4kId47M4jvRC0OspvauTlGhmAjn1n9SxJkw9Ukq+uJmszsj/A8K/ghDs0yITBPJL+x6p196rRfrW8p03PXidNVdd2X2KbuGKTT5LVDszbXjtqne8kXXp+jNKQ0Tnjv4BR2sfftb5jTht5E+R3vsqcKlN6T6ZM6WCMKb3ZMaUDx5TejmCqX9w19sVb3Rd3uS/epmzszWNsrFI0gEFS8jQbClFw879qHWzGMqcdZU6z5xaz7ZrypXOgfWEB7bt8gTt5yMPpm/Cqunaj44mGl5F3Ie/ikeRbOOXeTFNWKpVRJ++RD94N3o1pDp74NCuxzv025KdVDlrmlrkKPAjMLbgVogFCW8HcbqUWWIVWydxyoPQBKBR2vqqptZ1JJk7raUteUDffgYqnkJOd4FyxViMwsIHDNnDQBh6YM4F7beCYDRydoyLfRjvyU7i+UyFiplOBZS3lS3faDuvraYCEsqkKha0qkYIqAL9OsqlzI7l20imTuVr9zAEGigw4DDkFj1PoVDA+pxo2dVnZVBWT6csxvGTm5V68kL5wl6tsagZAlbwY3gYlL5YBZCUvhreDCS3pCFHORpF6gI10+xTtDBBJcYDH+1YSTEBoUKIABv+qHkZ/dNgLZMURvTx3UI7UnObBP2I93ZtvN7jBYtdE6sSbVkZboRQk5V9ZbOsxTqEeDmwfqwVtyHehzSgTAnNaEuRdPMly9pTFcFxKu9CR7TSDPwg9aE441DlalecqpZAppdTDaPUoUzZ1plymXsBiuDvucKvwm4vt5mXvXnLBK3sar/twF7yq91DA0817CfDowEZ+Os8WTHtc5Bf9n/0l/VjDXIMw7XRn82mYU4WYQE8XGg/Evq08BDFvwShsZz1+Zhe0ALXATh21155nYGG3Mrub8HAcy9ZQ3wNvetWhmqJCti7U2mW5W7M8WMnyVmRBOHOs+xnKum83Y8ykouTa6QzhyQcJgoYpP6wvypUflBew5duZLb8zUW7b0rs6loNx3r9jeP+O5f0lAHlR9rPSngjGDjb2nf0tq5//zHkrFzs7aNLOdR422j4oKLsTufEyvIBL9XkMgWdowy4udGOIeUC4CyXzYD37MajI3p79BB7DYhfhS9q1TnTE4cSAMb8vSwdtdy14SCxrnqLUvoX5xy5nz9SlA97VeaT2M2KsMV5k/3x9KQSRcooODHE3oLZC+kkxu/+AaM15HDVLGb+FsPm0x+FHWKHBLkguCNWSM2n2Oeq44FiW9yprzGJlJdnxSAolP99SLi5bKMh+Tgak4OZvZxjP8jO8IHiAn5iM9+NJFwT3zuKoBR1bUTlWT694sLMM1lPDWXTaV/X01U0WkBMvDhq4ywYGNnDYBg7y2ZKsuai9C9WqbQjtRMiuKTvG1pRicj3BSnHi9eTg47meLCrF1/VEXw7reqIvA7yQebmrup48oJoeDbfsXKEvuiBdri+6VO2VMcKekFYhjuTHfm5eAlp7aS+fpy6t4npPqZ4HPTS8n8o15wo2Bi5OW/M1Ttifr5RrQr7MwQdmmWLhSMn4Cj6VtnK24pQ1WuYQf79V5Smn0QKZ4FkMKx77vPbuh+eJn967H2YB7f/jM81YIf7wNDprU1HLaeYzflY+a01BrrPoNEhZToOI5SzaifBOI3FpqcSlcnR1CpBfegJhmM+L0imiS9YP3QIJVM9XUpURYfnBarVKK2b15HmR78Lz3tmc8HxwNgdl4nmDi6hbZLHaYqcJFLk74lW3mKUz3d2JTInNHBc62ad8Z8sTHbO7sxzebDMlRXLen1YIQVEhBMtTijm7nOxpOdn54Fjmwlk8QVp61o0V/Oz8LBxxa+N2iEizzZifn6VmmHegL1+FWelr5JLYPBYwQSVMe+T7uk79RZn6aEWX0ROMJKZ+7qb+8tjUX/mGmPpFdeoX1alfVKd+8din/o7Npz50ck8x3F4LHBrN41wY3TcTtlUKQ8/ZfMZuZYid88im6xR0OKcyWc8Znaxn8Q+QUPcx28DrbQOo0epTcPjPwJUpuKMUll6B/dZ8nyBxzqWDuZmtKitNDa6fPYrrZ+VnqzpHKnO1xG8omXB7ONU495pTFjOhdpXTW6dIYFPxuToYIqZG7QmxIBIlhEMjjjxdfLY9wJKXYJ1tYdOMlqzsK53OhYe0vVIKkXnx8bLL2XStlEoRGCCXej+njlcFPopNRGGzAI4O/qsgOr0HCpXAJrBoHHy2BC/i0CUS2sOhfZTQGTjlUyTKfl75Mle/3MHBJhSF8tlQVqh7GCMH0diPZ2pkomFiyUpCt6cXed61InYNSHyF3FFEFEHgFkHCtvuOIdVE0MaJFRlb9ma0I70ESp0iIdgwEgKuBdzZu/DaSfuk9wqzY0L+VGRg8tYgdUE+DqRf8r1wikhFbVj9QUXZtG0CYRGiQ6HpEPyDRjjBR/mRs+Jn78CNpksqsOsRVABJTQe2BP4Qma1jTJbh6isOPENSW++idR1CZUBOpKFsu1bKQ3au7e+/7Bry14xr21C/lXuCfv969r4qrjukCYjT+77qTqJWsRXg4btMXGNnkEplH5eG6MVTyZ6H/CwdSGBbEFUNCx8f5vd+vWF+7yOB+Z+Pwvwz3ygw/4tHCvOB2vYJrgMU9EgGofJIRsN6JONl/www5r56KrjIGN3PzvfP5aB3vn8WxPwXips0FRiqmZvgPEmBq9Yi5G21D29E6F74U1fhQvkaO8tCEXY6f9ASy4P4Jis0Y52pVTY1U8QpiVYWFhGUy3FnHjXBIw2IG6dhXwbgchRICy5xEwcu6xlX8UjwcFF8v9h28JEg7j3e7oeeWD+KmCxhsQnQKlL7XQHKjrgDI7vemuhcTUQla89ASLwbQ6FHHOWjUdJ8TXP9Q+s2+CzqCHcbKOI2xiHvihNKBkUyNL5W1O6AeM5OKpcbm+RX3lJtsFYf9++sP0ttg6AtBKYwwc1eSSYufqgvjLU+vzaPUP3IsGzcAIkx/LOSbUnj+WKP62ofN7WpZk/6PD1Jk8M1+e2uw9wABiX7KLAV4FYjI31PDgl9tZuyi7/G/f2XSjFB/2LIRcpyy/U03Y8TPC/3dZjdYqlh7XsRHPl+VOHp/ZOqDXvNy+lovZYBKYKx73EEV+l48blDHfx8nx+wlFtVMoAHkAGr/QT5EJBU7QNOMwbQQjzqRxSa5GPlHMgLhs2oeBUoUJGBjW2hDqch5nzTheQDidUAjOK5MQ8j7i3hc5z79aLC7xPx32U9mWgcv3MNNcP2GSere9Ai0lvpkV6VD2FwoKs2gRbU8Vkm7s7OZcpCCAkXsIqQcAEtCe2Wo71YndaTJ2pe2e8bOooaCq1BTWP56GmNNCwmbsxY1Kmmtk+KoJeLTWniAMeaD5R46SfaxkSrUj+BYUVBpv5/Pvy+9G8Lv7/zR+7/RNVFWPzcvX3qOhnL3ZeRhTh2C3E8uRC7dElFEx9hJaBOnTXzwS+6BTmgWvZLbkGOyXmUohgLsrsqRzVr3CTWzKEq7TNcEqzAuuQiLtbRiIUnUPtZ/sQKHHDj7lSlSPVAHgt68JOC6go8Yor0bR5zPWiDtiDSTsRm2ceQBXgk5BuUU5uDyltwUqYeygOxa2FCXcLaoo7tGDh3KVegFeA7XfNCvGpnYBhMYAKjKuKvXF6K0Dods76JLmUGm9V8lYtmcrdhndlHyBBKx6SlaIb2IPtl4bX9UTtU6V5Plgnw3V72DmSBgSWFqZ2VosBrFmj5FCmJNDGB6oa6LcT44iENFrghLFO8Zt1JeYjgeIQDa/fLR2EYuoQCrUBteI7Wk34r+pyZLmPcnQk3rQkFSEhdDliLMIFEKUAZnunb68xJxDCrVPHSFG6uAqLq0UJaFGgLCoeMAXaLCs9lXEAGqmfXe/j1937i4fd/9NOvveEoJ4PZ4mN9QqOzDXwodl7gwqnwsTm6X84MQtyje4+iChQiY8dxxMxxYBfG7EjFD0mi2thVFezIBRsu2IRvaRz5ijZ2QhHUsBuDvClOrPKg6h8jj5wattrbEbxPnW+MqO98I6IeyHO4yLyxWTHI3082aWbLBdviFLc12szWIG+fqJlCjy3jtWcvL+97K34JK2xIROnG+ogTHqo64aGGph0pGtSYdJfRoJorNjoZXz4YtIlynJ46NZlto/ZwoAosfvZrGH3XySIq85ILstgAKKYiS18POYL9uMTiKfL7FPBRxbgJGIxTsJE3gTQyZN5x7ZyAtQQaVoHuIEnNAdX1TEgtdVBo3NjoqKipHOMjTVoKCZDaCfLULNYT4N8bMRVfhWH1gugi/zj6Vsv+RMj1tmmxoIh6UXT3dD/7WKhw1zF7ty5MjvzvMb5Dytu1vhOUgGhppDdxmTXl2Eq97/AjNWUN6uLmitevT3rQ8YbgXSu47Ll76cjfT6pXKbxp00ZNuuoVC54r3sgFi2gAlghTJtysmhIpS6ylwOK+R94k7ntTr2TgpoSSwooyWLDvWcv/5SV/8Myf5bBH8XC99KusH62/GSd8Lzm+uOG9X29xw3sfibjhfaPihvd/o4gbPvBIxQ3P86H3Jp3eyDk9r/o86vuCoAZf6YBYCjiwcYQCY40KmMYIlvvWHWfNiNb99JDnBRUuKlBgoTfKN0UUqIkGvCYcI40k1XTzsw9WOSS/5JB8vOrMA4fkI8JxSHiB96lRDulicAtHLYcU9D9uaUWgHFJgOaTsQyVfFGzGFx19FHzRjpKitEYpCsiOkov/83inv4pmoFhmDfbH+sRf1ZX7wdj5gMJ4qFhIWgWow6QhT4Tst1QNGErP/lp2N97In3I+EeotW58QuNcGjtnAUc/MX/FuDOnK+JoXq8q5yX+X/XBgA4dt4KBHdbXpucFslSyW/Av+CIKjOjX2T1ksj9rFkpKBTql1WSFAMX4bnVICEOFQg0NikqIl9ABxbe0+NUTfe6biSzDAhR/Y3Yf8LIPiSsfoUeSzqihOnIBLFWL9BNMYN5dTxC7SrGnDAt97EE3pRXMeQO0yAxKXRxM9HC17NE+o8NaiS90BLSFIy/jlIwxcecSkXrDCkjmax5dGEaiNR7t6iynvVG3CptTAS0NfVGiDpmpvFsqOYSvNNeExy22d11OSUTGNiHnyyLjHVxzwXnqp0gGYQ5sfKx9AnEcPxsQ96EGCquMxvuPjk3zHlFgu5yT5jt8Y5zueUVKJnRUWY1eVxdDkbiV5dYIDcS242FAjefTrazzRCiVO3GXRGVVTNCscsSBrU1iJwz7YDyoa0Um1Fzho+h1LLaHBGLIGY3+PLBfeJhN3N3mEJ5lnZp5C7tZGdX19LNJoaPa7xuKmucIaMG9Y8A9GC+1ILPi+GEQwkYu/EvCHIycvwT4YDY24oRRVa9s7+pqhanFKQPx3GeQ2EfngsCGkZGLg5w0pDbuoqqPEplCXtBrZshY68Klcv8Ucy1upXgmmFiUc2iWxnM4PqI2KZBrmSiszB0KlFO1KpedN/ihv2gmUmTmQ6bCqyRJGtbwxTv9a6O3k+MgotEUgXTeW71tU37B0bVBuAnwIMIz5rKIJXXwxVAxY9TaGlPJ7ZecgdCRFU1McT4oJFoWttjiQ5haxXnZA5pD0JcFLg6/z5w1zEmBIRsSDaof8vX4UlMuOomGC0R3Zex8MR9/vDnkAPfVq0N+bB9XhCsX+717hUWAE+8EQIyM+M9WIeSAC5WiNQuInUnXA1NeeMD5q62yk0WOD4OCjyxHaotRJAFnvbeQh1fPAnA74xPXhQsH2azbs8hJWVhypn3Q7LPyo0rJqU3wQciWNBoy19G4/xn0HANAfFc9OwY8iZtHHbooITzLPzDzVtjUQR1fKiqNlbCsVW3CML91suWTd3teoBTga21NYBamOZo9os5YfUftWuFO5tKe2XdVPJBxVGy8VKX8jCp0omd+YMqF0g4qYtQCMjzOn5DlYHuATdqBT6QfyRkln1N+qQstaEgpLxXsGtVG2p2b61jDCWVRwXaCUR7efFWqpdoJwe0iv2e4xUV2OEjPPOI7zcLDjgSpkn3y18xIO9tLphKvvUDnAKUKcej0PIoyIEQkvlzNeAFmHwCmUlCd6alMdk6Av44ImnB5wY7R99nRRrwEjSo8etXUqBm7iIK5B/HdpT9lLHAZScwMHYnirNh5tvITbFmtjU9PYUJo4KFpyNFanEAMeauPTYZHyzxEmQwGk5mJ0acbRsOvUo03/NHjmbyjVzEOMDhehFuwxL4+g6JJyclwD4+80M9xNm+wLwgTP9OvEf9/W63/vWvbXEhWC3eVCe7BHr5YJuMYuc2X8yIx3lZacr5lzsQY1ma8xA6Z8hwfrC+W9tvOmGWtm33/7J8w064I+3ULzCVzR/90UV/QPBpFj0p2pZouelRUMBY4vGOAWusKfO6coUd/HHs3xvxPrhHII5CnXK0cmQiIQWsgTdTPWoAD6HkolCNnloybAu+8v4md85I2f/3slb4mkTkthHMJsbYJWNC3hU2exY8tndeEZdbYPPjMPpF/h9H7d9fj161O/9+1nvO7B2t7JfrmUR9MvJeuesxtH0WPdgn/i67cFf2DTLfinTrwF/6Ruwb+5Bf/wSW3Bj/rH34KrC1K3BccGKftfx92Cu33zyW64H9n2Opi+vT72WLfX6BoT8Oj/+u11WN1ehyPb68Ej2l6TYbrpJDfXg6mbaxrdWx/1x/bWD0zdWz/wqPfWf/p131vfNrI3HvjVVtBa9r+rW2MPW+Puplvjk90Kh9mf2a0wTdkJD3zb2V+vboswMtoMf3Jr5I2+3+n1fauPI5Mk6F+B95ENEiddAZoYkC8m7KobJMQVEZAAjBjYH7NBUlUJX1oKXj3qB2Jc2qPomZtukI5WNkjBlA2SbzZIgW6Q/H5ncoMEmiH1E3g4u0EiXU4Bx2B0e6STBa5Ppm6PaPru6F9vN0SPcTPkPcLNEFX2QuGJ90KPleW47+vHctz0D5uxHJ87McvxWWU5vslyrEcJ9rmgLQ29Xm6nxjHvBGzGK6s8xl3MY3xhMx5jGmMRYkbc6eURngMvj8dohk44rEFip8DT5yGPEstmME7nTUNGPBF1iaEBqpPH2D7BbiBoqUljU3ZDmYy29AidDMFaCMuR6+30POO0w55YR6KQJzfyezRDLQ4oU0GtDcNuwPAouIwFcysmUwZi3lTbmuAwOmUGJE5wGG0QtgWa25TDWBi7MzxLC/wlrmVQCjKCA+JDaDwEmwTVCiHaTaS1hGFrcRyG5JBXLFBEES1c2dNBOoyYmGKJiSkEmQ0NLanyEBBw8d1Vj5/xBTy0hqdYmMJTLKDFylMYCSLHKU9xzBvlKTDfJ3kKxD5KnuKvv+48xVs933c8xbGqBAkN+BtLpqYsQIFRDcezpkIcPCpre1LyEX72t8pHWFnPdHYjW6vk5NY4c+Sh93LdYExtimes5OCZmWdtQh2q+kpTl3+s3CqS6HvWJbC4wIhED1unppPzmEDNuEiPe0XdzeNS1zfoBwfspzSaAYs1fwqvhMoBHPHjWHdSQu4qGpjTFcN0tYyFx1BqRJESHbfGp9IPXkrlPmebE2dget5lyGTWM1fvXAd2yD+AN2UIMv6mQzOYgJiUMzQ7whBkliGYcwxBgxpq3T9mIqF+xS0TADf0c4McszrRWd2RWc0SQ+qMr/Ydu9p3dLVP0/f7fiB4YL3oclOxQhkVH3Xwik+4QZESdHZnsUstl2TgEYWEcjY8u3iGB3CBMXtA3c0juoVoH60Gfah1jMGRu8cMjrzPGRy52xkc+YgaHEGiqyMiWPc5kL0NIrWyKX0OSL7jVK6uq59j9Du0Q2Bc1vTjaiW+dMT2L/uimnIx9x1UMvfJlR42EYxlryj37q8AxvkcDhTzOFyX91DSfc5rudEizCMoSZ8COy7W6v1Uc9V1Y1oeTzLPzDylxUBWDJhaw0/ypvTdLJKxGCBUH9cpGIR2uyYWnMSkIqVQW2ScTGHcNuPHC3i94Afhci70i3hVSyEjBe3eyBdh9HhxrZ+8OF9yeL/MBR68OO86faYtsJsMThEagKyVSQvEf3zxv9fvQFGsWBXnWih/K6Xw8bUNj0xs24ZaidieJoKtixB/l/Z4BmzQ9iPDIqdcqAJhthKtUoiBUR4SB3EHF/MCPeYafEyiIt+BzvawfO+0pUMviwrc19YYCnE1ldT8xzbKryy29nLUnxMHctopWt5aC+3Um5SEBX+HLZGWhNaFRFToTQUuZCcKyTmCAxyLFodyEbPANUktoUhph4CBFvFITBeL7YM871/H9cxxszMByNbiFIXaziLEYO3UErYR4Q01bTMeo0+B5PsUrnEX4kNcUzmVq87lg+/XK7RcwTapoGMrcOVuLU6TmrSCXVoB4LFLK7Buf0JNRgV5iGSULXyxwD6gltyFP51rPlV4nFMZBuK9Zxei+DMTSxp7BhW040h+JvX4u/wsfnSuyc+mVbydQzkA9GD9+/MnMKbsJi9/oqDZCp2zVqzwnQO4EVepOlCwhOs8PREo8iQOPOnS3sYIlJ88yM8lA9VZDnQPFE/B3f2M+KEw36mppypsTlWQ5BYk51JuQLITIAGi3Fsrgd5mqJzrgG6AWhBXm1OH37m+EPYBMgq1vgWtZoErPlVzbzLGuBGN5oSarEOAZNTElbax9Muh9XkcvkfC+fmSsEfj93DwqMZfQE/AGnKhIs6Cwjl/qoChkKJJ5tQp6l1lAQc56dl8xUj19DhlN52C3Q+BA9zGk2I7nYmmJcX2YbF8nDOcsF+nEGc4TClArKp8gQYoNGc7W9bfnXe5KqEfmHbO5nlIqzCeAKIawgLHNoEao1KRDx2zABNrWKk4w3aalgBVuNBSlq0MfpmnKZ2S7077r+xfSxf2GDi7aNftzp1ekR9x5dCWkULztkDtNDqFCQfazdq0FO/ibhbhS9g5WP4UrvO6/iu53LX8CbYv6NtW7dvBBjBgVRw2kSgTUhsXtp/wUlq4Bk3eSl06hZ5yzTtvBmH/4Jv2IK4fCt7gQbZTQL3iNHX1pxDcwh1ZHjC1O4P478oeVTsy2o0njDX7okqzn3biZmNQ0PQnoOm2E09Buy/tcczTRjtz0Ul3BkOTP8QLc9/nprxEm5Cv0emU4F7KE8nbj7UctZ7NdpJkLC6UxQfCiIZwLUiHMYOJ9kNQjLv5xNmkkPYZXObCGX7tZuJg7U3FjFpD1Md/ZTPTaC/2Sx3YcngxLqFLzuLp9HSa+S+9SncW8Fiwveq5NQzDg+b51BxpHpqjDaMFjivaa1xw/nQ6TVvNALXNpDN4/Z/BAifS8affjBFYQ4NhnhkepflHDUTxV7RJJxZsJ0Lir0Y7wYkih+7pmns2LDGdhZ9TDPzPApspeqygBjkeWX6xIyBAP5mBdPFA7Z7odNYxaLvVH5+C4XXrfbmIogmMYpcakJ2ixRoCtNesW5sWfTEXvV0KxwTYJQtbrziDb8TvxWQ4Mhwcv07cb8RA4I9vty0QjraxGGkjMo7vsodc6fguBcMZjmShIY5kcfVn0HZpMeyja58LdH6bSvRR/VSyZMbhNJEAmrrNZMjbWs3UaQlcIsOk2KsW3zKwoV9nkDzkU/slMiXRjCPvnjITtVELaM0C6n8Ec8+XufcNOOs8mXXf+POthvlWG51vKZ1H54OD2kMXgL06l57KjBI9KX8incqc2k5mB5+cb6cnkexhZD+Qty1/j3t13T3+sYSfWy4I7sZz+YLgaEIL1BLbxSLwiQGEGX7mDEPpcGw55xnaKq3+L8I5o+3EAUAgBARUTCVbNsM+SVEUWXPs76V8PX3Y86LrKBAXZ+St4bkb6jL7iX8u7eF9TxEeUO/74vQ9VG9p9f0YJPUaRnWk4rhSwKK714twzVvyPquoXyqsKQqhRPLiiyLaD4SG0pbsEDnITQT4feCLj7FEBnOWlthJZ9uIQk279SrPWeCAfULzOa9pOyqq63bcN1tmtFhaegIVkb+foiJyXxjWdfNpRWDkrl/YzX2IzX1EGAfE2SsJFF/ag3ngie19HtrNr26luwglgBjEYAHFuNAlTZebuppPriwkeCSIaCDUwlA3Ecow2ji4eauaNV6gANELYlQV4iFz6TNQ73QS6nIolMoa1KT0vbAoIML/7B9km98c2+Y3LxBnBipkuH9MyPBpJ2S43wkZ7lMhAxLd/r9OrHwaV4UMuJi+S4uowiEpu59o9xtl91uPV/fR+dZJdx9tVxlHaGUcGPey9U5YM03GEY9spQNnZfm7a3qqUKIUnkLmPYtQSuzJx6+6o5P1RRYOXSpwECqnn1gxAsHeG7OZyAjqIhGV6LlEKOHQCkugl5P0D54FYYk18y1S7abVG7XHVmHRqmrctcXElgg5Zvi5G7KOGHuqjDwhe7MUbeRzXM7Brog15pXuw4cLpfuLhGaJ/5hHXTSSC/EYu4gilsmD5KKLRyYij0TLERdVK9SlZUrwx1QrZcnFliND2LMWycUK4LFCS0akruBusuSia5ybL6rkoieezNVG11ZTOn/LNfVw5qgxlPDxAa3IyUDRZUtExXKPC+cQcaBNW7mWxNSiNqA4t3hJtyXSvBy/JFxIT71+cyFbUUibIzjAsWgxdweSi2UUJCX0YNQOYKA5PBLTxWILn372r+N6ZkS4sCK76IS3r/y6XLDMoWxDl1YQjZq6uquFNTnYp0o0OcHWM0Gy7Gp7xGV3Ny97e6VssmV3iUzZ21H2di2bTNlINkKLiGKAfQnChhw6ICpsKCjKd6hvUcp5HR4XNCyUYMhoh7g85cBOCBqqQDllwHt10/cZDvDGn52kzkIIoDgzq92Y5W5srXSjbbtxKrW1G+BD0d1Ek7UbSBYQGRD0iCsEK7QdNYnLoA4lWlNLa2pxTbPHH4xZ1DS7yWBskbYXLWzy22LEPSt2DVjWA1P3CmIZzNMUkPkZwG39T70Sbwfn6qX2dUmXvWXFS51PmZ1PpxP3VPYCbgY5tPQwB5ZK39OmMGqpfCk/fdNid3GxW9TMVtHlSviP9wFn8j6AOHwm9gHHrw8yHR9/vAto0XbuD/OSqN3ncomhotqug/xMZswDKnhJgqHeSlsIJfOTi+Yy5fRwmc4k0qnY5R3BFuk9Ql3awmPT42d3Kt/ePSKtpS7z79vBv3NbUS53IKx0oMWjDlLZCtIUiK3Q6nA8Ni0JKJpUn/BgWiKhUEu4hctCLIgbtYVWzKalbVqLduqmRauykFtGjaAcqTjDUFDhDTWPQyY7HmRQD2bU1P63Tf/bJ9V/xRb1MIPaFEdkrjS15p0gF4v5NsGVlql5CPAPhcL6tKz27QRqe8Rg2+7BUHF1l7zSYCB5Ee5KTGYzJMbA2wDwWynhp4ant1OAqqBjzX8mDs3fbmHa4gcmMbq2LKSl2CYwPZXOANWC+weIQGlRu4KIcPYGLJ/KH+7MdxBMbG6FlcV8C+2kWFWS1KWZWSNTmoU6Cg+cbAGaQnX4qUsRliG7BLXNIjS+BOkCxJBF6ZaqWev17fQnHpsztwfWT8KZ280/C57vTvxaZ25f+b/dmdtUP1on67at6jyr9M31jea9bTOXbSfpp60zpYuPyl2boqC6a5tAN2Da/3Xu2h41bm2KWZP+2X6gNEB57GdHN3MfkXds5jRJN3MfRTBVpbMQPzXe9Yp5Foqc853SMFJfShHcyx7GCPFdmIoPo6uLGI8XOB9GVzgfRi97zD6M7otiz2qAO8J3rPbIHRnxmIHBusWXOwwY73v97J8fD79G0FI4jm+jzqP2bfTTj9C3UYZrSgnMyeiiFmf/JP2TrXaMR0v8baXikF2fu82TzDOr7AtFF1atUuVRPxE19zoUOhDS+uvQhIj4oYt+oErWbZrVlbjq6s7dYZ6RWPKfowslwJyiLprhGDz2Q0lFnNGvaaVlsdTmadVGuZxS2SNz69voPRqVB9JW18IIPAJFUsiVRdTj0mcRoSVVW1iTHpTemYQNgZ/K7CEAsgSN8c4k8/8O8DrGO9PV+HnBVO9MV0x6Z3IqR9/rVeVSkcbqpdyMHx4aFBHUFlVVMiG1MAuXOmo9MRKkg3OdCPjwVTSXg/TI/Ooc3xDuCzYzhPsgaks/lzZSmaZOwaPs1QO1/U5/A2piB6BfoooXL6AYxOoKffsefftOfbtc3y7Rt336dpGsMnldZU6YyhCkKTvWpBjRz2MFJLG2h7VmP0P6hRwBg1AHihTDHRyA+t9L7GyM1f5Ii1JAKBQ1hzYs9MUEDJG4YoZN8wErCVPwLHU9TGn2ukNSQv/j7s1JB9FMbTuyXMTYSKE0h+Ls9TbrguSX6LxjbfBk1Tt+APst3jq2wdiIJtITiDvm3Gydx8njFfmCCngW+94lYh99WTcuPObzus8Wrpy52EXywR0vGFlUSC0VkOW+K7NHi5hISswPerSFeiiEmY5VWmUuZ+sdRvd8bo26HFOufcT2y8uXK3vryG+KpaPDoVvZ8HkI6ZHqgz/kF9v4bdslvco5s4/J7lPPfQWX6Jj6dWGUcz+l+UrivN15qocWc0Md4LkoTxRKPqUi+kvIt+cTdaGZogjsRNmoJEQh5SBCTEYdzjYygoWvTPSyjmIm1GzZWPG7pPC1I2pOTxtSp0z2S6FUWyQqOSNfqq+Tj0eCIUogvVdTgMmzof0u+rVSQbIfqJk8s5hr610cXn8g50sJETPViDpaULcQ1U1QFTgWoRbRuu+0jVxRaIWUyg6Gd1/alG0CMQ9BmR1za6qEj+3VsdoB8RhER4h/d60rgtRVr7xu4DtD+IQW14TaOnhr88yOLUErE4U+uEF17w1/OKy5+VKG/89A8lxsU6jyI8QxGW3D4hmTDhd/cpaYwURotwjiEYKRzAWE4FgNZBXBPWobU8dY9cfVTCaMLL4BY22h5WB0Vh5av9+6wx3tkepKRpSiK6mVu+hhAxpcJKIKL3dHSMMiMdT7ZNSTWVGsXlnUezgI5QgOcKz5QPDbfIKeS5eNjc1YCI7GfEVjtGfjUR+3Ub/2Ght171hU/4GS3+ylh4MRc53xuLlOirKvTbM0pec59RFTVnVnyqo+acrKpUsqOvuIq0HrO2vlJwcxjObOBtWy6/GqvH+dcC3BGiymujFsRWuyK9svJ1VSgUTskkrFyNUaND/RgYqJqwj2POlSNMSauNJ5HuBRmrgKJkxchdzyX0LLiZks7BWQPa/zk8JRE1exU9R+hycGaN2tlFh7WBeEMqdSQJKG4BMWyRGLnkLbm9+H0zbouVNDgrv8wx5QDH2IUX/2qkOP3qhnffTyyrfjusZdnt7XgGloo7auK3wovZPGoknaCTFPm914yN5liTe7y3LDoX8Hlj0/HAXgsCJ34d0xjgDEPeIWEyiGYRSL34fw9C7AYMv9lZeNaqlfPfr6As10BT+uF5PrwfMIBY6YxQusWbwizv7uNXiKnev6BcyuKM+QJ8KPie0O7tu1arX1JY7HwFLGeYB4w323zOoiPizTxYg29OJxurXvY0+97vvfMvjcxUMUKxZqeEd5263499vmMl2K6Su2ZzwsOANKDEu4YcxX3nD3b79w93+7T+sw++tvv+yDv3XftphtCWZ/+2oxI0MR5tkl2uqLtNXnUkSt0pKEhmscNqz6LjzIk81BBGx9GX5egiUErGNE6XlyetIAJ9ukKPtnQAx5rioCXn9lwxWUh9qoABYP0B41jP7lGpyY3SGUW0+35WOVr7cpFVciyisW9UEhwUM6DlXYqlWHiEyR2T8aJ52ra9m/aFCmGlZNDp3uhzCTIXBIFA7obwTmXOBsFoma1oN1K/t77ZiWLxNHFyWOODh+jeXOaddYJmJBK/QSyYzet8p+XG5uyA0Tl/jXowYWfa1KD1MsKQhUjsZ8uP+DBY6BbVICrfmQYy8zcZFoS3iCgaAswklxmGQWtnwQY1TAlxB82f57P1hwIjJc1ut/Dd6KOPIhftYv7QHg2Jq9E7AR6pkHm9cSmlpUAiYN12YHLPLdL3cN5IsI+VStpSZFgh6f7ifnm/y52NtX6gJyorQm0YejPNm70KoV9bUUiS98pHHDlN745WLTSbNfQd5a+h7fi69zsDOts+BTWHOlCmYUC9UUNajtGyvTeqCqzGEChimRg+ciBoZK0RgfCksoYdevX8fCO8eVbUICHaJEd/F1XXswVtoJfc1uUi6uHDd01DWfj7IxhKgurAxhYocwux44pz1LpOAiHGkQN7/SFVVqqjYo++wNJ2Hj5I2HJhVYYFxlxIiKLmIW+N5+nQBU02lql9l/bAansFtc391hHFV7yUOVHN47Jjn8uJMcapKU+2kERVKDrmN6h2tqtHOhqOORFbrZLhoUw4iO6LaLnZ6mnkykemWwpVvjtm6UZ/QuRkcxONN7GrPCn8yivyAbME+AgcT7PFAaLViQ10WwbdJgyvgdSje6CVlCu5bXnO9dyVR0JVvRkM3uFq5kGfAMIXrnL3bLbjiijqLocl6jLRZNKRrh8dF/ZDWnZTVgbk0x11CcBrZhIp3AzFpm/2l8GgRevZuvqhs7KBMcQL17pTnb0I5dOR/A52ScmxViOGKHqLTYy/ZQ+RQbijvRfLlBSttpJ9yR+XmE7NYjodzR2oGzWym/QfAQlkBXVgrMeYjLi6UBncbZ6riBpmLx8ChoGV5IbWLoi/iVtS81NXrRkArU5dmuqpuShBJxZLaLAtwS5Si8OmdmkFw5k15yTauuF+gB/mbOGTjeKvHvwF3uiJatUtky7eCg9r2Bt/2ilFjjjtelRw3aQbW1R9mpLVSf6BSg9sj7hT6BUqhRWToNcVCHKGRUahWAuQqk+MS6RpNig/FicxSbEynEkrzgkkghZp3W9pCF9VPw3VZF/Ro4BoOYVGt76RTXfbuMfd1nm5Ho5slkruL0fBe3e5cCDTqteBZnwK3aGXCrJuDId0mrMVPwwAD7YmZDGZd5WuRRg90tlfc61vBMwKXvGeTcJWA9E0Nk7POpwoDaAwAMOQD79AJvzihS47PoLDrT6AfjqBUUYhY/QjwgvGCYtxDBz9Mo1VD2k0LpQxUwgsBhDzbHpc/p+ZWSuRrF3Iue9iNwV3Qf61nt/T97Eme1N/0CCPMAv+asVj3Df/Os9ptntY/9rFZRUM9qJ9ANmPYozmq/eVb7I43EFy1OPdIcow+R5jPXf39h7Pov3pUl0yS9/oug8TIQ95GnPNxhAzfK+jiCWjd8eYnf4Lfv99bKs16OGikjOyzilrowffaetLVnRUHerBY48bXKlJn5S5WIpWhli6YZmGnLUWREeJJ5ZuZpqFY/eS7qqBq2wsSQK6qB3CsPcTZpBbLwd5uR2jft0Cwec9ShuavKuyJO3T6Tg0memhJLLbAXcl6oE6YlB5N47M9nKdCDSaknLIulDnDI6vDOghecNfvsjvCK+Ww/cW3LaBYIKZ9fWWQ9LhfFZFpGtW1oeT4vdF81piN6jMBq/isCq/lvACwI9sEBCNAW4PaDc2S/jiPy7H/L7tvZI6AFEId5mi9jjkcj5tRxE7uv8Sk0G4Hyw+/lXs8JlKvrwNwo/ZijuQr9mBOyjUI3Jd08HDFIt5gTjSnUWds0+ID2z+M4KjuMjnHdyMOvB/EKe1ViUFHtpJGvbGfkSFL6Zy3Vr7h26Tqff+1xrcdb4SoxumeMGH3UESNNqskVeiVG0xjFhqBqQnhm0uGgqoLeRMsj0BY8Ili1q6vdmTrexIaE7IPqBJsAsWBw0t+N433KZM+NTuHNCGpT8JsZDMRkcvhV1NWgihAs7FeVk4pEMk+R8HNicGKO6zHdkyw0p7vJ+V3+Ppo/u3YJrrHNowi+4+8bEqvK50vK0i1LNjClXZBEKazYQgvik38l7xlH9YkcIOPKNljQFVqlRSGX3H4BUBcjLn2MwKqiznORrucCWzj/wgF9Z5BzG5FPRClWWZPbYfezdYWPlpRvpUWGSs+cdGyl+ui2Vs8K7dFVhtmZCeL0aAlbiVVg02ppLQuAEX1/bG9xSxH2Cbri4Hn7AaTq1pbk2ARXAMTyzZIMJ1TmH6i5fS0plPJl24cttAxlfq+yX94qu7k6uIQ8JzxreaHlyFYWvaojPqwpjA38ttq9HM+EorJRY8QAicnkgwblI0kkkAD+RIo/Vqt81QKinq9ydYt2R7pIPQ6aduNtf76MAaeeaT5/tvYN0QMdRlpWojBau+KT1tpFrbSEX66kXsq8Nayy8GnVLAGNlsylPMUWe7OgiwZ3BXNk7wQA+Xu5Xp048BIqLdDZsYRm6JUP+aTYOtVnfUPYSOxY0QvB7ymEqFDvXdoPKnTnWuTYseZux9oATLVHmU4CH53fKq3FNhZNA1ZvrdAwsS3vKfyoIeBvQmxU3a02ZfOaZ2ZnW6dMRoSaalJjB+2gpu5Wa9TTe3Jm3hf1NbwzZqwhao+SBoEN1e2GtTo1U5rD2xzN6htsc8kB+QyM+HQwVB0K0CMSVfamdsxqemkv6+h2xM3LpHmy+kZoJHGgabWnjBFNOVsEJpUy/ib7svWTEeNCvkny5Vjp6vNVmw2S8VsOGeNp5sBJLeOZaHNed9F5doP0ncL/8xG3tdoMcKpIWUw8cfMF9EWjJ2yN3gNzknQ+lmEdAqGgKrsq6mKOCO5iB1DZi7RVd9jrbVBCQraEEmRE7lupeat8USotblykNy/qorBgFizGBsBHDRlL241p0ewn0beKdD39oYpLC99MNQGQTjVRTDP+hWP1L2y8D4fQKatRIKpnOOZX69yO14B5crFOnn36RumRuGLxsl+73njD+H+8aZcjA/L0Fh+2RRfWehzy9TqeXsJbkFBPDq/l4BQu/X4Z3arejHuwzmxGnfXCAvkz1ex2R5Z+1egzBcMjRdWJXd1Zu+ieve87/yX/ivQnKxKXCQ7sytSrengdUgP/DbIfFeNzA2poSNKOlJmH4nt4vWg6R4PIYevkwoY5j96+h37ui3/4nO+74uJhxYOfnAUzAmiRsjNqu2t2ELHxJJuRMM8R0CXwh45mCS3qiLW6nAOMcMivK2vZhHP3XuW+fekN7S//Q37z0ykl93JlT0xcZSkuQcKoL3qUz/E5wO2fv/7o3a/9ypu/CnzcxOVjMnKIOi8rfz98cb7gGpoIeUaCAJ5mKcxeDc7H7JsTkvlPAod1/FLCnHRr3yW/9L7bvvSp1z/9+wtZzz1cn8l+63WGWdXXu/Fa2pKbwWO1WBLZhwJEwyAvABgDyACtiOUOxQzFHMGBEoJLVvOrKR78iy5GdEa+QF5umTNbClkI2t6FaTM5iMAjU5kJ5Vv0HBzY3VCn3xABxvZzVlgeEu4bbYFcBYdd3IINp8LM/3AzCffeihXGwHV4h6XYITsnx6AYEHEkz79GuHz/+W17aCl6gLN/ffb1t/7k9U8j9mSdAAk+9FMv/cDRXYeeXrXyntAii3Kx8wHmr3BFDktd8EpG5hgbrQUoMc7SPDJv4RFzmRvVzLj8ySpUVqkIZplBxtr96FvlDldZlMsFFn63nfn/hRUr9DjKHk7ZyeEbV+0YWxAAnGzyUXl2m9WqC3PfHnP67phTTd0aT+nPdjduKcj+5VXll3q06nPZ6n9QWVtrYF4tLJr9ED5Fcemfh15n0kKiKKp60nLypB/61sLwjJ4oq9XgEAf+4ALMOiVHnrq5USmuEXRHOqWqW8jva4s/eE6Tc1B86bfQRI880NX/dYM7uDP9JE+0upFFLa+BOPu2GUUk67sCWsGe8Lilpgu23E+jXMmVa648SSnRs9u8YfvRRD94K4k/9hqUUgN9qi6p6Hi7bxrXKlhyCSigJJnAuKGlWxafOmIpN6YUvIa6KR8/XEsEDuAiY6fumYJi4Iay3sGmps50W4nwVc4oe814tFYFsHjNVHG6j3GcqALcvHRfAaZH1w2zVlMje7NiJkPM5UIeAc+B7MsKRfIAWcBVleyqJjW/4Psxnwu4ZbY0KCsV5qGZ9WpdUHanOh4xHnJm7jS3alCq0uNvvLD/Zj818hCKlCOjQMYkkMMc+0KSzDFoNtRSVXzrw0dWKKfOB5T1Ef3KPC75LUBXa3dDXkSqEAlwAuEARTPKiux1+xbp/NVxq3JBQOCQtBDVxYRKFRy0ZHmCeFFByThe1RrIy+5Fy4AzmJXSVqU8HCbnkeRQ6EcjvGfdyjT07gpENsoz8cMcvyTZRzGMaRnRktj9/dYL5cwfghSw95f1svtu1LKQjvE+wEmAS0MUevmGirpY9/ezHdgivUxWvyajy/5Rk+Pqv9YTKxgwIctlqUIUpiz/Nxg6I1oQ6GyoxlX2WVQPT1t1VLL5B/7IB9Q6ovZkXykuX6jueNxq49H0VK+eptizNSg25qw9dEeVX4GD4IxU2ltdiwIxeZKqbrm9+smoqneTpa1gk63nmcCmMBcU2PP0Bqa8MM515yPX2yhabuklG77roiG1eCEObx1ig1VdgCnga0R9VZ9QtQ8cl2e3Yy5jmHWgveynEFH4TqlQVxqVyCSPULMomKpZFFQ1i4KT0SzyrWaRP65Z5HHkg6OaRW85NKlZFPybaxbdcWiqZlEwRbNIB2XSJVBRGx27618l0VKKalKmz+cBns7dGmmap9QL7RAS7oYcxCattqolL77gLLpUKoymT53q4uhlU1wcKeWwajlgVX7O9+qT3IUhH0V5F68IBHuESkYWB1ClLgLIg4W5CIAScNzHfyVKBBYl0H6HEhFqCCi2y56wQaLNh1pd1TEXuz8PLUsFWUGgGIBa4a9PGGR8iRCOpc/Tb2XbrmQ7AlFuoRLkk0coD6QZbBBImTsBU8b/NbCxP7lG+maWoXhByRBRUOkXxd4Ffvj9FnaiuoaqceAAB4e+IILoVuhiCLTL1nX3jfUnsGxgZQVJD5Sm/onX+ZCnYP967xKUqecZrJXaP3oQiHr7QYEzT9YQxD6sqqpDNp7diao6ZRzONSQOMPkpqewXTh4/whH88DbBj2AcP9D/B0bx460j+FHCKQKk/o0w5KePiyE/g9RHOd1/dmK6h9XpHp7kdL/6pKb7cWiYN0rDQkvDbvUDnMWEk5crLFc4E/h+Tbj3q9cKKItLG57bFgd3YA+BxA7bqY4nwwDfsoT929rW1/jPARScAHYBCJvszxvWbndzLZcPKNL8PLYwtJ39vKAryDj4hhDu4CKNBEMJjFb75SK0+wVTgfueIkF4V4KLsXGJiX0bYkduOPyh58UOLFje0BHZOXImaGwa3p+MZqgcdceikYhHTSgBQqsYYaGFCxCIRGBvAxGncTGQeIYWfigAFeQx1mMuBkCPqbaGJVZVqPABdtMxJXrbKIDHQT9ESK5HtFIrQa7LDkPbqiqdf6yeRNzYBjUPDDzVbAs6WgO6q0PuuSEXBHZDPfqRe6uSv47iQWLRAP5I3l7SpZpiQgQUiOV6LkWVMapbwsUUQJ2YBiYFaXVT3C/KyKUf9HQW6hipNxSCJqvGBNZ5PPmCLWu2hXgBjDgaQGqFqktJ/mi/fZNfc+d+yxvtcw2xdng4wUAcbZDmVIuwmbReMuq2/xJ6TYdv7ixUvPnovp3qz26j0/rgjTqUIvpc3v68qZu1VDLK1nGtaAnOeNRAdQ3jxsp1sV+D90nGlm8HOYF66wuLtjjbUAi0pA9aVCOfoZYqBeGd37A+UQMLQ85zCXVn1DLCRZ7XsiQJfZsFhmc0i8YUsxCYATwh26pdo9meaK9SI+/wD81IcZlSj2b/OlSfmAYo8AJ+IU9YwkRDKh2h5PQAcRpCXCsUQoBOZWgHWm30bbRfXp5yRXiTWhuqfjuLeAFhA12o4VOdpKnuf2cvLUIRRFANXUBXWLKnuxZTVBtTt0MepdkvCbrqqXDRgHZCRO39kBdwVHON1zW9Ka+426BZHhIMR4s6mB34DgpRSp4ozT1H32RPXUmEzKiVQ4nIozbOj+A8KlIDmsBH90l2lxK7xBG798C6o6NwvsPsCWrnC7WLC4mPheiF1bkSV771ZXnwUWSU1wLNidJ5soO4JGYpqVPi6kOCYIVvLqHZJEvXwipN+z9/4r/aH7ncGLr1l1ReaNhEfeja6rroa4qnKfoVio/kU0exAxVB+Put4xTrYAqVoDWhHv2UFYgFCy0iwJD4thyUQrj6xUIFQ54QQZEtrlqS4l32Dr1Cl475g6LQoeCrA9kwA50sG4BTWXM6HFOE4Yuqw6d6yTp8qeTI63rN0IEuZuLICeCZZDep+8uOAZTYWzRDXXOrlkDQzrVwbPRSM+R6PVKnl4p9q031qk31yqb6ZVOBBgxWfKHcvoIaEjXjpCciiLXMKsxTotLzGBUHBmFDZADWata69gerhflCE7Q/URWhhUJII1CzMVvqe41RtkdHO8QWICq3JTEIySW9vuxNRPCpeko6dDEuzyWBxKhP4oRXINOvgF+xEpX41FR9KV/JOr/6StaBOUrWNSRxiaK3zjItuE7SGsbIZ4sEUnrKFBZ8BZhMTgcZ1wYpviZYDtKyQel4g5KTb1DDNGgNDdKCE4rBtCgwYJJXpd94EYxaS5+y2W0co8UYZO+cciPnrU0+2G6UGlMhz+WqxtTRt5caU/caDamPiJ9EOU3akNTpp3F3ahp0q1CIyl9ASHYdwNkFDsFVvB7qziQ6gPu+RhVINyUJ8niyXDZgnq4pDnJycTxFUAbfyNuw6TljcSKGoEixo89vIiiaqUgR0yO3FjOU3go1WigwU7uS2JTEZpmY8RkrDgbJ10Pmgrd7d4JOJUaaeqOP34N6ud47UIQqd3kbnMfcGaxBHidqL/0NIRAq573f0xK6RdyXyYmX1Wf19NsvcCo0WfEtjr/Lb4OqXl0h+trBJoegAWzDEjAQ9lZEKn6vJ0KFe8VqgbaO/OxdeotMHX9nUHUcMgAyAYx/Jn90h7NsdKUQZIwKelSKLss26Wm8ycJH9NkhvOeZYo1WqV0zQ8t5aAZV73ZntpSZw+zT9w65OS0+gZ0ta6DZ6nketdbv2PfyhV/81j//obfyofmsOVu85mnkgnx6PgvoXkKeOZDpe9l7VQ/CtAvdzQbZrwAS4gFOo2crnuXerdttbk8mzR0qvGb521lBk1+Vj2coIBgugmK65LgKR0XcTHvZF8NGHcQGpONHXGi2ga/3pT/0P1oe9wz+rWQ6iDGL23LUMsMn4EpVzITW4zc7V5KKl0lqwjbrBuN5ge9YXfyOInPpHXdYXES9I7c7jALOwyZRJcuVvYeCIhZirWcjo/Vkgzdv9lGAfeNl4pI9JPSgBSzP3mP22MEGTzXEajeC/TjzQlc0hx5OqLxZT1YgjTrmYXZgfftCaE9xEf/RWjX+1w7Z+KMj8e8t48+dXsyuiWiulqmhZSSOej7cKVppia8+M/mR6XGpHvPqeZsHGhVVj0biUdV1iC2RkZl9wxgb9ITxlqFqqUP/ZHqemGI5+pYjVooHd1AgGanGHtMkdVBEgl9YQgIKlc7fFsQwuOyrbyrnJ9XyhkpTIwpxNrwgD7k7I/enQzlT42YLv8Kz6CcAUCyHFFVUV+KSXpALspJCvP5mRov6fthvcNmrLleDvp/zXjLXTWmslxDTjSIaks8Kxx4Wv4q3ErQTTFZX7bEhFfDI3o9mDaG6lLg267GQKFGIKXj3XRHhZaFvHLynnN4rUgPoI3DJOkBbGKwgRhxMTfDIOj9wSNVijZUAd+GvwqFlE+deTXM7rv/nNaOwhqboSUV5wkdh9YDv9UEQwBi245Hc7dYR34Ao+jyf1CjXPd4Fm6rCZHp63d8J6WoNi0gq39zt5TG+dlTVzz4gkwOIA+zUXKNaJTV1LEh1mxv86rl6WXQXxAB63YgBp+Z/xBM+4YfN5DbP83cKQxRuGOq+hal7c2O98NW/HwarQUE5UtgLQMFJU5Jqijl0jYDwTRCHkb6UgeyDaOTx+xJTXbOlmCjuMv+vBBHmhzpPtboR+wrjeADn0ZV5LRs3nE894L1QmZZnjzsTjgPZhetRVIMzHlgz+oUiDejfLxFZkVI6EFedXF7elknQIqCMyzM0S0nMHYOhOCDprbxGpm400+oaOeCxbkOLEfZXq8berSJ9Xd6ExfbXsx9RAxgUiI6+b5blP4aemEoWs6OyVn3so/jHnt/wZQ1tb5LTOQMi3TFchyE5lCPffcgaXNHVrkihGeTv+46Nba/+/H/gcdMSv8zNL9sBeJTxvMSkZW7oiKWYi0Npq9pVSn8qrFviFog1+RGjY8l67uPZzYNHNqS4jTmq5hZRIoNYhOCQ5OaQLNb8ej8mV6gcagQpDAAHdgxOwjw1LcgcVnUUuS4ZxaLD45i5NmcjvI4v1+QgthlKYfcb79AM5M76QF2gyH08ZMPRcyijHlYsH8OpAlTz1Aa9jrwoFfJSUk5LuQK4sY5inGvvYd4h2GFBeR75Q+EsTPKuvevM4oXaT70YY7+sPW0o9A5xzX3feV92zQ+c8VdP5wbLEqKwAK+pbUw20LMWk1fG64F2KaHWAUQPUCO1gdAD7Z36PlPL0v2GdMUn/w5tGgVDxcoAjBaWQz44fzhMfOOlMQaldZ7CD/rueEKdaAoUirqjVutq/OWYlzdQz5Anr3+r8bkYqjvwvoc/pnYz/Yz471Lc6Ynl6jI3AXrS4lfY3a8DWohpxtm1jUExR3PDAc8aVaBLyppNoGEDX8EUmbu1mOfH/JU9/BKHrywWeuX9nsF6MY/ooTxwJehDB//Hfb/7XT/OlmK+9SW//2vP+t1f+SCrVuy89RNP/fTMb8H113f9zC03DHZ8ArFbLnr2v3zuq3/HscX8Ef54oafPueq9orkjNEd+JWZYuPRKVr11lfUTe80KXlAxaLNGtT5S58r5onHAI9tqWsAmbklQZI7ZhhmOnLkUkMX9FbkzNbNxJJ+Xea0wJs29PMy7brLO9XflM1xol2ELLnStyAy3MM9tIjODci6No4sZtGeRC6Jl/Dcc0txxe2V89HSkH23IO9rUAsPFKCFcK1pWevq/0POd2Qv8WEfD2W9AZ1QTNHXUEEZ6nE9/80SfvtH3vYrf76rtSuHuQKrlBH0feRz6SG0t+7BZOGOGrVFXPnjjOX2l5OLgGV8YAdyvCzHXSlG3ssFy2PKRkuL/hmrDaxda5pzRWjWLnfFQCjppP8neKLpanpixo3r2F9hFatv6P/4GPoeUhOw25NKmmLTXclr2Zon2JCH7jLUMl/2wHl2+0fNBA6xgN/tFwK9Qs1oGjNWlQGVbnKLaZpV4I/31VFeJO1zlQJRFxTnspT3mRKFeAswfcylLXvqLib9wXVglQ2GpqRkp471b2fBdFMIuE+lbV09lYn1LZE9D/OY03eq6/+nzbVzl+7iLNn9NMiK/yZw4NW8wKXp00ETEvjzFY4/egj8rb+NB+QweSd7BY0HcHM8aQV2m5kxEPVFsOUKFKY8ARgnNQ7XYai/C7An4E+LHIrXwWKIUDxgPjkRrZVkdUcyKCHSZoCARA+SspQz36RpiwqkRS2XSwmgSSCtFG7xSdjF1gR1c8yIePOPxWKIFPBbQAUgu57AmzWFqz+dRavxigH8zxj3mwdLp/erqhmZFVEkFhGtwvRILhuRbHO50hRvsajd63CBaYQ6GGvl8SwTZ8HhSbNFWogDUpRpkUFY124l5YEZdTpZ0nBo6Tk0dp1THqaXj1C6Np2a0XBkecZhBbTccMaDBUxLQaOKxQA08IprV0xlptIJdPCIsmRCgLBELZVJUSdIH1OSmgtxpr+IM2kEeUOeEWWsEdd7KxXVmOGF7Eav7nDhfAqaNjkeM8ajb8VjcdDx86deQ4o11NywocnxYFqUcHpYlo9psh6VOS6o5azZDalBod7FIjGqX9WTXBmmFcC/ZXUK7Qz1vD+2ekOoTu0S3hrx7ttlitmXOeE7yR+/dH07cTl4NObxUnU6r9uezheUVhlc4W7urKGI0tS4aBdD1bEDdpsl+QbKHQaGFxa+zRU8wkdSUq6x6MKtXWfWyUgcj1NkoIErDzzB3ojqs/LwlSvI5uU6WAYYJrrNymGZx5H5gg9mJjfUh55zDiM8Zuyr9J2KyWb6hYzSklYpl3LMv19egoH+Ag5mlfPMUuv2yZrsf2ap5FlwRnx5PW+SXW2JLOVVmEENWWxfhQU814CNckcVBANxC4cZgVz8TT8BbKISsUw0k6RVZI7YLjeUjiKWphytdW7kMOKLapqi8oPcE6zJBt6MuzGDo0ZMCPcdNeLCRbPOZVtfQKpx05mrfR6zm7JBqeJRIpzUGiQrcdLO+6RnO3dJWUpuSNXCf6nceE4U6azRTdT3PhbcgkTduPchwPIRKxP/Rjn5XRwovM7Rdx2mZth6AdJ62HQCywDeMqLJvKWtEyS9ANYIz/HJ1+TLgt5dV38rgHaZJ5JrEYJf6V3EjcTvNizlf3A7cQXVgWkGLAB7RgoUhYAIwUUdu6apTPAAcFXVvyzM8E5a+9jOY+cnnxIKpICdSMs1Q4/RunhgzWRTZQymk7JQO5qcQcTNzsV41Qzv480L3C7J5p1mjR6zFGedDBjanmLSdlTRtg/Y7T+x0aePRZvBfp2ysmY/9FivHy9VLziMQqOvV5bYCQtokN3TbCl21Tq9OagrtQHGKokDCzcjARZ8yPIJ3rdk2RxtgW6XtkLNE1xQ+dIV/7iUMSoFHwSBNMQt+oLyJPTbXjFa9WGk4FRIKWRWZvv+H8z7+5Gce+quLsS/2ZdOUCcnTXRoA7ojAB68TFqlKFHi1xV0HmTIovKJjnZ8GhRb8sfQaT/HEFjE5zLsy4UH1IfHaJpxOvuK2c/WNcq/GENxYV9HWOrzBwhNdjx874RgdaAc4nWFsj4RiILkhuH7mEF05Q+l3y5Lgs+j0sZizGW7Mz4NCSUohDV2lsxXNz8IjV4qxRaYD06kYaHsObrVXBdOnuCAOLnAzphJD2/ui7r8dE6tD8PmzXc8cCjqTzrmNzuEk/5peEQyLJ9yW73af7pQJnzOKUN42RItx315QVfZOKAB1dZrfRhmd6fZYNMNK1j9Q7OhhQdk9xPmuZted3uxtNEucCHTtyH6sTU+gWeTLbMws3kEzUMROIPCVPTRMRSDQ9Yqe1ZucRUrEVLi48448S9XSlKyQeb0COtjTI0/WNZ2rt5qZykk6Fez8cDwNbAnoHWg4CedjKzS0R/x6Drd3FxovK4k6omD5DtK30FYsKzmtio00PIjz++s54M/N3W4I8Km6lL3D8BZnn+ffBG7iJsdO0FkTcQ3Q0IbZkIe0iAuwKKb8ZGEiZn4iJh2PYX7E8i0PhJ3gWit8wV8oT6/8q1xCXS9kSld3W6HuHJ9dRHhcXsSqAeNRBGDndd7lOyfyVcFrU3xVNSCw07Usx1t9PW/YdeN+OfBX4g02KMFjtUg5FqVnYjQMocr1XNA5SmVLOGMyYUHpezDloeRudqOYK8WhkCPkEDh08cdkZWFaY5WjHBU2wu/aIu6D0iJc8V1adHu4gdnt5Yswy4DAMifP09KGbHKOMP4Z8Z4labR3OGTGqgEfh8Jxq6l1Bgsos05BLqmNgwya47yDAkUuDgquFtdLBWgZdj8ZzeYdiFHsmUaTcDzCGUJY2YIWN8VGnKxy1SWVsnZlvEp5Yd7ow5iyUL4lHRlo0erVHimt4U4l3VDd66ktBsg1uWTgu2qg6VXWgMLyNk6W3tRLA4NvIT9ThF/uX5eUvHJUubBGnoq1dQkJ9Lx8D/n9GwMYMTwdd8j2WP4wdMMTqY6FpBJnrRxPuZXAxD1jr1kPHB653HJJsNJnvdZQBP2Br5LN/j08ePFkzfGJql14VNXusp6bqbKk6ToT8O4o0iLzOsGninnBRayzGAy6QOGqpcWCpmCBzimUIXOqsmzuu+a7//H1V33fFy4eruOUApKKGTyESVMjb7gEoNcVxHJZnwNQ7OjXVKxq+WvUiEa2kEtGZdaiuLeey0kfdrzZAVD7JhjrFku1DxQBCybUmItII/fni0hdII5f0pYsyzAfDkv7LngLyrd+mgc0n3dpSda5IO/oAOk3XI4qNgk31+VXRVMtZCx5xiXb4TiomN+lRewzZvCYUfcpAXU4xdQ1pwWhGFtveaKsNVUiBkVdqljWj+qlVIXqV/Ym657jAIC2jCfMAsmTCY88sZHPIAttKcem8l4r6D1dCQ4m1f2e3srryFXMjgx2MaM26mLqSJWk73KCjmjAkwCfQNp+JRNBzgvc44BFWUOUcCQmPYE3l3u9yoRxJLfep+risgVrBLpNTQUPRXLP/QI0dnR21IFF9THINIUeMTnFm97aZCSKKrtnxclli5M8qQG5ZXF6oyi5zHGMky2DVASIyggiuKBsXBPIDowCHO8KyJ9iEWaFj30HnEQIHA6olQdqUERLE1V3e32c5oA+MfoS64Tve4y2G36+yHv6KO+isciyUBX9xCIox3kVg+GoL/AKGCERs65o8zJ8NMND1AXP06UOhCNGaGI3A5HUFwrazlNQYLdZdFAKk7aYv12SpADFcRmoRcdf9x5dtFxFL76U7psOoghk9c/k7nNe/pXNCFpkJgo1tT/VGSHbCgAkHqWATeBx0zpxydD2rLQytO9/Xnrtg+/7z5+5eIibhorKLUXvxVF6tWjplSN60TpkyKA6tCwUp4tRxgt2o0tAC+uYGogjttGWlfGeU8o2b/fydXHatgRiWV0gXo4JBShiqgwFeELhqQtoqAEXPfAQ4CsNEhqip5GRowiRUgRMz7xj2GMLhnm8zfd34k1sRrUwexd1UmrY6MIATyqzOAYTg1kcV2Zxq1zUVRgH7TUsQ3ZRPhzq3e5lKNHPcbt13M3S3KtkSrByey8pWiwaIPzw8dFsPxz9YFWnJkAJB8oi1NLZBvq9CDELSCxkknmXeweJqZIjO4tkaxqo5NJiPLrgZFbLgNkioLTYjwyUZH1alVmttWZ6+rXZpA6PYo+IwF02MLAB9JYkT2Dz2MAgsHkCbbycWaGrsgx3VDIwryKBJUGjLO+ans8bvFAcoyXS0JaJhU0Jwxa7rhXRcGxpUwSMRxc1a+aQEQlvMEfKkL60t58b0RWodg3UaM6S9gUxNgbSV2OIMInbTfpyF17IvAzwkpmXw3ip2ZeAX/babHi53BaAlyvIFI2Xq83xnpqcUoDNp4Q9N+Yei9KaayrsVRzCrMCkp0AkB4vmvLyJRZBmEdevA/IAap7h0Hf/hriky7ey6LPYRtuG+XZqbRRENMxzxY45c+a8JEhZzIq5ufnqPG9XFjKwSpXdu45VTAsyXlt04kUYim3rg5zf+5miro8xmtGVe4bmD4jIkME9L76hY5WUxtN0jDDu+z7sGWccuaf3e6pNSFwQ4p5Kw4FH0/O5oKq9F5OqphT0ih3K8HRLFgdo4/gb2r5e7LxjCO8hhdL3NqH3SCvEwWKshvD5NcEWwqMdtJMNH42v+su4cFgqS8N+J2Z0TFu576966aUv+PApFz1tKCrsHijlEJ4Gi4FWmaPC9kBri+AdPOEXqAfJEqfWBYH4FBtybvX2dq1xZBdIxRzf1SaRIix//Zq1vxUzrwRmSB0TgL6qFEBPV6xYY4EycBGGUkdGV4JvDwqhPFxRguxNiUunxDWmxIUw3oWVSWOQGtn9/y99I6pOquJkNFVT8u4o4CP3itPH6tGKnMfqIyE/+1s5nw5hdJC87Dd1I6nvckT+W4jJozIu2Pdk+fcXF2d3I4mPhSB9sBv2Y1CipLjilFLAs8EUVKC3UdQr2tJ15lUFbtlvoyx8OShtf3Of2WvOn8CzJrKwYGPD7v7O2Svn+br5/R39FPbWtInmY2zoI+H6gHbTOpVKkzDx4Q/nSWIYpP+h1nPVgvJHDr/qECcSxAPbX3ye/zwu4D5AiUIQx+x37aa7peA53b8KIBX106usOD2yBtt3+S8oqjFct2tuYm9X7c8+esg6bwL3wDmSUrOvol6QiMYv/6wyQ34TNAf+AePY/yvcdO6zzgGA1j/auqzweqpUoKfs+Kp/Mz4oYzNpAdhOzrqBmvTw3X6Q8UKBslVVWdP6n3l9tYhwjatiALoSBELlF6ErAgCUxP7dr3JFJJqiGg8YVqvx8I/1sClWccOXO1N1dQOQOoVqpSagMPuYjoYa7k+g8guNAMhf8qa5vyZmr+FbFDO3LTMXelhQ4ArNPRj9vEk6ICJLoyYsC2WvRZWcwu89SeGpBhUvNQWFa4MtrJfqWAEbObvwdvkV+WHWsW4NmHHG/ezhhhoHqA4Ivw2F2GZy5XoBUpwS6mmPNgyiO4i9CtYFSpVjb/W3/2CR/ADBzI22OKO2a3GeGN1NHWScWSY9KQzWYwiF9Le/9MXWQHimJgZm1NXGLDU38rnyyA5np3aNxHqqi4x95vNysY1PjKm9JpZUF6ZloiYgDcUstvDJD/iM6OX8KhFM6BO5Bm9dYqLRGIBL9Sxxpym7QPYHvLKCD9onR4oyVkLzwpIu8EIyz7kXBc6U0Fx2C/x4oX9oAKyPdqFn9nC7xmQ+jOK6faJ8zsHfIzVpNNNWe6Zjn5zEpkq54SqwNC0FUI0QgdqInqV5FJKg0dZzyAx4lhlqaEbdU06MPAS0kkGNJoSCzgdKO8d9lhUOPsm0MZ8zdsLwYFxXl6VdfsASBz/EhXVdzkAxKxJY24wo2YAeJgUH1jaGxp7i5UyQ59aLuYpV7IrlxTL+8F5yQb4t4RcJyrukR/zk61w9fhec/j29rg76iFbFk61qksn6+5rVGau7OlAlfzUEdcy6GlTrFYhTH6Ne9gdKyUVfEj/dAUWl7HigS84+0bvd+BzO29BnmELaGHNv/l89b9KoEG5NqcwslJOq/qG/ZojjTS9DqeU2sXWS/aHVF4Puwx+NWxN9Txh6opMdTrm34FFgLgJ9hFfPKPu49ClWnaku1h9wYKHQYtSIUNd6H3+Iu6O3BNSTVvYJWUDUU2R8aZH0IGYgiBrEla9Wp0vwz0l1n9QPlLnRr3piLUTtSbbxRZx9Crmsk5QYj1DtX8cbVXE3aNi+3dEP33fO184888oqP1/mGjHomQcjZtoDakCz2mUGu7YO9Wy+CuT4b0oryox3FC3XAmquq3fBonlbdisCuJXOnxu25e8vxj0w1wIYgoQidlrGfL9rM/dlXY2Xtqh5ZKjlDV3bUrYaH6iCSSx2LUqx9ZA8oA7VFW6yng+MbRsMJq563CMQ9RSi7j6FYpH+XdZbg5fX0hDJ0bC8VyF69p721dzXDIEHh/43o6g5lOBCERoi+m9N9IC8I8OKL4GDwjNCVmW8etwVmheCOM6+ZBDJ2RfsnQ6GKj6AlWKIpNAetEK6HcLGWKS1F8YiGjQuvSunuDGItBjoRV6ah1a5LUSSlJbD9SjXl/v9ZLQO8ZxoyhZ38nqhnwP+aB2wxxSgDrSEy5FDOZQkLRVgfW/bM99wVm1Xjg8Z5m5YxCRUeqsXBtc5+rSqO0cEW9b9NEoosUis3+BqEPmyJ1R/ZTrbahTzftve2iatGddv+l+FIalrNvIwFQd3fe/FG7pRDHFI7OO+8QZUNy0Z28cGUNN3zjYbvFVpmMMjn+lN4+XeKyquSf0SfbgQcIMwjA9Ol9SmCWNh9sfATJVGkZK5c/kB2TD09kDwdq9lf4JMuvaEeIgVBLiZxFK2S9WyPFXLqjHPBn9+iapHNA5kfyq43zTX+Ue1VlMXbLlgG7SmwYDA6Yrs8fkRQhhRh23MWfTjENzwow5RytZDEuOPfV++oDZlF/UcfKlS8tT60soeTq3gQ4hkrOipiSK588tbNMjMQKVRqdXbzJcr3djigivWM3APH67Khz374QqtsMpfCj2FwR35Mm5C6jawgXT+WMANC0gHco9wXy4H0zhSPdeGArigreRt8Ce1jXybwHl1RLqyDHi6urm9tBVfbecHC3OI5rmKhRyanZGykHpovUVn88qQK6mZ2xHbhoN375Eb/TNrUjdt4TKOaBx4a89aB4ggYoyMm9StA+ji0fZBDmvJNMhbcKGB0wWz59db3tZsegxt3Z5156dju2iXjq/mW0oEiagOOWFX8WRmMqc6l5CSetMs2Be5iHtQ4y5VTFkkOD0sZkV2AhVVuZ425csdeY5TdHF8t5P/TgHDTcK4sTgu98w4cA9X0VGOmVLIKflOFCF6GbUiUKMJCsqHG3wb/3Pew/d5XHRAMwDqTgo0vZK405rWnVcmcgd89uWnyXRboC6D9blTe36aeCs8jWqbVHoanUq1ido4TptiKg20Up+bdsrDn/WKXfzVaQgU/MMS3Ss4aRcV/Cm/XK75+KXYiXwInKL59tokvOzWK8RTGr1TKBJ54p9PvuVvPu9Rzj95biwRyFLgzJ725KU6wnZw9+SZjvEsxNq0E44foehGCzqKYe5hdDjhFP471Y5oKCM6pXWncj7kD9F6gG/TET3VjugpU0b0lNER5apP478dMqLhcUaURx3+Jzcd0R0Y7YnaTttkROG2UkaUv9qBwOnVET3djSjyYSCRD4FT3YgiyY0o4AhMR9MHH67+FaeOjOtplKOMz/OMeerP77ms+lfsQLO5gFd+e/Wv2IV6HvQY6DsF/2wJhPxkUvEL+I7hSUGYuwsY8gpcCiNYV/yxtjJ8yuFlgp8FPzPydcluXVPUXnwGE58z1HCMvLxXeTY6473QVcEB1TKrdW0xl8aNe445OIWYs1tErJq5h0eWl05lmtB0CmmR25sNZJOBc0OStcpn9B2TNvkVh8+oNuk3S8XBB3ln1B7KWrAx2Pdf6h+6/o0xuzyilru0hevMG+tYoZygbziktFSwIG8k+SiSB4NyazkYHCncMkgaVP49/SvfC6dcHNY7QgPoghnRa8Wdscw42zfv7FoEJgSWOrBYhSxT4AxWr2I0XVIB1kdQAQSsHRicOILMMifAfGZDfVUbIJEKa9Sgk1qKTNg3LClHFOI4wli0CvUTX0VQLOkiudUt2RAXKm8YOn/56s7Yw3eZ+LbPxHDlH6N55AuDKdnBLRqb02JchftbvR2cvibifagqs1W2FH5p09dZ9C2CqhuIdXCad+DWeuDsjeRhif7eGqAp2w7AWaS2eBsecQ68IiR8xiaUpeuWQMmM3Y345LvdiL7obkRfdDciL2434ss2IlafKbZhslMQT6+xNg93ZvFIcHXBVe2mfazFUB27Ec8qQHrSKrMb8WU3wpuFkTqUmTdlywGxyDWJA+FYHb7sRvRujQJRdiO+tFRgiN2IfmN3IzF2I0isnMJj/7//zABAZUgrXTlShA7kLsgkxoyWrxXZhsqNKVdmdZBcmQouClFKOjpW+unhVwOrw/Llqp7ZfGNc3A5KNpB3DIfppzye8qN2uqimh+h+9nd6LtlfMObJQ43BpTWFlUQaX9GoIsAjQlr/ulJnJNJSUSWm9houjHhrzk25dRrtVTLwH5jVQHUunJuY0EriiOP1DJaHXCVxIv4peKECNE7gUPwXXjdpvuj4X7xtyhcv11uA9j6i7jh9t4d66t5OWk5kbe++v/380Qt2/M6Fe/f92sYb4weW9tjA+XvtHiN8Vg/nTM/qDcQvQ1j6ZSin/AV7B+l/8rGvnLCOaz2PKtbqoKKM7O1KIWH7yFfj2L8rZnWCijVZHMkM0nd6QSCHVpudswU67rk/oReFYFw5W6vbc7P62LmZnq1NzaOHy3mkPhpw3mnsklCgm/Xsf2HPOnbS9p/5bivwEvPXV1C2tbsVb4RyAcvHV9g6H/qcmV3Z39woBTptugR4dNAUveZ500wvizkTfkDd1JpchkRJtulCElVKiJBKCfuoNYR4kDmFz8jGG+VQxWJEPaiLIjPVqsK8wLd9EsJ5IrFeUBXrRSNivQiSlhGxXog1BaNypHAq6VQfEeslri0UW7FebMV6dSiyjIr1Rpcsqlf9FX2/S4dgL1yHFCWheIpYr85ivQi4Esl+W/Dn+coaqGEf3NarFpU3+p5oa3uFNwnArwPgIAdiouwAl4wALq3AoW4BV7eAS3AX4biAS4ZStgNcgwKAK6X6FHAlDlwAE0HQ1YTyUpMstHzcleEELzU2vIsmjnTGgAhVRibCsIPZ/PcKRrGpAEAWfg+knd85AIDZa5rAQeEFTkQhfvZxpBBvD3B+sTnfmAdVVtBz4mbLFlaZQngVGzyeTB9YsWga0xcaRkedjKjDp2lMX6jFUKRMn17oncb0BeNMn1jtNWVfWYRg+lALB4KpTJ+yn3kwhekLJpm+MK8yWNaxyCSXFYxwWcGJMOPOxxEzbgy8YNJOqzWtm913aMruym1N3fYtctu3aHL75tIlFRPhEVUBpq+juh+fRXaFM/c7+5y+gteIjL1SZZnUaj7cDa7JDYD9+N0tVh8l4iz87Fnb37/2mjVDoiItpya36rGvA99IkTQIcZHu6yK0TyBem7Kv87nV96r/LKFikh2UgZtX3deNmIn9hOeHx1FRcsJxLGhGPSaPJjWX4qrUu+6CyXE1l8THXWK4q+NrN4lLnTo0l8BcWcn2kGJ1vjbGXj2H8dg4KzOuy9Qpiir+3PG6Uf9kkNBKou88uVR9lLXkM2jYQKkLOxA9CCIf8LkJ8CkBVbD9pAYbdFWbsT7aqX6sKATe+ELSoIGiN7OmHajJtzUlH+iuloEqH0E5nTT732O+WP5M37fWrDYQY/G9iKsqzqxqXz8J7GB68uVPoHPgzDnWAEKPJtMv+WzkWlBATxcC/IR8XAMEkZ1V4EQqgsIUrEm0rvn8OiuqJvynMwlXCSv8UgQOgEO6K8uDSl0yE+pSVyhFy1lD3dQVIl+EupS/CDEpp9dFAQgvmI6YAq3SMB2BfhuB6QiE6cDkVjZjpC0hfmJpSx1VK2rE2ha9WB6uSXSKdlAdZH5aa3gVKAQsxAHUOrlyL3vgtXUNqZwQp4c8sZVjz4hCI2lSC94qViJfBiX7S3wlIyJ5RRx0v2KBfozMeuAfyqv4AoK9Z35AHCXTopPKS1HKjHSWpeKnqf/pmjrEYHT4yD8w6qE4qLehJJ7otil/bVUDKHQGudO9Zu5iLmZ/JX30SIrgR0WypXt/PELj4kOalqSvwN7KGd4xRr+1tWrsZn/FR5y/n5ORVWhH3+ukul9U68HPopru4mQ5Q8Q1GBfcL8e2y+xNC/0YWJO+QEaCPDFYjodUjLDKGwp1by5d1hZwPMIBorge1JsITQen6Ek2gcxoL9NvBaQzC2jyKz6btCYUICH1uGNdvgQS1TfULUy/nMYxq8qp7bhy+R94IwLV7McPldW0eEr6JI1f1QPmQrRyZBgOsJqOQ0T+Un20i2nifiYG38G8WLCKl4o6n2QjJgMgjaIuLComsKiY+xCWG3ucOxWNVilUZaVwuqN6XmNDwvMi/ezZFOBxuZEEWccg0IJUF+qqSqwqecYfo7Q8N+C6XC5OcwnQQNIzdHUfgksaPh6rudBuD3lC5DFFPgC4SYbCh3bdef4umVdOSTVvIkKqQiOvpQBdfMmECD11urFqI1L9zkkbilhZB5jhSAIFPvn2wLkuiiLox8tydBVUCfSTveB8DwWYW8/jB3fvO/GGHgQ4j7dgoaTvZ19Upz6YBYWv912lQPy8RC4FJ2AszmKAynJ+P77LHsSiUrTVh2NbKnXCbl9ntVI3W7IaZtSKTTPa2ZdQOcw2jFYpJkwPZP+spjNloJXYLcgqgHtcEe7quivJQ0rZfqk7iYAOpwNr3oHh4dTyjzosQquendfUqvRhjwI3Mr6MDEb7RUUdBlIvCG7hDFwx/xz21rK/V9EPccIhT0s46GmaqtdnX9YcZ3LJeYsCDnERrgY0wVZSJ//A/oI1obOhXj4tmkMoLwe4kXwbB3cbNZs9cDOt9ATthW31XRCySWg3FEkDBe15/i2SrraEb/bE5GgXTUtsD/4B7ZtoT+FvrOfNSeNfaOPVPXEayBlmVb2lun1uKupSc/2Ig7veNp/JW9a7Ba5hZAbLORUTa5Zaw3fvQX8i07J/VMjJ8Bi/qc/W6bBwqWqB6rSLdYbMCQmGyTRdprvAQW2gYqRYuVe3iJg2enfLHVPVeAx0wVxTvXQfA64DIXhRl3Y5S64ttH9qmi/NlUYUNXNSB+yP7Z2fQLSCZfT0u38yfU0qcQ+auLZOWBAb9VZqBtdFv0mjmaaX8vR0EROvXJxr2Z8gPt02LRbLudrV243t4aQIFzskKJtmf3tozFvqm8GXTPEcTx4GQp212csUumbsKbBI6Yp3EQXukFKTz6ok764mS5mra9abqIICkbItReMUCr5rHJdT6dv7wc5OHCY6Jy6QPuWhcSnQAnYod2iI7Nk15XTR/WvXsNfXDwMK8R5a03VILeq5yGrcd+ojMxT9tb6vPlj1YEJ3GhA2415lpG4C7fPSnnFj54+6sfPannNjZ0tJlSK0dJVSauAn4lMc10Ixr7KDr5OdOrZKDDr1a9fyU9uHGrDU+mQZNR78iXDE+V1kwadbAG47AuruIFZmrA4S/m0moQ6nGAlHFI1nI0pWtkRdpsDzlvUtlDfVD5fxKtSk2LoCTsGOIUbv9sqnutuPgWcNNMLHaR6FUIRP1/abzXdM6f7CGMiO1YtRbIsfK5sfmlMLTrlgy1XFsObuWV96icAPXcA7IFivVKydwKiiak57rnYykMZonVadEVUjy6WVzhh7Nbi7jTqbWmdoPEB4UnGMSPTF6OemumAy7lmXlIKCaEAMjGuiNKqXjijj0hGlR/ptxUNpXYfR9Eck2LHz6qF8sW0/bjKn3HiUL9txgCK7QRDNo7rxJ6le1ixBcY4k74gCMWIxOTN1x5Ed14egj57r8bgYO1b+T7EJBEvtXwXOdY26ufV1qgb6oc/3HC6shXgl312aaIBCBs77KnhCnV0xNcRhsOlukH0FfdGByGRLIr6IfbVFzYCDKmf2z04a1eKU1gGGbCENiLUf/FUXHoyb6mc4FNvW7AGk9BXjY1QaSMUVvxm9r8DLufY3Ji2gI5X2f+ETP/8JdmyDbjVMSgvb4Aaajwb1fx45qNXnxxmMBh2lq/+CZiqnwtWN1CNEBeAAv6dtToBdL3ihqDA0rKuSBo5PSp+TYkKDBJptKbOIEUZnxOhwYLxRtihRiDcEynhL9AFfEg8ZLGoTvtZdN+CnYJoKRp1RONMVHQz10549rHhnJVyqtQ7oQQT4VSRW6Z44/XQWt6/Lfd37iMD11iIsE74PCwM7u3nG1+y/2g02/E9fq313ySM9eJ0qZeAoUFnpim958V/3/pMpg1ubixfiyH1e4cM4PZJ6UMFogdZe2Ndq/792bfRzCsvvcCYtEIgslxZy1A+bqDdrlC/yU7VTAxtm6Wt8z7/Wwse/dTp0pjekZt8f+pocGGuJHQWU+lUaaWqwOZg2LwylHA8aI2OB9V0PFPApyjD9DwxITMcNoAIDFcDh3fXEGrJk6Sv/lZrW99acKFyMNT7PmXA7eJTfLxd9f/JwhcVdxPPJt68UmvOP3Qjz7Rb87B5cYN+7+NnD73vsdT3wiGKrTYtA+iV5hMdeazv3klFDcnunbbxRpRWiWy9GYJziiuJPo68WPVIQLbnGk8JbJetBtNXPFopG/7RplT5qC8tuomNqcp7yGelW3sFjV55VC/DHC3BFSm75UmEhZUm5BlYZdY5cgJ7DlDqH9hqXj0Le1AODUi+90pJSqDVozW1m7HoGPYjEtRZWCF52cTeGWupPkpq6Ks1W9BGoycQ/n3MxuETX4uKkzG+VAmaJv05A6mdhoq8FsFGka8cc5CqoQKwZdoCGkIZQZ1h0RExMHbEtZdUHFDYCNQObWG4j6td5pkCOLTZlDAqiGS7OQnzGIhbgtYtaWHJaxgqO4oEO81rp1iYQ9Xql9gsIt4RsltlahRXltsD5Ioo52W9Re2GgPqj33fliSvM4T+EiQmoJkxKoT3tRuKW6/C5CmzxFa1JFTjcUpkY7Fs9C49xYmQWC56TdMdz4OLu1Zq3OPaooUnVq/bUTOLXe3C76a09kF/1szxv9tKafmkMlD7lrNve/mhfvG193/A7/SHDynvvBWk147kdc6Dz38/zq86Dj0LR1Nb+tncCP/yeZFfKMH3/wSM6P/yeQQqHySs6P/6tf5/z4b1bnI/Lq33/JC7mAtcfft/9rXjfNtz/qUmQac+9/CHGP0nn34deNO+/uHnDOu/Ey5rx77zTn3QV/djVj9Nqj8OB9emU7LxPG+l/87zyq/af/QN/LflQ6nd7se42Tc+VeYL/uXLmHFVfuzpG7N+7IHSKah3R/JXaPIce4A1VAYRLnmLElDeQqi7iy/aZc4aZD3XhGFBpuGkekKgLh8lFOVQdYGGcMMzLII5QH0rKPvdb5bA8mfLb/HlJr6etjdpjovdJdqK/s8nWq91+5NuPDCXZ53VO2Vlo/mtHyhclSIYrO3BExCNUM0rtTbluGnoNoGdU4m6nG+89n0OvOx4vcHTLsrcwnljPgaa+ryh4BmYxTHJW+qYNmadV51VJseyFaNwtVjLIaYy1vlF+pZ3aNUOqeUuwqQftRgqsFEkKmMKkRjXsEn1P8Y9uqTYRI/FJjDD6AL+Ym8MABFL2jppq6L1JImpIJ8RR/gl6gOdJdFr4GKQztqzerWPxt4tOWmJtLeP8+Uoa2vrXGWSDyj0B2WMQP2yARtdVKgezoZEdvJEqtEoR1wKXJaIx2qwhkoompws8DZBLpD0NCwGqlaj7FaHBsbnYrdBo5ABWMlIWecUNr1YaSNjQxNCCG2o5tKHoECXiLUkqy6xFHkdyiQMLuUkKRHoNkcxOfwp3NXApbR7my59QP9QLkmDPhcMyZcOQcFfOnWnCAMfLla3UhLNTBN2QBEZYs6CR33oNf9bqp3oOPgOZZ/7QBZEKh0EeExI+8808bm3kQESaWWoSuO3ewMQy3J6pVxS+eaWcDBApvTYPVTZ0gdQWIShX1YyFqBIInPmhD64MWks79QFDUqZoVpsNAVeeDNh2ptD6l0sRUulZxfItK9xfSKSDMmJ/ZYC39OTBEenU1MFsdjFpYGqz3Dcx1CQjt6Huaiswgz3gTnslQdX+/apOgGLDxfmVhj4A61YVdbmcrQY2MGQEp0tbkC82BXKJ+cisY/A+HbgXzKiuYV1nDgvE1DCj4gJERhiocep0s8dB/whLmHI0Lw4dWRqjXVR5zwdr3QPseGwGqrnEilVbxj4YSnMHqt1BdUzhEWABaqAT55BHKA2nZ61/nFrb6xML2hsfAz7xxgp9pVfmZ1gQ/s7vkZ8Lsh/HxifiX7552eFJheVW3HWs97MOVBx0/grIpsGJ6rd/xcaN80aPu/k0T3Q9f4rqPl7HuP3UaO8cH/PsfBSdXCBgUX3lBzK5/lURLI1QjQrMo717NIsOkWY4P3+Sk4auI5+D7CHdZ2lAVyI42tGsb+s7YTWYq2S74IOG5KYdKl8tlo/4VWDDFPXlDbxbY/0pP482ZOI7FUg2WRI9Xd501HvdRJ456SNeZVdMLY6oB1pVQyKEFWLZao0iX+DcxPLiHEZKt029LtRQB9GQAFEv9fWsIca1IUSpbk3rJz35MdyRhGc9dLhNvRmIrGE1jVrTM8OPIoExms7+sp0uWrdA98k+4IvD6k+6DuI8RNQwGHpLhFm2Pn5K6gWGMVbYRNVwP1CKRSpdN15YFgGKTkmo0ITqT4xwX3YRagHsdhWFQwjAwMAwsDDWEOOU1a5UmpKbXRVPVSMtRrpWjXOP2YYynDa6O++QYt9UCXx6DGBj43YoE4deATxp3G+Jgrm9/LtqweskmEqZMIRxzrjcjl54KACiMvjZSeIjcg+2AAIDnJ87HMEz6LVhI3arJt7lQJ22Ckxp8P6/VfU834NwGexSkoYjHTRkYMdrWSWVNPrsmeTSEPCg4QC41I6X21nx9XgqmPkh/O/TrrD5lLeZV5bdWG0iV8cQQnHIdMVRtQoE8VrRnI4x4Psy4BGH4pZNjtIYe9DTNOeqfVcS1H6m5UQmpoaU3tWBf64206FhL9bhUuN7YrBw5OQTu5cIolqu3TymeWh4qQetd50z7K03ve8evpGYqqVUkQp5WAlQ+6c5sDhLgi6tloitoIGo6TkNOvhXH723teCBN1ZCfQZdG+oDv+w6V4LUwGtGKDx2RCGTS7kFIJu25CEElIhLEwbp8loQV23YhzOpzoiR/sXiPws9O105tXV7H5HJyOqrjiQmglcVak681eVwiHqgw0Ap1a4MKN6vH03pG4VHWE2g9odbjaT01rQfTRWvBZDleHTWtY2xg6wrzyHleTP88UIi7w5e4CnHQWF1zjJtBDDtCqH4fxWineCMwE/wiCYcyqfcgzN0Q+vb7tTVcEJbfc11DFdRyIyi0DcVcwhN7HK2urnUFWpcP0MR2lFGljnKEKjevydeaRoe3rCnUmiKtydeaPK1Jh1dr0uE9fk2e1jQ6wGVNgQGh1uRpTTWtSQcY9WCAj19LTWsZG+JEhziuyOw/XtkI7Z7U61G101DDGMdcppQucnXiKtTckz3vT/SgW0ILWEsllAAdEZJ270RI7ZsGnEkUsqg66tQo1/g6tj9Wrz8RU4O2P6Bvst1OWr6ojmsdsVQAQJLUiLV9FSFZ27sSulrW8ZCfOcxtPWFNWoDWlItGKlWK1cmUEjXPpdCrI7JODYZuQ4FjFX6cnb1f9b3oZKFaQzMiBW6swK0boIZGiaIEaq0Eaq0Eaq0Eau24QA1LoEYqKeJ0aUgF4WMtsu5gWFa1WlbV1aoWtOW1zQGIKAc44ZRwcMqfhJsB7qcDPzIUR0EXjoGuwqtHfV+Vvl6JO+aiHyQMIMXZ7WiDdQZwndbi5bEKpBToItFAhzAX8bGuW4SHwhYhhW3pgFH0KXQdR0vk8pOepzpIxzL1GpimFrLgPs0zgDFHbV+qnF1MvnWPoz3SHYqPFpXcLqkcUwvIfgqfF3VR/tIDbcsd1EeoSnh6QOfb0C7llOvCTWKQFYzZW7QtvlSKJnxbXheDUjD4pDInSMNCJ97z03dG0/CbgrK9CAeGBnclHL4YNHhB0Srjh26ugG66udqJkExN7ayiFaa8w2RrWzYWohAXcAYIoTEOKwMydY1WgzFFbw1m969FVTqJ46l1PFP6jJLVEGNNp+P00usyNbXkBdMJhTCq3bR4kexClFQt+eTAU3iblTxZcN2MRoZIs1equ/0m9J27iJNQxnGPd0cf5+6h8UZ5GZiM7EpC3SqXkudoToWyUD29fgRpq/uQEmlDXeFCxlZd4TAJwRth8ekK7QvNyrYgoYxDmTK+Qi9K3KrzWyjkBF1RJYJqV6RQ9bGMD7gXUpUvYOlK6CWmFh/99CfrOU4Fz9RTEPGsCl3Gx7VkgN/Xkos6v8uCaq6uACgW6ZBDkU5DNUOKFOk0ZJAupM3AWySPqHmKc49rb9F4IJ3pZlouIng4tIMsW/tnsQ8oCs1IRznTL4dBwMubMzxac4ZHPbA6kyKpmTiKVCBVzpqknDWhnTWRcgpwgIyHbn8kpNufoL9TeYLdZc90cdFTyKgijI7xbIWbCJ6C4wie/BMJnryRDEVUFit5i3qFzdQjWhyTqFaU0jPtZV26l0goNFCItOdR2fMISdhfTOu7lFLO+kaVyTT7JVqr8pn9K/QwMFJW09cqEoEsBbZqYPBZEloQ2oZQBtpWsprYkKEdaNMYq8mxehvZUS9VqOonss7LUDxLtRbBd+YNqmOFFk4K5Ea5KaBRKpr/7jLDL4VeMkn4wE8ov+ErBwU7qXgN5L4n31uD/q/1BOJ/uwhS0BDIrtU9tbL2yhjpSEiW2GYhk0Unm+X+YzAt4FHDykzr4ejTlR9r+XFZflwpP9AsU7g0LPaTZevZySiRbyiRb+rAa5Fl7WllOtQvYfJZF70WgETt4cDqjILkJPrrmpxYuqYMNUKWoY4t/SH8LJRQidNKFYFWEZRVBGUVDS2wqUQvREV12FrK61MLViYndcQqrZKpP/McwlBJoRRP/BfC4pXeC3SIAhoiTQTGY1lzmCMoVtc793aWdMtZsqDzKJOIXXJCgtBOneAyEbG3DAVrgv72ki0ITU+KJjxFQWmaAwnmUlKOXiI3xPWQNHDWFZL0rf40VkCHFs3VITOzwoK+VoI+QcgiZMnKhCUrEzpWZgIbAfpJniNWdKyruj0FhetEBKFgSGrkVRt0AlyIFRfqFVxIcm8qHqjTsuloIJeVy4MkyHitpgvV1CqA7xRzPHeMr8IhgAkXr4PKxWu13aHXfe3ZfO4HSFepsd5vRWewXmfrqrCnHyOHlu7LK1eIM2G5d1C9eI0XXB8bvXh9Ma4Df8FevOaroPYWV4AMoVhYkDZlP63n/5Xj/4lr12993SO+dv1/3sXnO0If9q4nFRzdKPf9l/J46lWYa6TH/CoWN7M/xBXR7I/wCwUULMFysnuPxCDn7pEYSC0vGonxdOyet8nR6yXi800/UKeKKvWrxtTlBbpEeuche7vzBxoWidFLQFV1VYaIFClDPPQ7cB6gq1ULgQN3N7NIxV0qpXfg6VHD5NNUicP05gR+oAKzwcAjtJ4EMarWNYfiQkNUCOp6Ltf/eG1N4HM3P0vbkO7qZQNXLze4Kfa2pRwx28uUlKq+vbbTRqtVVFuZ9xJrhrYuqFa6b4rLC4MaUzVRo3ck7512R3IiFjNPz3Nn9IQ8+zk9ifuE5/nT7kxqr0WBA7m1dg8wGI/V0bxIdYNqKpz13cVHTd5dST53MnlnJXlXNVmq7E5rR8tFfkUjq9deUJjr86+ekc6JlSdw/uHLA/5rXRe83Ha8CIQ1PMgX4PdeUy62qt7SN04hLC4XifG+g9QmolpI5H70a2fX7n/7DYdqooTWF0dU98r71PkTHtM0GP+Rz9SoQN5SFG3r/et+8mIY+sZ931qAFV2+4jmmNho5ogVGrGuMEsRsPh4tRtYio9aL81mSBs/BAIx8C88uote+kS9qHXkMG/5969etjXScZ8y+GPfnIjHp9yGY9EPCRSQRQ1qEX1H+MCJ0WPwU1sS/6JI6U1xg2qTeVecpE7M88+Csw4Ne3qU5dGgLP7jDK7QA6WGPC1gNjNId7kVHeHSL2rdOtf68Nd9GW2HUPScRu4HCdLCMJ0KJ4cN1lR/gjXKKVE0sj5D6nXmBxyX5jinFEhdJXDTlWwUYK+KVhwpVllii/ADNXQ2wzK4ZTzuwhk76BhZX406Rbiyp4uV22skectBWOgWBrWgwaSTRNo3clhrNTK50C/pRsSgfwHQ9O+UpdtJ2zkvEYViZ5gTEfBExDyCGNCu/FDZBs2aSVT/WrDUK4GuOI/hJPZ5MDyHYY6hd9wNFzO8P4n2BEPwyB0UcU1PHsPCtq8qf4voxoi7FYsp6J/eqdcPdv/3C3f/tvovtkwFiIb3nW+wTbTyljP51+5SmI3ov7vN/0D5RBDdVUq5Y+d53HXu/fbqUH7g6OOf1W9bfa5+aUpD+4zcu+EucU//DF9d+4vf/84V//Nmn2ac09PO3n/n6z332P3/APgEuxL/iq+/47r/Y+ltPt08b/4nv/dCWgXfGB+3Txv/Mg9ns7Oz1F9unjb/0u/DvNz5onxqvLUX/dOn6oH0ibcLblPSYxrvz8T2HPvBX/3zn++1TPv3IO971/rf8bf50+7TNePt33H7wua980wfs08YfXvxd7sY/P90+bfz/9x8+tHTgQ//xg/Zp458t3fjpi+3TdWc7TJ97ZmJ55bx9+NunGbp/+JNese3h7yhOnZLIpvmBylyab6Lsk7N/O+Hbh78DlULyBFzkKUwojOg0IvmUtj78ex6N5zbaGbFRXu5nQkVXsTKvWke6HeToUNb3OSM/YizUjpjGKokDP7wLj6w4Xaz0YB7nZ2CiJ9DOPVPXi7Pw4aflw7OV9qL0HgV4tPmrGXzJvTg7P4NizrMLa8s5RgdctYTOAl19ArYkM2x4K99NZ9MMPeEAduNMYzt45UlZzHPcWp7xa9w/GHCwxdP3iVzwk+iM/Ml0Jlynm5WiDQfUy/xTqPcwEIce4sBMljF6VKLWgI1LU3Ej0MkLyvId1GJ6/iQm5k8GFe+/Ms+pEGcREW3Jl2gln6VVqQ0yN3WjtpNmy/AptFSGiaIyzISFZhFidKrJcytwaxtF8nIqLcnzNESea/2Q6XksOzFA7FOoS4TAeWUyzbMN+jLPF417BgRAirlQrFMZF8rzi6k2EoBSXQ5Moie+kPK78tlhj1uICaB1zXHtKIcrQDRKkGjXhKfQeahAvyb5mLbRuYjbJnEDblG1RE6VTF06dWqJcCyhncLXu7lP0g1CHEncXVzdSIlEyMQfdl2JzrOJHBou4bFEs3jM2nmTQ8CQ65ygQniJgnbIcwdtkecWWpHnCq3Kc9X6GZgx84vmZX7hkVELjxY9CY8n0ZNp9xrj6nKfH8v0RHz3RHrCt6po3Qhpz+m/gq90eDU/LWeG/+91ZnxzZnxzZgQpJkLwovx8PC7FMgEs5xLO4FCCmzd5C2FMhQ7KOptrOv8AiuMZIaEnMvru4QnxBJ4Qux/9hKDxCfGEPOfJUPBE2METYgs9kfu+20yKOcrzeMrEmAcbvsnEiCoTY16Zb8aWyEyK2cqksAM6b9CASPHZxOsUs8gNzBaE/vlnP+/+H3r35y+2z2I7uMit/L2yKSJjsM/iXE4U7NKSgYeCrhrbnZwfRIKOhFLLKUZ2riC2bB4YGZ0riHZ4qL3Z6pCaCtKaT5ESdZqMIjW88NAkUiviHhe35/GYh8coTCjF7VxwN3+UOP4E7NmeQC3KgJVPxtuTGccz4OUT8fZE2o233YzqBFTfg8/30PmyCADVIY99EvgiIHeeVTB7RTD7SQe4Vsa+FuPzAuPzMuPzlmCvQUvawkib5CTPmjjZ30EL3McV7B+5W8t5AfRE5xk4cwyZnMFS5EtgNStoGVfpNcUGBSNFQYdljvpWBpBKUqpDZ0lvdcw4GqnYNp7smGGUZs0ozQP6MnR4zk2OGsC6w47KAiC/QCuUycjhjflhvC3zuGYY1hY+YHKkH5xJZ9E5Lyr4B1vuV66pz90z6RyaOZDPYN/IkI9pF9hsdqaEj+iMkol+Vm5kFwVc36m3XoRCDrUQEvMsT+Jn9BK47uXxZSxpYrXvIQzRAw4wWwdMgcVyvlB17gtfUj2M9hm0g3vLSXBQNsfJBc3LDlbFBiiRCRl2tHZYqSY8QpFzxF4eW0Tgg5q8k450LudHiJExx3OrrlI1sxbn8pSF9FzdkV9NAYZdN0pKjvCRepkKqGuXaCy/oCeahDNY0BTZwu+2RdgdPud2m/uuwSLM9k2XZ1AJcXIVYG3Uj0nGa06FSDjBFnCENcdACKa5KFpSJCTsoQ7q/VGLaOrdnnpWwSrFMCxjGNoiWevwUGScr5XnvCQUPN928PKwRUUN4mOXVrh+XvWmGPOr9R5e4A7uQJZVgTCJZIdiWYt0fV9Fi3VpEOkPxWI5YpE/tYSX5TLUJq6US7QlbZNvZSxPpcXbOPdpJjegb/ePEc2BAHcJVWEi2608fIEpv4LPFNTVz3KzCm02Mi5ngZzngkCUkfM0K5OZH5jLeORU4DFCf6/DRLVmrtRkcU3n60pfZvYCHkyLmUjkMT98+AyP5UKjOYAaJkmbBafRdf7LPRGYBvY44oHu/hFJaYFzLSO5J59lSHJSFquZ1LxuTPyqm0k1SqL3bRsqVW1CSKm3i0UAqDYEashMCWgCjIKq7QNIPGvKbVuEkrpb1ICw/QBTCYhPU8z8kHwIJ2fwADPlb4iDw1lKZfrPoY0MGADnsh6HjipNZrt18yibZuGhu1hQr4y780U8duYNVUyCHCyDFY8QUlJqyCE1jwLEgwbllmhpujdvnaaqUzjN6bi6sVwks6gsTctBvkySZVpixOBHTTyO86tE8BJQk+6pCBH+9olbuYx68Vpzr2g4lD/mreu3Ljo3RRKzZGgFnpeb517z3K3nwl3KxOCWWrEF5AJ4IgckJn2NM34ifsJDOci5LMg9uRDSzhfRIGlzA9BeXSu2gv5wHxfzmo6GqnXUQSyEXBH334hjDbRFyyO3CpjOgy4gwyXWpMRl4i8l91ZakhFGohTYA5hXdHLC1ZzSA8m7iJm0qAbTGoCjMvBdRoi1jWLbbfl2dMQ2skEzP8DdkFKrDlup77nemFYQBWI3nJHqxbCIk5OMsxxMcACaouiFmmRz04W6+C0gfN5GM9S4pkc0pJq1qaMNVZ98EN7yEozGruVdUpWrdv+gHELMCRlhSgOyUvC8udSiU9ceUv8OD9pxTPRP2uKPqrb4Yxesqy3+49vZ39wWv/OGRJ5cBI7V0VHp+ifZOzShLrsUHhTRpF3+P0dfvGunXLrE6c6Do6c7/hfcCY4miUX/L+thTg0nDYH2PlSfw0kfX9jT9eAy2NbQw723q7l78spVDtyR5M5+Sa/iYvDu9orIeXKREzNcFkF/h7gJd9tw7LOqeRStPP2bJMhgTvu6yjWesNrLQ7842suHXC81SXp5I4KpfnHn6BfBQN6nn3odljSUpp+l5pa5WAz7EbSiHKPSkf2uvYOHAviXUA/uYGxZ5/waGFwGhRNvuM2+J+tHS/WJzDEyWpNRq9+CFEiqBvPiY20STUMFPM6ZJTGPVFVi3w/efPHaXz7hdwgeeXC9z7MmLXnaUVPWoVTksQFFVcNjYqRXAAZ7gC/OvqwGuzEqB1EBApJcxGIOKs7eBlqJKjDx4zKdxNMzls6WCLVb4k9h3Q7+URtQQ/49OehugQi17Al3w7h5U5rucUJq6UZKESJLjyIkF+cZtG1FKVrTZTnJZ/BYkDPFjOr5LDhqyMKx4AHEIHIamqOMi2dAW1DOTzV+viArRkh47jZPMk/c6HzZNUxGZ9WlnZ4pikJ1tl+juK1zxH/c1gQ+D8ALLfIJvhBD44QcZ2fw1EQxFuKWLqALMtzovfC1do1YAJiEaqZCNTW3WzLsnkqPWZXpoJogICXPUf0W1BLJ99gfBZQJA9IkiI+W8Hdpbz84YYq4qdopHFSgPZSWy8CCo4Ne3ysbqpBRmxtxdRnwxF+MyC45wH1uKT9UIzG71qDUrgfL6MAcj/+SlOiJL0eKxC2H8wmkfKLZ10nHmtonKImSx+RF1w5rqsysHbO4pjBLGeIyauvCF7obbDBJ4Ttl2xETyzjqVyfs+rZb386yBrw46iJFw0BTMrHcdRGUrBA63d/JNFVDbDW8W6buKUNE8PArTn+U0P4yqKJqMF2kVgeOlk194+NpTgwCMQ572XtL42E4Nc290qrY+8qE3KtYQSDbnF/xQu+VHpPq0o2icQhxOvws4cMumsIIm+Tq0K2I8SPkeVV0ilMxIgP1f34EYkoZFJ0UAKuajcsjxPn6nfGOX2NdQPWjf1TseMnO937RTSJxEC8Lu4nC/WQ/e6esOEf9oI5Gv/KkjHvw9y+01j1+8p/+KoGO27vU6MW4kQ/NK7qxztDHT/A3FPR/91/eFTozH7+CAooAdUXiYxgA0J16QjHrvEMPSAHBdBIrRESJbrcUBvIVAX0ktFrG7RT1WWQifazigcgI8Ior8AooUuDIncbs3Tra2qUg+9WK2Q81f7W5+Yv//mjMX2yMm7/gxlTNf+BtzADGCxn9FW+VkTN4L6gl5n/6t7zyhfphkL0H5Zv5MM0EjBrponATEzCj1kZ+7WSsjagdCsUSZ4ZCO2bsUHzJC33BvSmeuyq3BlR3FviAtQL4UFcjSkAlqLsCN4w5+y74b3VJEOu1qv4q7qKIclVD1WOtGe6EIiQ2rCUfLaaheQMgSFRFEKBHbtCkME6w9LoLlwK4hRWNJ8nkaaYRD1nfc9JGQt71SinVd6UGPKJrxXEshbxCmBcZPHSmZSajRIDsthDnaw7f5MDbguQPupp/QSJAaLomjtcS8QyqeX2Tl2EpBLB/TE0H/iG0oE+OjDzgyMibhh8RBHn/KBnxVQ5Rd/QEHyk9SUAAhJ78KH/MYDn0o0OlJ/XsAyM2gww5j1QHxhj+yT7oJjdej1Ymt//1mNwfmpjcD1QnN94e+eQ+zJNbPgyyDz+ek/vXH8Hk1rGrTu4Hysl9OZdZncShuW4a6pjoiOT8jmcR2vmE9mcfkRwozU2i9Kk8c9xEQamAb+kImQGyVvjmU9/NEXQ3/TbP28RvxMLamMomIpPxmeef5AQOT3oCTzelVO1jaPuYnLCPKCZ9V8jmFKNS4FerXDPFhH0BP/CanR9coTHPI8WnAtf1NSxa1ZdrOKEQmx5cLXm2wFydxqlnnH1SBFxqKDGA1ifxdD0Ajy/lBnmqVeddUI8PKQJTwOzoARxPJgdelDcspcDODSIP/F3Ww81g7P/q+IkOrG0IOx5A+RmelKhJIfwtNIj/ZLt5nSRc9aIDeDxbrOYcyN6m8KdEL2bLtQ/xxplpt5sb6+rwJlUXOCnKPbAhxolFKqCzQ3pHfsXZKzOm2T/JtlHc7iRFq5IIIUf7yLCYQU27iw51aObKHirChrMNY+NdTpwZDodFC3l2FW2ObiEPtwLKu1IDw6JuYINHVxoHbp8DzQN9L/ttwYiQGphJmtFIfgRS6K2My9cwUSlwZkK+iTXHwxrIA75uWPM7r/u3xpqvvurksEaJVxVrLrHLej8+gKd8vnoAOylr6QRjFVM9+110s5NOxH8U8ekXAt9z9gsOs/XCur1/TCzweyCk+hSxBLj/B0MBRB6Rr+tcHcxarb8B+8f8cre/hhoZCJEkZRvoReHBYqVoR3vZexAD/OsfjHC1SoIPhNDixu61rur8dTED0rWJIOkojzx0BjDG2vEHdg9D6uFLxIncTay9N6HDaN9NEd/zQEbE92/y1yRN449eb+MPjsSrm6GaSsZquITJPefuq53LW5B3l/bvQ6YEDwhQxh4uYy+aFrnbRX64jNw5LbI77fPWlMgyRpte51G1aHNT5BbPw/DQYy+Y4aubPH4yITmIZwzPdQmgdwivIUsw8TTW/gJMV2BcEb9I8a/AAL4MBYDRQTKncNRLUEg/WOOz4vP8q1FRP2Cfggc0J2OvXAx7ASX9T2PWUHxAr8JYurKqLph2H6BIJEax2NHLPfXOa0VySFOzndhMkCeNE7ZT55u1nApzuGi9x7VK6TrdpF/dwtOvvF7hwVaUbFq+kxJQzGdTAqdqUjx/2pBKUT5obfbXIFOa/xLJDx1X9XhAXmV6FoG0Jsg+rx/s8q/OAdUGDxkaAdRO+Mt7amI3J9FCIKBJtH7IfhD8AoK7JXg/gmdJ8EZPRD0IPoRYkuBBxK4iqF7EuhJ8EMEFCd6EDJkEDyGYIAhaYxjUA5iBuL74MUwd16pQY3VJ0wZOxjbKGMXPhPHOYuOXwunY6NBuOlaOYmNcwcbIYqOn2IgRV2yMHDYyHgJ7dLwOIJNDQI+iqQjI4yYK/Z7DuVAEmSXOBdIE2V0ozkWKcwFwLjD3lyZxzqxSQa8IjotznuJciPKPj3NYPKo450lrvCrOBd/YOBdUcO73Hmece6JXigeBBMY3pLqKDrLfV5bAUAjd9hz/i2NTvvjDc4Jt7A4mNKsqLkoVQfXIaGPsyOht7pBnwx0ZvatyZHT32Bfvc1/c7b74SHlClOidZ/34nrGPP+o+vsd9/HEE1bYRTjTiMqTKCKqDQHrtEJiFkPI1CEmt6vsDoQyhdnndawahnYYdOwv43DGKS76xm4y42RcVczR7YD/OS+bV2ePCi/JFQWa9TjS/P1/G624U2kVoF0JbRA6FhV8U76DfJFvAjLZQRPMvLnrUo4UX8WPhwP4DxSrq5pjF/cxjFj1+248N+ix1cbVnP3WgkgAH0Ijt0QotQ9aRr9BsP4T03sfDp0jkJyrYV5wQT/D5VjzOzbfhQfl2PRKivkBdnUGsrGV/J/kbNA9ikfeEc51DGIombQ5SQosH1qgF1yf5Ai33w0uhmAeL4KIJhtKKWQSlYDiHRhciubg1K2c2GCyeSuhFhCZHnK6+Ko1aC/VwZj1DCzjI5hpotZe3+oJb8jFXLd5YVbICvzFFPnqeuh25mLxisF7ERfchjth3+w/WDl103/mvzAv+jPTsGQlorZSez7k+NFwfltU4OVhG7CEw9Oj9qlg8zbdMMqL5DoZIx+gJ9HmmCe/ZoS34E18MecZNaNAyoNOlTA10LIidmWVaAKatrGlP1wr27+Nn+U7CkxUT9VhJ7Fr1yF9DJO14+PNevkPPkljLE+7nAFZ1y+hLM/LIHZipjoePGnA1ruFDue2Uhz/nPXyfOy8rZmlWMp9KO6tJqiCkfnT1ro3VBl3U8ZtDf2wTI6mcoMSIbjDHnBG3rGIYYlWLIxRn1M46uN3eIXF/5A7UCnO3MaAdqv0C3usaBtGL2YvFewvoThWUX9nLi5E5oI6F8hSJzwdy8Hx9VtujbZiiy+q7NJ8TVBG4papzKDhUrAKL/BflWxRfekJzmKnUtTtfNPdFxyjZpx0lu99RsvsQTB2y+UYdYezjL7iPNUnVEZQMbhEFKHPC/0tjJ/zuQ03SE34E0740CWeXxpFxX6qRXlPHxBkX7sUKoLQCLIWdTiYCBwx+ou1SEPS5oRdEPWzt5jmwCIKAkUxynxbMTPeNexEfNpp8N9tXgFw9w3AgMrEotKLn3A+VREkokk50vKobK/WhG6E5yKmY5gO7pQOg2D1QbG6V3ImsjdJGKamYlfq1ZGHS+qA/KBOgAR3vgDp4ILMY7lntYd0BAefVGV4PAsZFo2xPkYxRjHkeuP8JxxLTFbJ2GIUsPC83T4vn2N1n+FO6sUXohng8a+KG6aKhG4uUjNONSOjGqYQntGCVCohX9eV8tkINZi0R2DEy0zU5ox10ahmbqSZeT8hKHRcleEB7jgZYpakubQGgobe+V+a8hnebOd/RBtKcowMSVvqQYfpn1DE+SCpD4mAP+tnpd9jbkhkmKFy5sZh3Y7E4NhY1HYtEiG0dfwpZ9Sc/L1Rs2hjlp0J4n9EClsLFPGIg+sTIOD0vl34q+QLVnbRC0QgxV3Dy0OwgQ9ZNzA47RxRf5Vy+mDUQXQDETjXQ3CFQq4tp5wqk8oWpMOiNwaDOMLiGkedR4eMiLeBPoZYIzHrAx4wSBg3mJ4rFMk6zYt1kBCMZBUK5rowX4pd77UuG2/T2pcYvRzH3fKCmrqiR1byL4K3EF9zdARtNHqLwOr6ERVY90LiJq1vsTCx2XsFw3E0avpzDRJth7QIKXKBO1eu32jto0yrNKJOky7jSxlXQRsxK5Z66xB+XNISnzkLeM50CC8eZxPNdUUDEhWzlqpZf1cMxmyFe/gH+Fis/0zjdtNm5Z/inFLiT0gwiZ6hlceNtVf5J7Q4AQRAt08nyRAv9kD9xjNAWxwjFY2gEVsVc/b9WSVEyxvSAXcTfpT0RhmDpoi0UK9sjvRTuscefrVJMQKkKtvwXRoP/BgrGaK4vjowp0XcMDVmGBoyzKo7vIL1XNsnTYOJp0qY8TQ/g69n7wxl1NuFpAkZbUT1A2NiFpZVJniZB4YwNZjhoQTduiw7Qy5sDGmDNaFEwaZW6HALkerqjkKFbJqiIVZglECuByorV1o4qqbBFSonM1EJ0goBRCnjBO9YpKtyiCdWiKi1aJR5yFScUwMwVwGrFsFuLeGH6oIATZqtGW1VdXJmtrmO21CadYbZiw2yl05mtecNs/dgYsyXvymxpUJgtBFNF8CqzNfbxF9zHmqTMlnwsKlL5smG2bh5jttyHmqTMFoJpX5qELd4BM8+kGmW2lhE3yWwF2E2B2Woc0Jm0irZLQXlHCMqqMlsdDsjuDGOymPu0qmu5O42nBTNqk8zWIiIX7d14y2z92MkyW8i5ObM1f0JmS8c90pOT93l4lrxVAJNfG55UXmHFpMYtDhaAGzad0rZ5WewA82KubF+xMLFdS/l2cZ49qsUuo3n8Xdqz1GuOFtRUakdJ14qQroVymnE+vXhkWK/AsV78eJ/HkOl7I+yXL9uwCtVS0jTJhNnYjGaFCePyNlCerCZ1y4jpZDSbMWw5K4xY4JY0JVTL2lzqOuIlYSVq86BZ87R8qbmRuvxM4bMyB/Z5B/bVUbADa7n2TI3PYM9M/OhVYLCia6Vhu1YnyZc/QbWYaFBnCtVSxfHjEi2wLFWKBSXaCgBZmpIvqBK+0YJcrrKfOg8dGmZKdJUBFXz00BsHmC0OMPMTDCjwEcyXY6WAXatS5haaPwEDugpuYh5brRMzoMAox4AGyoAGmaKSZUCdsmyVAU1GGVAQHsOABsqAAlsWgCELJYaAbk2BwSQDukApmPD5RzMngSz4U6gtAmaWAV2cxoCOzMoq+xlU2c+gyn4Ghv1MaNbMy5PlQBWOm3OgC/ZSyWKFAw0qHGhAtNl0XQW3v2oQU6djDajrIL64+XQEqDu0otPRbHYWp826TObp6KyLGN9mgW8y83ydedHozNsccxaqXAItT2OgY2rqmiZLn5ty82bpi7H0cXOVlxYMWNYPFoT6rW7GS/OcNm0scsqpuHIzVjqWZtmlUVlpa23OeORuaRYcxVq5/T+cGXf5poknZsnqVrI+8MYk67eMiWpukndwD5qk3MPNCNrLGGNf3O6+uNN98VYErWTdCPHHPnyb+1CTVIhffhgKkS2l17GKwq2htJ0IJaVEu1GKzpulYD1VOXxLF/d2KWafKQXznVIcn5UienXZjdBcVUg9r0LqBflWZewLrGuPTlRZFMogM6a5FxW1A+VVYx+6+gf2F4IY+RylxE04QC1apjYyronMOuVXxrgD+/OWiqzvks2yL6yiBGt6HUltjbWV58d1Mie2Nia+2iNi6wYLxfMuZTSHC5tNSkGLMGz6qZNYW5l1b1RmvThNZm1XWyknX3Ui7K1cCoottkk+MevatQcE+Yzr2HbXsRQ9chcleVy2QYAdTzWglgtfk1GMP/UfzKz7rDR/O6XcZ6K84L8dIBorVFMLLI0phRX5DviWJ4YRimmWO7w5I9nGUyXbNQPuOSvZziHZzvWyXFsl24C82OOgGWqq4KoUUePqLJWy7HyHvcvX0TGapUL29bMqP7GSpm2jguatqEOWkNwImmtVQXOPtvJ/PRY0bzXXcauC5l6KRBE0R5Dv+7SgcwDjW8yUI5xv0/FryPRh2CKl9qK89chFyo9CjrxNHKw9ajlyjVpT5MjxmBx5DkCYw6SDpDStCO9A1YEOoOoZB1oqF6kJg5fmbZlwTnrcxIJSTrq5taJNDUOuEblq/e7PbSY9dtuZdku9H4/LjtEnaTSTijmQB24TzVW3MzrUup1p2yU40RuaVMcv72ZvcvNdd36Ga5R45Rp12GOZtm6arrpp2hybpi2KMU1nN+GVgKOHPYOsB23gavO8gkAaZ/HHMpiaNHNGltQmyNwKyUzE4OAqtZ73VYQwoH92Uqo4obYGuodyVCKDGQI6qCDKMBsMx9OguZJ5yu2UgsskqjnuKTeljjNPo0XNAfZz1NJZPGOMqwjjpC8H8ULm5WoOZxoW7qpmD5RiO2yxck5NB/8ZB//WOJkU4UtTQKfnBTPSkgrBUBLYFIjNjRESasmmBTi9lRrlLVeaGxe4bK1iGjAdHFTbGBjfCrbF8CF6GVDJi0fzcrqt5CV15GV5OnmZfeRClEchOVlGD2YeteSkRrNTJCcziJsgL3prdGRztiTkpaPkZQmor0xCjbJyKGpOXmLJSzJJXjJE8gQC3Ds0dzLyknbLcwQGOTclMLPHJTBOXoIFqKWapi0SFqFtxCVdNSlopCX5rOObK9KjbUBYkZjo7IOss+m2DNu1odMQP6NlbFRjY1925VESoJhm8afbtSVhH1qgPdtgcaRjbtR3cPe9ulmriQilIH5i86Vtz+XijooPdBRrToTSKEUoOe2okBLNlIH7r4hQ2uAo5qDIqgKANjVhL0UIl/IMmU6zVVrCsDjCUnOEhcMz2lpaKSUoGs6QF6oZ2PXNWAnKjEpQlhz8s03hD4qP2tUQBbg14secg4ARngoSZFNIkgpQqpFCi2YNLapVqJDSpFEilIwRoY7SQCVFDYCv5sDXoBnsCQC+JYBviWbcoVTHIeaSQ8xYaanKUGaMDKWKmisONLNjoFlV1MyUNOOvlND5sgecLkPJdYsbUwfbullDnHnXMj2v7nZVKgfSbXFzriJDKYixjeYqMpTcsiq6E66AEMQIuFIYPMoFX5rAkWaJI1P7PzfW/yb3/38+ep5gVnkChVkmEJvDlIwJDlEwG1AwVnBqj0/K3UYmgzCJXEbDmchmNAzxCUEp/XFiADBbQZab9lABaVUuoFblAqZOVscFWMS0Fu0aUydjZ8pkXKKGmYxNM+k6k5MulllaiaROXsOkA67JxPN14tVGJ97mWNPUKWfI0oxbGgpfyUlL55c7K2hRirUPBr6ELxXyqkeUmGDSljkzIg1qO4HJVq7MNkrU07aqwETXJghM2iAZYMZSbYcxIeZX7Hlq28placUd4K+S8L1eZSWijl3TgGhulzBynB+5o+xsbFyWaBtmwnazSC0/yhmxnVbwp4faWDIjyjAj6rRNVfdgwGEWZBZb2IbyxzojfLNM+ZVlSrQsOiNrFDMV2Kzq6oTt6eTqNKZlgRHyKXVLUwntJbs0bassTX4F230UHGsLabnUstBwJnlXMBtWKHZkOq0MlBsGrNixEmkMniPSOjSzmw/Nig4NINeiJv4UvEASAeZxifQSpcDcjLveYTCsnIBIN3xHpJ1wQUFqibTTtKgS6XBsuq1SqkRaIZqrDylAq+mgNdH/qUR6G7Qsske9cUvxpzBrAWJKpJeoNY1IF/4IUlbItF8h036FTPtKpjuqY3HSNBoAPDGNXqVWlUb7VRrtE22Gtal6ro9HiVwN2GmEBjNK2VKlbBgtipV2KGVLj0PZkK2U4fSu2oy0KYm1UgXfelcdlOra/7PivSU8T7tzQdBVMwzwg6P7i+4FsgJFZs6dW/EQt1N9cJAHWJeXvHB16XlFQMEw+7RcRoKWNrTkf+16vYuc/j+eN8WjVECe9SzrPevCWo9DvrqACuQS+oKEcDqboeFieym7R+/bOlMVf+174bQ7rPivvMeqF4D1Ml/EtlM0SS/4FSHHXmbiIs7yEr0pHMDbj5p9Q1O5GeJ+TR0isV9FaFuHmDsB2kY8d8Rvi0eh+sS5tGf8cmcf1yvTYk1k81pCrQVt0gsH+NEr5oW3H/rnJF9EyKf3IdRACYazekvaw4gZjz+AZwg4J/pw3oCyT6hPPy9Fg+SyG9J0jxZWjTd10uyTep/9+Y/mwvin3IXxsgp3XxwvY9fFnyq12OtROoT72TrPfs51/Lvck1fc9W63Dln1cjcaYe52f5fnT7uToC4Z5WL92TV+4/lk/VTlAI8eBMgd8D+ecm/hD9oNn89XAj1neSX/vry07TUI3CQQnD8U6GS4CU8cW0j7ilAYGneW/L1FfGHttZIHMwzeV496ZJAbfgAQutHHL/zJBC8lz+y5P+LpeR/u4CfCxWwAhdy9WAr0IkpN8xHfwz9kphHucL6gaEgrDt54Th9SYttMbWHjguAwWhVTY98fv+JP/uHYlz5w4ZUc/lF/11lnvIGeedWLX8ycwYW1D/KA4bpngxoT7pTuft9wIJXov+eD3eJst92Kf3988ZAaVAFEDwbU7jJ936moEhprjgeKpOz32zztGDXfTuHbDRXAFwLf5hrTPcy23STB7E8wkHlor8XCg3KRUvpKhHZJ6Npfu2OI/l6hZTVl0Wky/csOgfTloF4jw1I/4bDczeCuj4wJtSgyPX/PxcOhDkn2p2jcOjr+PJVRDd5RyqiOGpH3R0BK1BDaLZI6/f7xIUmDNEsLsR6EXIFSxMZmRRRtLuROW8h5/jENVq2R3a1RxDn9j7vqpAoVnh2VmjHtMbbkayeyT6ObYE8+gtcN0V/zoD9cYsOtDBNkkPwbRYsvF+8TnPnYx/piNG2mxK9s7xDAHA4o2RiauJ17h1fm4o6Q2/PdfekGhTriPkXOBFyfow4jdYjxT/BTe+V7TPpFMBF39resfv4z561cLFkHn7z+EI+PQ21ywat6ZfzhveSCV/Ye8mEUgrxLenLBt/Ztvex/6RJHPNn/IwWA2ndhmZBb6VUQX6Kzd68+9uhjt7qMux8ICGEonkH/tQE86Wh4Dwcf0CAuzH5Bg2/D0nOvhuV22Kc1fBfi79GwXMX9uIY/gfAxDX8K4Y9q+DBqulvDH/QMjqsKnUwLEIC8oY3Tpf4QvjhLgvfKXV9X186ylVQ2fdU1sYugXrZTXuEmFJW5+hLX1FCCn1Qa1yip3P8GrOWEGE3gI49A7yJyYkP4LBAH5MTldcSAHp7NRFgXBKXVa5Uhh2eqVDN90NNM4mpOyaXZpAIALLhXfytoTg3baalPBVjOKRw4uKBciPtJ9kYsbHlNQU2N7C9uVIbox9/Ay57GZrchj1I+pLwWC+KbJc7EZp/RHAyBH9aFsp9pyZYcX5R98saxLH/hef4rsWqLtQMK9BK3f34ga/f5gXIQ4TMufm0RvZqiV0BXgV+ve/W1MI6J6PjVFL9CjSn+x975wS6S8qsfeBRs/oE6wkeO72ozgaLgFXnQ0pn8ioJjJaX3DO/aPEi1gbuxr5fshA/CV2CeMByV93hFwWmSjo8kKb3V8z2+bzjFK51Y0SRPLaqov0vehek6CRY4yf1NM/3Z68pMQdVZXODWwTtMMNw7hAlTl1D4xO9X9tLf8xyne5BZiNgUEo+wA/Gm7MAP8rpTNMqVJ57KEMRYvvBIcKO23gd21vGy+qyefqqOebETcF9FWho+47WQ0GIxhu0ZhIehHLV2yS23nPsrPW/SVBYgZpjW7F7lq2Cw7s81iMUaxviU5Q3P92FbUX1a4pRG8K+0XvUZ/QZMMDDNhyGLivGqSzyPDcdado+r+ws1e0BgPtCF7D5EtN3coEAnBcbXTgoK0j/5BjZCKzGlwc6KXY5+iCJ6oEPYS24M16capf0TP/Cua7xyipUgqingawp473QmkAEeewqxMfv/6z0juw67Fmty9rsQ8YzwNZprVxHiQdxARqjv6hV1TNKI0/NElrTsWng6lAISkkwos2hyYfz3/+txds6HavOmVKsmWLGbVkuInAEvMEf53SiaS6Tmd+XtVJJjVNegZpmUflfeQlKbPRequytwA2rkMVDi5md/BYyQ5ufafAAbnxfRtDZ+t+rY5AEmkb74DgHPY/yv7mfsDkh3prqtmQB0mp5d/UzQwOyFDL3BtzX9lnN/JAx97EGc9XRyNE3xVQ9TsFY7L6d5oFVg76MonABzA4aQJrTspsgwUJ5h3/5OJpEQnQX+As8uFjcEVjmQPaA8Nt4zCi+soek+lnVYnsu+iFRTZGB1sbIvudjs7+X7yLx9Wd4C8/YP8hbLYeaZygELo+iUpQ7fhWCIhemy3kZp49dOkW/fO8CXwh/DJsXQkWG82s3K4KLhUCJk+6E91xXetfkflZrcgXk7GGBWKpNh4MDRAfYKVxY+474yFr5hFHYLkUid3hQGo34HRUeKqDQPLOpXMaGR6zJLoIMmgwKaEOnKGJXtF8bYdEFjuLh1LJReKUtBiyY3ZhcNB+kv+zDhhmHHnQSLfQGQw26Ua9WNck03yvCn7aXKwwqdUi27EeQQgGT/BGjJu4knfl6FjwFhmGpAPKRT5K0X3r6Hfu6Lf/ic77v8YnLBq3r7vl/+fe7iIXipE7cLzTBFu+1W4fG3o23dhbo9q2NY2ae4ApmzszX1LsnFhfLTPH90nvo6T/3sc/op4jTVTnj4nj2i8/ZExtOOvgLG0/5yqvG0oef5m1iIu9MfM+Om3rlv94tAWofFcuBT4LzgaoZD1Qw3TcmwW9OD7M2vcpG7jJxGI6vE7xFSsdc8nuZxA/LssbcaOQhKu7h/7eziKgs5Zhf3F3yvfpJWIcMftEYhkcdDxeNGZYsA8khnUBbiQzFNxc+6Myn7+RErkO7OgzQeK0OEel3lMRe8X3BfhgSrUqDyQtQLc5T4ooUvJZSAc9RvxdpxqL7IY0CVK5EaFBJ4IC37grMyqfyiV5UW/s1jkBb+7YS0MKxKC8OTlBZe/Vilhd6otDC00sIbPWYbq0syyBU4+3s8/B6zVvQv31tSWiagKlJ3FvbLQPbP6C9qFQv7/piFffLExr6P/24bamY0/Pm+z0JFbsZZsHYmu2qS7hUR+LCY4lcSh/ZI6FoEqYzcZSJ9I8TLHtQVFcDWiK+ondH0wk0p2C+/YToFKyfsL1cn7Ji0cwEzUA4eoDytrIJhCHC7ZRrCKPsFc2uYWAcoyP7F0tBdWkKmJSygBFKjt9DzKIUAC2uKwCEKEO7+odGTBJxSBK67ju4KbpMJdfU+PGxokAx4Int3Vqv1DH22HrECcwSDTF/PspP0vwTg7/xrK1bcbVWGQNaMHU/wHQG+5tI4fAcWP+ZNwJGDsktNoIP4zlSQfjSIPXtZwG2Md+8vIkv8FO+L2Mnc1LIrUObAxkBRA+04UNRVCkf/beA/46qqEkKijnfUA4ndkuE6lCJ3VrI91gpg40VF8+04uMpe8R7Z5FAd5g8P7JfILkemlA55A9SilnOp0GNpITR31ynmn+xhoICdi9dBt4ciGDBMby0jv7ddzYDkrGiNJBMqIq6G9SFiPcaJwX9gM4ytC0M1sT7/1dlNBSJ6ZhexjMva6xoR8kSwtRiLjAcvO9f6v3YT0yvEq5RHgaRJP3q9k/NovIp5QB3tdvUzcRiwiUKMpTuMsEPp/EkcOsqE7XAABldN+A08hGV1OZ5A+60eMWcOQUBVphBRpHLBKzgw4NQIqdndb9D2HzrkK3GFnc0bUWmMOAYUTkT4pYbXh1IUVMdhiZai4m7Eggo/6FO0iXHF+321rf4yzXm1sbiOxniwjTbqRuOgp+kwlib5L+cHQdoqj7362KOP3fz4EOfZZZ6knzxPeyhXtA2q/E+gFoPUHH5oFLOsGhww39noeyr6VZH4vo899brvf8vgHy+2e5C9e4fQsNDOK/up1SgKaLRuv7x9F960+zM//D+f+XQ9cPHJL2OudDc4dC+2QhHW0tsB1tsD3YKZkt1eIZY9GKJv8owiEViHK4oYj6uKuihigZhpCMSMH7l3XIKWWoKWqpEDCiSXTJ4RcsgTvPJ1rF979muP6kaRB3NPC8BEjI2ybARjpySjkX1Wu0GRGkgzsZ8pY++txN4vsQrYD+pZNrLcGMiE0ATlohEu5VpvbschU8o6qOYrrTXaIskbMObG68/ea4qmZqVm/4EAXM9XZQmG0lS072Mfxb8vXDzk1I8gFavVe+4YCiVzu7Mf/+Sp96fnzD59OFA5K3LAcmp0ZY+f9exrggkz0GfLDr4e4QhgRDpTp42Amlz+BrryrgBUl9/uxqRiuGBSNZ9x++evP3r3a7/y5q8yQt8Z0AyTK/zUIEnME3zsr3FmaMPO5Fn/7geZ+kDhTAr+mjR8NrseNWvR8I81p4dxoCPzWKPnYAmvWFAnLgtICJ31ekYx1ZbW7YOkFtWYFFXQPM1QSmjQuxh7X4UKTfNQpVTYkYYXc8Y/VaKdmUNPntUTj3xAkwz+RDKqM8LhqiEHbhH52mz/BWti+aJOi9TCpjQ1xS8IAKjF8Ujp6TY+67cua6PTdwWsUyc3vtuYCPqRykSLDjA4EXazjUpEvBLTvDjgmgOsZnGRk2MxblcWs1hFMIIciI0JFXMlMVHJX5v478oedfj1yL7u2fu+81/yBsrvHmDC8488OuuOkog4oIOTyzsDmS3z6PU8eTh48Ci7DGUrm9vix0x2A+AqnWtzGrBKigghbV9Cz9BXsKnDfNnoDGp3Mz1Osd3NRrq78Ai6y+NiPDnaPkdAd25IUe9x/305mPZF/EM15YaTvqebB729N0M+xTob8i7NwhCifwCXxTMGEmcWKPEHwDWeFmgj32zmtdVgME/3G/Ex7nL6DsSJhW+xYkG8e+8AEvBbEL1Reo2sipN6Rx4K+uFLsVmdhx9jqn47kDRp/Cp17zCCjS/xKtGlLdSlLnM2A7j+xDav7KoRNtdMv/qHX45T7TxM8c06ukIhBJpLeej8HEZDWl5/80Mxskl6xg/+wkhEfo7pkI/rGjt5Iclejd5jXSZqUh3RqDt7jc7y06EaYSYv0nbndSnSP8tWV3fiAZnNI5FSC5ShTbmJ3FDDy1k47+PCOhJfk7ekb6nNLDA2UZ+goWGp6+VrgjUioToedZ7LBM+0AzVvoi6Zm+oVA+8kjSDyqYPuvhb9YmLJAIDkBGmr+Onux4ZQDGqnOt09WgCGL8g9/DwTSyWYjkBYpnFAc/TZ0EE5oEHXE9N1EB1g+LXWbTU3QoEzQ3Wcg9advIV7PNNvKZbq6oOY0ddUXw/JuDR0sQGJen76ltD5tTjqDKQ7s+akZs27+ragby21+i2D/TqlBPLCLTQ3mNVGsOAdWEQUF2M4RcwJhbgE3eAQyelvDGclTVhGDdDBc/XUereqwZxV7t0uQkhNOOu01+sxifikqstCkr1eZ2TAtXFOFScEMNn8BiRIPHBbKlhFo97m4/dOORLTZp6V11E8gqwGkamsMBYttjqF2U0oCMXG/ZtN1BsRlconWmj3WSrMEPFcpKfYoXSFx0rb88PSHhEKhe67/WYLgOhIgIoINDvDT0tbKayRAqjmAKSAQw2oMCRfK/oRVOQSNPJwGdl1kT+qkRVHVD/re7HFj93uVC6kADKMEKdoSalDBpzwGL74of18iTe75wYjS+hLM3Eqx8k4//vpN5S3oHYWsRFMoSFxVZQo9/MryavVZN3M1vsHZAJhTr9AQg2BUaz4oXtpUsNHHjWUicSgYOW9xnom8+At+mXXrI0dvMdqXFjIA2YlcwsNbOKyn3mDDt7u0kUWROJOj7BWiv1UlRBNJSMGFGz1YE2K+6Xy2zEBpBiUKYxnPGRnHcXSS4rILMQAgrfZx1frx0Yq1kEADTLSM43J3mlGwKtIJF3jjTSSoQRITUojs3fh87JRj7RF2a/g8xPZDH73GyY16b7shZBu4M/odPrZL+o2Ry2H68EqZ55+qIqJy5mUba3Eg3C58y5/6se45BWCp8Fqp85UgDDUAFslwcEgr1OMtDIhswmxIqIHCA3hmmB4JPdxMsihQQ4HTqE481MKUKM65hbjIBiyz0RBk8/s6tNVW7XP1ncFdx32VY3NI7X1JStlqKoTrNWt1r/Mua5SmzxCnVH2JmGH6tOLrT3SYl+CYv2y2MQW2tBC5f5uQ/xXpCxKyVt4JEVb3W/KJd8U2SNk7jCSuC1om2aG67gEcms+o8bPMkqUr4MQO5/Dg/3na2PVQI9YaysCzHhuGvwRa9fRKQ15xJ+L18QFmiPJmS+a/i6IbdoiFqlzIL4s4IISe1OzyokTUFpcc9qakAORyEjc+0A2b3AbSnzSvi6eDKW4hNpI1mHXFUDg6AGIkb3/nwLEqaiou5FomJEIMCoyEg1ka2g2ioSx0hai9SFPyDwWeGl3+1eIvyJopLTwUMV87CLQzYFMZASKtu7GE2xzAn6Y1K6mtiRVCw+0TEfKyKekPG1SXsSdAFE9fXPdS6a4gtWT7myzowOAwGJVrFgFmUMJmVgho461BDIxIBOriEFwXp0S2im/b+969jcV769P2uv49JIRL7AYiX9SVHEA/N+fHgLjoUvds3Wp26dve/Vtj21m5JrJRawq2Qw5gCPp+w6/6pCK66C4Kgtg9mOGVfhIbU3yZTcjQldP0uUxNqwjoi5h7lHtoITyPZoaipBQXkhedurLThLmI1OOAZgqC7XxNbibq9tj6vxxaUTCfEIRWeAhQY5pYY7xJ5Ah+0mZ6A2Jxco/4pNWXY1ybPYzItJsynGvdY+rpz5FKkhKofrMKXNQUxR71AR9qEL9UNpnTqb4i1scM5oJ81RiAvq8UY7oevYLZoR1xHXN5wLukCp17rlSsFhYiz9K8IzonmWlcmbXDzgZo7XGuC9H03JgE/FAqCNfoKLm9J/T9tQYQiwf5InJRknlW7+luImMuGngyQuHUgjHdK+hIOGH8vkADUNXY9ReP2JCE/MVk0cBtqpjeqsilqCWi71NY53rVKqlG54ojuAP/Rm9SFFdbJWYBtZVEoQodSPvVo2BoJLVetkXz7o4ltCDfe/7+U6gAFs4PwuX5yNWCBJmM+YzS/8ijkHpga0kNrdhjIEBPnj3ruvvNiLlsH8/BFMAiczJUDESB0C/iV7r9QlgmLqWS98dxQ1eeAOjvG9daoTWmQ/QS7eTMBcair61XmqmyHmBxjqGm1nUzGdafqqbIHMxOcVq0ZHVIaPMiCMyoVuIm6WsuuHP5AJfhg3/OuwD9TvX5PMCwAZgNd/vPMtU46UiKKGQ5tzmXevtKDzdFr5Fntu41zFKM3hASFkHmBLrdLopZEbzFNUY9Cll2kg+NQQc2ZtlTyRhmjdLaiDrqUWfpqIPjGsanLj66aVKDXln1+Z6cKtPHXgzbhLboNv9wrxLC1ieZvWAuol1GVI/XZ9uBQgHKlHcwsdQHSM7YL3wzJRMLIpZGg4ZqsQ57uk4HR6a1/WMlsGwFSsmZYEF7StcakksBia49/nsu53Vvl/10ktf8OFTLnoaHLnPgpDMw1LivFy3YzToYpC7QEa9Xk6ewKg1MiyLZkwWsttlDObMkP/txUNQEsZjvZrGLAwMOeaJiAVEIuBkBofD8tgo/dVHdA/qqP/CiYtQEhm6m1DYzIueiUceh69GxNoJ7kZ97NZ3xuZqFBgudzXqo5zAcZ/76K2Buxj1U693F6MeSaXuqhQI3VtQCkg5npMXmiCSUJWbsUtNA+Svpc+GAoEnbrd0vQ61Ok/Cfemc8b1Y6nLqrsaqbPl2RGrpO7xA6ca+//x9n/pU9y9f8v/myDZ6rr/vyw9//GV/depXLoa8VDlf5mxRiWxowEaBwdZdWY1N+8KsGe8klXTKzWOO9tHFegdSCfWijVnil8yYbjkiwewEnBh0iAcuSN7z29LkF1eVhUZP6vWKNviTPEQML/pgU3zyOIR7Cxjawu/vJv67rKcMgRkWIdJ6Z++IShmc8s+LRIdC7Tw8GjgFZLa2hVBM6SmHkqFq9klPXfAR6hr90HSfmJNb/Z0v5AkED2V/8cU9z217QBEz0UhSFcf/WXDcy/4FT/KyhwRLx1DxYUXFG+C/MJg8Y7dKttM5YiyNEDXp2WOijghDPQBWris2iK3caFh6G62r8Wu5Ni2j3DB7PD0oQeamHKeRlEYNyEo7cLmH/Rf/nIWKEvYoxquayOJ0/651vwEvKtJpqUOxUCeKIrryrFIlvgXaSKir3F0qHq8z3ersgiQSIcR1NXQu2Je6VKWsqlZ1VtFCValdBtpuGZiy5vhYc4b5DKnMEuXu5Sa17xADSqobKDvVW3G4NqAG3jtDaspaMzO6GGApUJ7E2mBsYaqqS/sE1DypDgNWt4nz/1r6Wc9rbqZjtjCqY7azdDwMHOSyLCKpRkys/JfqG+SJEq+G0z/D9+KDuIkjUlFB+y0uh2fqX3xxY9UpoAkK5+C/InzYEBcEcSl7hXxWdckUyZ0zYsX16c6IL1K9LYACjeCDECP4eTHijnZYrUBUvUKZRpha2HTBmNKj/lgNvaU3Ps7KhOqBG/Suqkr41dcfX5XwR/wAF0PjadIwd7t0jQvnWyp06Gd1WyGwRUr4s0Ws0va6CEOt2FrHFtUiV9zfeUCckoosO8q+ZiTZXBB/MXvcL26WLw6+Qb/QiLwxmjGP5eu8qQXOaYFNMezY4K+vt1+7qFchqmThdS3DJHiEVHpz3bS3nkg37Tlc0ahSvb1aDfo8BIjMOo94CDol0a/wPD5ZtiD9O7+6XjiKref22Pi6LWqtFA2P7uHB+kbYHkJRGsKNWG8gWHwYTZdUgOwRVgKy3FkzH/wsPhCBJrjC7E59BaWOCW6fdaOGWZ6AQVsg/sn2E8yE6FGJZjZrCc8rNeiJbBIXy5jgERahbuCVAuA7nLTLRT3olejGVY5tkZ1D/CQV/sKjO/cYFLIkHG/4+kxf7xluFnvlLP5pN4s9gffYLD78uDcmg+iLQ9b8CWRtVbrycyegK9fwNqCfiYTJK3wIZD3UjYUGaCFcef+J/NrfnXv9ACdWKlR/ruoIqptN3nFwCJk5xZi14GU+9/gRHMhD8PUa7ac/G4SJ0RCccktIN92A3KYMDCSEugWHQDzAGys4mWMBXySIz7iRS9stJTEQUD9vPXPPiHp8+YQi4Vhirkh6FF9tT1uy/6WzyOhHv6hAInZZqZHB98VIo502RsUwsefpCkyq68d5pOivtmWuA030NsSMR8Dv/qXqnBlHT8J3pRasG0ZhYAtvL5vrRSt78xu5Ue/eg7mhXf55HVpqZT86NQlAZ+SUWosYzbfuVyPDR3BiHR2qU6LzpyJvPdHZyy+gCnf28rjS5N94/Qlo8h8FkDa9HNyvE9+tFdOs/NbFRFZMeKoXFOjYhzqA4F4f6uD3wU6RqERKJJOi/RTxGRykJiIDUlkkUQTmIIYVJ3x2Y6Z3yMTRUtsYHocWFT861BQJVsyJEOHZM4EOflKK1UpLpoxgpLb+Z/Bjo9RjS4wRiq0BmlS0GUpDNA1Eqsa54d+KiN/qaJ/KJyM5yepYHiFv61g6Idus4GcHFCWFlm8+m6q+zRy1wbbmGXZna4VsF4yO6Swc4O17svz7e74/M9T2ZnDGk0knTIz4IOJG2JhYbPJSqup8AUYjMKOR3h7VS8VhfobXAlzdPLFNLxp4bereyrIjeMNA3NspUjzv6xQVI4FHLxJbleWNRnF6N7Pvbz9/9IIdv3Ph3n2/tvHG+IGlPTZwvjlO6vTDZ/WI2cJn9QY8milGIFXLrDRTFla53pW3Re54sENJGVluH9DYrFcw98+gbEiuJuENbkds+z9i2n/3SPsPP31q+xd/8Vv//IcWaO++7/mRD//Dru9ZtIHZR9F+tBDt36zd/H2jf5jlIurinksu0h5kUYI4qUhaWKHJyzNuKIJHgzxL0U+CHUc85qH9g/02RIqZyBXdiQlFqrFt8RFah+XLlb2J+xF3PX1YJqsMcMB7qQFXwfv5WJiVv1YxJXCO2nhmQ86CQJdLn6E5Jqil8G5A85Sss6COZgXfOCNGCYF9L/yNr/7yy7/EOrV8p+2/P5rrKZ9/vbue4sRL7n4K3sYuqLyQOQTdhlRV8gX4IlTZz+KuF+qHQfYFlG9YBhRRtevj62rPsXLJWe9NJvoI8UCrnlxehwmzv0FhU+/A6E2zza7BfNb3guk3s0Vu/ndTec0I5UcjDG3kGNpokqF16ZIKgvFIqgDADTubPVAyswBv9kV9VdrpO2YWu1fsDpnaO0Y20oxByciC3VExSIg4VUjBQ/g5Ue+fYGSx2X0QzaJAj0OQXQ9x/VFGtnIBvc9DNXrfaN3u3hVfvOytgm4yvrqDxsNqdSSP5v7SXSd/gy0YucHmb3KDzR+/wQabNg+O3mB72+urN9gMwx0rwx2B5Z52jY1PXOL9IheOhSbhjLJyjS083jW2mHxzVU2mit5mS/QR6gOY9PbXH+8a2y/qaPyi54f2EExxSjEtltMrdToR4MHtUNsekTLVajlZOITG96EHgFlyqYZaVNcNk1wcz96h814rwHc61qG8os0sPwMEwlIk3UnlpQitZW17P/wSHH/t0eHmsXvoH8zxV6ScOBZ1aShaoR3I3onahb5EDtXSvWafjH1v9ssqxiQUVd5KFXgrZ2/JneCRtDBJ33/yuNYtJVm/8Imf/0RtCq4hj0qrHLr9PPIy/vDjDIdt7xnBNrePolh3V4Jy3c1Qrv+CF0K94+uLeL92XMR7L1IffzmVeiaA6YfqfvL9J9hP/uEpTXDmK9f5fGsoePnMdcHLo+tKd+zHnNMY6Y116HL7LztTUlN4+Aj3ayRLjRB+6B0u/AVnLUpKUa4yj/uKEkbeBcTtQvMPxuUhrmZrii9lZyFQuKEmn0o0mcrDCKnqsV2Tz1CCHE1qEP/xRqCFDODcWvs1c+Yyz1ICBrxFKRJSlaPO2dveomOkd1OksWhBq/QiMQukyfDT1KPXPr9CbmQP8NplWoq0NtJUEYIl96LkcyP6bYvsH5a3Oe47fmqYCNkHdIF0scYBTL/OzZUvVOUdbqHl3AbybBj+FtUl6Y76lmcQzUKf+EDRFAZlgRssF9pLb+W2NJxMN+XbsMiQVesUFyntA9hOcSyPB4MNVUFEji2sdTxjT0db2DipSFydfVb7gL5ZvYuGTD65YbJgfDAuyiESsGFJfMx4Yjk3wxhBix5XDeDGJqFsP+JWOEMPrpmCvTpg8jlhvKbjZAiz3Hii0YTxUD+YBtBFTZu5VX3pbUVr820O2ttLg58ZbaVUQY0PoOuuJA3T09imZkzNcIDED2AxS7EBYOTIcLrWljwzBDvsPdUEX6aWZGsRPKTCFc52Sq1CK2/iVlGyOilKqImfto4l3GeYTa04NM9JnrU8V4VNcSvhrP46FzUR5WOWUzG/JE9EVE3CoFir4MYZ6QyK5g4wENEq3eCKUpszU7rNXenIoM3AOKOGdLdwyN2byDnrKgv1ubM65VBg8e6H58XBWVN70eLhnglUR0rIA/kHKFvD3l5Bg+bBEPa0wddeFfTwZz0idt9DES0Z27FFjsicI7m38EZu43cifqdmXrCRpyDyFMms0OGxmdUBAubB9RpxOqd8ThMRkxPK0hgCLDDgs+rpXjx0qIVczVl+S2RLs9+CqWRwzIide5n7Mea5uIbVuERd12rcMsRXy9Z3oIoelIacCkti3hrAehqgK6FdLvL0MvIMF3lmGXmWCMvys7k153B1T+BReQKP3S4l7obzrmNK7cYjKZ4o1jnyJTlpAFl6Eg4lhQ7mW9EnuF6EHfJ8iTiGxO3Xk6WYprHWczbI+xbWGKItEFHOSzeflMc6+ek0hssuY9Y5xkjMAMMFeQGwcM29qnCoJTgFTrwkzLA5j6p6tHKAiZL6l0J4kaPm1xDaxh8EL0ZoO4d8CS1zyENIboN1xSZ7l7YLZuZteVnWl0xe5vSlIy+L+pLSVn7Zpi++vCzoy6qAR+mbjzqB4kVL5ndEq9pVvBCleJklvFKRU0uegk9AplkiiizKdgiFUE4RI1dxihg7pgI2wIkm54+gb3Eufp4iWQdecR7ntUW36Ckk355CEv1ZrSQzlejnO9VrYHGKVKIV75C4u7jYkdJ2kGTaSYi2pbV1fuXSCes+tMi1tHMRRxJ3lKuqlFbjVMkU0U5XmqAVk5RQiSNhxaIuJkrXuKDVK6qx9bm8xdmSB1Y+mT09zPhezU8VMc9nFT86H4i5hx+8SF7AxV7I+Lnd4OfpXMkZBj+3P0b8vFCx7sISP+c4ao/gZ49DF0hoC4fOl9B8ibNJibONEmefys3bJji7jRKLmXhpWMzEy1P1xceLReBV2sovPX3pyssWfYnlZV5fFvBiZ8BiBZvjCWxerGJzFy92HVvAS1tedirSZwbPTzF4vgMYcC4hDzGWzsrzPEReZFEhMzOgeBqjVo7A0+188BVVT6EdMh+QjoBk2lnODoe4EZ1HT+HA5FwRRMTP8WfKzpGZkmr159JF1ZkiGZ9GT5fJN22m4IsdkzOlozPlFNMHM1N26iQgbb6ZKTQyU3SKUE50gpmyDZNim50p2zFTttOFiGSkw0wJUkyMgB1k4wHvCvOYFbjVt4VnxYKZFWdygWeZWbHwyGdFVp0VW5RSY3XQWcHoyBittHqL0G+l1b6E5jADdM4Ymf8SxRa1M7xY1O7IyzZHqGNL3H15WXbTIbb0vFvB8+4EnvtVPF+t4nkqeG5JN80aFJ+poLgdLlyOzUlRbYysK76eh2TB0U+9879cXP3DsAMxdtK5gsAXV/+KizhR0FCrE6x5CtnYKWYYzLSxWKPof4pF/x0jCHueknbg7dhCUSsnnaL/FIS961EjbCw6/hZhF4BFC7QFkYwZQtqBsOC+txsf+PQkkEWLXNsYEcM8x1NI0CIQZxV+5Q0J5pWcsQKhuCStcAPrC2L5djVvy0vXYtlWfoktluFl1WBZBX06E+iTVtEnE/SZJIaTi75bQS0RU9KhozcKWY6OTg6y6m7UQnYbdoHbrL/97Rr5JDqbnvyign9wK++Va+oZ4Un0ZABpRYpaymu0G7uL3fREfGQYzFREZHTqGj1BFxZdbdt8pfcAQ6wt+2FqcxocPgmv1DX65+1pfjxUertktlIZ1LknMxUXywllRi3UWdQMoLGfL5pmnvJU0yGgHPcffcxgvDDWU02HgJCXLNckE5yn5Iw8hcw/jX+sl40dysEw40M67TQN/qbJLFU8dS5C4DxNgh+Np9DTdIe2V4vQF+IXzq0vmZYgA4yx5gBdjGJyLeZqTdfMu8f30bppEhwQCuzedbMER6hRdTPt3MG0DRcl/pHdHjSwG3AONSseTCuXNNWjoPFf2tV9TSj7mi72NZgbT6Bz7B7oHImDBMF4wniUlsl+6fWP0I/B7spRzF34+OvgvKBfMROYiEkpIUl+/1rs/Edt8pEP0UvFWKAPIe0LbAk4AcFDhMoIhwjz1tiKM0vFRTLnICFSxHwo7FWrpS30HaUgaUQYnH4r5NKZvZZBfsUZhdaEAiSkwk1rvy6goKKHHaZ/FHntiljUnU75BvqCKTzevAZfcY2Rk5o7H9ACLO8o4yaWtDB7ULVk9fJWVy+KZPrW0rfQSK2NgFCXAKM+S8nEPaPcs+dc7saRGvkWDZpM7OGoRrOzNz8wwXP28q2zwsda0zAXf3y+O5g34cgL5CyB7kuL6nwVBBFQAOAdv2qsYu/sKw47s1fcXIjTPD3fVYWPFGJHjqVO/7ofgMVbGD0eubsF7A+Z5EIc9GLTEA81qIcSPSKiIHvbq5ECcZ3Eq3NBUe+DkA67UlWT8OwZbe2oDTAR5ZphkMZeHbaexBpGKiG4am1cBIAJ0nyR4GaoMpJ7NWhki8d3TTQlfIVDUNat5Sda/kEfOXB0V2QoHWIj6nA7ZInokC/8AIptqdRIK/c54F/aA77CjFdeNyq9SIW02GhJAWTuZpW9qBXKRS1NtJF9cqo5i/zjjmrYE4XM7q3TYvt7hGIofZlipxyHomIz+1dBc6oqt9+5qVnQVWcV9CvOKmhWsfm54Ex+jhrybNVIm/SoCev7Jghrt3qk3p04Ud87zeRjwZ9dzeR07VHbfdSjpyqhRUsMof25kz/L8kfOTcNNzk298XNTmGZ4aPTc9MEbqidZen4jp1fhv5Hdz6/ccLxzq79EKms2B4/kJlJrykWk1sg9JAh9X6IXglpX89uJ7iB9ko8FvamXkD6BFAr13NBdQzpavYa0eZ0n762p/5IXQiz/+Pts+tDUK06oK/vg6ydvOH1YDxKfN2lL2O+DTCqvUDIK0DTUka7OdTAMeWC+oKBqaPhRTfdfn5jurcp0x8tx+KiPPHo+SvFidHq37PT+3qoxj8cCoiI0QBIfBLlf8ln96iA8Qk5Nof2zvh+MWOAMJi3xB5vo2AaZWvDxs48qBC0rpzY0pDWQuH9crgFhvoR6N9JZufL5bZ1X6kRtF5Bds8mTpVXLD7KPoXzSpOz38KL6cAtjtqBrxseSucdZuRJUwBZupzSai5ciVkOGdVw8gXPPrphi4fZH1s/d7tHF1F37dYvpRCzAaNDmKdMXU1lJRdkKa+PvjK+om2u8/tUJNF6xbrrav6O8z5IUVs1nY9+PPvNH7smvT0pzBPd+kDwMgtO1w3AAkmVM9nHQYIZc+hcnupdw7F/jXsKxR3ov4Q9G7yX84cS9hIMZdqBT7yAcrT3KOwifm3YHAVVht/kNcxfh9ze/i/Bvp9r1R9+gql0fP66GzSd0YXyn2jjwNlfvOjM4sXrX0U6p31UTvXs17VJHnNXvuufx0+/C9aX+0QzLzx1Gx+vGr4zpeHHiiJIXh7I/ObGS1x8/CiWvR8UDfPKxyFI+9U1ZyuMlS/lp369c26Fp9t60JHADE4tMl2qSkP2ZqqlC9HK0g17AeZPaTrxb3jFJsk/hK9xGAp9yD8dXPMiy27RjnYoB8z6JnNErVUAGhhH5ysXDis3kSG/K5IGtBOrBiBma2iJJ4NrQ9QFF6+7jwQWI9tximnvuOmJ1d+4rQ6GTrMJQ5NNizcxU3WpG7wyZqnHfK9OI7Zar+zTnigIT8M8VaF15+Yy+EInBSzioEpqGVw+v99nXgyFeP2te05/xAnX44+Dp9z1nhkWtFIosZwKoL9i7bgH4OZQnAAw2puVT0BexcULDKvWQu1TAGZqrRP0PySzBSAzc53ekT+A+l23S8apEaP0VVid92DOW6AO5UGI2TpVO6kUYS3Sk9pFeczpWU/RHow6zZlGkrRyJi6sfOTkfpq43xZrrB+Fe8kjRGGR/KTBrUkgg/TYCVrmgdAijC1RnX1uATZ1RzcmQlJZZEZJsXdnUjfpZUeClh/1YF6tNrtr1ZRroVgBTTOl1P+pzedknRJIQXhBcXt4ihm78FMt5VXN59Uq8WlHE4YpYFKNAZfOMeWKeB5p+WDj1fhocNVhAKf+qIQbUrTCTT/XKNTOKK/dWYl0Q4gE3FXAY9VYzep/tTY8OIkk/qULkoP8YQRIAJJGApL45SOqPHSRo64lg8pN+5GByshBJ+9kIRNJHCZHQQCQEROqAiIqoDURg2NACJOw3NwVIDICEowAJK3ezsBnkRsISiLD7AEx6IsB8dRpVPMrwKEmMNN8HrN1NTXCDR7L7DfcWaWgwhdJh4QhkoqJxiTEYtlGEQ7xn68Wo7y1bRcN2nC5HZVWPY6Cr6xJ1pIiGlU3fHRw/xJo8dIWMF1fj4tYHGFwlrOvp5Z5X7bq/t7L6kjfQ5q4XHOb6vAk/NLrma18g1fBFPR1ODz3TU98RxqF4gxdAIMQFhmWBsNLt2tVJKzCp9pHfuBXfJf8+cTG54JXiJ95Adfg4iFXu8nyf0YJqcmfUx5NvkPqySRI7sfhjhXKuAkZcMdA+zEKqHXcxToaxqBoTjdEiVqTi7/3L2uZow6ukQ7nJXdsTaz+eKYjRmbGf3+Ub0UZBMc/RC74U88J5ivKysLVUYWX1Llq5LcCAK2TUvYydnBRmf2ut/vpiRQ1PMJGAijIGxq+YJymepjiXZI4/Bjt/Ipdkyhl/zve8V+rmks7zCSE+Ks5w/qxhtdaNsFh72aWhnbBXKKGzYOBGQrthpVBo2C597NTHWXggzdPdD36NZW+4hDno54FurG/ywVSf7x/kJ7445GvBh7mlhzXMeeDmTMKcjjxa+mF9Ig1PiT/dv1nKnroHeqtWxlm08tv5iU/e5p/PfxLmOBu/i/Ofx38avpPDd/og1JLX1++14rfqE+keONwNH3bK09vhI9btZUPdy0YYq8DsnvXGUqisEgUylrgVJyYeJZlihCISwX/2perWNSi3rgFedfOCrSv/V926BsY26ZSrSQdn3dY17A++MmadTwcPrUCDsy+Xu9Zws13r3z+KXev/eafevjiZne5SC20YFRj+ws/j319bR2P3XwxpzaU4aM1Q9Ga7uaCymxNLT56a91zhzz8tr3+kJ0CyhzuUkT9V2PxgB7AFr1hTofmNsNnAzwfZsh946BEDzSAfbhXwqe6WXyZ3RWJWMIg6VaIEo53ac0p0m4C0sJpWr6zO9YqVGQom9nWDiX3dtFhFW7OHe+JxTl6Bv9mD44Lit3qeN/3sFbCp8i0aC0hNif3C1Nh7K7FfKWOPuVi1DiqxH5nM61qZ1ch19FGf597whnHhzs7qAc/OiQOe/Se8If09L5TPguzGNzzG+9FVQdKr3/AoBEk/928hZR28YVLKqpPh3+gg+MgbjideHaqt9x++aAbOxuZ4L9KS64PRy1N+9/gKoV/u14oojyGwbIljpLqWoZcIjx3/EiGcdB01lwgRvqsSHmgY5xJSSgoPGqy9Ti/OGy7YdEFkOJZAdVhsZeVtfhr7rgBMN5/Bg9Tuxll5hmzRGrLgPBhvoX1DGzKsqMUsdfYLAtCsuaA4t7+Yp3kMteyQ8gWK7J3DRZpFjog6xH+s3jKPDEuw/7lfMy+7zF2axQXFeZpDwhbKwLzmK9YIdl/6z/6WaB4W0wQ/u8CFZfzMYdSW1vr8au4lLiJ6oUzbgrQFpHFRLSCw3kvcQKm2SIILI7uBu4u3ZT0uqIMy6v1Bg9WdARR+brVAZr1Pbt8SzVC4VmzHnUTqe3kO/Vd0oqAVDrDBlS1r+Q6apaX9iN3Jn5wS7NWOaUkUccem40OY0Rzh6QzDCB9q9VnMZf9T5WI/nSoX+E6D+pTwQkt0qrkgGYm7KL21J2bliWQ7MU9LuLLHD3tlr0tzSF6CBu6C5FnEpR29srdIOc1LtnkOw4zrssw8/GS0/QAGAdvkU0QDsivzGOUlJEVBqCDG6BegJM6CwizfJc9afrqCQszRzGHEKWIeGjXOrT3cFHvJpz/8Je/hBzwDjGwNiCd5EtpVTVKjNHPgE+f6BGjR/5+96whvG4nOsWNKlJdLWUQhSLG8AUWxk3Iv8tqit2/qMfej7DR/uaQrPUcfc9Qtvfdeb+nJ3tJ7771n/jdvgIEJSbS83doizBsCA2Lm/6e8H48TIC+giJkQkQ8M+1R9043a7KWRe6F+1Dq0kSHGgU42cm/4EnUlcs+AUvk0/B9fjdCk8hQVjQNPPwWjmGr8BGoM82svWXNCPqAZ7/MuA9R9HAfzFTgX4ipickZUwcPFfWpQwWxOwfZAPyeeFh5WnNUi+WBKTZuc/c8/yDl7htYUoFzAzJRKkzy4UV9fp//82zkq0hTpqU7r+2kTRdLMfDRAesAf4b+4mNa+6TcAaNuARRqnH6NugSN+8q19quK8EU1pljzVHiGnj5tIDoQMVSBPd5wMHo8QuhygXbvz0tv6oy4CcrtUQJaCG1JRiEYNbXDmBfQtO7TpTKKGXDMCOPO1uclWNeDiAGP3MP1RoGB+CbZnbQ8+H48KOABqBKiZHwkCAlY5ZrBrwIBkLEnAb4tW1eX5OQQEqqv6hlcNmPqmi1cFoOS319U1E0PKvxt0XR/xu0E3eBmjbgKVOuev19UtvOPAvZi6rcusSMTobXVTn3ebrmMEvMMlVSSq8Br6ZEJUYRndUaAPa1+kFN2mMtGj+YF+5VA19Vfr6UJadFNt0y3VSPqrmDSYGgQkAcTc5F3kgW6SI+wszHfs5k/m7dIStVSVAx63VU2X+BVKU1BVKFQe1VC62b6Ku4M+VZI0BusKUvGAPD5OgRYQwOiCAK7NoECTR3IB4XjGW2f9WjEeaTTRYBH3jPp4jD8Tc+5qvCuQNSSbEF87I87+B8l278RF9Pnq3y/GM76Tuf3IZK7Gk0yRI+KT+jQ5qsgpM4uv/vti3DdFjpE5MJmr8TRT5IBwEq50iqwAfRXycPDQLsCrDxeMP4evBSGziGauUsjHkGp8rNmX2ssS5UABohyaODRpm9S+BkZjvoNRsYcze0TZeME7abwgQ24D8YKMtbuMtY1HsaaPHg9Im4Bi7Ou8fUZiwcAQ4efrGoYdDcO6hmEvC8Pe6WC4TaRqpDQc26pBHdWkumoBjnh4VaGS8qihAg3UiFq4WwaKkQPRIEkPHOhOqWDGtHgmsB2h1caC3QkFfNxF5itZIPepiNx7NKUBEvdTWPv7cdWeA1wVaUK7SAD6FrhFABdAHTHyBYOLkGcU4c/UAn7kQKlKU0a64N5CqZp+h3t0X+fK1b8v1BrTK0ykPMBXaWw4NKVJfpHCoSzgZzwK5AO+ugzgAxwCinCILPxDwD8U+Kdwx7FEDT42qMnHJrX42KJtgHzb0oHIB3AVDoraOLSpg0OH6nR3X8O1B3L0aB3XrdOGDRG8hhDBPRzeRhcMoCtFN3WqiAFatZEGGwhl3SaiPc2EOkjBqXWN4LnmxIbmxN3Tc4Ke5sSGCjUfapoLJeqoBq2rJt0VXlQpVIUcbvgYrI/ghudww6eC6bbJE15EDi9sg/qCgwEZSEu+YVmCb4CbMf1tn/45f/4lP/RX9+0RvS662yLmNna2Zo+aaAyRuMhFGySOyeZOc0aFAQOSUGpCs4GlC+fa70e7NDB0mblAlMcZCawNU/jEaWa8yMK6gqnPIqwFusehW0L8qkB3VdAtnfopUb5BhJ+laJMCLuuw6tSB1aF1WOt0F9ZdDXYC2Oe4fE57NrzwGlYKHQ0xhrdSDrabjO3OI7OGamtEb2tE98xkQ4BJDQ3bohrgiI6V5xDbCK9WVQ2/kHpmHoGHVwVnLhFgLuHOH9xOW8A4EzCOXJxJF+y24CDpTqXppP/NtNmUZMwvLttmaKVIWsnn2veXHIq3iTD4Nklxy8FqUQ9WjxoovUFtXNCmjrngFl2jO58X6z82GBGLs1t0h8qPVJmnvzdVga4jGPE63cBFdg7Kfu+iMj8eh2nyEavU74Hai8ShTTyxiYMVHv9VD7M4uko7jx9pCJhmb/BM4RoEZzJe6uYbpj/SDXiTtvnE0HwZI9Sju6xRAWgqE/sQSrLkivRlaPfQrHUqupezrU9lvVaU5i9QTc99tLGnBtooaa6wMYW/CikGBo4jM5pVZdT2+chDLsY5PLRmNcCBnmFmh2xchcfHZxjTMJxjqEZiYj47wGdjMmO/HtZsKbB+DZa+wFg/A8uOjEeO5jwdjnESGiC5Mazf519KX9FjAD/0Bd0bc3tHxqti1ir40MOHsTgasExhvHJmnzOnzuJwyhSgItJYBur/1MCQLF0NSWykTwNcbzupQENeFfThPFjACzbMKrfhNjCugWrSnudUaDwkq5o4xmnAS+yIHQQeD20IhbJUVRUAIxnd9C1RDHnomzxZ80uM5RZVjYcCxeIWK2bxFyX+B0/XChWkeHk08SmcWHzq21k1vh0BYkBIXeKX1wMqopMw984/6bPlpD0KjJzimUrKeoIoxLpYewhUlZ1RL6nI1Kv05ZZYD+MGdzYI2sfleovfl5hljXyWlTIsq4FdtmWWYVnJZVnthWOZRdJHimUNYRlhvGg8pCbbczI8CKV5NZJVLUO8qhDPX5J4snO0MKMKHFYT4oVMPB/FOsTzlydefvGnJ56XnOQtEM8WEDkFRFKAZz9zrovkuiglbFzhFqHKInNrlrkh/0jIGpznTFE8UkN4y2T9jMQ1WTCf9RAY4MGrtV064/ELxWNQl7Eh7D0bNk8YNivLDJsXVZQhX49PqjDDuLZV8yVqGvHzHFioN2JtoFdNJrNNfUeey5j5dUlkjhL56AUKPJGnwkPMuLmFytIVBlSjUDut8fop7Cr8uFQTD7bNjaR2AogBj8FZb58ibbBf31T4+T0jeQVo4yp5JhuPgWfVPmtxdnv8/NKmooU0YJgHbM6LbFyeRxocct+KUAM3nH/BF7JogW/2OIESGSShhqSAK6aKi+qqLuQKvawumyq+YBzPUCG1cqar2IpuOz9zqB6kL1IMjWue789CV8TXoD7oAv7KvSFoQsvCYYvlTPwh8xYRPaDhYRr053HQHxXMLoVq07yWRAF4TZvOpgZDVysQCFvsrMjrBX+9u7wefHBxUQ/+2u8/UQ/+Z0cD/mMn/W6qB6MU1h0OIDYYPViSF9NkcsInRhJ+932RhP96WUn494tGEkav20TlvGeS8IGVhM8k4YOPmyT8bp4kfHAmCb/gkvCBSMJpJxybpCbvMZLwu6eVhP/6YyIJiyv3aEm4kqspFDFiiCRcOaUk/OQZJOEnzyUJH+ZJwofPJQl/T54k/D0fqCQsWrAow2eS8EdSEn5ySkn4yXNJwod5kvDhc0nC35MnCX/PmST8gkvCTz4akvCT00rCh3mS8OGZJHwmCb9gkvDKeywJY8kVpJsTfECSMNzT+U5uOKvzndzWdZ06ub8nLQXVlnFyHzy7k/v30xujOXIk4YOvtL5FLFq+9ty+WbHA9AA4cXercxwBXkEWafNTxPxadoA/kfP6znn6g76ct5RPHO4M1w+ORReoYfzgYIiKMqrxiqMaH6Tub1jHuL/lhwetzxIo18wU9/QF3APUzPN+n1/C+y2lW6cDSq+cWLp17yY1n2zzFZhbpVmU6sH8+GYAR4f2werBkaWZpdjyOtLHhGJnFGsIxVLJGDbgayXjg1QyhrUgGS/FOh+88MGLXMX4fJ5ivDzr8kvPZV1cyeEdYCzMiyg9ISI33zLSFXwdar5/gu8ZUc+ImmrCQs8Xd1CsLDMonl7tXVlUe88/pfauHKX2ns+qvbBz1N7zi2rv+UTtPY+yuS4X1V7Oft/U3jO19z9N9G9R//+S/rmuklZ59c8sfum6Pq7o/7Nq79qi2vsjJ6u93/L9qcL7TU76G5E2ai9KEUnBqr02eTFNygnPpvbmfKkNdOT45SIkft8mfs0mfsYmvscmDm3iiU0cXEi04kqiFVdEK9ayr0++aMUrwEki/4ZUyWrFYBbERfIfmpOj9OSaIa9PHj6oi1a8mWjFXIGQB/1kW9MayMOCsQfpqQo9OBKtOGRiJZ/V8VmwqBUfolRb5Pw7YLEGywpsuq0pq8GqYcRk1dTlJyeZXzJpgCJ1U4C+Hw/aZssWVWU2hFaxLSmfhVXpR0qP0DGweFt9epdTWxr2++FrL8QRQfQ19/SpTsEj9Lg6l3c59flWnt3lFCOAKlhdy8cvDfmYlUhX5T5DssspNYVHB/pnvlqOVq7Hnba8k0QGmuCd0s+JDjDWd66i4Tq0ya8YxXWIYhWqPkRuV5+yDf3J1chlSGaIXSIcT1LE+0YR77MiPkhre5iI41Xqu+K454rjDdnlFCIx9HF9EH0cFcwtgN454HNCtI7Rx0OKyefTfJ32tT4e0ZDKdpfTzj71UDJcGBDFPfwJkl1OQ3mrvca7nI74CNkYFWCESs9RxkPyzDanUFixYU2qjINmIr6OMh8RNzLGY0/G41Cfnrqa7M5GUUYZH6TKeBX7R0IZb0KD3Moo4xhGe6KMGwrCU4xtTif46vIYvsxPmLSabFyYKOPGmlIgleUZ3Tuu0cQ8UDyithW5x84upDhBJeo3kU3upPuSApAXUCTea6Aej7OF9B2Cqf6euZr4SBeh//wVi+BIz3h3VJgonXbMR2Okx8nGqXHR1nu+Jo5qSc9AxQI+/NzdffIBkrgAjzLtOBumImdE4+yGqZ6d76AbKdlVxrYdoHtwp5m8GNJ4LGuijDR+mVrOmNjkuhLEiTTug4joW0JI402e4/04tHAgCBm+zZAVWNqlENCWiuMrPFBdScesq2nutTT3epp7I829KUmgdZtWtf59zuxFqb/eHSukM/hUwYxDatcK6b+wHt/FUf8g+ytGSFcipP/auroHIf2QL+yjUvX/XV1mXyl9Xp/uou+4zyV5IqTvYsDahJC+qcc3Fma26J4qyWz7ivLoKlebTyU0fphs9ocWc/b+s3NhHHz7eqbdEbOLW21RF7v8bTFmkSadtb6P1ADTtsdINTBj5NQQczVOxfqrdPRXUNRJV/cwhsaI2IiNUWWDjFGnvjYGxiiz0TZGD9UjXXPZzlJjn/uqohGgQjZGVCcmL0yKx+TzcWZ3YavRiIrGgJyHQmhMRezltWOFlokGOo0WiclUjPfwZ27OXYkfODu8+TQnvnaHHjg7vEVyF3P5zAowO3wXc+uJyVyJ55niJsQnzWjuFBcYUuNLg/JWphyb4vaQOTKZK/HMKa4AFmsbXYpTHJClNHuEeBiAqQOydqhryFrCvL1EW8jcos2s4n4/VdwZm69CcX8V2HxNH/SY/7ou9g0N0YZA9Jry6LpAtPGcEH3DAO+NBKKxznqNIbqlU69zalOnXuXUegLbSgLbNxPYvqW/3oBhO6CKBSeMNy04YbxlwQkjFnBCPqMtY3TY2DRGiY11Y7RhWBKQA+jSAqDJBXQHhh2W2zACNmYG95FAfUegPgEC9ihgY041Pj5A5tsWCpGQIH6HZjRG4tMsJcoGrDs0YUrgcyT4pJlLEAvdIj2g+ZG7to7w53iyzDJkqZv779HbGbLwme/QpzEB88myR5NFslQNWXbkKSxZZoYHI/MAQpaRSxZhCV4hOIEsA/BiYMnSAFka9AYyNe6sAr8LBX4dByjw6yAGVsKbmhhtIcYNXeBNIUb72YlxySXGpumvMUYYYmhEalCbHntTevEhYMepGCQwtIHcySQoWXRHMCy6q2wM0u66RA1hBAyL7h4bJIxwoN5ZgHrZhXrPhTpDIbAdONUE5aGDcttcASZDZMCW7dwtZB/g89yNW9HugMaM9nI2bn1bf8hINPdj2MzJ5hYXUS/UEdgIA3YsAyYZyD7g/l2QmxkuCgnxhAE5kD08NWRF2xXItoGjtt2Ue93q6LtYUTTMqxpE99A3WngNeOfWMR/RDxGg0yPSsDZw6xBRgwFVSvrXtlkEkaKyHdUDNjoWZ31tlCzOYPQEZw6AqgsAqrsAihhAiz3i4uCfjqO2I+PeQ5ovW7M6u7hczcriRWp2gJXtgAiZRA2TeY926f7nxfqPu3PrPbqPSupyUUoV6C4WTHfpFVxkJ5VZZdyznpGCJA4LPAYrwiKb7tBlUb1R8z0erXeheveNDFAyqrfM1KQJcCPx9GM7WNQ2HAfE3pAyRBhpB3EVYt0v7VCgum2UkTaqplFIjY3/P2BjBi9/tnFMl85DWjynkI8PkIkRAM4hiPpoFfDIjlcT89mv4TOQgseyOfEwNzef/Qw+2yMMeqiktBT7ooC+wFgHsCy1ZJ62SGzTBYxM4b+f3lheQGB/gbfPitVhAck4YIf/WGosZG+CuD2BXyfEi/3+3KFz5ogzZ+kyEABEuog0Fnz6P1RsJt4ooDGuMxqQJ7isGe9sm0qWZyH0GlkX61Ph/+EvZQSwQEajmpHACE8innUJqMr47WvaUDUZimQhL47gbYqA7DQgsGAWdDXDFy7dW/Dbi5/gpNJtndrqTP32oblVmkUUGr+9bx7/Kb991frtI9YzXoKbxJkDW7I8jHssZveoRP1UzFbUy2dOOcOcKr4v2LMMc8ouc6ofPnPOmNMT5miDqPeQSiKCGXBXhUwan6qeIVMkZAqWI1MAuAcW7hEAGFkyiQgWoFSHTMHyZMovPZdMsbdIJ0GojKPpCTVy8lOixR6YG5K3yLi6q5TVaU0CT+WVbuEb9Rc16h4RNGofziMqnfHvBeEfKOdKzy/wEOYtM4RdVLUMoYhP8pg1RnouyRIglZ476OfsZBErQNhEZm7aE4mgR4FIz3XqWekZdV+W3imkOlUd6TliT3FdnL82t5bCSqRnf59qC9Izi2OAHkXkW+nZTrqL7qRbXrWxOkLH2TJflONbWJXbJYQnOMcNRXrO7plvUeJqz7eta/uOLuW21p5vOdpzeIT23Eq15ya+7vLas5+vPbeo6WjPflZ7nor2HILCNHW052bGzw69Lfae1p6/ffdlG2n88lde0Lrzp2rd+RzrzkvEGf/1ycrzbztq8y856Z9IlWcuJQ0jPinO+PEHGme8clKc8UoaZ4x0fpzxSl6cMapA4oyhrb5HccbvolQu8tg4Y5GOWcdsGh2zBQHT6R3a8o3JSGZKSXByLMHJnTQ4eQuKkOgYIZ52WwKS0W30OCAZuX0jl13kUA1lk6KTPn+YcpNaZnVbk5DkFtXyQ5JZdT1dVHL3mKjkRhKVXF46KnkkUcnjk6OSx0dHJY+eJyq5BqtG7Zyo5Alkq15We53A4SH6F2NY86HPQjNtw4cz0RHKUzyFPBEEroCdOBVEH5cfIxrhC7l6QbspbVEF6mtFJhPUIUmOTWCufS1uiwr2lTgiXOiJCBvbC3ZQB+kFF9ILmP4YVZ6KTh7moCwbgjxCepREJ49hjs1HO0jvLB2dPFiMTq6R1MEIAZfHPuwMt8t/OqPOViiw6mxAaxjKjG+K45bLmJGUTVYX4mw3L275ciZueXJi3PIkE7cM+9nilq+kvf7VNPdamns9zb2R5t50YpzrR0mzP7GsNNt+SprlHlQ1JMYZ8SEN1dbnNVxptuJKsxuQZjF8KOI40nuqk0izFbrKleYZRSdI/PlortS9vxA+m9G9tnGrddqGwrXOMyakWxwahVSXNS6k+qxxIdVEN44Uz+RintzF1DeLWp+NpjGqMNLlLoyWMWrU0EbXGGUYVhJYQ/UsSLOerK3WUr1qRDWjVwUizXpZaTZyvbOy5shKs8V4eqw0O8CfoXX57zkuXI+GNDXS7N7T8pD3lDRbzEizU+uAH2aKm1ppdugU5+dJs0UrzQ4caXZ1GWm2Issh9zXLGFSNadtQtYN5bSeN9zxWmp1Dmp0Dm1qxgwL1qi72NQ3RfiLNVui6QLT/nBB9zQDvtQSiPZ31gCG6rlOvcmpDp+acogS2KoHt6wls38DPlzBsu6QsOGG8bsEJ4w0LThg9ASc1tCECbMzGhtVpYZAxtmBYErQcQHcWAN1yAR0zoEWv2qJElZgZ3FcF6jsC9SkQMBD3wZAiPrJi/6aFQtVKs29Zh8HbGWnWox2a5kuzQhBXmt2j4XHS7ElkmblkMez1IIhnyMJnvmX02kE+WQY0XSRLmCfNFvOk2dVldK48snTBi64lSx9k6dNryNS4y0izZKVZAjGULmJDE2PLSrOIVhRibD07MS65xNgw/TXGCEMMjUhSTIK+ThGnmoAdp3oggaGNiDVt6lh0V2FYdIdsdNPuukN9ywgYTcsIGC1hhAP1eAHqZRfqay7UGQq+7cApEpQHDsoTlTOVZofZzt1Cdm8JaXaQI82+6UqzAwObIb15rDQ7PUqaRUC0C9k97t+BXHe4yJNm8yB7eGrIiuwgkN0CjrZoA5kbRBlptm+k2RbdQ99o4dUVabYr0mwL0FmjFkuzSMc6q8+A6iT965ZIs20q21HdZyO2OGukOm3IxprgzAFQuACgmgugKgMop0dcHPz9o6TZ6VLSbH7NijQrNdvFbLRLLWTqCjlBmkUlbXNR7SWk2WWDllmsbSFE2RFr0RZrqVgrMVsds5yVuZs0ylMu71DisVKxNsqK5hXX5V2zzTTSRohmcsRaf8HlLc1lOnke5OKhuL73kIkxwYZkoZ1clzeuSkOyRmZ0G9IeEhifJCQLI4u4vNNSbEiWvsBYB6vP7vJOb5yEZBURoMFO3UOJznJd3hKc5bwFnrq8JSLLez6Xty8u7whIrQhSI6qYiKcOxR9s5HH9Yxl5XIJfxZkVW7I8jNdYrF2jDjVSsbZNa/nMKWeYE4pYFC3DnLLLnPDDZ84Zc9aEOdpo0dpD6nzgAcX1T25A8UX7qv8avtKa8I0ai2LtGrWSgOJW6Yx/Lwj/QDlXrH2Bh7DK8j+ekRKqlcYJt4xY25FFQSrHxOjn7GQRa0LY1DKz1TXRFNacOOG1j26ccAxDVj1WrM3GCQPnR4u1gpJlxNoTAoXfScXayXsSKPwOTU4TKDzJ+N3zA4XV/7P3JnByFNf9eFd3T0/PzB690u5q0Qr7df8UsuKQlksHBmlHCNAtISyDnQsbnPDZlfMB3w4rrbAVIxs5kW8b629GoyTcCfYH/y2fEo4POb6U/MFXLvkmf1/gXDJG9u9936ue7tkZHQj5XsFOVb+6Xr16VfWtV9VdkLmpHvjG4wt5kI1uwV3VHIxro/Xe9MoaY/S2dldua499rgru//aj18p90F519mjMj+zgjnXkLjFMdKuEGwQYDahULkrvftcbm5Elbq7Ghficp1v9/dHEtQldMpJG750PK281zlHu+Q/1Kv9ogRvhcnQ4Bg7HxzX9pE8DGkvpEFpob6iW65g71EcSHfEGkMLVbFxkE6rToQ5p2EDl9496ufgA7o/n2H7+vvAOJoZ6sfQ7X2+JjUvBt9/WfCl4Ki69JBs/rt6U7UavQ1QN0FCRaHZ7dqWak7QvksbanjMfH0V8veg+ehcavEIuXpnNBA6W/MpPXOPmqla0VZPyoQC4pjp6Q+4e707r8ZMQuYdp7uYcpxAzb9iZL3CUEBsd4Cd6L75c3RwuoWDjJArCFln3aC7RX1gVhPWMnOgv8ag70yEVdCXMbFAIZQzQ6/hnaIycUfQLcKqRA9VTbsThFSgP0XzQQojSh+MnAVo70Au8DdJF1Qlu7AhGm+h7YJCCOGQAI9HjkF0qiMChplzzChWzlr/NGC8VPuX0SqvtQWX0JnaQ5kNV0Wi97LiiY5Hw7xH2p9kxqeKrQnswWhjwAmWLdkAu0hFikzY/h1DKzAO/jHvXd7a7dz1Yeuzr1/2xJBiLPWYtEAUnbpLc9ev+sa5fD5ikV6zLHfZQIMQTx4cjYdEbj3n9+pv0+vXbDbofmkAUqKg6GKa9sMglY3BnDpGND18BvoB/orciD7Cv6sdOMXqb9nebnQxeeCzKI/grXtbpUREEyJ8p3RV54LJD260hO/ZcxSNW9ZCj43tSrH74x3zFPrIrIoIvWnh05t4BRuS+fynW0av9RzhPwuEbDPxvl5YzhEwbAxAii45KLTQp1EeYDSsvlAzaDu+OylF6qw+d1TmDC3qzFIQeB6JPBlMqmg4PLh4Sw5k3CqwMSynCUfSW3ICSGBlX4e/IxlBO0O1UD9/C4ol+dou0a4IURnU7P2GiZBVo08AbPsWBV2e6P0MDsT6COQjfvEB7USizKGgReZZG5K9Q3+yYe6zM54VqzDQ8YCZmEy9vEbDr/WkSMOAhbkgmjA0m3Kz6KQRuzcvjgFFB5YaUeU9me8WfPvy+LtEKjQ7C4gaB6fB7OvC50s8w8KGrq9iN9qqm5q5cgTpGKjLgBkT0ET8tCRnAZ0c7ZkolB5LV8Ar5lW/0FKfzSTOX/7yJ8ObQDlNJEBe5mlt9OWEWNqYub5EXWTGzYwR7oWeWGlgpehhzUuyRA4Q2Wh2/CSM7adoBFqqbl7DroWVVwi4k7EPCLvkqYddKWIuczWWxxTwgdxO+fvFlKajMxAtGpSkjVjWmcGzG+JZ05NUgofp4lEGBV7p8UA2uo+cVAMi7+S+yMyriLOT0FEXvtr21gv4bAYjrONkDQYfV//JGMRtdnEzDGZbAljbdDp+cJWMdID4Mo9Edkpen3xlxRyEPdjGTuFwnGfV91eOw+ihn3EPTNtlK9jLpX5g0rVpI693HpIMg2ed+fv547nkGej0WgxmalgmrhznFKnFvfFouBAfA+W8QuwdgbxD1wfetVEXxzmLVB9wOk1lgm0mwzJsXJ6crDEfFsKOFDlePviQszKIZaVXJq3HgafU9iae31/Q0LgKYifqjHPnYkk+nC9p3sb9rs7ay2bsHJfOOHGZH7oSYUlYMjsWFVIg9ZOVnuLjY0EwawGEU+z7dNISRsZWuXVyXuVo4R0NBH9xR21jdzHRuSUJeXSqNYnxykZ/b2EychprIvSXPkPrCgANnUCQpx3hnymn3mSpT5veZxM7p1S1xkJZKg9oV2FhSRklyPOl0+HG6iIiOdLzmwKdfNPxH31ySuhyQDvcLL01dHHmKG+S/T12QCeQRXgP9eF/q6uEnkpBrZz7/wYMfSd0s5CU3enNff9qeD6WuhiQJJcJZWtahfamrfNnRIHUlMyIOI/sPeT+8cPtH/+OJuz6SupL04+958CPv/kG8OHU5qdDv37Br67otb/po6qb0nX2fOa1mnlicuin9FVc+1L/poefsS92Uvnoj/v31ktQFXevExn5KWpgcf+QLz7voK9+6JHUlk+/uOuv13/7W8z6aumnmm3/6nqu/cfqnFqduSn/k+Q8xc2fuS92U/jeHo56enluWpG5KXyHMfWJf6ipdBc/ta2zHTd1k9pG1rXM/t84XTfI7RzYkZ7QJ/F06A2flYpp95PNcomvpbi5LQgZHNtiLONAnR62CJmznQMZ8RokSzaZN/GqEbunD8SnAR4+DapdsCAzKwDtIM9GXZmrfrOiwYDvTEJVlzJWpWe+RZauhfMRH+9dZVbW1neON4G6EaoljzKUz6Rw55zmvatD1YLvUkR6njF0+m5v2WNwywgdRuQvytjmSNAZAHjH4LgIhPUPTihUUB8dd+RScq4dkyRIKTEh822cJ05N8bTp38BCCSNzUdnA6jCIsFJkcTqfOmOEA6IHIJGgaryo0lwZQ+cRtTFjA4+TKVwa77COMtPRM5Is8eXhBfmdzPmw0PAeGtXOoZ4UV8YzGOjjEpHrAI5czjmqY4RHe3xz+8OTwvubwQ5PDe5vDv9cUzrTp811tknRZ3yHtDHmTwYCMB4O/VYOwDNXtONw7Upe5dm9NCSMvHKnJsNwN/eqmCGITdSHFDI0Fd6WPfzKY7kRfFV6e0Y4KYA/0qli3Zc1GBgtkpoxGu3QxnC05R43b3pKBuqZWi8yUwailYbj4MYi62BkShKug72zyMtHl7RocIcfp33memQjGzYSskmKPzFnS+wz+rBBjf9mulznbL/7mgi1xYdnt78S/u5cAI3sjEh+rfV3Q1JNw2ec+i3/hyHU4RhlE9yIkLpFHoc7t0VvfAEqIFVOtgf0ouD16JwJ2L3v1y1fc8LHfufiS+h6NSj6VuP121yjYk65drxtk1Q8sM48vqSeBzenwkuss6is86TGChAa7EM7spEwulVcwMhS0vDdnogtPsIL1pNhcvZCCOvlpLetcyWK+krvT+l06wsxTUHtK/GeHtLkmZlSXUWMu8DYZbLxgJSh/f5ow5E2csZSyInEH91qz5Wms+2bvntgXUOeSx11dFhXRu8CiLOv44Y36wF7yb+dI7orBk1sY7nmqC8NnNRaGYWLsmnWs+sqbxjjWz2GNeFGLcQ7LkOOYQdUqt+NUGoZQKPtNdGfDAlQdzluG7jqOZeh/XeZG8kOhKicWnPuyVZ1OSvaTAsEuw9Q1QuVHXV0GOEzk8ZwhoNWkn/PzsXvi62BgyMMS2ZMJhnnITNEFi3VN81cA86nV7mw1GSaRXHJfjfItpWouLcl9JGdP9B5rNvCkgVWKWeXHYP16GVfYI/6zxi1Yx59U41Z0x+us3daP/QYz7avfloPo87eKNt1qXHOz2UKuvOnhscXai5CoXUfJW8D9BV7EjgeAM8nk7cHkrb6hBe6Qhs7GsjVn8fYG1BlS4uzKF4wJT9A2OPyi1Db4xXseORNd4261llkToa6DeETObIVI40FLQphRxVz4CKdl6d/zyD19YiwsRvc0WQpVlyF+VmVr6IvuVT1GMXi8L2fDc5tseC3d+eQGoPtbBqDhTdkAhIdJA9AY9yPtjtKH0u5Mhh0MCWPV9S+SZF70t8g77eQOTLshm+1AULucJxVSG6YRU4c6vjrNVrC/OxErmN0lQqs1D2jDx98l0tZAW8T8yM6kXaIHEI6snsIu0XoMjw+03SVaqoxgrrWbJaAPNWM8BA/kgmflgyvnIou8RGwjmTQOU3RDyFpUjzucK79th/P5Ryss289pV2JVk+ksY9Ao70u7kmqRid4PgtpdrZJL6TCDcE4tar7fr/BIvsVMGP6D6/FfYUv6ymZ1p2HDvZ1sPOTXUfWr6YiPN9Vc5JwU5nhOEhA7YVK8cjAOyYeJWp5Ld8J2U156ExU3xxV2gs1xh8gMqttJSBt3wYnibjgDcYQD1CLFYIG33bBbWeBthduxwHslO8UF3o3q3KDEazXONZpkvT4t17ARjblQw4aVOKRRSIkDGoVnyaXQ2ojNWPp61xwg9fFk2uZkOofw30Z+VZO6iAm9SyPiv6sGk97ndjqS7qAzSpomGk/6Nif9TO1HGiqRPEb8yCk4PnVSH1N5V3t8yzgkNGpnpjJ7uCAzzuX0XgWlsed31aCvJldU0JOJ/dmiMbAHzWDK3WgozPuecIOJH4OmUsOM6hOAwgytqoe9yg+KnqLV8MOp2IemrW59EK+B2uaKPmT79U6jA2cT7jHNw4Sf4p4znCwXB5nb3JC/bGt+8rYTivYpifbWL5ueZ/JlxuUJFwbgmwuivT5faly6OeBnd7O7pTDR9Mrx/nmtrxzveHBb45VjdK+teNb3iDVI+t52eCvaVRfqp4K3njkah+zuZ7eE5znZG8ZGvLqlF3dkgZ1ZYJcGdmeBURbYo4HTssDpWWCvBvZlgf1Z4AwNHMgCT8sCZ2rgYBY4Kws8XQOfgSqdpablZ8J/jvoJ/jnqj20cGBcSGwf+/8OApDdmxIAP5/4OL/HiM6T98cKYvh6E1+EgYRbpNjg620gr/+4o3LOTOTTEVkWe687kUYP4R+RSGo0+rJNVI4vkLHglm+RsjLrQF2kgMptEWYbwG5+T5h/Pta80nSl7GRiZ5lVfOtrlucYxFVAH4jlwzpbD2POwnKd4mAroVuciYKsbnwd3mxuf3/Zs9gU4vDWHigRPLfXsTD1b55CTDogyxCUXLp348/FkPh4c/ETJAqEspPm08KpBDrmQFuCP/RcSP101GC+i82FjuojmcqKl3ePxs+i8dC05a3+Nm+BiGs6OjJy7Zw+TLqF52XoMhMWphZgNUFhk727KYclSAbjxwqVOPD/dWbDiOwtsXnhnMoKOcOFSgNzu18QLQHc+kAwvO++HT77zVa/+6pI651MFNYwvpGF+WErDNAzqpfYjmUW6lOs25/7xDxzpbZamNbsmF9AFDVPU1lL2SndJTqXNpbncNnfAjpJ/SUbVk+Zg7J7LVFpCl+CFCs5BM0uWtbln7zIOaLVJJ5cj/hX6IrTMbJAM/n3zwxPjC7xQqU4z1dFeQXNHaRld0WrSTpajsMeZEVoGX4vJOVmRmt8uoCpHpKUsiI5UsqlrRdNR+9h3f7pq+YOLUhfE/2Su6QqOEXNlD37wod4f3/euJakbX1AN7VcDDsKGJDZBWgZhg634glSe71Cr3zNJ5HgxLaYrNFKH6tJXlqSuGnm1zSBKulwFjTq0F1F7cRKEdgHzYkUEFUB2DYHMgSl2Do2IKXa+besRTJ28VuRitJ9sHIw5bI63/yx+Xkj8xz1nofTuZKW8eXw+HmbLHOMkq4S0mhVsTUPB1sgdr+fZplwDbVqrxtNltCqea3V4terZPDGbsly3FiBYK0uaSwUJYOZFqFv1dES33kRB87iqUqm5GHvnclZdeLkaVcTnkSUS0jAXRGnhKJhWxnNxAfPPufA1gBxraMT2KnCykotfx2Wo3NcpPgKEm8taor4CJLvd5UxkrMQ52sZHM+bgzXOxiFMBv/EqK+11Iu21nPtqbwTtoBNOavmmVXLj9FppBwhiK+qEKMysvZK6IBK5iFYzH5tgRVfSHDtUHHGkO82zUmn++EF2NJUzK+glIWji86gUM8+o//lS//OtUKpdiMwMrQZDWn6On3lc8HlUUGbRNunY1cwMeIP3mMzMS5mZlzGzWl/DX43G4vpmh0tXco4025aDrO0YSnMxR+cItsOiyOazpSvZw+1M61DPdbbxn0WLru5kQ4K+QQ+NlFaaq1gCEkNv0PkcEwF+QrpwnOZGH+GJG7yzavFonfB1K3CG6Vwavn6Q+JT0YDqAQ/vgcB1R9tzGjS1g6Dy6EHCY58IN+s7lsTs/xhX9NxEvBPsbO00FXUf5RwMp79KFRpPzIJqY1YOZGAFUIMxvHIl7DoJw3RF7dUeF+Ztg/gSWn2d70Tz0onmcWzCpF1UApVkgWjAe/J7tQKBgjul8VjDhN7elqufwJnU8rE1p2SvILrK7J2F5EUuNDbfDkFbWYvjC9yKW9vw7E+7Do7TwzmTumk6XzpSzoXN1VYGeN8ah8VwU4sTDXIB+biHLOBnOWiKtooq6cI4Txee5I1zLMhcp/YPF85sBmnqfNmjqPTZomgJNU6BpCjRNgaYp0FT+JYOmcAo0tXb+KdBUPiZoKp8caHJHfrNgUjQFk6Zg0hRMmoJJUzDp5w2TwimYNAWTfmtgEv7jKv7ZU9mKe4uFS+84Gly6IgVHV5xScBQcExxd0gqOFk8GR0vagyObw/pTBI6W5sHRpSk4urgBji7+hYCj9bT4+ODo8vbgaDniX/Z0wNFlbcDRiuOBo2oGjpYCHF16EuDoMi76lIKjSxhmXnYC4AiipOVPExytaAZH1VMBjliB1qr6aLflkxc9mHlWeqraK6HSOcw0V2GUbc21UKjVOYjytOCJzqQtEKV1cFVEl7JCdOo4iE+kdJ3wC5gJMeFDEzjEHhTlmDSq2VpKNrb6mN7Sz/zlpVqoHjIypctbhGtsf17Lg9okWa9CpjjFgboWLORYrd/rmAN219Acrp2bYQ/U+ttprV18GlRqTaNSKCoNedlKp6jDl9rNSyEQgQvIvIVRol8CRxk4WAvEsFbRCgevakDUVUeFqLsUomJ+mmcnoWHrknUj6zaAayDAFY2xUpoG+QftgatFvCsbwNVlLFhy6WnhVteZfBk3UEA73Bo2cCtHaItb3WPgVuX1+Li1LTOtuDXMcGswCbcKLIIYCxk7nMqg/4IVvlwQpWfQFQrDD2Qf9AJrbSMUyDgMCsIFPiPmJkMJq1DzVacUyZ7JXfVKKsDZQFfShj8cpA2MZLNj7gAObZAsnRoga5lNwWza2eYoiG0PYL+bdq5m/DqnuXehfqdzjFmcuUbw8ujVe8roFZ/vaYWvPnSFWtBrmKJXrx16DU8CvfpAr/olifOkFX4dkatzqpArEGuKXqeQ6xRynUKuU8h1CrlOIddfC+Tq/9Yg14GTQ65TyHUGx+j/zUKu5zjTfltBa3hSoHUKtE6B1inQOgVap0DrFGidAq3+Lwy09p0caJ0Crb14jfyXAlqDY4LW4GRBKws++BW2tF41GbQ+uwm0YkidjFpBa4KtoBwLtyIYwHWhBa6LUuAKMJsC1wUWuELvH0w2XPq56Q8vfgsnbCDVDfxwKWv6BlAvhrKo6sZzG4h13v3jDx6ZngpuK1DbCP+PiyuyHtsWsc6RbvVG24cmI9Z5mEbOG83jVWQFGNV6QdvlHADyyKr8X7Ic8YFXUwx6XgODjnwm/6dXH35LMSiyQk3yf0nVjnu2EnNtBfDNAZbv39w8On9yNQBWv2XBKgSb/7NS6bh2ab0z/wfidxSsflvA6uOP3XhJ/o8H6LMtWH3sCYBVjNo6r4J/9Hjl4bN6MidBlS1URZSOf+7+9OL8nw6n2liQIkFmFqr+HyQG/LTSQXsiSkMW+09AGAeVEYup5oE4zwLW4gXu/rPi+RVamA6ImIeq46MX8DD7rI3xOlpE86+KN9q1lqjqgmyNlYMl51tYsroVWq2xQZixVzbUb2U1aJytxJPLAAuyBJQ0jSl5TQ7MrD0JMHPeseGVTg8sZi26CUednyt69akveiWmqZVt4ZObwadkCj799sCnaW3h07Ppql8x+ASWfv6YqIdjRA1MBCC2jtfMGJCIUdqiXxRKWmhR0qJTjpJsVz7PgqDz4Q5AySQnBUrnZtCpIMcvPebtxFHSPKjCvBxKwgNL+URR0nmKkubgiv8ROlM65rocaDo/BU2H91nQVJgEkBbTuRmMGt4zGTStzoMm58RB08ZffdC05OmCpinQtPhXDDRtbA+aNjaDpucoaLragqaNzaCJW+L8hjqdr5MIs3x+45KteINtdX26smoa5i7muQFJ1jUgCYZzKvDAmcwbhC3oBCDK1skQpepj1MUcKDMw5oDzaaPFJtc0sMk1Pydskr4Ccg3LI3ku0ImJVx4VoayahFCioyIUnrhf/PNHKN4vFaGsBI2zl3eXVuYhynNPMT7pTvHJNaj3NbTx1xufbBR8svFk8UkXx+hswifPSfHJ1b9ofOIfE5/4J4VPIF0fs/8vDG0cH2Y8NgUzpmDGFMyYghlPzwSShxmrGjCj0AwzOGyNvk1ptwLXsu+EAAdinWLMofQ1KX0NaL88yLEqDzlW/TwhR8cU5Mg1QIVjlH/VIId7qiCHV/m1fKc0nDqZP3XIaeqQ09Qhp6lDTr+1h5ymdumC35qT+YNTh5xODr3O5Bin/XJP5ptTdTLfrfyGXEUw8LQ/Fzcw9bm4qc/FTX0ubupzcVOfizv25+I6fsmfiytPfS6utfNPfS6uIwVHTjtw1PGUwRH4P0OunD+DhtAqQ3Ld0woJCOxFZB8oFXCVXTARbPHT6798uRl0a49c/2UjygV2Bu1UhBMm4ZVJaRA3p6LMMjtbH2L5op06yI07PeCNjqQL5XboBaqB3CfHTrjAI3UGKOCr7cLNSTeumIO/uDmJcM9cQOxE7HBIqM7hSKmPRZr40UizPGTpX7bRD1r6gWgpF1rdH41SBwY7H2pGDmOg8aSHi+TQbrmarhtEh5gWLY0oktvpIr2dLqBGqoHmC+1ACpPpTXfacRrycDsd9VB344Y6n6bDE/fJ1aV9IHSjP3RTdJW9p7ukHz7mThot7Y57qByXqBL3Q4jMT9dzON8SJ+uJu6k/zYfbH23uQ/78KF2jj3Oe4JzXX4aMOdvtTCxRDxM513557KcIpXM1N0gkl7qqFWZzBnWd43z2J4wp9OphPH4Yj1WMZzSDfGaSguijegklwKFqRFykIJ6BKz0RI/EBLgPEH4xnsDr0c+gAdcYlHnYOc940IDXAPX7+qFaCuQ/BvI/ra/lHusYAasQpS+KWmPvHzIrYZzdCJXwwrw192CrEIetCEUDfH2XqBa1J9cuqTmRVhQMPWHevpT9gc7rL5lSz9HfYeDstfbuNt1XuQMSt7qxsXU9V2aA20CarrM0al0UT3QOBnUjy6r2adaabujfHEetc7+Y4ZFWj3jsTf4x5kDu8fTDTz3JEc35cm/MmNICUqHpK08bjIjdYRN3UN3gnJnerAqEoCWdTFFUm395Bj8YuoZ0HGiHUP0olhFUogrpFquRZdYtcjyLqAaVv1p8KdUJycSeVxS1TRdwK6cWZRZLRJvEFORbs0PU5H1ehN24t5C3cscSGMesogJdYSUDBFjtwpY/j5DIPMqUXtzDFe26noQIYHU64MUfUvzApYbgS/1BSxqAkfkoqGKwKnLr0XP4pX33TRc7vynOI5wqezyCXAl4PJuF4tE9m0bJWmUujlJZwi4OnErKiIrdwiUIqMdwtUUBliC+EfvGkGNr5q4PdYRYUO3xDH4+ucTfz20EdepWojc4YfelEHGgftv23RJ0ah/PmEgKWOQUA891QiIgzXKjZD2n2ZyB7B3fts8w5pwIkEsAZSsKNnCH7RpISnOGkLISlEyqkMoX4Ax+QkxSJarFoK5PqwRXowiinzIW2Htw6kKes0cAkc4eqbWaJ8JxRxX2GOtlF+yHHCnWhDt3NdWDmu6hb4C8ZXW9fxYFFzoS1vUOGD+z7p1dy/ovx9DJXq05bzVjik8HVqT65uCxVnGsIRAzB3A3dzUkBl6rCbzYnzOoNHMzOenY4ZLk6C5U4rDkMaQ6kxAGNEikx1Cg4v1F0uQwIizz0YS83KjCag4gMHkOMHj41gqPmYOcqdK9i5R9dU5pouZ4W5fjVbsEsbhygVPZhDYyJK+RnHkNk/C1TIa5wGNq2wuUx7jeDGClwhqJc9bXTTqDPljDnl6q+mmqZ4MUhpwzjEj+V2WfzpDLWHFRBWXYeKGEeKEl+SdmaBEKYtLhQ5Fpp5FqmIC5pXlTmAF4XRHxPd8QE+B32O3bqQH6E/OwpiEBWjDx+406wEjv8xB0QQS7KclktxvV2dERI7xhHhKY7XC8wZgu3Ec/awAoTuPH8g3c8Gcid+GYLORvv3ww/urESrr5/vLLzVF5J70GxgZPga9TaY1gae41r6R/KrqX3KsTBk66l/4hriid4KflA41Lye/lmcQcs2NvIs0vIB+wl5EX0YLmE/B7EJU8uI5dbyF303I81XUSeMU+BrVJBKoILeAvgIWNE7se/4UXVgU1cTeYzwETkoTfp9ONa+SFdB9KLL0yK820OzK+rN38X5OZvdgLEE8eHI2HR3+duPi8233zeXYk+ftvJX3n+iZYrzwfyV54PtFx5PiKlaJMYMvCwGDjZjWTGIKRjX0veelO7XkCs7dh8AfFAek/5q41c1Q2RRYrqWI0wymA03bzUfy2ewnE8hpsV6qbnzpzYZZ/BqALVFCMx+rcr07rcrM01VAOxXv8NBSFuTyqIgpGvt5u/5tTxgCGmiYUQLOx3mnjg51YmPmRcb8IbT0WMrpR4lqXLbR9AjiJ/LgbFp0ccWdkyL4Z0j0tCRKc6gbTcy+34lzAaqfNgLXE62scBfKlj7jbSu4LaHeRJRHI27a3XkgJq6MEm4KXMb1QBOpeJGnqpRZgnXl/l6qcQAQ8huodfgRd1RbeK/kEGEPZDKJ7m+tXO0J0w47x0HJdb0G9u3H1e8ybdfb7dY5fVeAdcznSIjAJk1KfQEM7zk+Ai51bEgd1oFL11v8ET6hfae4+3ufjd6jK8fTmuLfYw/3yco2GTErsLIV+jPFrdKyCVvKWOXHXOwY86mKg0HnnRx7Zbozh5Z3k3JCXhYuu2udUXsphSNpXD0iJvJ+cABLPsK5u/+t8Hf/TRi65j/xvdobPPvI0uu/7FL8aqJ7zI2Wew7zCQlDg0tQbX2LfV8J8Y7T3HuXExhYNJub7bFop/L+zkGnCi29+Jf19ZUqcS5QQziGZ9wMpito4Bvs4XlU1JCDm4kMN9RitKlfvJv79x2/xslXdFAAI/D5N4o6++DrDUR7ZnAX4A2TKQ3ALfkPjGP3hHHfW/VvOqQLZUOcu7Jtq+TSGtR03NVDxuMx1g8Reb2ogYWdiaf2BJva5NFP0zmNuDil+jF48/9r7GxeM77UXjH5fDgQ4a+VEJbTsKe19GmF5RLplUNMO9/2+aoWaxHc/tskg6OZPDaSbz3ZpGTK1Uh5fwslBJxDHdv1I/ikMR9kb0nfBirDdoW3K1EtFn0LVwL/db8LhXNjYN7AGqDfjHMkGEnRKBFSfpWiY687nPVa+DsnY1tC0aqUOY9RqFe+uWNnukfl1scP8983N1VapBvra421CygZF6lUmHEFpH+4f4cbZ8wIZfPFKvLTvn0lnf/fr8mUskau2Lt2zn9skUnTLv9YMN+s4RyrzXDT7pJgaAZvkgsVt1Vg5G/4qGZva48z+HPEhtIzuOXNafF/Fy7c0j6ixUZ1jv9X/UsMtJvgnXq97qsbb9l/oXsvcx9Q6z93vqvc+w/5D692Nk+Bf1PwD6l9V/APSH1f8I/AfV/yX4P6v+nSjpgPr3Gei4+g8izn4dDuKSMtchIduR4mzxHkKkoays2Q0uqcH6rIzFAfF+Gd5e8e5AVlFWXpix6ov3izrmlRqj3mdlIVqSi+Mxb+zwEjEPcCD3cgf0YULMs3hJBwrGx3N4UNbpQcfu0VyT7+E4FY20z2ik8LI0pm/nLAhgiAenGCtusOMADdTlvIwDaM2JYLAMdTeaJ5AGxqqG0RsAV2JHhU2l6BsYefjprbcxmFFqdDvi6NiHkFsBc94lNEuNvq4xWAZ/ofCnGmnOVI6+uG1S2OeN8RuLQG8stYBS0DQzBUedmV7GQ15Sagx6Qdu5KcDICYczGEiKVQimiIdZlw9qUp8CpHKgHWmqguaGZDwMA9ggyXIyVtbkRx+SagXMeQrwlxvD2CWd+MlEnxP06REmHuQRfR6EzpxUPCsVQyaVCnmVr/o+Jn3DWChbwRgtxUIjAQ5VA8Vr6ImAdEeBhipHCLXwWHM0oCNFIHZ8MnZ0/CHGhkQE28sp4A6wW4dnFnuix3QKw3NE/kUOGHbRa0x11mj0OEI1S52giHmLvnBbgxr9p6Qv2Kf/kifPPv23PAUM2zHe6QSTjsOJC+8h8WKh4a8aTLfxh0bSoXftSA0pZfpJCjwuZ6AAjzX7WLu4XheCzO5ac+1AGc8HtcHuAESs1QAAtQ9bOTDZw1R8XeIOJkXtt67th8OCRyvLdr3M2X7xNxdskcYo3kGF3Yy9XvaWJaPfmfcPdL2abMHknrigjXKBNArgZ0EXk4UG/zLvaBUshbPbww2atnKMNkwXmODtmHjIGazXKu91eV0syhC7qV5wlaEyKVa1mTcGoxCq5i7HcRmZOOwqOmJyk8qImKJ/hAzl2dKJ3euRGHLnZvRBd3nEJrMnMcuevPvxf1rzgvVLqOHliW3ZH8u/b/OkzGI+Pl9gw2adYZzEcNpmXodQtpFGZUoOHGQZ8nCaljS4HBDdr7y3yZbQjLoxR3A5UvmFsfYh21PiAnltkZIsrmCO4mPjL9tEXvQT9AHhT3OIkAMyKuichrLSRTp8vaO6fvaRgYws/yR18DJrw+e8wGAM4T9el6TjyHCT5fYs76BJghyqMVxv/PAipyYCEUlsSoqKc+iPau7S6zudbKEVQsl1xVO0A58aDMkI9mloPhUVT5f+NCnfj7VktPkDssiCYZdKm8aEOMDEClXqtTuAixuJeduto04V6thDAf9ERyCuVNXF/opdujCpvLNBfH5nPgKCo6SjKZhQEHEx9Rr6uQ9sJJMlBn1YQXkXMUxtUkUsyYo5kaywZs3htPOFTbNogRuLAplE8TB7tPrBHZhHQbfTKKSkQW+8JT+Rgm7nUf4vnRW+HvjehLkZjZmt/7QtkVeK4LbvdxZgGVXQKZRBtIEfXTw41prhrzha9S5MeLm5E0OPQq9r2VPj0AJCo6/epvxv3+6qBSNhO842FBqAxoLCIpQfHDw+WUFGRaxPNRddUYAKaHmY0XGbtUDI3eRRDgJCfaXGvJGzARnMGM6OWc4D161Gw90dRuOvZ4cAaMUZUWehOsPsPMRxhqxLmuQarSH/Ugq/XgXdYpHqatOSeIBSb41HGTbDKrrWVceyzz1r4o/fXfufJek8NMIdy60arbwdbLQYNLWS7RRsll20Y/jrf/GqyxYLpMU036Bcl5bp2Pl4JhWw3N8Fse7ydBrWnHPQMYh+ZMk7YFzGiA8j3bVJAOf6pIiJJ2BDBqkPJk12xJzj8C4hGQwTIdhxuEMYNeBU2IkQsUJFMet4EmuRl+aQpuYenksdaGqTpjZUtCe30fk0A/TEQE1I2OEASEdrRN/SauBFR2e0Qf16g3ooR30UVCvYfbeoqPhxm6cdQgN2IgD+Bn4715h2FhxuPAC1/6+NdWa/X8GmvlhmxPX4r7DFjLduAOhsodtsqcUg4qx9PlhR0A0jdsKkeKUMO+kZyKR0Jxsd4rLsqMYVdoLNsfRjHxakTkLauAtOFHfDGYgj5r4HKzhse2w37Fa4e8Dt4E0WdoroTOLcoMRrNc41mmS9Pi3XsBGNuVDDhpU4pFFIiQMaRfdmPShTjx56giWku3k7P5lOXU17+UmvngCQ1RVpmmg86duc9DO1H2moRPIY8aPdxu3EvjZOAGD3H2YZPatHZfZwQWacy+mVXX/qQYP1UGgV1ZclL3li5X92AyXPYMq9aCid0u1aL8IiVqlhRvUJYHSGVtXjGSL6IJRDWo1/kIp9aNrqftgj0uaKvohoTXsbZzhZFEz8aVQkBsiOvnzbCUX7ikT7t+yQSWHSIZPSCR4y8fWQyX76OZ8xCZX6WGjPmIT2jImlf9nGO2jpB0I9YxL+Es+YuOkZE/eUnzHhlTqQh0UbfbBEtJ4x+biTP2OCx7ZnTMpP4YzJl57GGZOLJx0x0Tow874eMRkfTfhHj5igQjhiAvfYR0ysPhyyLvQA9P1h/ohJmD9iohoDTdEjJtbda+kP2JzusjnVLP0dNt5OS99u420N0yMm4dM8YhKeoiMm0Ld+jFzsSXh2Pa3piEnpqEdMSnzEJGh3xASanHATHXHcYQZMw6R+Yj9Zf8T+yPpliw0q0Q9tOM1mQNz6o9T/dE6ihPYkSmhPooTHO4lyd7a5jlMosXfUbXU3t60OnWu/rR4cf1ud6R5Ssg+SriClZMmeIaRFUVb1ORFSRkjJuUXIrYzcyo3cStyBysKHxxmocJGLZZITcw78kG6gu0fdQI+OuYFeueWpbei5x95URO1cNFDrnqJ/1D3FbaeOBX3vT3lot6no/4ZuKt4ZFLB6L/JfY+H3QClnKq3uCkYJtsY36esnxMu8WoDfXUFSHKuWVoAF+1rLj5fUuQN6aZVGalDH6l0BrKboITAKVeCEONxj8SXE04VmsWegAiwJ0ceokNbL44fuJEof3dRedYhXRz1owd05wrRl/1GJv3PkZz9kv7ebOX8zOLc2WOohr5bSUj4bHqndTq4X3O1eUrh8EGY2SBN/K3hYVezeCz7JW+TdFbCrHPcyVkqKrBjMopbGD0V+2P1O3vVDPA4JiSkhKHsDFU1csKNKGfG7CRaZbqnldUn3YFwQBWUPywA6WbS9H6UwrReq2EvTQcNBsE4mY7KkkJHFtBpXloVQbzTJ60b2POkhSXHvntqTXMEqAzI5ycV1K7ycQ6jwUipu2pt4NShLmu4gNyw6zHTUG1wzxu4BdjnLewzzRL1GHVyyilWV5K5SUkSXLLJY4gIYC5nfClq7Gw4LUbOSyndi+SI1RAVEasu+d+XeZ/z5d/+Rd1F7uZg+kUot2w+rsUZ7iyBRDFXQlhtZ+CKH6ZDUdDuCwEwWoc7dk3XXe5k9Qq1qPt+9S9skXbsF3BVSHP1618UaDFi4ccTFxZpIuvpA7JPhBb5LZLAAGGDHAyQ1VUfM2IhLEozos0BzYRAgcm0MpD5b4w9JfPdsECT+EGiuxnAlBvJbqGWPpGUv17JHtOyFmtcyLXu5BCP6MtCk7OWa1zJN/WyNv17LfjYIEn89aK7GcCVG5Z+MCU/woNEhJ3/SqA8HVA7pcRt74EiPnfPglp08QiI9ehTC4pIePerTk0dlOXlUjL7WdOwo+hc1e9jtOD0rFH1diC4KwuM3cseA3OZjQJXDZb8wbuQURDYio+9j3EZ39HO7/A5hi1et29XuVXmDpccUd0WnaQwpcWYzjwMdNniMzlvSmf8C51nhWrz1DcxL3kqPIa1GBQ2os3V+2fs+ev2Bx//k+2yA3yj/3rekkZPa/RNv2YxND/VveuiPl2QW+5Hb9+9ZNrNm+P+VS2r13fXdVNhTi72KBh/68xHytRDsb/xw0RM/XTr321yytzvRPDTS9YPROxFJoqp8fPJrsC1cl249BHui78rCsBjdCzfN7n84O+6lXHLxds3l9mgHIuzm5B7kct1gE0PtCuYILkJgSJZZkQWHVoCKcZtj5QiGgFUsj4yPBJiFsWlu2OYGNWmDmpYGNb+mDVp+qk1Z0laES6W0FYPWVgykFYOn34pFkTzMfOjtFUob0WV58VMcIlpIfBwcbdCmbT20l3k5OaNTrfur1LpkKJT2TSqDiZx+JPZIO5pVMueix8YsxKmRd2rkneqbUyPvVOv+wkfelqPkf3IyJ+C/2XIC/pCTPwKPp0ln4F8kJ0QY91uLCRw/0aEF68Cxam3iRZrQi76F/NNXKWDaccMFyAUrSFffgmCqHv+XQ0OhOj4ccDXcOHHvR99GZsc7YZ+dqO9rOlAPjuyJ+vWyk4cSLpd+5ItV0CNf1yG6Con5GS5OFmElKnFM9ATyIyMhRkMqlWcZVzPUJRRyhXyxSQiJsEBGE9cmdclIInKkupXfM/6E7idi5cfFYbGm75Mmsr8tDYGQYI6LIEwVCMQGD0KDNIE8wbyUeNUBKeP9rgmf3jsl7Zd4A/kVXvuXS4rR/9+8xPsOHo/5Nkkx/zZJMX2bpHjst0mCxtskxZa3SYqIJ44vDsKi7+aWkUHL2yTf0+XtSuOhUVzZleEo0qICaayi4zQReTBCRB/ZBp3SBuc2hdGdhRMzM9iZObkXU77/VF9MyXeTHyDxqX8RBR0/p0yuyixTe4+FxIbwl0p3ctF24BjvS6UWGb/6Umz6/D50E8pevSHdKkf3k0bNlvT3GmPS4vZnr5SSaSdKGJjkuMMAO+4inOPA64c4zgufPc4Lnx7nNXwgsC92QWEj+wBnAEXxF+HEBwyDw1B2tPDuup64eVy0F6U7XJbYj2B3S5l9jVso2KNU3oSKnlT0DnZzY5fdx8qj2JGwo43PPe1RHiNBrjrslSMv6IH+XnQ6Vmc/DglnHvuSEmZsmdILY7p9SGXYvfgMYgn7D1SMOyjETiyOLakRsYOd+m6YAStV3TmB00GdKKOTzBo0gmQfl2BEC0EP90oZe/dg7i7izG4sB7DqcZlCm8YTMoY1uJCS0VHwO8Yz4z6LQV+QMGTRwf5Xp3ZLhy2TONTXMEs2Dr7DqvuXEOWyz30W//5rSZ0tnKNV/n/8puizcm7Kt6cvMiDg7QEfsEsXdIAI4PgYCmSCSdGJ3SvAaCLmXSBgzLOGWxeEcHcS1mtMCOtMD6Mf6b5nhl3kUMoEV0Aq+v+UQ19b+2YzYfivcnPuREeQH2UpNaN6L2WwVX20bPed0JwY5ag0lodVZR4Fck8UatsK8+W6NG1NtqJeyS2KRgZTHdqFAtZ3kvPOVEazhzKLhXbDiooSS0ccnHUOO9u+ZBF3MQvKLzIcZbNs3K15F1FYsfFBlogMJN8DhwVMPn+Xahp5/DsdNWyTeZdoaI8wmVT0kzu9FMV96XjPW+xAPLmvy8T91K0yQDxO3U99HEIVsIDwvlQYKgprSO+lPo7X8ZoDn37R8B99c0nqIs+WD1RxLkl/6xemQJ4B8gi2RvalrrJFEnLtzOc/ePAjqZuFvORGb+7rT9vzodRFCHIj+Y+fEqlDH/5TRscf+cLzLvrKty5JXWH0u7vOev23v/W8j6Yu5yH0zT99z9XfOP1Ti1M3pT/y/IdOq5kz96VuSv+bw1FPT88tS1I3pa8QYP2JfakLuuUUPFlcvi91EdbymS3UuI8mV+fhhds/+h9P3PWR1JWkH3/Pgx959w/ixambsnH/hl1b121500dTN6Xv7PsMV+OJxamb0l9xJVD/c/albkpfLdX46yWpm1VngLh9jdXC1E1OO7K2VUe5Zb5okplHNiSDbQJn0SA+Jca5uZaUuhx9LSHtkQ1WcTupi9VwgFscuc2gWTRD0tJpRz5vqCV6F/cKF/00xK5GfhDAu9tVI4NAQF3ytcyynslj8k3clV5sR4UO2e/n6OzB6CADPBUwcDjYgqkt4p+jZdzJGeus8pRyPcy58g8FuUNLtxvXTATjOtSgV3r5Ic7PvAUMNUaHRnRizLlurWlTNfOGwmZYp+JubJnoGy0hD/xGk4aYMalUSzBtelqsnnnxsaAkB/WpvDaHKoYZcirL7fEZtrLkrW92GFtH7DC0IHYYN57NTrF6tqAJ+Ih9A/DJ6QikNQqCgDyj/8aEwrGGUxndFwTpzi3cqb3bqb3bo+/d9qHek/Zue09i79aJuydt2vY1b9qi+jv7Exfu9v6kn/rJvW7QvjLx6SX1FK9dcKzt214Iq/eUbt9ezj30/Rkai36kK4FWEhPHWqj1PdGb3oBsqnbdX0WuBqucw+lupho0TPRjEBIxQOguIxwyLEksWtuvmmx++VUTEthV0xcwGnrjuZWMb3u4j+FkmB2DBYsPpeb9YBQnLwL58uEJdnxdyMCnCxn47ELGkYVMAe6hvjhASGNBY6J3iVmpqHXYLQruRm8EMYehG97nD9brOOxGHr8KVRcLRPQT/bCLn1vrfOPXBOanCD9oRvgK+aMnjw3xP+l5HuawNitQC6B1OAo8eepgdfUwBmFsCDFwgOqQELirlLQpkjL5wkO9HlcaRWPa0lapJx27qSPjqX5HHMo06jdoL2DNaCwLd3OGJakbawzzTx3yyZ9KdAS1w+zKEWWoz9LUdHVc4nid9aTMj8P6uFtWv8iPfSRJSuwbwFwvvgihtycaNWxEhRi65EuoxIOTDLw4yFeUGVpHWAzkMsbqYJPYLxPxizud1K2EElhgQhm6j5qAv7QmFQwznLMdVLrw0IUHGUCgcoG0iY4o+YX5IWMabXgoa0MqoNNdww73MVKbwXpd+i9nB++l9+H3A334qgA+iXCFWA8+hdMJFzQMCcPiOwDi2eI9CO+Q7ZXGmheGuDdGEvxlJ7VIzHEJh52lR+5O3MzsPpKpRcD9EY0lvdfaIX6avR9ia/h+l7tjMOH+QrujmAJ7tTtG2h07tDui6aVzllo6p2c7Z0k6pDa74cEm4eYFqczqXGeWAC2NdNu6rsShPvrSapr89jT98ZJW8jsQsZfv4vMxG+StZGpMs+ashrGMkzhiaoOZldO9wEH4enKrJV5pA73yyXmQlm/CY/EmOamI41aOWn8JlmJ7SNJDHzH803j2R8EVNDZxqlv9K07aZPjaHU/RZDh2XDu+mmMTL7p1xym04m/fcQLmyYtyFnU/taiHmUX9BhjUX79jkkEdNTsZy+aao24IvA5F6Kec+JGd5u0AZQFZ5XYDLjr2bkB73nUz4CWOHudClo4Vo1r9rfUdNFdjuDYGnjo0fq/G6tB2QN/EskU7K0IlSYc6kTq9lSuMaTXrgjPmWYrDuPOzdO8iNekqJW+w7XW0GdFOVSfasQPES20nIyPWYWsp5jN0xD9Do/gdwM/s0bHqK28idzS2euikknErRdwTt9+pPMeY1s0MqTiqC8wFfhs+XziRh+gvwYx6d6o34/utAGhmi6q3C1ZVzqkmO9wAsQd6oyU8dqQjIo2MHI5AxRgbsMK/ErSDcB3w6EMnNL6BHK3jd1e0y4EEn1Xj3+fuaUtAH9FRSGVjGv3Vfq1MO6xm6aigkaXWJvrordJSsQEfItTJbfWmX6W2emvWVm/7rWurh4/bVu/4VWqrd2Vtteu3rq2+0dpW/wO42UaWxKI2oyJPjJ3vzqbAlyausIFiXkkuA4GoJuLT4BtywZvywZLnvzhZnjoeg3qwLfXidsThjPjjW1IitYvZ2xKz0dLZdA3JWSnqvO5G21BVDdDQZnR1kmCn3gJ2/JdmYAcPk8DOs9p9uK96401jJ/vNvmMv+p8wxtzc9itWsCve9cZXy3eq4H9Hzr895z+8E/77RZPQT1H+2/E0U7+T9WWNm3/F/aCSEHpAvdDt/Zn3w5l3r3j/9mjZu4eyqI+K9+/aRX2gDVGwXpWFuP9/+I3U2Egm+gCxYdmMB3Sgv5ahrPIz0w6BaGQFIg+byVvJoB7IUR+xo8/HDcbIO+3T/twTUjyYpcgQTfWuttRdbak721K3taUediZRmfZNY/Uqj5wi/uQBRJLyWjkL2pqia6hw41MybvRJxGCJpP1nu5tJ76DJWZfQUyDlu5EgRtGqnGqYrproHglws7byqlxA1lZe1laebSvyUyl+1nAJnzVpzXyVY1v6rqPQdx6Fvq09HfJspXOdGycGugODLdktIW/KllmASJFwpaoHZHfdrS5YVX1IVPVeVZAjjhPFvriEnYQ5znAckAZwJ2SqQ8ECZ5idAj8Suz67kbRN9bPveN97/cur331NI0fQ/ap3eZWP+uRp+LBW1V9R/elrm8gd7clR9RZqIc5CXLeFPNye3CGlbqoye5NCeqtbRqvdK1rIcRHOALJrLXwgDuEQQodbQiku6UeTXjFa/VqxJXh2XIYzhMRRS+hQrB9Ral/w2bHU5ILqJS1BF8jLod5NVdNcR7e6fQLWoZEVLW290Lb18rgg7jVxN2nIDdyqN7C/m91rbGsvt63NBhiofByxexe7PezuYneaPdsxnd1t7PZWF2InWxaGfVjgfzjpr+Jup+JNcH5SXNlpqK/6X84V8Yz0NegZAsXSaBhHnywuz1en6iBPfKttvWxY/yH3STz9vjxda5+ubQq7QZ/ivop2mniA+ppE1FV1Xy7nPXi/gUqbkr51TaLyqC+67xYr5lfiZXFOz0AlbIrGXAmAmkEDFOKMFvYS+5mKREkfnHF7Joj60F20jskMW8u4n2ZkcoE8OJGeBkKOeI+5v5lrCseSPrBeaea3lyoZv9sMpEsVMDwwmeEBZfg0GmgwzH8eh0hK5Xq7SSrHYNtrw3ZF2Ea+eLfem8w2k8cSD5yX5TQGy5wP37bIfXpe7jux2eqp4Psm16MP9agQV1TqQQYAX55H8d1KTa+1eYs52UZolj4XMsbJUIeqN5klmpZnfZdBthyvcDTW+8mkrHfgPGuIZ2Fdmd9lma+ZBMygnRj+ncI6hND8zpYW6MlX467/y9xVQEeSJNfOoi41qRpmBC2IytEsvWU8vutb0rw3x8xMrfKi9r2lse7MDFqtmZnpmM04j8zM8MBsPzDI6/g/qtQtteYYduapKzkjMqMiMyOiIokGZ+DjozENP6oa/D/x2YJfWd8M8Nk08O+aAr5xFPhGBXyDwBNq1jGo3/cZhRrdjKV52+i9U2kqtk7Cui7T8bSb/7g6T5BvATZbwxkdZ7+Pqnli7Jb7hCqtbqyYe4oqLTU2zf1HlTZnLJx7lSqtYeyd+5oqrYlj4ZNq6pr0uC18a78JL6Q1QeDnnR0/s5HbxmERf6rRbSMt9Z07/Lya0iKy4jMzvOoWUqVdjZ/LlRLL+CCHFjrDV52xdG+k2mT+xuAp5tLqCfRCFbxSYnD5Jzwh2ETo0uApNwVnNZTQHviFEqMluTF4KUIUBr5RQx3TW4TSucP0FgFCUFvQX2e9xLxjXW2bEe3D1oQCdL+FNsyUNmVXVAEx1AIgqul4Jd1CELziCYEYeHfdpFuD3602n7HaTPBiyux97LCtETvT06Nm23bASEQI5ErNtdGlMjKDj6iUeBAJ+8LV/IGheSINOM4+IXiuwXHLTRwwx09z6QyIsL/SMLte3ZgdhlIhMBDdBMRfBqEcBRHUAofK89kfMAO7c42Nkm2I9bP/hGbeZiAi5rZ1tevkKoqfuIcbPcaz5ru0KW32997xFUraKFO5erucgoN2rSov7sJlm18+fbQ6pP2yScMsHuz/vaOOacTzgWkwf955/d30pM7tQmoFAvcX3tHHR2geT7OfJABVOxJlP2UjNDni/FQMTwXnYC4ZPQylYPWGGes57/D7686nOsU31x7buV33MDs3SzD0dFT7UmoIG68a0mqJnyVBn5gCGkwNyrwQ9kAqp7jAG1vTzI2xVMFMV+EnIIRjUsNC6RhEhVA0lgCh+uh6WDc4TchdeffFYXi3Rtd/gakdgb6TFE+lo5/mCDDsnVXxYVmpiUqeCqRpC6f2yKyc2nBvMqb5VZtQ+bTUDHEfmM9NqnTKKh1xVZXO4SrlPRXY0UhnosNrS/sgolrX+e/nCH7we2Xugz77PrQLvS1an4KPsLkLwdaWSSvZ90nn+337QKmp/twD6Rw09UZE2weWQ29GtInBLsaSSfv71ZnHABIWjro5V4RyZTLKzexnOL6M+TT7WcbS7OcmqcIbJLJ3WsrIgdim3rJ//pKP+ZZ9lzknMer8ZVdK4a7QNuCr3E3a+QesrKP3ojUrOrxwoxIYARjwVrxEQTU0P0M9zaZ5H9ku8Hu/hMUosrW5VO9m7ybL+dOTcws77hycPvLMew4egQ3aDD+twodYntfv5i9mP1R6w5DS1wq91kX/26zkjK/1MVNZapwnSCsogIStTnCfT/WoldM38uh/bSdA1zZ2entj3tJ0t0maiM7YjUX6Z67meK8QzBbyntSpT+5orGExOLgy48zpP76kEUyLIunBVVQPFDanVZqakkrjNp0DzcExDC1gTUCFyCrsaIXygymj/3aNPuckvkO5ct5vOQPbD1TPnZ9QrAZE5qTCu8APcRZAi34Romvd1V8WtPJl0VgtH6JB/Ec06gQ1FzRlAAJekm6Rr2gLS8we6ED4Ve14KCsKpabUNTgYawyrfU9OngEOy/v9fA0DISfydaBiPpVkTXr7r9SB+Eq3/6Nu/7/d/i37zz5mnJ7NkeoB8V41YOsYsHVFXptcgik0BkufS1v5ugKxRFQjBWZJYSkHUJalpyr2d76aVy3ePT2aHGRtdMcabQLxy/0QKGvoamC9pFgvKoaG7tIhdJem0Z1F1NBUzI782z+1/+Vu/4fdp4T1omEdAutFw3rxAOtFWTrAumfelT8e0rgsE5PsIIiezO4K0c1kqUDhjzWTkat9/DlML4BNVM1h2RnIfRsoaHpk2EWGXTWTV7njZzK4wEy6mZlceXzNZPAZm8nAZrJ23EzOT82kHIcgfv2ayP7NsnbMNiPHpfn5/kix+li4Zh9/ngkKZ9UvHZ7ppWqae7gU31PUs8ffVxjuo5p4WX7V8NAYRBeY+NrjfeLdZ2jigfSCpvgFO6RKMLUg+P44P2Xr2FCHYUPbPSUbXAhXxGkIa0GEtaDHbvL1g0UgmiwC67DLLcZ0hIjRXJ12FHZay+qwFupV2fcQAiwnGB1gcOuyqiKhcmlV8DEb2H+hK/ZpkqveWLHN15sVkuuQOC0SV212QG94i+/LTzdlRZawNa8cqp+mUfGqDMf5KpeFE7wamIxtXTICfvLjAb54GPCFEnDiVM7NScCioR5MlmcQAGMC9EcYktJYrrOMlhdlgUgMPhkkAiIxTyRoKw1EZpEYEOp1hEgJhpMhsTQZfd+jk03RR+9mVvfhMyywPI3LZYEmNA+/Y3j1dnMv6+hAJ4e4+A8aLoNZXJaAy5IsKPoLxEUx2UDdjUqWkki/REpa+fA4xFqKmI+MsFpHUbMJYKlorInS2/IryvHwliO6hILRFrZBU+uI9GRFk/yqojTL5/I1vHi2tu3/lMvXZt/fNfzfb6dzjWar3ZnX9yPEn5b2ZVYUJ3UmT7L2hwqsrMgqX/u6lDQV2pjL+lhzp15u3+P4Yu7fiwE+cdwAD6U1zrHTaR0ZZ5lHS/OSgQazygtwbGr8h5079nJAR89f9OXPOwGnj4LcJfNrEbNK4FWBK3QSjNCihloMDSprCgnoG9i0FhPX/P/mgkiPyrNWBJTm5grFTLch2nbWrasMt+wMjy4+hC4OJJMRnj9gYmH7iDm6L1dwLws2YEiOg4iZLmpVXhLjkyeUqvhE4tfwu2ymosoKVRAMymswbbwt6P/UMuLnH6O95MT7YkYTOrBjOnSdNhX5nXoUK8pDPdEAgA+53B2AG0yDG1TgmrQswCPN4+r9TOxRDwx6pZojChgDPa9rubern4omzJLpOFISPgBrIDEe8SzIhIkHTtFxj+/zc/SuMXLl57mOMu+xh8DKtyijH70WTkybavOXd/SxrSSnjzeC5OhMrzsKyCv7eMPZSFfraeIJadvX5j3RvzPD/KR09UXPF6QJzBfxSMmul/HOb/uhlhviE7JSBPkcnkVW9W9tdni4zGfsAO5j12VZ+hIWY0QiqB3wd2YoygCkrCRr6IWNH+olL9uWYe6JQK5Nz+OFpWlrpwwFIpgnSYx4Tu1qjbqckkBje7vavJnCTqZgp/qeJMKbH4nHG+rlZKVqWZA1gOvDsbaTPEooxDB8tQ+GmM5FCcecacu0xGW88Mu6an0hVxHETsgaGl+TrjXeR2K/Wp7KD31almcOW2WOMejAdE4VRcWCnbwS51ydbU2y91UDiso7kfn0Pe0fdeaAnNCnCKCAXajkgbn+80ISOml+SPWR+phGqRIgg7MT46XPc+QOaGkccuCDaSBiwYZF2ETk/R1+XVc4pEVFKbpbF19s6Zwqoy/NkZsl5VeTkE97sxcZ7WCCxBCnaNmE3OEWxSPGOkAW1Co03+kCiPxm+A7RKW83yZm4ZwzHca7Acgb4WZSYtOGTRxU25O2QdJOJshPgahmW3sOXRHuPwndwYC91SHGmoabBDJiZJK9CkDQ3/YY3V6h9yH6fTl5UJUAhTko3wK75u8656Vuu0+pyDwgLNyXF+nBWHyEE+Kl5c0wlhgA/lQQC/FTqEF6nMxxcG7gayWDkqaQ0zLqcoev5RQFCT9DQBkOw5RKGeCfZCoO/jOAig7+O4IDB87VqCaKoM/ugScoU/olvTOeO/URiFKDpyq3CiGtb/Mx3aGYGi2NqCFITxEdlxs8rz+dd3RTRm8vLWALOgSB0aRCpOsAE6psoQVE8dUrmuwMY+UBizu3IZe8lvOz9hVreqa5jWkwfzYjpX2q2NFNi+j+soVAZk4Aif5jOQQ5/5GOK33Mu3ilNXwRmL3/0xZVZR3lcNCtviei9iCkBFoOHYWjSOoMcRDMLQedLpyrV1jIBx6qD5pzooy4JxLeoc+Dr2YFQXbWlStFyys8OJdFzML+Yzevov2l3Lxz+kqCujylhKeem2fynukunvnoNDVszvbz6puBqhCoP3xY2D98WNsAQ5r7nCTQmFKc/pdIoYp75GmWb8FeKELkXxpvhyCc6PRau+TqvVwBaBdLfyHC9wG0yNaqkkuznvsxctViFmP375A6op8oGdQDvQO37BR8Mro9Hr73bXomHzeJypLoY2P5o7FugZza+dblPOL+4aJCaiB/Q5xybcNovlPMA++2O3YDUFawvcXq1SEl3AZPZVPYnlVaSfCxGKzdqCGRtnexpm3H2m5Wm6EO8xbu0VWA7Y+2VF9Yw0Xa7YAqIbfpYBZlaYlsvr7RLK+MCGdv8vb/I/pR0XS8Ll1lxlUuFsLbJ3MRyrdT9HPjC17mHMRfdoNiBDgUpK+ZlicAmw6V42VfgVaC/jzJM1yAhmMqfEQbeQnq5plzOV4spwZEUeDjh8EpiIYJQObcKD7jLKLKhrlwgEZwBHiBwDa9Y0uKxBWWq4CWWtHEUViA8Ay7QP5II2sPCwQ8OS1UfplvqRm+8zsiBs1ONiLGn2u+/K1X8NqZQMI1Do+Hn+vKb5klGHnPDvRccmOjVsj8HoJiDxAD/C8QRBDc7j8hkl4QbKyfWuOdtnZr94BTsdkWi0d//zZf9j4K9qMEA0xsJO4qOtcLd0FLk56z+BIkqbi0S2RVnzE81HxlKGT+vxqhUBxonjgA9VR7TaVA0UtXIvzNDwCKhqTf4vekndu/OR75m9t6dj13jV46p8b4gmMNeZbaSJpl/Knu99LFNkpWwQEaEvPQO+FexBhuFpHc8x9zFFSh+v68X0FhCnKZJPBVgm53qI9oeRffkifVn++gWGQBu3EqwdfHtD80cYSKZUzQ+TL7TEgCWx+wJ9BlxE5aOoeHbk9buN/LKMiwmCfWaeVoiTmgon1DqgR4HqOVJhVSeVlcdSCyKVAK87LjdyENpVBbvH5pPOzvxubkdqqDORTtheXLNqe3ELSBgamCM1n6NgJIhARYccOdARsCKWhwqmQqPa2Z27sWpWVMSpDTFWUoqc4q4y3XNwwe4yIdLoxaPTBoIN31nqCU0JBoIJQEvSOz7/XIXmigKruAFOQF+oa+SdCsPTVpyifkRAxumXxn0HysXfrbP2jWbqS53dw49B/eMas+u0nutAPvjtjQ3jyQF0jia5LTPT7CBMiTzKq+3iMwrEimRUA2V70ufyaol703yw+Pyu2VrcLjTfcQPILrc9d3yFDX4aunageXV2hQHRLEGtFNQdg3KVAIdgdl0Z9BPJ7WlcTQpAPqo/XGKyvwkNkE+PQ6zKjM8JrNvO7au9IFzX7q7vj/BuV/h7Adf7XVAvhpVpfuqoe/efN119z791cYaFFyJtySGEwY09QofDtmGVuxIBzxmqGeivDM1cKHw0pDaprUgHYxaDXHQe/PZ3G029AHApWF02SFdtptCX3uTJgLpIGHSRmBtBGzD9oizzbBS3mFjeaglwIna/NE3/rAF6jFw+HC2VHko60tbx1lC/dn1Pem9Avpx5eYcFDvTcVY+unvz+fNnn/YoZwTJrx6WU8Mhxm2ke743VWv+siBF9Od3b8Y9ecdX7N986Su//ql7Op8D6Wn8RDkX+UnYULH4K6Rvifds5wv8TCNflBYeS5KUr/+yxEiAhHVlpOOoEb+6la8Z1a2XxFd+yr4ANhzLmqzAFjLR+xL3Vf/vw0I0/CUMJ2igtVXkogVXRbNa4yLPZZk7hUUZapJvbxWyhH1YZ6uAbzZkdpjdHhdjTZrDGETAWxEELs/Yy704iVH7FGbVySklNQlsI71BF4SysUUNwulQOVmeVHQ4ooU/4tKpSDGRiEHpGBVGpELUakobOQ61pMagtFHIGZk56OPt8mB2gC01HoS3WrT8RVOSN0oOkd2bXdOAIfymqCiojzZq+cUmqrvERv5SyKy4TZTT+neJXPyIva0elYwsPrK3W5KP9CoiuLQpXvq71DJcupuvo+YuBrWGQd19JO+3oqZcVFG0q/hiaTQwUM4LHI+F++xBASDviHre14iEcjACZcvKEZDbgzrL0OwRP4KiUDTLEQAeP694KN8BbwFDk7Zwpjs20y0RkMqc5HZm4ZRHnHKJ5bTEY396LAtnuVSvYAVfMaGZnJDunqzf/PW/eN9TtX902fzln3D9VV22nf7Nqy1JZaMVnIsf6jMc6l9yrn5wrWh96vjIfRE3uBKgo6RAWoTk+h15KppciIZiIxCpVzfz5nXTo82BVSHB1zUqaQFXhBGEIhJASoWWGs/cuQnXyDeEW7BAS+mGO9B4wHPZVwTIWPSsOPCtwqcInfUJhC66tW4LG4+LvGMXG9fxbb5tsy4HTeqTkadgtUfHZ7YQfUKR15qsi73BCK+I7qUDGE7qTj6TtkUy7aIrRBoMeE55smjgDFdOaXA71qApcLCl7NrhZatVFjg1s8ChR5/22Pefw5PYz0dj7AsHJoE+oczoP52q5/T5Pn0u6PNvadWvMECr0cVjWVNTqDoiPfGOTfYr3XyNHGuN8KHxBoyq8fsd/8/ed4W3kR1rNhqhIYEzw7nknTs2NeJ/WgRJEaQAECDBJImQRqRoedbZ1nqCZd8M0WHm5jQzm28OFLXpZXPOOeec931z3rfNT9f6vPVXVbNBCJSzfZP0EZ1On1D1nzp1quqcLuAij7+18Bk1CGZ+ulKqUf2zQdihNsmqeYs0/ifGLC0SZsewzzElqOjkZRYJ741fx+ffpuL3qGy+QtbQyyMvRjZvczdBTG0rNhOjVWiSPxOH2fgPQuZZvKCm6oCLZlk9SgGI400qdMk9uM+437ZOeFWYySvpPC4eHnLaKhxPF3iYSxcxpwTgVZdcvNwnovX6gtFoUW4rldKlAa0KoYE5Fr+MOmfNK3KQEJ8rqBMrCse7oRnvjv5HPXcWxzT/tIaezUvDn44LkTxryhBelcOtpzKkNmla4kkDMZoDeZe8bGEBTVweaO2XBljE8qHWj256eVOSkleM5NM3NV0L8eB0YFEtd3wk5E9C/jS53rWox/sh1vcjfz8aMFBoQ3lWyHlmzmTWuuJBiS1USbM2N9oqWa+zPXUfBwniRxciqPHkcKh69BeuQv6PdyXqozNdiXFWv4T101Y10B4g/tOsu213iqb5j0mujrirC6GNFjrqwu56hUm9LriVpt4oKDkSVI0QAmu55fv+lpXqCvA2r2O5bqPCx1Z8R2mYaA06rEGHNRC0U+5/LvO1rLGgnOYcrNYByJ+MaMiatYZ1Jqf3ZA1NtrHJQtYsGCREE2WFmbalczbSysqzUoY07e1ngaeDmNkxnOmLR04HEV9uFp4InqKDp0OJ891fJHSyyn3lcUMknw2dlla4RbT3CByB0TB4tOFj8GPkIISG4EM0PQlCvQw/LVaj9VXET2z4iTP8nI2hkrNuWFph4UQmQaRpoAVh/hDx4L4aZifPhBllb0deoeH5i4JYmvDFhO19AsCUoMqvtir+VR9X/NOCVVWk2WiHXUlLAJITYh4FjGZeQ9ns/KV9lzOKF7AebT5pD8Olq8V3Fd/trPhCqDrb2lZSKA/hBSgPl5+LnESJqGSpZnipDuOlm9eky5p0v4qIKdRYMc+5lo15yz7TAOoyRbzXL3wXIsZQ4wLquIjZyb/hJnSO0WG+xmSTmBe0/JnjsG65TP5NpnFt7S51lAKTTSvfolxNgYTurWJdfjeUMNVRdAmTsIoywYWNR/+lICF740FWJchiPQ6DTJ4C6nXB+oPjMTgjj62SCavLSiLljQ/+mYekzN84SsG7gB4Wj49ITpJQpMKfeRg2efd5ezgnj7asgVShMh1ghaP/FSwgOWv0VwpsY01+d7Alv1exKb/XUH90Lr4QrpsYLfgGtkVCYNWAZPQqD9GriqpSa1uohR1cwyplPzO4Pvz36D8rLSfYxOE/uZ9u4Co2cJ3PmYq/TnfJbKIkrw//MaZo1RmSq4zsgKoy5pyIERsfsIZNRH/aVMHjEypvGRUvkMTKqkSZlZrpkpO28kTpFw9kfwWyvwJZGWyLv4LYX0HsLyYhqyBsCAT/FuEl4L2UBbnm83v1RA3Fal0SXYaaBy0SdEXNugYOD6GS6Drm1CvSuNFD7TCNhCWxXNFI0zixdzQwgd59fT4AdU62S0J73RYCZiP37oeF/ps8LKJBpM2jwWinJfQYoLWMHq9mXdOn2SDEPOwSNPaflyX7fP4Cz6dTzrwky7SCJTSQvGuGWd+eUYOC8HvW5sYa2fCZ0MEi5lGR0uQg5kKWL7/yZA60J7VyG0XaBV/zfqJmCimjIWk1TVpXE0WZD96dNvWircYhQaUgEOflOBE2rMrPq9hIaMNM0HHNV9+hmXpu+EaFfQRt7aYxu3emdBO4gjQwvMmuUPGTHImEoX+VnKaeNNLS0+TAOvNoI408UdbOkCjZoDesbRdClbqx0bpJp0bdTGehIsd/WZFWy/Nu0bjTgFrf3qKtWQ7fRWWVhTZvU3zoLf2sVoXwFVKietLwdQ9+jdEYfAFZ9OMQoz02G3SpodPC9ydjq+bvlCOnil1wT1Il8IwSuChNRUyO6b783k8lHJhVaLFrGX87ypquzidzCMzp3brkx8yrzmpzXzVRfCQSIGxIKRuoo2mEdiaGVSdi7ERMUOT+8JyTm0gvTapDHPYKEjsfZjYz0blIxVsae0sTVgbcrrrCBnTZxlVFRpOQaBokquZlrrLLCcms43Ne7JPpthCat/g+2vzTSIr8O/uxz74o1yypP0iySXaihp6yU3FOgGdAuuA4C5GC0IC26x6UnvZuHUOyadM6EVBx40gZyyddWm8kKmv02m2sc+rCCbBM1muaoGdvMRWNrjJDHcpyOLco74tNG30BHYE6uv9MWY6fjYgrY3+H7Hdm7wjldkg7llXNma2Iq4RYmJIogxMmR6ysLY/haywjRYh913fvyR5Q32TUwTZWTRTUcVIMbTlZRlQGank4pgcmtJlPW9l/YDN140bFuFE1bnRPS16W2FbO/jD7mwK/LVn9cI4D8vWJvJNEBqVR3lGgVk/xrv4476qneFeF6iJ5lsO5VYfkqOsNUL2hqbyLYFI7NpMRxZBxSri2KmT+4VzIytX36xWiU8zhw22Uh8gej9A8E788RB4paDRnh3N7Em/AbvR4o4eJl3jlPhXGCxfeCC3151yk/fKdHFQ79IZEJ6Nu5J6FoLdKafvWiOsh8qEKbe+eZkJQAdVARZUDNcA2KTIowwmox9LSjcBy5URcMjHmpPXpkFBgXdT3EhhmqrfpmSE/+CdJogEjEOap9vFhl3+SQG43uAd2SNBDE+TifXOtzlN3mx2okHYWjFnd9seN4k7qXN+dxyzVK/QMJGpzMUeaNPmUG6SgUbDKCNNFaMlRUd9kkmZmhWx7IDrtj3jnwJmB1uArzY/Wl8CP1pn86DyRH70n8KNzmh898mNuhB+fG/l3Jj96mFN+dB7nx1tfJj8u4h2S2hTYsnsbUzHGSckWuj4ryT1eNejQ95NmNm6czEPQfPRs2Bg3jUCRzWDTG97y9qNnsSqTrT9X6MeP/khBW1zyFj9pAkBSxKb5N5QUXdFZ+xyslb/9t98SF7ZcSsvQoEyK0TxklkXERnVd7pSrKKiesp1TqRFiUD601aua9j+V3kD/ULPo2hSDSl3QHHhGd6xgbR83NCbt4PX0puP1swXe+dGCPflZcV3y+MO5bN2toY1z7wnEzdMHoUF83VcF6CbKkuXrpqG3UTlARQS09ZA3hj0Mbo8lE+iklZS2wGkAwjePTjEgm0Y6E1ADtVNg40zQoPtGeFFhEm6hyn0ILmkEU7gsh/J3hyvkYdjR6VBYkcrsFbO5xR5WWO0X+awr8/I3REcoKWAqPFJ/LLGDh+T0RL1C/KArv9vjUZRP3svKyURQJEO4oAg7ApDH8WRjyNl4ymeSz4e5k+l90S3asRVCze2Q1LfZRY4enzmKJPAcOEYL81VM3cVe/4JAb469a47zJo/VXDI6IcISdXwyTDJK9uRhJSy76lvgKxP8qR6mrA0XeGFJqzVPDZyvszphQSppPnhuSSQOeiuums5KcTybxIJqWeRTQ17tsXw0HKM2P+TTEnoD0x2aps7UTZ3pmDrTck9Xk2Ly1GwHIofpLsu1D+8oIt4E9cJSnrxdCNuZ/pZVWd5JE1fitm3+kK6afkD2UW/LE2xg+JEA1TiAQcqGq05XIVsqmWxr7A/rBbN6xU6jZZvwnEfMWnt9E1a05CEAKov8clLLCcb3NLbP1cpLVfonyDCfFpKr5pEsfZmcfPuXKyff/tpycnKUk/wqOXMvnDAwcnYxe+VYQ7mibDh01s2SExm7WmM/VbkaNige+Fba4Ts9Y+mszXybY17ZCKvK4c4YDjedwxXjcPfURDBGJ5RRV918g6NBxl8ONFHO3IYZ85S5SJRp2z53Eh6hqsxGdmvVRorcLspDMhTVXxfccWlzk3wSdBnX5r0Y4bsxwCfRDRK9MaTRL2F5kC65rNRbHElELnpkTdoVOthg1hWj6PoJSbrePCUF2qdiYFTzwd5haJpuU7FZWd38px4IiAYj0Zymbk9SfFVCghAi5255OKpH1xoHyFE9j1VTyXQJ4MigGuIh/cI9r+gqcbT+pDHHinRBJija+P6b0upMdbVv42uoFaoZDhusQcCijlkzoVGDvFnNQ3R4yXWCHr/TMkeyVMrAVtQEk5qKJtNDaMFcKiv6EqoDC6W9zElvY9hwFlYtiJrVWZXik3xyLk0zzlpVuiYMqVK0ZErGQZTDXfGO8jNG90Rvrsu5KcvuNGbYvWvKb2R6DlF8dsSWQ3KMqszJqL7veWfhW4Vc5VG21JlB3aGrQhFdn9yTegXON6Wfk3huV22JQzzMYVFOypKcbzcgh65SNfR4oAeDhA7zbluSgk9mzaRJkpM2XaU4VPJWSF4SuJ4TmA9r5kTXIBM3eEV5DE9RrSd/MpaUf7PkV/+yIlf/spQJSrVs5dYpSt3nByof/dM6j16Rwj4soOFPzJ+iy2+WK6//bOzTfkxngR/z6KF3iArB08rBc4UwZx1+Z6wssouf5cWkQaRCicliZwmQCpoGEJ6PcC1NyDcdRk5zsOk8NFHT4s1WZp6r+KhM/kVoqcxVp9OizQ05BFKhbRnDysawxBhWtxADYxtHt5jcHWVUQkbFWCW6TzPKbZ9/M9rPWfPvyZr/ecIaXv377Opvxs6oYSaOjHHKccTkVYs/MNadzbVMCLEucVaXui3KS0b6+qWMXW8nwqEW7OJ/VuQCfvHveTHpF0SW93Xd16PFmvTIyDpn1bExsk5GJsrI2EaBjH2tE0YiO8uYm0nNim+mZ8xtSANUmuuRE1laFn2xDOo2YLjC4GI0HtjdW+hLHti16ZiIRZ2HpZENED0+0OWNewP4vTm7R8l8mN3bd1m9IOBiq2MXtc1M1AoDaohF1CpoFWQtV/iZyqcA2EcrC5hRgTJPWcA57LJmFRZ4mAwrFrrE5tURkbDzoUqxv4JlUTswP8DCIRbIPZJllhGB9mai+RA64/SQDIOrBj87+Zd+QsmRwEYEtLRah65pVP37gQ1UWKSNBqiqBMr1wDhX81bdvpGreuwPjwOyKleh6h/Gs5Ak73zlE+WSGboU6QrlRrpXhzl0UJdc6jrkhDpip7iaA/MxtErOVLCCBVJvFi0sZw1MnH788VGxMkKD+HGCmlXarNGZlyH2k0xxGqluNk66kutNyuL0htSfWSaYxTyfzMNuWpTVuMpG9m4srl/EXunS5610VtcxFdWwrTn0VPqn8Yzh1iqvQ4BaYpbYD5fQIuFbYM/wcZNdofArXeGsrvB2/Pm6wuQv2a7A1v+i6Aqs6JfbFWLrCpF1BUK9oVAf7QoNo6t3lQzCSnSGonYG1sDkEIm1po6OlNxSParDMruIZNDNsF817CdfIvbpUU/I98Zp7KNOGhnZxk3/VzXWfBTuwyD1N+NRSOe2gOHUmdetGxJ02UqZW6A6AunEIJ2QwlXmbbU0ClazJjgFo2xI90o+Th4PAfAlyF4t10aGYamsDi0Pjj8NSwoCIiYmYpIZY+8oUA2m6j03NhtQWbEza3USdm0+Gg8AIWUahjmbOrNKe2qeTVdIpniXetAebr6emn/RtCFiT1djR3m8yL8spLGvHNlVVcljHbhMRFFskJXiEOV78jMXnbYy0uD0MqW03p+F/B3M0BfRQaxuxApidQG3barrcetpV5uv74rh6ZxPL+nDsb0fXKuliYO+4Lb7gjUpEr6b+xLPslz88CnLBX2zXe/NuZNXDm1UFXHatjQa9jwa9dz16AaaH41TPf4k58e6UUo0+bd1/f6NO08VhGcB5z3dTdtFI1afAbdcSs3Ri5u+RMjWj135M+nWQ1uNmq5jPVtFum6xzmn62ULYN/a9aBUKfTJAetZPxgOa5PFNmpGsRcxKItywf7LuK+29Ll1t4pBmBbMf4DmfdNFShB6R0lI0LJOvcmfduHNc4EbDayihp3lP/h02NWwagsKcvZUuW8XS9one3SCY0oqIyni3H5lZbzYHTBorZBJzzc2Ka45GvN4g28+girI637rvcXOQOWo4qxGzEBjObuYemizr5ogxV5U51yXKgjNvzPLvYGYgPdcMEdGjZx/3O5ijQOCm7iuCCBo716P3gy4vRtDRceEz/MSkGg0nCuoEV3WGuPPoLxX08BcKj/5UQexsM0UP+5DTOD8t5KfKhXFzO5tkokwXDIPvJCk25OczcikXBV4UPvPoQoFXMa9iuYp5VeRVUa6KQ74Sel7oMpl4Wxo8/Od+FI9/8DiKs90p+fY/HXPPkbv3Qwc9+rUSo5D55arMz+S/nJJQVbQpT1B342TlJA6pDKgfhpZp4k+kiJvaLEzmLevMJLpLbAuLa2QOmm7uCKX5hrYpuaCnixf9ch7k5MxjfbqhDXk6bGeRu+ZcU6nk49qQNXma45VLQnP2JG7Ba4+zCYdVdqglHbVciayNFLdqhmxU3bzNpGl5VKMarQMzLbs888gJrVM2R55WJZOHCqT5JFGDQ4S6U9/jA4IToWwWSLbGdG5jYllHASUEoW8DOavo1qGl3Gp6dtOjrNERncGI82adHQGiktjHuLK5tMu+RoTPGGnpEUWLLra4xHLBkDinvT+sWO+1GT4riksqmdwMsOCqzmVT02zyYVThU4stbLIB84hEdx4QVzQrNWsq0L6CskzlJZf4hIqJUXkQGmNkW0dr2cXKYEiypa0vQLC1KNg6uWBrPEGkdX4RiTQp6Sst1VroUKqdFmeds8VZY1ic8XdUos194RKtQ6x3RiRahylbWLbcFQh1nQy4bKufIdvqoQt5+mXINtTR2Ufz1huhMSTmumf39fZXQcxRjKsjoonysCOi/QVLv7pJv45KP7bpRPpVlExVbVbFVivk0q96SvpV0TJSdB8ThCKahJPtE2FY/fzCcFQUhlUjLGfVQ22U62Eh6SA2IvluYiYrK7llNNS1rrx2kWbS1MaqCJcloyXJZdHiK9TBRSUWVdft1lG2qPfqf9m5aCse1gBsYv34YabAwjezODpOAWjKV2e4J+ao39DgbYAeFus+yTfpbFM8LPDWggr4zDO4LB1Jp0FXZDaD8Lqayn+UWq+0JdiE/EVcOQy3VYoyuJSaeTiId/mKZIvbao+8RDH6rwvctMNV1aVbJ6ShwhxJLnzle9NFKqpXJNvqfanQIRbvpysUn3sSy4PLuEJYSKeXBzwLA5mZDYXgbD1M12wbEOb2+ky6qTGVV+j8amLRd10MC0ix/2cehFRyDDRFsxWSn1qMelijlOZcDUXOJMIyLqux4AAtUXwNmCn3JEmBFMuQqy4ZhQf5yhElAamtC0FW0QkyjpkMMFg5kPKAK3ms+5io/FvU9S/Ux4bC0LY2xu+LgKpN2y6jhUsmC4P5vBOzqijYEslvKwAVRGlijbBlnan6VnxtzVG6Je0I696C0p4Blxf5Wp8NRqyeEUJEcdj0hm5gGzu4Kg3+eZ8o5rrHFxGJ1iQE0dTIofJw5JD6hTexhujPcLXJUA+44qjPdoOvQ+4padgAVl8rf032EpI/yFqae9fzurGYhg1cFn6UdehZ3Kb4mqVnAitGEOPvXogxH6In8XdXkqxgb0x84dbjQWK3vaOiR9vDHA9z6PDQyabHS1orweYBLoU2q3ebvYoRm6GOA7TRF5CYovUuYeId3MZNGj/Cu3EQFnE7vCSlv9QvyB+3HOzZPnNSzgHuECDzg6Dhvz8bp7+K4vY91n2PpfvKZb84kN1MzU4h0ZHcTF5DzLucB44G2uA96PYTt2/I2y0ViTzbURspz95Nmie+7LpFReUwH880u+GBNHJTWOIDqnFvzLAKkgkJuHbBYwOcoWharqzi+YjxErBghs5eiLJoTmkfk9KTLqSfw7vJCCHHhO2jz4ovpk0OOvdu/O6nhv/CxtgglR0ZivjWslFqTJqdcBU7YfUkgKJro0eVBjp2ZFWGRyiUbmsUSbgm6d24S41XV8Qsoq4NPzS8uak83cBGPvSjrjOAIWcvyiRZuYar2JZErBOu8WRHM1PbUAIpxp2HfLGh8wS+cpVZP0YSjXtRYqIzE96LOdxRO+v78C4I2t6PWayqvvufWS80/4z0U8a4P/pvJjPe0//MINyUgzB4X0iyjPeEyz7wv99C9q+oVNvUUeBetiMZzTp/863wATt80A5bzogovUWKXsItgXQaCajDLN5D7/qHJCumuJuu6K5Ma8p4XDH/RI+mOpPxK6yQEpv3sR8SrAWQV8wh4svZ+vlX0/JMAAOVISc9B6trF1xRz7X0s6ec7kuyMjMAVWoLH877Vcx+dcmWHPSpZYUDjszS63+IQktOpFPPG0S76Zz3tw0LkWsgoiRYkFtUVOSWSha2rakdVEHG7px15ZDQIHgS2VYh69+Qciq0cWVIPDdkt07MqR97Ry0/2Wady1y5ZmGGYvNWooMF1q9rNvg5E46bwHH4iJAgYG9G3lzxdiT93dybL6Uyw9yKHvNS66QWWJ4Ra3K7cHI7zm7zSWJZWOX/y3DN1TocOiQgynTGu84tN2M+0DGqQ/77I7mYv28TEW4/2BmNDFYl2VSZjzwceSVlNundI6zYhOhXK9A/+lCTH4UPQmAjM1rH+JYD30LbOri0p4d5O5TlwE7DOxqBfpDGfCDn2hDi2gwD3286r66hCWBTSmGTHUcDVSzaBfEMX+h/v5xka23ushq7x1KB0ZetXAvsgG1hx8Wkm3Z6FNYt0xBlsTAszRN6Kr7AhJogj7mhyr6OmL2NVbC7SZZNTZ+kW1nVkPDy5SzrB0dZ5pq1CpD+MficZ3y+9UBOd/sPQ2pJ5TH8+PIDzfZ//q3jo6F0a7oYFkd8vInNowdHvkfdlh3Dy9lmH0WqWAIX6vpbFBOWgFpNupntb18AkAKa6GUmOtaWPDxiMmw+lJS//be942/ADq/N2PV12OHVmQcpdJUu9MAEMKzZQQAJjuQG7HFVCZu1EXRteoNeyffg/4jdwgctbztIWa8+TF/DB3D3QfqxY9XSJ/v3mH4NH8FHvYyf030dj/X+TfS4ZeI9MngF9wSkFP6i94Yy+qGKXqgoyaoiucvh46ikuySRzta6JlYbynJikIc1fJxCrYxYM0LEg0hQuiqq2LVRdY1YbLDDdomje+YaNQv6J+TkE3fUwVLFZWjNerzaY0UYls/+M6u7o4U9bpeTDBdPh5GktUjd2KeSKfXlsjw33LJ8K1RZi9ceQnr8x3BX6cuDzfzSTQrpb0m/WQat5w8HUGFwnH4UHwZvTWe3HpD1f/3o5j/7p/9U9tlct1x4YC68Jot4IPvTD8vJ7RtE1e/cJbtTY/MaNV/TQWKT7R5ev6umL+y9RJX2MmKWiBUebcBbg/wJrNZq2SR69tRa8DWk9wh8OSFGf9u1Y6RH6cuvkv0sUBPIkYTVZWYv+gjF+afXIlgtgtfiQwhETeRV0eMDaJYjI+ctBJ0F9cuQP7Ebfku/Nki/9SB8G75FRtCwIJmPHzSv2KC5YBHmZ46W81+30XKeRJofGS1v4VvxbRwmA2EYsIJvGRkt/2T8lRotl8cPli41SDtbPGPXVjT1erVCEBGa5EUdiXDpPWRsrGod1iF/Aqn12skSkSCZwRE1jDmHlxzI/oJe8hhIqoBZJUtWBZ3GAJ0/IzN4KfxV+c+OVPzurG/pZZxd4hXrOpaqlN2WUfvnjlNQMlPdxcf08UTeQaE98ZjuRf3RZK/O+CAuPfTYhbHNxVORuiIeU6THYv55WZ9QyCqBZj1YengBq59lPdWfC2GB13AXl3G6Yzwwc4nQyP2ex5O//ae4ef7aUQDH0j8jg9lP6GiRjUOwA0cXbB5jTUdsZ4Xrsvkn9qSBn/6GX6eDoJ5IS1PgZfkPYdHLNYjAkj7/UMl0ISMTCcjBxpfnSlM/hH4/fqxX3+Xrkgj945vf9m2//zoHy3Xt6fdUtPv76BNa3paUwxoUIcDHiYSPExO+jJlZh0TJFMo+QJh0TliiIE9b9bKM5VRk8AnsEaN9a/49a/4e/SCcqI1SG6xcYUxFRug3FMsO3+7YRlkA/BHCk34/x07wPiwTfmmED2zEE4jwwY24Sj1oIy5lloXLzP0ybvJwE/s87Mtr6jl+rwqMRRa8iJdIhZdwh3LjjpsgTnvd7dYL7KUvZB9JmtKbVLeSbIv+fxgXy7qLLIFqG7qWdPwoC0Z5sPAuWqj8CxxmD6jyvIWShkNxvpqoQZw5lA5vDUfs8zVLXkVFX5Dkk3+XNtT0HOg3JxAYt8J8zw19FvMVYQG/p83PRH5OAkfOkyesYijxY06ykRyXAaD0Kdu3hng85y/G2gHDOQ7tp7OMPAc+4dvaZMsilA2H5yizz22oSbWcxdFmbTMSWlQaSie+t9drK7aG9fkxsSo3Hn1AXG1ULhZtxe3rtf9XLFV0l97SDxndS2nRyFbKrAnZf8TmYazYxELryHaUdZVAUWQuCqhQ0ykrmIcSFbNpS/b9gKEoYhT5/lMFkzzneGmn5yVg0Q0HPGPegjalrjwrnNyBFDgjt+XdKg/nNfjIZiWJ4gfnce4BSka/ZCBznvOW5H5aM5Mcs2LHPcspN4EyarQqSzLhiRjwZH95+X0aVXHKPeMf4YnAPZafwQS9WT8/xnQ5Md50OTHkzxKe7ucVZx1JUJQGJAQrWiZEyBmCA+fVkpnvb5R7qN6yDJmTdCDmUyKbFCm1D/r3LXQ/ZEJYv0gjyylYDGI5+VSg/yMLT8k/ssF7fNGCiOhmzaJWan+oUCpYH/4R626SV548jfhCygpYp2BcGwujFqZg4Z2hcKIyTdFjPjxXYEyXCVn2dr0h2bwnu1epZUQo0Yh3dMR8T2mRpdqutJ+1ik4ixqPhnXULukHtM3rqW2z6lU/Fa/9k+tnptwpvPs2+80PZpyti3f26ImfsT3Kt2UZpkT+UOLwEL8qfSlUGqcdCLji35cMLrJIKg2mendNq8ew8zyb4ak1IzotJXkzwUzwTdIPI3s9Po8j++wyevp9OEqzP6ldU+2+/iWe4VnzKV2On0/cxTSUs/UbId0Fvz/wxvthNnyMzp//Ym+k3/YH0+fv82OUN/OgfkDXP4Z0oDm+pLaX/90I6gylffM79wQ/TF3RtN+V7rE7VdBZP2a0AXOTHeA/5mdyAGcghxQuiK2HGkl6CvDjn2K4P+Wcm/szDdN7nhxPqoFmQbrco5zGXPT/HwxIumK49Qa/NstyUwwqTHIQrfOtOaEpV3JXTIvGet6VVbzKcLGaoV1hVCczbHZKh+2fCGualqHVckB7ek0wnD8IGOmFTt5BxLWgeFY8NO/aIsC1suWbEU6yJ2rP92UK64z5idpRw1TG3iR32vJouT0YNO2Z6vyaS9zpmgk0Rn+NwtGrFXcN1UnSKEBwtafU1HtvYktJ8V4S0Ly6rG5LbtOSzoVJ9mtRnTd4hILqDCM/L8cBggHe+wZEPfeGmb9y1RNt3hJTvTMnJ1J0ZDvU3D3jOPylkSl55Dn2CqypD6sHrKkwkyRTKenFDyPjiGNfPLayEKRWbt9CTOIF0z4MRzNWa7uNF3wFunxMDlabp/qNZ25sVe1kUg9wqnNyKs1vxya1idqu4kTtnPdDg1niJfAtTlMhTFKArYVrat6JemHNYQv8Q04Zrkbd520vSk3krlhvT98MUGDw5fZiJ6shYdkOnJaLOjSxJLGmd8I2s0xQByKLFA8QHu7hO9FxHTcfLHTGq4Ao6uLon80Nu00eIp/Eb4Rqu0k+kZkKBlOFK7tUMVzeV/xfH4Oompr8kXF03XBle8QKmByzoi0NXILau4SIPRHhkEJs64Ln8sbxrYyHGJL9UIHZ9FGLXPw/ErmcQu/4VgVhfHEH+nVKH2dXQoQZCRBFfBFVT0hB9jh76agUIt0GF+hnD2LR69AvhJo+/VXxAxIbUbgbXccE94aHs8u8aMylbrW/jIq0H/azqYZsf8bl14kyeML/JtjB6T78t0HK33t5432krUBtrkaRyVN/4pVO+8e2zfOM16iAsdsp94bQZTsn722GLVE6ncl/4Dal3H3qOG5x/b2NLuoa3b+LpclwoFLgEDYgxoSSi+xc3nuxOFsJnzc5dxvuK8ltjUL4HMchg2QmyL1hfxDr2nuBD3xuPyb0hAi5TX8WyEnD3lA+dEFvA/OM+9IlTWpZMZym7pvQWanZzNpSpIlPdeVp94pPWQOPrs5JJPURP4us3hFgzmcSz6t6/hPhMpqqL5BnJXsslmvnlK2L6psCxpDNGfXmX1MYzbJ8y7robSszjN32ypXX4/+RdBXgcR7Le7qGVZlYaUaJYclwzF87xhZPv/CZseMzM7/nTyvdZYVAsO0z+jpkcP4ZjZmZmZmbmUP1V0zu92nUM3/EZtmcaqquri7p6Zvo0vRNdSafpQp+H2Lxj7j1B08dXToXr4cNu3ZaoN/5VY+zK4GndRo8KlJO5cQDeG251uS/1ct/Yy32ml6snDyL3373cN7ljvCGb9ZG7ODntSRKfa+W7ZS3eOyachaA+iNI2B1FadxClkVM2G+Avvt51ecYAHlXenC14Gg/WecYGPwLcMOC3ALAWaCmucVJ2/hRB7B6avmdfTe9jTH/TljaVE8/5ArVbvdqPNFrdcCUkiJxrXyDXFp9aWvxnXvFfDRZv9op/b7D4t7zis/1iwpGhDqkH1TjpMt2e2wHPq2T0znO0ZNzBrQYHtx7fLHQ0q+Vm0+ZvQwucGFnDf0xowkE2ROuH2Zob+KrhhodZcMPbhRuUtLf7TLXDrhoolg1+ha+awQof9St8ckiFd/oV3ttXoWqpAKMMh+m+1izIwgvVA0gShfKahEdeW10E6m0BzYR1/9+sYmjtdbff678PQetWv8LD/AoKd4cH9x2NFF7ktbpsoNEHPel6Z9Nos2s0yEyy3PaKzx6AeUID8kc7ncAe42cOCOwfrZaFzGPXfJCbW15xuIqbZ/ctyu86eC3w7n01/Utt6omQsEDNNxZtAgCDQaMA3BL0ccs2PWD+n2Dtgn5R+5nCPm0Atm644+B3NOLNTpu/d6gG2GiMJ9QWs6q15KDaNjduq5rWzLawgm10t+2xwgHq0L9mnKmFE19bqjv07GTgr1wSYBjoNWBlw7Eh/6hsWzMcCS3khTapCjEK+TK9KTDh4LhgvRs6BYpq2K1O2FriUQlX1CbNCzfVeRHfLlabF0rDJDhhG9/xpeqNFnefSu+B9p5ZMPLrnvyso3+3g8BYWJ+tiHJeu7yWCzjv02//IC+O4S+Cvh+UMHOIiG+wvx2G2iGQ5cHIiHQ8Qq7NWxmAuNJKp8ijk3TDCIfH2vbJdavCEFcS/QfmyzgxgC1JKAnK8g8B0zUaXo0kKoUy9AXCe9wwnuYfRt1W+s9iY4Z/BUanQwPKAApWyBbI5DfLrhEUcup3kcmNxU0p+CkXU6sO2Wmc3NQz3C1BPJZvkMlxJsih5Vkj+QxgvFX9cCcfrJjftVPQfmk7MtsP4aPqghV7JfqRqHlqZ+vrNl9L/8eCh4SLQbl7q2Y9BndkF+UsXDnvm8vur1Ig25dWzjnn4gCfnUTpCRjbf+lTkFWyUP1QAlI4218+wgBWX8w/ciMjBw8S5+5L4BQ/93cFMXZA1DS4nuqStgrZoorcP/HdZ7VOm5kz0MoRlpRkIWufV7dRooxKuftjY4NhuLMr0y6llGp8EIRlxMuAUS8zeLUdjhOG/1WOdYtxCl2cMKcYMzChAV9Lo3KEIbeb1KVPwJRYKDhgxGkxLZ57MUMtOZQd14dwFpjLLhWHUiYRu2CpmFWtcRiNUmexPmpzFD54hyNzcwz0k60NxTwDTTbJfswSNjkiILKW0GhEohLsJ23g27UU0+RinbdhieK6w2rtJRdcgC/qHE4TxSQdVj9JOSIkEXV0uOx1BLS2sDRdxPq2tDtiSA/aC9zSP4ZXhk9Uc02crTpdL+1tt4hprQwctSPqMAtxA1Xj/QfxW+ooqBUFBeuaNejM6xUPKal3ZQIaZxJvwpHFnG7QuaMcYZcJzlxDXCfmi1giLBtwhf+spaYkiHJopzVkcblOllyzbsA0R+sQSCEX9AiIL21zadzl3t8s8l+SWDd8JbrOI+GsLC1nhYSZkjCiVAgX0GRNTKvoORJSqrMR9pOQJhH/mHTLtLV0CLYl65fIR8VuYtIZotpqBITVrgWqW0W4oI6+bA/E/oQXD9ifMuRcz/6EF+3D4qAD40xOcLFnciBk8Gu/CYXSGJ1PDhgd9HJAZqb70zcwnxpqYCDWgwbm02pgbjUmcLQmz4dRKqMzRSlEFg6lt+iM9Yv4MeyjyqQEFKI7kAZDyT+j7hKbCTzFbTKjneef7eUXxnlRXELOC/pW24w5bO7vzjIVA4fK1bQo3Rw/2SJ+hYFC/Igim8aWjdHjRSPIYv5dmSfR3n+nDPZnJHfLeneR3m1R45KXTORFvT6hjE+Cqhe4wsQn2W1c+7ui+fHMfH0aGSXcqwhmpJpfQd5otIcdnFa3GmkU8laR7uvI7b2lH9aWC7UJWiPIw0Ktqg1cniRM4I81oUg2Y+cAAqg/Dn3t5r54+A6kLrwEXv7s6zUHJ5ViFpbxc6Pxqr62vwCcrK/TzzV13lnXaXI+atRbQl3dZbR8hZ/LFmWwCq0IseseNu2+qIidsGq0i1XgUFIa3g5a6kGzw32ha7GEvp2xGFEsoMt1ZYjdPTZiC0Wqlr3AWuzeUFBG98sNdGWHk1MWirEee9170c07rGsxrpv2UNRq74+hUDyqQFvEixDHwLUBV4uC+itwzb1x9XdFzlkZnJuAOidZ4iSCPAUUVIB1hFxhiTCPKxGuabm6d0/MEsohZilfoAJF0oI6AiL/njBfwMjjwNMEQhdA6L7fyy8SCB2j9FeK3rWmxg/TIwiOKmZjikVbEYz2ikkivoCq8jH+yX8gGmgIEj8cQIJ7p5DNahG6kJ3pve42ohyD34eZReG2xfzHO3WZbhFCE1XLS94najgv/xHgF6GGTmQFhSnWqESkXmuk8RQgdP9mBf7Qn6YClH6hcrlmC5mSVKGvAz+3Dx14UC7/F271XX5V+o3Lj5tVLv/pw1z+attS9yC8/QuM2U6WXfkiIAN5zWA+4dULIVjGUJppvuUekWe1opUa2mxW609r/VlkSP1pobfWsFIjfbsx7cF4mnu8ycIoWDW0VXRxGerxj1zllXi+If+i2j5dDseyTC8SSmrssGYO4FZAv/N/9QLWwxmunYCQkvxLQvFI1wCxWjwRSNKlP7Pbl3Wm0Qluv6KyAdJileNHgtLnW5Ps53isP54dand1HD765uLGPOhKgVG73eGvkYlviMxEWFhg6mLlWhlSTIFcc2Yo44kUBYcH+1hxtwj0g7LC6RSrA2NrYUGLTCkBiFA02hYEr6FDPjJ0gnqShJKgLP+mR65EyeW5L9/SKXyfMdEK5E/DckH+1Jt6cY6w9hetfPynCFhgJMcyM8MBDvQk1BC3uV5hDSa0VVLpUdplAn/XECeJPo2ENm51ogbEUIgk9J42inCIthVnrEjQfyrGI+lbibgXtq2LKwXw1NISU1+7pWDYnVfLaEWsVeUNCOFBqY2vDqiNyFcb0Sq1gV6CFXXzREM4LSkGXKJNTNb8a4Baa0009T1Zq2NsqW4WhYAOJAmRAJf795RTmH8dwPalkZReKuD99IocvX7bRfglwmeKkGdDGFdFVwS34FtOylDnQ2qYOvZnUGDqieoLGrZd0DDbV9AQQz24ifr2wERZf6LswET5JPwOGh+gUvdZMOwnqXUk9TdN2vvcNNHRv95GhuNC+O+v8WIVbBWrIhGvqmir93eEtiWMFQZYGGh6GAnLESYigkhIObgDBybnJNH9TvI9agY1r5GgxiONOA6DXqsT1G88Rt3GI9hrrKw4gIE+uSmvEITC9RpZSylGWPejEmUdpSz/GK50Ao7AD/cFrzHAtgnH3zri8KkKCPG+Qli/DQuY+g0ADVx1yNaeD8X+xsFDML9WJEqt5qza0JwC1eYhEvhn6pFo9ChSkQtV5BIVucApV7JQ1lCDi4ulxhqMLmnS7xmT7c0+zfbbp/mtzj69+d8f8SYRxx839pajO0jyIkGSFW3VEyOqskfVFqeUOmOmAAPEgWEpMrFnbwJgJh8nR4g5S/OfeOYYcSn5nl8sPrGa5fmeWb693yzfcQ9meWOrVskqWHVI/SElWBnX1fhCFV6C20y200VBs6JgCuKfbZYx6WeNGdkbBfN9UvDqXUJBpVmsNEuUZu0hpBrBA6xDSaWW/5pdavkjsc3qvyf4iXtOvEewa3f1Eey6XXsn2FXGSLyXY5RMCR19qV5dzzVkvsbmzFPRoOSSbKgoW31bhZDmdUp1en8yKh6lAiZOcjI/HZt454Cqnfej5/MD0fPuPdnEgGy3+qet0izI7/ppWsYdu/bbMioj+Woco6rV+K0mgDoOBsxjKMoYwjPNyzPdbQoo6sVk3WfKYwpRo32slSoJhSgEK6G0rQ3Vu4Qgqs6b75nZlHSHcSfGk/6TCXyjcvBbfWXYbPZRCONse1boTN8ZEMDgYQcbkaZB2CCZ5wH8VHjt+l0/O167YddPkddu/DXjtZt+pXitAGF1X7Sfric4ut67Vb0OfIhH0neAKx+L7DXV64dkpkfzsJkVjfq3iOIbmJug4A754XyMIWCfJH2wYF4/lILKXEiGf3iB2bHuQSyDxHjPY8FNYgjpW4p4dMUuhytmubMSLNe275m8dIxcXFcW31fJx3RfVc1u5UmeXey+qhq/hJKFV2HKif9vnCvb1Ra2phreC9kx4adG7uABlaOCaJmKx3m+vLOUdousRpm4GCVmqejIN6wo4J9u9UK0xWLOVtuXijFBI6re2ZKJP9sJbjHeXObYH8Iez0S1srkjh7thBl9Q5ClZyk8NMEFcBhQSKRjnAojpOJdRogGGeltmTM6OKGPMLR7DNAK6yFJFgksD8KBQPqtav9NpeYhAfWRCgWdiFB4GKY1UW7ABM4pdRpCNRx1g8FOcEfBQu8UEBQxc+1kA+2LwGQbtjVQ6TnULTJ+WTPBAIWn4M6f4+KAlg+N0z26K9Yqs3Ba5yoV1H5ad4NFvd+8jTfFoMaldyIdYdYwVrXXoGaULUGKaCWggysMCLkGejJPGQM0xrtvBd34ysF8m852euUP//HB9NUsjXX7h4swTrr/qFb3RufI2TVdPuAw1LE2TPX+uBPc+7cYzzfKZ5kZG6sRzn3bmynXXvIJJ+rlLz5/j5PGXbZyr4XxzhSYBuOltGRUf296IirPnzxUziLgE+DE0ybumc8UhOhOHVvfjXovZ6v5IDmvmRY9m073XhWJOT/d7pvJpW4mDrz/MUwTirlWi4PJwGgW/88Q0dCotqFfkzaZmUjMTFBRlMq24g1xkIgN0OPVOOolknmPKKa9HvO3Be263LyjH3W2157bbYSIkOuRYgcZ3lwNN8oEmFlXzPj5pg0/GKIFUJL5UKJ9E+im9e8DnVXt2K3ClAZgK5FKkwEM5TeYPFVvbAHnl+j1Pqi/plXsE99ttue4Ft4Fw+hfTubEk3aLLgIQsbsUyIKHDLi755yJev6ptmr24KMjikKt1Em2iyb6m3Kw6lKuoVBU9VD65/l9wjMY6sPK6ynJJ1jGO29ZTzighF3uVRWXO75i6qsgm/x9z0wsLJvNa6rxO1RNqUSlQk6YHJtcvY4JHkyJRZGNkQDwkozKSkMVCqsvjAyx90bvseHAAyQcEMKYGwzPZa20E1bjWKHwbq4osLE3RGOZ+TOa+lOeII2RdpJa9sEMxJut3FHNHVtHUTtABtxk+e3TIElcFOWFifVKDD2jmNornlOiAkfc0yD90WmIKRtkKIJGTX5Z0ZJTpRGD9zwHGTeI4LEPG1mr3hdVqvakQYmrartNM0vgC/sNVVUSYFMvQeB3g3wGNEqHRGhpTsA5crG2WV53BFfeRQOtnXFxkNKkmA62bpqifhdxwrrCKLXdkgMFgvZSwUZQtiM3qcM1akcPyTiGT2qKiS+kdplGMpW9j+q2bdyfM2/npWJ5D92F5pvZpdjrcG/QljW0AwLEiY2yFO2halYun7f5FSK4jtxh5v+5SfVFPCQb2ggFVZnl2RopJ7qOpJyUaxJ4Uf0cu7kp+u2HhFSaiTQcNlNCWCTDJBKgB7LyMWZTTt13K7xf7k2A9Q0pWbai0b+ynra6+jGGViOXHe7efTEhRTIqrXJolkCYTGe0nso5TmWQPKC48GvuUq+EBQgyOTMRZUjBiIDH5ljOEz8E01m9ejlPsoKt7losJ8/KUgQAqpnG/Y2UmFSgPbTbdGQTKCT7ZcqpbwvVsgSzD3Dcru52iNtAKnPi7wyQBOruSw8HYQ+j0ywVEGPz+w0fsvLElbDxB8ClVMGy145EuX4VEc2/0cvNe7sO83NmFRpYIpOhA+TjVnKgQjYkQQYCG4+HBaA8cB/hNvLjcSNUESD0hL03BELDbino9yxKOhabVsibdqzesBUzNKjivr8zxGGRQiK2d19Nm+2qqx1Ozm+gTRf+yfvTRdkM/7ynQBajRmhZKQxA2dxdtvWjg/l3f6X0IduZP4LbFHEgSHR9806jRN4VVoWH5kUHC6IpcKCKZe/N2QvGoqHbialS2OAy2uYvLVqOCFqIqQ1WVar/53nCBmzDMtQ7Qp07bfwCsfxTtzP4GTVmf2bpXM2MN9iqaxXhPCXLpOMNVX9xVBNYgtSyIuX45I041mIK1Ec0wU+zmGyGQBisshm+9QW3TQVnBvDxCRlIKrCPZ6y4Z3IwquhzK70gaF4iUMPgjaEZvai04U0A7boeuspBKz8FEr/7gkprssuxoup+RLj1lO+P603kSEigDVXaTdqGwh0/7veTT9TonnCoMv32qwiNLn0KCVEI8Q/c6NcjJoPSHBtxpdALrwid4pXzdxoQ8M3SbLeuqZCl9p7XBdlt/QoXgB1LrZaU98y73p3VNz2je1foLTI7e48/KNUVQpZxjri/Dy/+rS+GZJ97Ij/hS+Htz+uCUWkhc3DlOUXezZ9Cp9Z/jsHoRidmAgiRL5mnXU3DtK7SkzqwMN33a9Q6n5BqKYbyv1YpkcEN2ma8rHna3iNEvN9nYMdL1Zr5mYaWAazjkOaIm8OfINnCvhTiBYAvd0hCDOX8Ok2AaD+AKBrd+6Wm/Xy+jW3dzdxXgjdxK2LvadZxssAwP5C0zc3MO+MrMzAzf11z5a65JmTFHSWm9h2XmJs7dlZmZmZmbnN//S7a89nOZ6w1oBaPRzEgzo1GUKUnuEAIJ8EsbFN6rszMSCJo6nVbxzF/0tCcfUlnwDDRCIjkdk3dbv328vzv/9wXMTXW0fjdzQbq2sfRxd99z4LI7v54K8/RbtT0opGYGfnzITjqKg3HktmzxXfKbbBj4VXhdbvfd5tv1uoebQz+R8avT8yyVRuk72d1pa+QjdPECT7KBH2mQTJTBg3fieNLASO0xsk4AhlUCI/WjMITm7dA1pxUGK9q6ttZbr6Zm4McKUPoBUQs0QGWKuRBoKBKn1vWiLVORls0VWzarll1o6Xjsess6KwKguqUI4OWKAF7WAI4GAA7FPBzUbad/osLK0gXrXj/F4dnbn8S8n8c66xewzvUMlv3fPRXBsttZ+6+DZdxTonFfNy4Fd5RoxDY3orFsV+czsw2SP/eO6Zl6Tv07ZaJhcskfAf7UeNGWLZGWzRVbas6ORsvqMkF3foGgO175AFg472BRwD6uJNvMJRoO0Eh40ZYtkZbNFVvqAXSiZdVvN1Nx+gTHq/QgZCzjx9AH0vilIz9xLn/CLKNGYVw1PXZ81o9xSyvOJrZG1eycmaLG8iI4LfPQfAG+IEONgAtCSaqRDjUxF64jOJSijbUrlKRWxrT8gPMch7W+e/h+aGY1nqmCwg71q0zml5st9Wi0omTJon0kHCDvrweEwmIZijB9fuoq/PPWYSBSwifrF/DJ8n7+TOMQqyRw4TiVPoroecPCk1NU+azJ1rvkRxDDCJBx8EFi6VPnnbhGiOLqDCQj41eC1w14xp5YcxsOWONsyWqNsIZCsOxn+rpyob7jjlotRHFVCViFMzKANlni/APGIMrHQNH1a9j1ivgDqVxDBw7xbfAL8S8Fs/xGvx3athdVmYMRldlfUWXqFc1mmPhvOWAuLuZwteNNicdp41mdFq28oyocf9HSI09u00siLOrvZk7Kia3yBvTgp2IL3gion9AXoRT6CZFKdz7x0HarP/NGc5h+7/wlTn3zje0GAlUhPXrW1Vu/9u+7RoTpJ3adPm9gLZ4NwvSUrxubmpqOSQVIr7slP3cgO0jG9PY3Ddxsropd89jf2fnl0KInww59YpB0mZGIbH478FTrnZhlkxaoRzSrCvBTIdlrtvnBDLy7yKyMOnr4UdQzIeQlyABrxytuXMdMH+gdzDEl4As4RsjDc/BcEHof9sFltDh7zvsA/1v0dPim0+c6YPpW2WB4DuQ/vurJA+98O60/TN9+9XX9F36YHBGgyfCn1nDtBmpYk1OXb3Z+98ZHnzsw/DHzce4OygY/LEX+eJgJSFXxR9KjDx3af2WCEEF99gO880qvAbjUsm3MEu3uWJiZbbkGzoVrEpBGJZrDlMuIIg/p+bF+r1/IXNYo2WVnBrQ/hCHBHvp0dACkTGZ2TyrRWFF7avxYragcldvWx/kA82x+9ea9KaowpRHV509O66KnZhm3cduiB5vLJ77uihoivj0/D08ABYLmLy4BGHbEXtmkPeTakLRa7zs8aXMxjSWFrsjPV7kYiVJsiC1tHmZAE4XJYE5sFt3ZFvC7Y8iBWNIdntr66sBCOGWnPcgLp/flxH6Xt8kTpXN8tkgBzvqoMGENymh1d9BxWZ+iLPdce86vKGVqicb2541+IvCruXhj5Q3U+i5FJgIm1hJMBFzBLLarCn0KY42soiTWoN5Fdx7xcHXfzFRI+cN7erMRL832yQwYVC+K+8btsdZdqSCkCNZeecSZ/76j4/7Utj3+mAXXfTSl5A/5zrfje3t7n0n1KPl8I5/v11AuayiXQYihFbEnluB7+NHSQ+5bzWEQBF4uymf3H8BnzRzybJeLNpk9/Zjm2a9hf4IEnPOo+54DqOoADCTXaxTPEz+N557mufc78twjzz3D8yLKWIhXXuKTps9mbdscEuMg/cTlffeuOuZWxf/Ay7qudTQZTwGwWyqw/5SWTs2ki2ZYmkUmcBTlCLlgrMzurs5C+uzuru3qbMKMBliNPHGJi4DMgacxCWBGzpK2EaoKBi3Tm6KsuD6Gxk59ubMzaSlB+x5WB3C77EDaGQaMQ7Nmgv2B7xSsETf042hx3zBJ8FAWakNR/olUIN107QtjwY17UgxUUtdIVzFv2RfTExdcd0bqhIev/OrYY25MKc5NHbm3skYKVADQ3D5Xtb/XezOA3vvk4ose33FbijoHLJUuYMUVrD2b2ybBZsk+MPKRQ2ff7PosYKGCX0WGxyV+WWGARwmdo6TSVj8yxfGQ0yqaE+XRGS2dfqJtKdqHsQ7+XXP1EmKQUSKZUFbjHIe0znHojb6djq367ay2pd/EGH1XotJNqpKFanlIRxw3OqsKJqIgIwlHpSD8AYOH6WX3vqtn68+WVgLoUpEHmrR22iqgqFAOqZ5Hvpen8/bLbpqns82Jc3f8jUNBvTDdZH2y4LWgOUcNAZ5pu3oF47dyN+kAG/GBfBmBlhys3l+0W3MvZY93dPweq8vrYuNSRcl2WvBQA61QORqBVcW22Q0wAiZjExuMwN1/9iD0L2cMfezoTCm83NQW+KJ/qrrD1eax8o//2+E7IOW1ICDI7VJVF+rOCDISZYMsg11OamppPmSHk0T301vSE3e+OvnSa45L0XoKnKcS+1/G5KF3HJvrzz7I5EerKWYiqQIgh+qgtve4bYsuMTrvr+vrtW/zrdb/HsbgVPSRVoGEovWhp28Zq0goWie8fscXAjcRI3nupWOGkLTVjiKPbgxVrV8XNxvguvJYteWmbonrGkOxbO1ar07wVV9jfN1r2XEAzW0XDeRuQuepQ10HhNF7ljYv8LT3Two10fWt/g1MrXHJTakxknH5xe2bHgPJzh1Ca2X7XOM77bFRy2Vx3yDmTPuZA9mVxvhuT9JhqaOfMZDcePucm61065j2sy5ZfMS5Y3r8+Bh2johUz1jp9pyrOyO6NLLwq3ECicneCcrxQt5xUEZTO08+TZiNtfxxEnVQg/Jcv9M6z2FQZAnp7L0//2OVUxY7QFeMHbB3KOEJShIdxg1cEzc4RIpRA7rAhA3Q6hD2LTqgDuc+ZJSuIi2koTF1EqM3gYJ9paMDBSgihg5LdZBAgxmlAgy+C9AArqIErokSHMbongVdvI+EFHWshStFOgaArQ4RFLv1LhCC01d0lsRcrLbUyVP/X/SKPiRqXHLnhOMdrZBmPP/0LLGNUhHX3DEjh6SSPm03wKiOE3he9k9s2WNkyURGyabLLvVE47onDWKfVpQrtMFPCLk0ci/KpY/2TJmZLZgx69gl8qYX43eYuxTEYMjOHx2+0XfQ5mXOSCyBFMb0YWseudJHq73bTBukRCBDLgf6ST88aWDUvqvsBR/mk/0fvaO1/1b4UeklX1zoyv22auIs7+kfgGezF52oEdonQ24GqszYKdLNTJQiE0RRloV7z/SiQMp4NchoHM9X723t5wsstPbP9fNNNxTyNthhyuU3uXm/P+LNOcDWFANZqDYp9FPJgwvTBR9N7w0AgHRUqpJfF6YLnhx1SNEw6VaKUvzATkG8fKfA0TsFrpHReHGn4Bc4qsT693ZU3TCjRul8j+fulnnuzq/13F167uhQ/JUJQgTtP5IiSWF2CkTJToHw3nbiXBH5LTDXijPNzVexKX9xLrtANVCHhxP5ezFYUiNtlngZv1bW7qpOzCfwi8W9ZuHb1a+TdvS1fpTfYFZGfKSYoifcbnDuDH+KxfXQBFOSdoWSuvmlNSVpkXm7RgE6U5Re7E3m71Po9ZtM/0SzseStQSmieG9JZlXpa03pq1d83a1OeD8wFH6AvrT5INc2uUBdWnyQmx+CVToE8K1y7QqkiAxpftW4Qp2mSB1gmhTEqYRwpLOnuK54HpgGDGaQ5YrhmUh2rXSTDNvJBPefY/zFsEct31wja55325PW/zi1aqBZiiA8uKXk1bh7hLu7JOhW327P7tQbObpnb//DyUiJyYnIAySvwiXF8ypIsIzpnX3uv93dtHxf6/mp9fvA5337wylPfoJn9B/9dOfej2A++Pvd78+TP5bzf3f+Ttdd+PZVr9121kvn33Tph+/e9tkXf7723lnr5fz+bSYPBBlXngQodpBTAkL2WwNrt0NeACfcqhUTIBPEBJYxkMCWssnJE2NsVZ4hFAlk3LMPMQ+YZy+F9cg93QJFLoArYsbsUoTEgCABfUGCycUuTTOG7BOmSGJeII6uIAuxK8cNtTmxWUJRisVaOSNoVis/MmDs5oN1PhMvEe3LuXraAnQycVmaiLUkchBMsoAxaaVgQywzhgWfQiB/CwhuSIkDYI8umltnsH0EtdhXz/EWS8ZeE0jtHlEQ9VsIlx4svErgCnBH6zyYFXYNMuO2iTQ1nmI/C8W1jWR2sTeXXHtTubAHdn3AzYwoA/IaXCjMcks93f4cj2ReHbFjzCPT3nKHUTIMyXeFvB/y1RoG7ayTFJulxJ2zlhhW27mutSkIFrVran5jTVWnZkVgR++BStrbSQetFOdBSoEyu/ZqmAbXDgWmxCkzLmNbOzQW6gGloESqyftSMphQCTlNEVyEa2xM19BOS2t1EgipowPz7xMULLR5nh1yrHtgWq1901POLtDl9z725L2PNo8/+cSTzz35xMP3XgEWnafOHDJIHWr1OgOMHSgl1eHzLrisWd9w/fyjegOP32NqixpiTnwCYcPk8gCBRHQ8LrxELjSlBk2yDWPsaXcIspVM4SRjqNaXOG3iwXDFF0x2Ps+qlmLW6R7r0uGOE8AMy/2Jk3kAKKax16hC4q1uI5gNjGvICUyb/BgiGLCcwn4Mp8Ew1bk6qMQGJtKhlKuPbhFTR8fSM3bOAdalPLrdsqcCabNvg2fFekChenP/HYoW1km9F6y7j8udWSX1GFYdXvlE1ZnMGEVXyI5xHvf/GbULsCi6qAHANmF3w2KhIA2KMHCwm1CQhsUg7O5YSeklDBqlG4tyllm6kWXBBFzKhBnAwOLjX93h+e7f8BQzL3e459ycEHWxI3b7/840Q9OhMLtHTtHJ2n/A4eQBYVGhD/1OTxpILeh//T+JsMXt6JlONIhPHrDbJ/yrP9c+y9Bh/F2q6EdLQw+Ihp5YMUUPN4lxomPQNzEPCQn5ABdjV/w9/2HjljDLrX1EESzzlh/RA6Kned9gxNBPeW6f88pnBGvP6uVLHv3ERLt7xMXNCA6vkWD0C16Ixy3g/D3HRNxs4+xzZxuJI4ZZjbF7F4tcD/HvCh5p8xqJRofMyA7Xt7holUb8/LmbtvkNhEB3RZDT/DEc0UnEmQsKve0aiGrXHVuUXkwXxS34+q8nursrj2kgtMY7d39e1ySqPxfxLU4mO+L5BDPYyL30PkNUPhpx1p3Q5s18IpBV0rDTfKnIWYgzWvPa3tcTL+SzQ6QuLRM5E/EbLdMtPOsJyHyaNaNy5vBcD/HzT3+tXVFPnH21e/kSi1mi+BmI33EquFPOI8YYv3PEM6Tp/KDxp6RYOfCInkRntVJpaTo/X5D40394j+UR9hZjB4oTl4nKcxFnn2pbElNHTBr95Sp5aILIoxGvexS8VK+OuKbwJTJnVQ8+LGchrmdzZE7uU8IDC0mRM51I5wdxZlNVWk8tsSTDPTx7mTydH8R75I6KydYSUwbB2EBpNp0fxLkGh2Ssaoj5jpVPAvJk6HGBeHRoWb9/NaHuGuVocEF2eC74jORH4bR7YRXhn+2tkqk/V+RcxLks/YrPlYQ9uwb26edhomsintkmjS+uJD4WbGra77OUMyxnIW74JdxiVwXR3lAw5iVPTuRMxOsYB6KvlRMSP19fIzhD+UNcMGWUZ0oZYbZt90n262E6A73+3HeTn5US9m0PYg52TKH7H5qfhOPKgyXEGsMpUesjpYbngj4k/rvtnctKCH9LMbZ3C0PkXMRZVYfldxYT2HkNu4IJs3WG5dGIs6UYv08UEVrGsjvdz/fS8xviPdLfd90sJMSLT8xW9l1C5xdxplKjXHYBcStm6pxYluLwXA9xdt3lq8+5xBfL9zduOUnqDMsZiAteqwR0EUSfWoyV8ZmldH4RHyEvHB/5BCYcKCvV5XSG5YJepP9a+hvb4MS4fFsz0wkL6fwjLtimdSQwjyhPtnyvsWapzrA8GvFolWcbi3IIxz1KO1dcnj48ZyHO7PSq78kiXp1Sq1h9exmdf8QZ40Bs/mPC1KbUznKUtM6wXA+t//xbz9c+JN5M/1H9ymbl8JyBOCuGXHXgPiER43/W5vIMOv+oT+UqS2YQAX6rXCLNFYbngh7E555oXpdC7Dj+rPOi84LhORdxruo3s9MJBHm3T33T75WcYXk06v/kekTGEMn/LPuaPeorNixnIT7i/KQw5yiiQ+Lq5WWsFZxhORONr1Fsfu5tYk38zyBj3+X0+ELL/85M5PoT4fH8b5el3uDDcgbqUw7JCa4RHXqvJkLbXM6wfATt/+PPMJxLIe55ZuYUFryXjwg5VDaFzg/irCCzPQw21Pe3jbNsGtpfoeUrli/degfUJ1io5kXL0fVDXO+dp/XaaNj9vNeKO3Uk3T9IpLxiQ7p9LCwf4Jw5NYtufxbi3KgZycGJcGWZRd3NC3T8eqg315yqSgWx5S829znOo/OH+jiuysd0uKRdYaA7dZLIBd3I+N7E0759H8IiJ+6xVh1aHxEX8BK+ch7Cc/3XcTbl9PhjIh59e6fFh8cgtdAaG+dE118Pce5HSf6IbFDtjkjylerCRCcR1zO3tlHLhVebOVpWUxfT+elC6pfmW37wCXQ69suz2NPp+iGuh480u4EDP9WilLdpaH+IOEPSZU1ZPgg2vs1w5CrQ9UNc8HpNwHsCBiTvGjxTH5rfUZd19ptdAH1iCrXnKRl6/H9C1q/FV+WTC0A9RHODXwKdn2jEWe4T7HiFcPfR9arDEaNFzkKcPTPz94Ei8Dy5fXGiUikmqh/imWouOgHFcD5rwPiCCz2/M1C/29EpWwJlV5w636vR8Qs+/utTfPL1TUvhvCK20vvp0P4J8eNnvKf1lEKrTHin79Sh9kfccIObr2cZjF0fcHyK/dD9B+Ij1nzKyC8H3soPycY6YnR+Ue9vsrCogGOD0WbL+8To+RdxgRfWHVQJTjJ7DNefpOcXwQdk/2Np+kKlCpJbU/V9NSaInIu4QFvTo64KsqYZmxdvV6Drj/iUntJfx6qhXv5WycmuXlxUf8TZDZk692tAI3Nmv9ygHF1/tPy7wUm7a0H5y1qm7LRCTJR/xEc0d6R9rYWpfk8OzJSpxEXnEM98eHhByFNQfjOhsqtqPp3/9/+62U6m5ok6CNDvnvU6/Ds9vyPOtHNQKK6DDx+xWd5zZOn+g/j7P/2TBwt64vZNkqHHHxPx76lVVod4cH1WXH9N6ND+E3FHi30hBA+yOZuNuuOH1lfEcyYd2TijHj7mbcpr8ZAUueAdkr+myz359fBljOG2n+FydHyIM/mtvTP4kIPJ8C+20e0bjfiU/LMOh/hQfq43s+boVDo+xJXVzu0q5IMVZ1yWsfYckTMRf9+4+NHcBogQsLtWdYjT8SFefqLQ90QDnHnmIFErq0TPj+j1Z0cKKhog9oXkfE+GIj3+EY/WFEtf1AjmZfuvH89XpON/i/TP8t39lxqB0rMmu9Ok6fgRZ5q/4TQ2QtOBWHG58ZIc0WtWBz0Ragpfjf95rnCW0NKOxEP7J3A4fz/eeQOYseilToD87Kd/XgvNrot1+PNWhg5q3dDXEUuKRR9MPP4y4e83FNWGm+r/fFbhqqUfJnhuAv91XTxK3JhnoB2Gaaj9StL5RoF104vw6cwTuB3rnG5oFwU8e48pF23YuNu1o+9ntlMw/ZuDxq56H+y020x+5ksKfvr9WMyq9cZbvjWvOFRHgV35Wzv9fiZWHnZmzsYyCkL4apYdMWzM5XNppW4+BUcuuVjHh97GJnv+OGz2mILf1EDgvMd+WP/mk/KBqRTwwpWO6+TrYvd4fNWuGArGH2V7qo8+iM/n/5NhH0bBJI6S3K49N3Ejy2l1I4MoMPmo70OxDPFqlcNcjhcFs7405i6uCMAFCknpoc4UZJhYfWjnszAjv7jyOxcp2BIU93HmfBZ+yegKlnOSAh3VFpMeaX/8o6+P5o+DFBC7p4OPpzd2purYJ8t9FCz7NPVs+MtbeIPVGFeBJQVMJS3d/q5QLDnXUcXDmIIITfcq53f++MKXvxcZ7qTAtyh+w9pjXtgzn703tDdRcGVMR+bYiyzsVtOVgK1AQXBiYvuA3y1Mc++Zoxc1hb7ldN8cGw8M4h8Y1KpQ0PdO+o78ZhbWfLntwEZ5CmzET8ClnFv49X1fW98soUAlReJIa78z1toi/TVCSph/4ti8MBkdnP3yVd21ORQ8kpxw0nm1NzZ+dEe82zQK/KtqPQNnHMX2KOkmZUygICslc+eZnS7YzGwVyX/GUbDjdGrbyHXumMqLHb+Pj6Rg23e+9Zpmf2xw1v4H4r9JGGPpp82Kccd7owJtS76R4Gi4vbp7WyBelaS1OqGXBD8Fo/nfxUJw+xdjj6R3kVC/Klj3Pe8E3h/Vqf76HQkz59c+nDs3BO9MnF6k0E7CkR1yCVui3LBF6tN2xLeQ4OW0/CJzWhC+gJU6ZuMrEiw9Z2/xTzDD5RT7ZSSfkTA/dKtD2MrL+O1Ew5dfeSRMTS1kdu9bjyl42jHFa0mg9o/TlrC/hZmOWNi9tpKEC6PvvmqtPorVYQWP75WSoDxtMvgNBmEt/Oc9ckUkZGZcfFLLPovJyq1qfEWQcE5g/ImzMAib2DwQ8gAXxhNzYoR6sD+esDLi7INcErbGBDVVt3jg6+yf3nuVRYKt5mROact53NkgYo/8IxK+WV3q2jTNHZ8caF0Ze19Y/vnAnLEaQdgr2cerNmeQMDbMSyn7ziVsoOx2w7Q0EiSMF7S17mNjK4y3NIulkPCxdK6hW5k6lr3J3GtZEgka3P3yb1WDsS0yaTOPJZAQdTbEbluHDy7RdDa3NY6ExJ2UdomaD+5mopV5NZaE9A/ynud3u+KMomr1TTEkmJntOd9cG4QvXWTirHmPhP1zr7KSp5hip5J2NJjcJWH5IhuCehiE12hfs4+MJsE5V90jbdpBnHg1/sw04TGZdCSHctiHK807gD2IIsHohsBYp4mFuwYb/bgiPH6qa3F1v/R5/LRt1/szwuPMK97cbaQ7fvp63JZQ4bHXWxMp1bnueIXDuj2fhMf8BgmbqnA2BtYtBk7C6y+M25nbpHoJ9xj56dQMYX0OcR2MB7qCMdUC5ZHdwmOTw89SWj8dwPbqP131WVj/dU8fKpXcvYFPm6drLCuMV321dm+WUxA+vXZHiKcwH1KDc7VcbVh4WtniTfOE+TpqevKFYUMw3h24IexlIgkjvCZZOqSxsRB7r5dlySQ8+thToJTti72OllvXmUrC4LuScGbWAdxnw+NZqhkkbLD9bO7y7RK26tzMkHRhe7roSCVISwThpYMB4y0fkbBC6rB3TpI13llSk7k6mwTzXPblH4sP45N3lVdtyCMh+ceXRevXB+KG+i1RzhwStvvZPz9c6YbniVUe7+WSIFsbIP874wTG7olxDigm4ckpyVaN+iPY4sXtc/eVk7Bv0d5FY0o88AOd1pfsq0loVGlrd1/gjakpbOsKqyNh5hOcz3sSgFsv1X0wupGEehUyXKWajZk9VJ4e+ZKEhxanjro6uWLEwAWTQy3CeCP8bte8ccYvfuYTh9pJ8FCrCjw3zwdL41uERL0n4edL3jb/S2zcPst3hRhJQl56056XRSb4r5kGOfc+k6D3LV5nUiwb1zLv9D35Q5j/oDTNL88c8c02v/rODpKg4WV2qI0MwLeNu6ucOZaCmmZbyeeDp7H6gu1sqQkUpN4J/PmLE4BLSD23LJxGwcMJGcrpR09h4bvcmsPmUhA8EGWl2u6HXawbtE1hCP/eXILnL3DFtvNMFXtlKXCYp6+ZUbMPe/xuXPARJQoc5wYeXnnIAXNiU02M1RTUP652mePFwn8WWZuMBwqO/RwE6zR//LKn2DaFzRRsTTqjmT6Rjfd5ThT3MKAgQUwn3i3mNOYR+6tpjhkFkxfpMSIDnPE7LhWz2pnC/x9Y0Gho4Ye5qb4e/daJgu2HRqaaa7lizEcjP8ucokBa95GYTKMzbht2Se32ZQoqJm7WzpXzxFfc/TpjkzsF/BtazDFZp7Fv4P1OkU3BiZMRRl0lLpjLjrJfRqEU9ATw/af1++Ov2LH3MmIpuHJ6cduddF+818FPYUsGBeKM5LV4kR8ma2FHzs+jQPVTUlGwvCt2O+/QavkSCkg3nkrSfi9Mb+NRy7N1FHS3a3fkrfbDZ+SHpw28piCiJmCntuc57AU78nrBOwo8q5lrC8buxnpP/AfxVgHexs5sU0pTZmbGP2/B+FrvKtQ2ZebW4cRlZmZmxjCVme1NyszMzMzcsaPxtXV9mfT5eLJzZmfOSHE/ydtMr5b6+qdzKMdxPCdwIqfi1JyG03I6Ts9zPM8LvMireDWv4bW8jtcLnMALgiAKKkEtaAStoBP0IifyoiCKokpUixpRK+pEvYpT8SpBJapUKrVKo9KqdCq9mlPzakEtqlVqtVqj1qp1ar2G0/AaQSNqVBq1RqPRanQavZbT8lpBK2pVWrVWo9VqdVq9jtPxOkEn6lQ6tU6j0+p0Or0eJOqhvB5S6+E2Pbia9dH3Gdgj1GjqFtbdrSHPGY3BAwYEBpn68bzGaOwdYepqtPN+TIAWfu4S2Lv3L0YIHKQw/TwIitqfBlov7I9c4ULgXD19BoLnu3QPNwWnPWC0XmtM3foFdjFZg8P7doUHhFan4Pgo1OZwfLJpdYi9+nazPoylIXTg/3ug1nKqjAh/K52eUKu4OY8RaXFZCLVKOmSYcezLdxi75GPDh6uXDqpKZsR5hp5RBpIjQlzMUL/V5OqoSrsHPTKTlV1Cp/lNbU8aVWow78rYlWT4jr3zx2W7RXYUmr6++pn35H/ZBpnyFLhGMO/QQzcvhbuvMvi4pdyy5r9dILhbRk0x8jR9Rb9t+doR/3NNTxT83wiyJfuwHVvHjiCG4DWJj2IakHTh7sU0n6eRz5vdW/k+3EgK7IjbujbWTJp07J6BGzHfnv/qslUJZb5UkQafLNPuLeSftKrjg539cpEqJ+OX1pnuRbSFqzcYu7sluSslTpteuw5Z4q6K8g/1IsaEl5nF7H1JubPaxkPazSAPec+Yoecmk2ZPPYd0fdXGnv+Nb4t3Zx4OkUbn6Gf2hvzK6ukft7xKT0KSeg7XDqlMbk0bXihxHU++pfSJ86+Xn1x5cnbSru5qcrb6x/yzmxrJxcvRZy94dCVJYwpfGtS5A5nVpOGbddtLE3b+X1v3//J2y/uB4dEz/Til36Y7zU7sHK8U6POB3C+/X+m05EToifj7yt2j7a7FVw8hRcZcOBE000wWdNyydlErN68iS8b1avauglf7VUX6n2pV3qtwclxO08c8KQsio4r6fNq86/nwNoet+eutynDoXvHSytptCV26vg1TGvXmTfv6zFWWJnydcDsiVlmfp+339U2aE/2Hwff5UstJlWMhOUrlOknmn9ye3LXVA1JPM+R4xnqXScbI7188u69XGh2YfjrpuNrc/OnqJo8h//eL6cXUHnmVSwU7pPZ8Ul8xni1c+/T4Lsq7Yu2N28I6K3fCTx8pd7Y2kZ7xyuOcY8miIdN8G0Ykk/jmJeK3r9hE6l0/k2PQzqWkFJ+1So97Acqpivt8K74cb869ts7MadJ2y6WGO0xjMrorw2dEpNxKEpXkurmvxVTxU5p2O67XGNXK95DVAyZNMJDtxUddjljenbyP9D+WaeV4UkU5U6dCsfHkzAWpZsdhwaTzg2L3x53Lp+D5yNm6Efppo1ZHbUdCv9sh9IxP7e00W7Ggl41eU89mEz1G2+yXKTutVpkivLfayjXqq7whqm//zL2p3QD2wpNn2jdgex96Ytb4uM2I4LalH+zj1tbLvOGm4lN636aHNSq7+3Z50Sawaf+Gvm508AABIAJUADWA5TQOwKFlrjFWB9AD/t8FVwNQE2BwwUkAGUBccF4Ab4CPC84X4Aeo5YKrDagD8HfB1QXUA9R3wTUANAQ0csE1BjQBNHXBNQM0B7RwwbUEtAK0dsG1AbQFtHPBtQd0AHR0wRkBAYBAF1wQIBgQ8lvfc//GNY5QQBggHBABMDmxlYloG+Xo8pUmixZaRxFy9Ih15Kc2N/VnIXhnbkAnQF4Ajs6ALoCutFY3B647oAegJ+V6OXC9AX0AfSnXz4HrDxgAGEi5QU76b8h/wUZOvfDcagO8lj+z+TfontiuR+x8YLWlX9e/Y7WkQ7VrNus+55QtLqHQNqtV5gc9t8WFLX5k42vsv2njt344gNZC/RYaZ6H3WWhdrIN5sZ6F6rFQnRaqy0J12PJ0nvHUpuPW0Ato0W+36Mc46sd+sS72jbrsdVAf1YH6sG/sE/vCftHiPGEc3of9YD57XdSD9agO1It6bPHLIu/J1FoYK/8Wj31hXuwX61Iddl3YN+pm+rMw/aG1MPOD92E+7BP7sveLdWk91IN62fVkfx+QRz/GoR/rYD/YN+ZHfVgX5wvnw76ezO+3fT6Yz4eF+XzgOqMOrId1sG/Ug3Ud5+svDb3Xi+pVJkpSz0++9WJ7NzXvG9Vu2Zhv7c3vT5hGelZtKSWVCGjdv7yvdOXg+HyV7shmbd1WnwKqNjHvm5j57ay3jc0dJrQI2PbMKE0Z6l7Lp0RTyTO6wbX2tfzNRyu0y3Ra1VGi1kz9GIf3mbEu1sG8tJ5E9UhUJ+pCHdICY5MpRUM7SlfaeC5t2aSNmVr0m9Gin1r0Y37sB/OjLgnroD6cL5wP7Bv7xL6wX2rRj3E4D1gP80lYF/XQeqgD1wf1mC3VvYXnX/wlas2MlX6Lx74wL62DfaIO1IU6UTfbn5npDy36MQ7vs+fD9UU92C/WxXo4L6iXWU+06Ldb9GMc3od1cN2xb8yP+mhd1Ie67P1iP9g37ZP9fJiZzwfmRR1YD+ugLrserIvzxe53/qvx3+p4YWEc5L/R4aE4X+cm/828l1aY639JR36mjorRwZF/Z/0Fpk4dRgf5h3QUZ+rUZ+q0Z/jG5J9Zf8LUCWHq9GD4gL9JR1kmT0emzmCGH8XwPcjfs/7+TJ6BznVGzGT4OchjwJ/UUZGp09k5D5nN1IknzDXDzyB/bv2bOuchk5g8K5k6Oxh+K8NH/k4dVZ3jlH6K8zXT74jdjM4TTJ1DjI615Het/4jWTJ0FznkCUpl1ucTouM3UucLoUH5Bhyez/iOd4yK3OPOlrzjz3Evm/ndMnWeMjhOEXX88v+A+Bs8fuA/B8wPuI/BchPsjPA/jvhjPM7ivwfMI7kvwHIn7STy/4T4Ozzu478HzDe5z8ByG+zE8j+G+DM9XuM/C8xLum9x+YeQDDAYUYPwfk/qF7Wq6VR4iet87lOmU3CvBZ1GFxlflrQ/OhsXuvS137hV71a/6A3n0nfxqsuGxvPZjwbC3+mfysAENKlZPei5/aZDzwSP5gJxLudF/inG//KVv2x2P4/fKlpqHir2rsFvupFtVbc19i9w6dcn9hu23yu0rpkSvu75GzpW6ZeOlo4tl1DEEMBQwDBABGO647ICRgFGUG+3AjQGMBYyj3HgHbgJgImAS5SY7cFMAUwHTKDfdgZsBmAmYRbnZDtwcwFzAPMrNd+AWABYCFlFusQO3BLAUsIxyyx24SEAUIJpyMQ5cLCAOEE+5BAcuEZAESKbcip8okhPerEjn/ICHZIc3AOP3IFnhHcDG/6rfw0UeD+p3Y+LRj8PR7/4z9wf51/wZXfjdf8OPgtBv9WX4BX961g9jJWAVYDWd6zUO3FrAOsB6ym1w4DYCNgE2U26LA7cVsA2wnXI7ACe2p+T/uHKxXOKMF7yWyh6lhrxIybxcHpPb26PMmEh53uCigdsSouSI/4vaNeZdtDw4/+raNwfFyiFlsrU54B0vFx4XCK9EufKaqJ3jXiXLJW1jtZzHNtbJ+Wusy1dj3Qa5VqEOfU76bZGL7+8Jr53yrPL+8EqV077PPSi3sI2zMvvv6cHwqzWjcj6qmVv6UNOjTEbDYUMOQ8WNhQxZz5cz+BQUDHx2H4NmTivDyxc9DBMnTDBcnLjUMMVzu0E/7bahgn9e6eiR+tKK5GQJPtVyOuscp73ZgMY60nRsk8Ns4xy19+SeUCmmx1NL060lxz5ucgEt+mXIS7Uylvk+fSdgF8DsgrMAFECKCy4VsBuwx4FLR4E/I77DyAA2I4U7YPQPhskqIAhDC8OfQWNL2U1Io+Sk7YsNWIh0SU5hk1QUxZoSdkuHiUE3TtKWBrumdINcTz+d/vuuY7rGg0F5CZ5ZytKwqAvbujz+OBeN0UkT7Nb/IrMxmYc2xeh6zOO5mTErBZsR+abMtIhnfJ/+C/k70/iiH0/X4v2YZipz8esB0hZ4YRRkzetTOmwM1eFipw5HrQ8g15dN70w9GofPMO6sABNUWhDdehT3me5UBWkiUibLsrUPuexogNI3azJk9/Dx+2OW+LfRoyNExIYjDLh9Y+Yda4StjqM6ygL/wWW0JrsxK6sKzc7zvE+czg6bUwhP/cTBcw5cnWzNcUNnQqqHkf3TDEFBNUotJHiS8Cf+73bidiwPmaLlVDgVIvKlni2hChz1LSJu2mlMbzUgY/mMWH0BBISG0QgyoED9C2fXNpIZqM6CJYXMcGvhSu8OFs/UJbi9lLZD0wk4ORvXeQG88uhHVckPCT0T7k8uoVDmEqlFBSiaGSGOFWGBy3jvrcSFkvNo2ELa8wDS4s+gZf6KN/rd3BgvjZnvIPaXFPB6k4xdQC97b1siJfGZvJUW6L2uIf6ANvPmlvH6iB9bN82Fmem0iU5FprKJK2rDOM5w5ZylDSkDywkKrmaOw0PUv4TzKXcnLUUV7NIUwcrgJZKNb9is10jjhQiez5FDLuwL7zabUVKqjvB7SZoDy5DKW0fH9Hikm7ehPGkRoRNtCV0xgq4T20i9HcyMr+2sWGXCeKcXJDVUc9PaGFebSkTlYnhxLg3BuHa2+wVzoyAUmz8Oc+TPv7h1bCueb7JRirOjM7eM4/taWJDvhHnpUkprNJFLeE6BzXEmPvFj9ILJTFx2gaItRfxbbIrZ3VMg1cFLk1TkV35k6NV4yBlkRlQ5XpU/maTfxX9tIdz7XMjjXjkiBaLI99ZHWeQeYks7ODzxIsmz/FG+f4XlEQX4q6sgbu6OT/xJ3D7PRK3sNH9LrsLo73d0NoXzJeoM7z4d4JzaGQ7/cMPaWpPMobGsOJ+GU8wuvH2MOW6lzhWJR2R9FOG42nx6duugKjCNMeIjWC3sjOLPzSxPOsnuzyPJfj2PnsA4PFb4cEWyhRNRcaSd6ubZxvVUibYz66wGXauDuGvnTIO+NYZWozgYHoz5Bnm07PNwrx6P+gp1tv1vD2u8X7J0kwdiIvkodLkw2fEVskKXsBq9jjS9Or75FnOoT4qVboFMl83gtIs8JeUppE7exMl3rhyuCUfRZx2jY3LwE4qiQ9ULBmX55p2AY8FK7JuXcKYhlBsGZzCJGmJM2DHUjBqJ0LlEg9cxpB5+RrhJDwmthWwPucrWkEjGT4hg3JdqdoXcom54Ndonx7FF2hfbWAlsyjJ5HJ7OeMNsnrePZuUeWb4/6KZuTiaik5MIX6CCfagvInoajI2awnrdJKbfKODWj5tsXzAR9wIzlPZeJM/iDKMMQhFp7Wah4THc1c6hkyaE+CwJqgu30RVRREnqataUxhKvVcGnRE2SI6JoMHZGxq4R32MtOB/dwGCdFjevJdMkocbvAPGBWuzNHPkh8BB5B1UsLXJZPqyLa186e3I6kItsIjlEFcdj3Ywuk6B/jiA1H6az5F4MllP/QbNChDXGX5mUE4PG3Pu0Jk1hrUMCz/NjETMYx7a/Kpjb54v/0dGES/lQErcRT493tHyHC6s2U1T7kCTHDHyrqng2cjp32pQ4di6fwlQ/wlbU0mN1lZKQTlJaVWj47zwG27N42ujOycczUah7wI35unDrPKkbI3lgORp5pTRWhwRRKxSPb9JY/LdcQ3KiAvUPlej/OER43S/Cc4b44LsLwcRB9EO8OOghwdChYeT0hbBx0kBBOgyz7G+/8XSLf9w9iHbSQS13GwferEC1SZLHSibMt1nME69KVMsekbtriBiuI7DrA1sbrjLbczm2E5+Tvv0AXjYrcbNo5tyGEawz12LGq4dotBUxycMaK9UPHFROZPrdQq6payL8MIZvd14i2TObf1w+IDvsh/ioEI4bKrG24iqzYs9x7/oLVKxESeszZkJtGYE5T7lQl0+yVDal1/ch7LodZXMpZDEneHIrb4XCmCxmz2mj4xzKaaR2SAG3+Q/wD1+EQMcv0nMv4+y6llUKCawt2opSbxZvtp6l83E0Y8yOM0s3jhhLayYb3CFEO5ryWSPwbgjjSeMDcnd2YeYwgRFCbhy7ncLdvKesN1/BjIGxRPsUckNQjzzDxQjW+9O8tJw18v28Lv2XLx1GBNg3csG+mpocNWLOFOK3+SUu74tprZ1Ehu4fLJNehvkea55nd+ERUUKKshVjTX8wTd8Ym6JDyA995fPrDuYElOJ5ajHCzcUMvzmOh+s7bg+VECmcT4DVbtxS71LhcQl9H39KJrjSU5WI/J9N3H+SwUPW8+7uGHZnzONj4E52Vx9hjIQi+6TFCXKMYoS8JFf2+jI0lIPF0hZqgjT5r2YSRzPSKToziFqCLG0ehUQVa1KdYEFawn2qyscyMVwJT8tFKFqEc67yPa9npeO2Iwl9hYtMsC5nSGwVbzsHOKHnzrswRb6+PMBgWiItP5+hvPgJKjo2aM82ZWrNv+wbFGVglSsq06rZmHaANeeOsWlOOQrm9eSVvEZM5jRTvB7hEm3Pgq07Mdjwk+AJ4+i8P4HBsi4WZSn91p98sSqnYcdOnE5cIEKjhSdSj7DZfIG3llmsDy2hWn88Dd4rUJrWwC3pa8xWXMaWjjfU7D3L5U15rA3rx0JwkI9/3yR8jibaqXNwiqzH/EsS+xdoU/r5AuvHxHBO4w6Jb8biIrACh7utBB+O5/D/ztD3TJPZEffw37+Ks1WzMbxST/1yc97u1sXpuzG/LjWx46U1/k4xZKTsxbz7OgsPz8Uow5wtHsLMVghDZ3ko4e8/8fHyS1YOGDJs8ZVp40op3nKEqP6FvMgvZlxxFXVbb7K8OIyDJrbMDtND8e8oxtscQuF//oQoTsEkdyKHF5zkrz/CSSj6wMc6f4p0C1jQ+Y0ep98/EJGLw42FLIm8Q3aAGDHr65FtsMPlbQPno2RIkI/GuVIOkR9pmF6ZxZqzpXjttyMoYC7j0tWJ7zrBZIvPzG4T5v4lBTyDzIiVWc/9vmT2N73mdIMNkpojf9e8Quj1a/j8cEfn+F72P0rETX07y2S3waIfPMePwU5zRmwxo/n/FNwFXFPbHwDwM0AsYoL+bR928QQbn1d+wwRrYgcqBqJijE7ZCINyo0vEbgXsuHBGNwxsQODhk2Ybg9Fw/2e3v5/T+elrL0Dk4Kj+r6T6+Hu9kyl5CWI29lDkbW1Z5LZaZb/J8lWqeAazPUxUnuH7e4Uq/tSOM8sTq2sz5cu6AYnq3flF3/FfTYZn3fSJkXaG9OJ3fOtN3whrRRegWkv93/rf8aVg/b8elBG7zTM59P4bLnudPdoiRWWBaM/hb/ijltHSTaHEaIKLRO0bnrl2xoREe2KR6ErBo6/457T7sdydxDvU967jfsVZs4RP9i4l5thlruz6gsdWJdi9GqsKfzT4MOEL3mqVs/NklxLQo4BVYRu+YK5h6BvbH8Tvk1d1tn3G1aJDhfRHYp5wfUnUZ+w26afiWALxrdTx0zif8dW9G/X2CogFG2V1TeX4s11DSfQJ4lpjk8kR5Tic/7Bu9ibiaxXB2abl2G+D5lpmAbFo7vx/m8pwTerLyhm6xD3mC89HluHv1cs2CTs6iT/E2ZqVYc686tJ1P4hjZBGSNgnOu+smNk0lZldOuB8nwYGzazP5d4jfn9hZv0mCl/l/mTXsGrH8yoYZLaV49N8TJ5ecJ04e77x5UynePWHV55+7iI3Za9bfK8EH/V+vn/uPKrxpvbZaCe7vGWf2xoBY7jr/jnUxTuk0rfAdTiyK1GCJi7BwaN9hobSDlB+wd75BEW7aOvrWz68q+4SM9ynEC9PZYutUYsnnovy6Avy+wnnhrPvEIr1FnA0FWE2SWDwjhFg+9bTro3w8xcM/+5AzsbH5mfNa+bhuxXOLksPE4g0PDOzzMOfLthj3jarwsa+F33LxrEKmxMqImHecek/lYgvt286uE4itV8bH3c3BolWmK/NYxLfe7V48Ogeb9UR+2t6iIOlnuVxyzMZljyeqjfqqcobQsyoLLxh896g3jRiVWxpuzMJPJ2t5THmssh8dmJyJjd+MtXYIV9nCLnZyJlbe3rev7xIx555o99UMjFdPjX91mviWe8+HjnScqhT6JexS2XB2nnU6Xj0i/8k7U2KD7n38EjF+y3m8kLVAFT5kUUWJ8RKzoij3ccSCLXTqPozjB8qnGrCIOZyoESvT8GjzbRadre3EvaYx41PxGRvhTuUP4ls/ttv2fsJe3vvGzMwmtjYycK/6iJvmFDp5pRAL5jVkij/gt5MMtVg3icUOrzY+eI9TeW89kwOJ0bNXrJB3+C0tmx3oqrLJhnant7hi8dblISeJBVfP6xx5g38dnSv6YElce7vayvw13lq+5J4OEN86u+3n0le4opftEGRIbJ3d427wEi9+0zrPeBKxwfGYjTopOGmZf0X/cGJUfvZcXxJ+ZbddV6qUA+K4bg6peI5LEhcc1vyPGF3+r5V+iqffNzyxvpxYrMcJuP0YT4qp83ooVllt6f5rD3HZihw/oyRiwTfbI/b38Sr9WzGVCSrbWARa3cU1DTuTngYTc8ad/G1xG/fP226U6KkKb/EVO9zEE4XLg9+cVXnnzvY9cdiwt/W+9IDKPqXH10RhkWFZsYUFMXoS3D8vDD9+Ls/JMVG518BzcTB+vMRd32aeyk8OL5/oj80dm+fOmqBya4a6nhuOTBmrqTFC5VnuIzWs8aS+Od1/1cqIRf4dsovg1HwsY8ptldcsN6u6CotifZLZJ4gFGVl3S8Kh+LmU6ppNjALGpifGQ4N+qHpek5R4TMmP5NvwNKXQTfCCWMySHAq8D/FaCXcmORELfnD8rB7Dm9hRfqH/qLxPdnbuc9gbZz2ylkUsjvkT45wMMZ9c/7AK2sj4aP9W7noJ6qFeoxVhxMgk6Nei11Bi1X/qmRWxeN/VA5pvIaH6yBPDucTo7HKXindQbGhnekHRSsZ7yvZ1Tz+AmvvDO+fTVNb+lOv2Cc6PWHl+ThCxQcMS/XWpoLH/cGrEflV4tf3iURiCEz8tfTOHmBO6cJytGKChVeqnbAGUHOZ7eVM6pEdVOg9mERsXFF+YkwHzNl/RmhZJvCP7wXf1TDA0lWXX2RCzl1KZNZkQdC3f1nwlscDDbsXHLNhsPHX6lpHE8rJ5q8KzwVumuNxY2Uw8YVbx2Ry4s8Z68dQkYtGp1h5OLjzc/xnqfVXhk5TicXkQ5DhSxtlHLOjaPb8pD+ZueSpaYEjM6VFb8SkfyhTh+rdYxMhwSltQAUymKmclfm8CJGFZWR4qBFFK7rDZL4jFdJHt/CIwKolWLLpMbG3+dXlXEThvuSf9aKUK37gsNb0YTMwbEnKWEdeWvmcFl0D9TlsjrjaxaLx45J5SSPjOXN9Z3wjo/V9653Qk4IWKEkswsSRc5729BHQy0yrEscS8Kzftvkigf/zMJ3OdVOFbll5dUQYj4l49Q1xi85m22jFlsMfUptFiAbGgqJbpKQNrtc5Ilibx6RPfjx4oh/l3a0/MrmsA9GjsSOMP5fD8TZXrqzRi63VshwmfIWN2tO2TeOIJrefnuH6GfZrjFcPdiY2T+rlfP4OW/rfKgr3EtUa/pUu+gN1bLgux64E6tDb0nJo3Ffl6mzoyrgezw8i8GYdQbl8itNGOenh3/9uVh/zr1POL24cjXj1snb3brnngGPVCt2aIEdbDoM6BrXO9vWg6+8RwlFwPrIoq89PpgXRXutU0JKmHMeEWCVPAjzLtGtbCyOph1991kzQE3rQg+ooOYjfATveR9qcYT0qvyXaAMWqAWVdT59ShYOrsGJ8ahtsA5az2C6FqF2jRDVtdxGsApxu7i+0HbOnled59jLAB/DSUN9PTfKj6DIMhJqkBbE4WzR/vzaNRPrQxpQ0wJchzhINAQLtMmtPEyBrgRW/C+XniEKrx7g0NxG6EpVv/WJbzAyihYfh4ZNwIPh3Gb5uGAukbjks10Y5GoJfb2GEcQOUErDVAvEZw9hzTYYODaA13ZQsjbIR9hWvuXEABdI0GPQMlN8KoLbUmNegSHThZ6w9T2gjDEpmN9ugave566AAjawQTnofE08ePyj3aNw2xm0D9dY1LqGkA9cFzoz4ybgIXtZgt2wV86uJwaT3DbYJFx5mfcm8hXaZHVTMXm+CjyZyoJ748WjtwQycjbALZo5OhkwVXadNFMb+YpCZYGX4wsJZzlT7Vb0Har5q/8ekjSoCyvNFugORNMOrQtblPIJDWTN4wBrGbYW/F/lhzxonq6/o0HBk3w4TzCwOfpgVT7lOj2WhHMxi7u/0qGLpGmS9STkW8Zqh8+mONi5mQ3rn0wBQkagY9lwx/NXyd3mLKXYCSm+EoMJTG4Bm6bNqL70xpM7zmifQaTH1pNw1LKSNrhrvVOrWmmmepQ9o2lYxuC3wY9ZdJnuZBal/BkyHGqAWmUjOdprHc6aqPkT8ZbgskLrhyms240zdsbs5CvBYw5V6RbGACKc7/rvYywhbozcyIch3yoriFGuVMUgtkLVRI5zIn6A1WZuVMaQtMb14tfceco2tGnuhhZC1gNXpRtLqZD73L5c2/jG4rTDz7LuJkehD1e19fO2PUCm05xiGyoZP0rP9wFcNtBedNrfRp8Ke7P+xuYy62QmvtLvldb3/qqzCWjH8rtIf1hmj6OVJx02dPR8mtoKEz4eT1wdP0jY0Rv5jSVnBozp2S5n2dcskabGZkrTB0LfH5qrTr1MKeuP8hdhvYH/zwKPSSMzW1W1cbGbdBRS7vjCg9gMrSdW9muG2gNbQ/e6XOfvrP1apFiNcG63XTt30T8OknvlXTkagNrKwGI4ReTrSfmt0PJqkNvI9Nz57KD6ZWbTo3H0naYFcK8/Im6xqlFK3/w8jaIKBoZ045ukBFdD0tZnSlUH7mbwOOH5/+lbezkjGSwskRkwvSkScl+99aBcOVguXTiORHjAM15khgI3NRCgfSZCmOXftobebmGCSSAitv9JEQgT+9fvz9GiZJCm8M1n3VRG7Ubb7eJCSRQpjVXusetR10Fv1xOJJLYUz98sPrOZdptRAPJaMrg2GhslWL+7l0buCfachYBnvGOCqe+QRSEct8lQxXButyv38xg0DKbuvjAeaiDJzdYqZ0qh2nzbJ6/2WEMtjS4NpZdsmV8v5dS8ZfBovvesVNZF2kb/7nOgVJZJDyrGSL1MeeWpxZ283IZHDwKo+1ctgF+oK1TSejK4eKUVMsnnsH0vs9rnQwRnKofTmQeYYfTY/XHhhkuHI4FFG4bAhHU77bitURTw6Fe/8T+yFfqrFQQeafHCY5r0yrYc7TNhVaLJQsh5Y59S/4EEqbfL7HQhI5dCeau/ddElCDgxV9jEwOYrtvvGEarnTU4MfRiN0Ox0ef9/8iuE4d7vzTxxi1g2zF4Mk+nED9jPtK9t92eLFDj+eK4qi4PdPJ/tcO0urfdb2DIdSc3XMHGGE7ODqsrjJGodQBao0eSm6Hayx1gTs/lnp3c34PU9oOtsGJT5f02tDoS2AnI2uHlkMPEzA/nLp3JUgLsRUw49BgqJ0gkVJfd5ns/wpYihNbMphwyr+LZhiuAhwWLfJuYLlQP6fPVzIXFXBMi+/yaYBPUf+Ej0UiBSw0U6MK1Bxo/RN7xqJkBaj9pVjqKwijV+8camFKFaCo4pp4M9foqOfvRyO5ArLNjHdYMpfppDqPfka3AxLmHblmj3xo/tFnZP13wLh37+AwE0rvtX2ghXZ0QKpv0AxffiQ1vbt/DOJ1QNFX7ayPSEB9MDpA+r8DLB++/DsBIui15b80UHIH/GviwrPjX6b25b9UMqUdsFgPs/9R86AmvE4m668DknemnDrPj6E6k5aMQ+xOmHV54tGVPbbU/KBNZP/vhHWWVQ71LD/qxOvIBobbCQcDXr4/wwRQtc4aZP53wm5FRnyKOJJuSL8oY4Sd4LDgH8VITjyl8TDtD5PUCRsuaeN3TARdPZc9Hkk6Yc3ZKvuT4li6zlSui+SdMGXX5dEB/GiqbEuVHmIrYcW9U/Y2GtaUx9xh/0PGShi5ZGZJCY6it/IqWxmuEr7fHjbMQS2Afrz7qIy5qAS9k/k69Tie0mPXj0ciJYhkST7Z3teoMNN8dZSsBLEWHjXCLJGmJ1pMRRIlzN80u3+BTwz9/y7uAiqq9P/j+B1ykK5h6aG7DeI+y2B3b6/K+ncBax3cIoyxsbHzuKxd/13bQe6jw7F77MFiTMJWZHV05fc88JlzOKvAva/znTwdz/c9u0hb0/TibabVyGeag5OWSkMI30NHH6MkjXT2+tU0cBcsGMRPVWwvXQcXRNIjv129c/sirAsgUXxPvRoWDNKD9G9WLn5htiTNXML21ptgQwLdENeQ84tzDd4vlh7le+yBsM6dWF+snzk1AU5MpQP5XnumeS7Qj+dutKP94JIE8orvuQ+DjZak+9gdu0PVsD6CpvK9dw0s3JEE/52p5aVmPxALmvfgzX4mZet/syveDauUJIXvxVfCQpnYfmbT8FGX4dJwmsH35O/DRgtae3TR9Flv4K9DaV9ftjdvVYvnpxAf20v/f9nDbGcy6Tzbow+DdUFU37E8oHd7WB9F9p9he/XdYJduRPruD6+Gr+DsYPL3IrZnnwcfS6bLNiRVnSmEhRCq/ZHt3c+BNdFU+Lpgo34NzL5vyHq+hw9HphCT9/VD1ofhfR3JtE5sL/8irI+nvXPkQ0cZ4f5KalvA9vRfwZGRxCk2Uv/JAr2dXX50Od/b94CN1vR9wvZBR8Ng1Vux5wm2x98BVnqRv1YOi9F2hwU7epbv9X8L54WRoHG/rb4zGta3p9F8z38iLMjohpCihykLzY4jVjZs778M3phKZzcN6lOxB/6+HfnuFe8AwNpwclzby/uX67DwVFrAuwC1sN6LWLyxnT/UBKsUpA/vBDiY+0lvpUbtgmdFAbDRjkTEs25AImyIJkPadNWc7gi/9KFreEfgCzjbnrgPb5jTMxcuSSVbeFegEFa6kvnxlYM+zYV1NuTyR9YZWAdro6h2XLugR7tgdQyZwrsDR2GhStREiOlN18x+KG64zDsEcGkszX0T/Lj3B7i/gpQeZF0CJ/StriaQbbNXj7mghNVupJcP6xSkwN36kJpuBz2nd4VTU2lzt+AbWFgpjjr+KuqnMbC+DenPOwaTYc1dcU+PiNfzFsM6K2rJuwabYLUjzRm3+qBRC5c6kibeOTgHl1mQcX++OTqyGi4IpFp/1j14bZ670Lo9WT9E2qAnpnKlxuYOAmy0J89HmKr84mCVHU3gXQQVrHeinv+aCroNhnPSyFk96yTkwi4+9EBlyeytxS3WdPmapvBuwkLMu/vQ6mMDvlJtgIWz4lLeUTgIq2RktmJsvPNZWPlSdDvGugrVcPYbMWPHd995voFLbajEOwu2z/D97IjplDxmkC9s9KQz5rDuQgIc6U8s15+pP9UJLpORRc0dBlioFv98PLz2tzHmuSXty7sMGtjgQEuzm/KHLIN1DeJfvNOwDS5tEsOmpV+fcBjW1IldeLfhCqx8Kx2x9htxrQZW+9Onq1nH4SPsoaBDJ3qPznVFL6+7PanZwLoO4fAFFfn+uSIjJQPOcyD7eOehP5xoR/PG5oam/QgLj6TOvPtQBL+zpeEHz/9euBBWv5FqmzsQsP6R+PDMhJkN5bCPgjjmsS7ERbj/W9Fjxmfrtz+EVSdEd96JMMGa55JN1gG/tc7oPJSYpP8rZ92IMLg0lv46/k730+mwsF0M5R2J/vDLBunfziWFyTmw5oyYyrsSxbBkEqeKoRaGRXD2VWkB70xsgR3sqeu1xe0PUdiok5by7sSVFmvuutDnIdGjq+ow7/Rc/O+5osPStyYfe1i1V7LkXSoF7OVGp1pkeOQFwapD4hjeqYqFV74Qz1S4xl/tAKtOSrN5t6oTnGgQcwc3jh/WF870od/yjtU38HQLuixQdGrzI5z9SvT5h3Wt1HCoJ4nbOj7majFcVifpeedqFqx6LJ6yzWmki+ECgTZ3r9bBwkopMS1wzcltcFmT+LGEd7DgUyZpzpiHXV7pYF2VqOjOuljnYKU1MQxJC8kwwHqT9IZ3sh7AO33J5m3Vwza9gGut6MvLrJv1AU50pL1CbkQm2qJ32v+V+B3vaLnDwlPxffTQHbcCYElBrvGuVjSsqhUnWr322Noe1jvROt7Z6ggba8XUpH5LlvWFVU/EfN7d+hZOtCbVR/MHb8yBUy2J60De4YKvRpI/KpbNvDoJ1lvTJbzLNQcu8aM5Qzp8Hb4CfulKtvBO1wa4uwt5MMv93aq/4bRudPAQ1u2qgB+Gkk5+kcsSTsHKNnQP73hdhTUPxCTVvqE1RlhXL6byrtczuFRG/jmfOr3yPVzgSxfOZ50vG/R9l8aRgK0F7Q67wYJBzLrDul+BcNsYEuJeuP5ODPzOm9T8wDtg8ClvGuEx9UNgFzjRgljwLtgAuLs73XUhIH/GUFjtRhQTWSdsNKx3Jc5G/7ZOBfDzJPI574ZNh3UeNLFi0a+HFsEGd2pXzTpi6+BdcrLG6VLOnB3whGCafpN1xbQw6xW/9/k9bdJxWONCqyxYZ+wyrHeihZ4jApdXw8oG6WI86449hVeG0uAS2vPyezhRQcMO8A4Z+tTtk6n9pufPkj1arKlWU+0N1iULwrx7MF1ftzVDGw+vDKM5XqxTJsL6ABJhepAzvAcs3JacebfsS9iQSMtL7q5PGgGfCiZp21nHLB/OVpJPvwSEhE82W0FTeddsHmxsQ49+nu+rWg2P70yVZaxztgVWysmyn54embwf1nxOXvPu2VGzX4jB9551fqSHy7xoRXMHDU4MJ+f6+lWrn8Kbu9N5k1gXzQTfFmlFWe7RYDl66dowsox30hSwLoB07WoX8SEEznanym2sm5YErwwhT8qnZ5oyYcEkevOOWl9Y1yjJLm/pqPzebHuq4F21UbDGjYanzM0ZWwAbE4nAO2szYVUctfp78b17S2GlAxnPu2sb4P4BVKYdWz9xN6yxJfeieIfNbHeaXOmlzbpgtkBu8S7bbVgdS5bvMEyJewIb/ahFHOu0vYeV3qQyqcvkLPlbfH45jebdNgUsmKT6AZm1E8NgeU9ysy/ruLWFDeHUZ2djw/2OcOdkemsp67oNgMXuZLRr3R11NrwrlNyNYp23cfC3WcTp2P1bEZNgYxQdx7tv82F5CO1t3xQhXws/7UMimjtwsHBMaija+sH1ECxPJPa8C3caPhVOMxesKu1igFd3JfeUrBNXA6t86Zknt5UbGmG1F9Hybpx1Y4vfhRPPf84/jvaEBRlJ4h25UFjvSfdHefvfSTHbjbrzrlwnWFMvmRZIn8oHwtmRdEUK68wNhz/lkwXJ8pOV+bCyA53Eu3NTYM1jMX/put0NpXBBFEUe5Mh/+gtHhCz9lSlye4PFu5GC7F2gIFOOEmTWSkGmZ+b34ezewO75wx+yqwwHts0Hba1x0Na21YFz1aiWx9m1fhwOttvjQDx/7e7stR/itX9hdsQhemf2yz/PWGXLZyhi1+xRLfez2H3eqJbnbGVXHsBwbRXA8BgtyNz5FcsX/DlleD6fn8JzFHgOn+9i862Y12Lu1Wp+vNVcPrpl/lmr+XXM+X1Nq/diaRLV/wDFlEG1";
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
