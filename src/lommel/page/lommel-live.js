// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 7d9951598a66db0cca1f32d232f693484db52e6e3f8ebc1ed4501a1257a6ba21
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
const wasmText = "eNq0dgV8G0fa99BqVxpJq4vVi3O+y622vn5likshW65CpTi5lMHxJU5jh22HZcuJU58vx+XkSJbL/cr8ey91GMrMzHhlruP3P7PrtZJrf/zOSrvPPPCfh2Z2SV3zPEoIofdYa+h0QqaLHAaZHsJdE4b/pPpPc9MJ/iyXo9npXAlwb1NsngVPScBiWS3OZrO+lifAnYKDm5orIbiaodRpm0ZpawNt5fyh/fHtswRrt4GBlTx4PLSjWc8PpRHGBNPiGKBkekrggQKZ1fraXpkB3tBcEHqeVe7ptbMQekBaamlrbS98A6Lxg6WEr2kUM7R6sBAMSWACRwJ5K/HEyvfiZZSd6fmtOSCUmeZzn+ctZvjJ8LPiBwZ17+lLfEvPUabd0sv4mdcZ9D0E7S8S5Fqp+bKc74Yvyga59vWDXAfeYejVAis/LTTrtQ1kHq6hVgqe4IPA0ApBQBok7IFkg7QFgfi5tDTRqlAjuWCA75uBDPukUjcDbsjj+bX2YoXcR6PZwExNfLiBSDWC//QbB2MvRdVawVqgfNs2DC0LUED5ltggXt8FPafBg/Tr9PlpzHoLBJ0AYN0reGCODdfmraGjChrb8Dh+T7Uiav1g+h4KFqWtitkKJpvIf7q0rrmhtnl+3cLm2Qtaahc21S9pqF96RHzG3AUz5tS2NMyrrz2/voWEQ3MXzJtXP9eEVlNL/XwS8RliVl3DXCJ5PrYuRkg0FrftxE8SQxJqGMK24+EQMWwhbWklSpLJIfv8FAJChBG3h8bjpcKWwwxDYMRLKeWcMcz8H5g2xhDAWLTU8m62/FkUCyTKfj4kQaBCDKIGHsGQpcSwhD+wsmX9QlIpQQ//ZdxJueBZ+5rlv9pP/L/9xfADhH3gQQdJQB3syEPkoVKWGIcdcrgFd/l++5WUDDFLjhhWYktpHynYiMOH2KJCjCg9ysIAkyI0ijWFTYyQFNKIG0IKUEKUGsRWf4lgFFP693jxY0Cy1+SHDH7kjnG0PVRgnWPEsch++XFDh+q1h4+EaBQVYuSgLzYogYQwIQkZbVH4KRWfHoGcSIsKimhssCAw7JIxFIEbh0n8Ex4IsSsoRehgWSNl6Vi31DAqRaWoGpmWlcA7oqSaW9bxtpExDMuiVMZpKfyHo3GphrBLAYOfJLYaQN2fW3ScZZVw80jLpOMnJJPU4pwbEyedkMzQMSeedPLIYadwOrlmmJxiT6XxX9hWya+Hx8utyegGohNAS70eSppJm8KeyoFVR5eLUjlNR0RO1Tq2TI5WRNwSY6WtvKDIEecwOVSbRG2z5DROuWmVnyhPHD68pGS4dapkjEHjdC+U+BmmtCromXZcxI+3be6cdbZ1Tty29Jh47sSz1c+wJp5Xm6RqLYmE2bTUBo30U1lRLuUQVRDVnmL65Ip4vM76zeQSU5ZTyVGbweaxLQ5fzjqHmZb2oEZ7wE8UM+yZ8bgl8RNWvW1JMJlllcZpnFIa1wCWIVgyOeuc2skWPf+sEBp2eMmQ8jFjuI62VCMZVlJV03MO5RFjjcOSBrGMYq4wDtt7OgZdwGcn+Tm1DfQsx8tOox+rsJJ8jpxrVdlU2CdLqUIBX/vELM6GUkZHwHE5pXxcyTwh5peMHDlsmNx/hCn3H5U0LRNZTCalzMQzZoZK2zwV+8uMm3u0Uw0aSvevamBL1NC4CloS3eYIhMdL/YSoS1VgoAAgMzMl/CGl0rDpIIExfPhQd+hQC6PSkjqH1oLkwsMnSqyUzGAxLK1X2F9UJJPJRWObrJEWAj30RNos7WOtKULWYAFgwgMJVBC8BfCEIg2qzZAIBQBvFhvCRwOu5kkVG5jQgqavtkTxbJydaNWSkhJpKpeLWlyBC46h+IAfIcWIEZ7xUlq61MuW6eHTwVgFLmIhvrF02XJrhecIVYlaODGZqVg01sKgaqFjLHR8kCsPuUpUrNwve4yJoM6sqGqtEBRyTKDhH1h73DU4UUvSeI3kI5SjgtpDOUqDZdqQEsvOtVNLd5AElH6gjGq5UiTGqzJsfEe0F6voCFEqBljWwNMmRrwmOi2hx2raQXFLtAqTLqQ7cBmCktUsdLSZo+n29nZL5ki6/blV+kn05ElvcrH/3LjZU9r6FObmn9k+oXn18xY0LWdE1jbMb2hpqJvbsKKeCNG0YME8so6Gm+tbauc2nD+7hfzdmyypm1/fTK6gfGHzLHIllTMWt9Q2189YMH9mM7mRSqUyo6Fpxlwo3U6jHllb39S0oIlspvEF82thEGhsobH59XVNtTBvaaprbiEP0LCSN9XXzZhNHqURpe/rPk7DTXUzGxY31y6YRZ6hcd9GvegbZtSTZ6kVoLxBxW/mLm4iH9CI9qduXn1THbk6asysX9gym1wf1exZDXNb6pvIHdGQT90dDX/DKElTuZ2OGjt6TNWEcdWV4zPHTzwBJ/cpk2umTP31tMXX0evp78RDxiPGU+Jl8XxoR+if5mfmt+Yr1mvW89Zd8m75uHxC/pleRC+hl9E17ALWybrY79gf6F/Y39g/2D9ZgfWwK9g17Dp2PbuJ3cJuZXeyu9jd7N/sXtbLtrCtbBvbxe5nD7AH2UPsYfY4e4I9yZ5lz7MX2CvsVfYae4u9zd5hH7AP2X/Yp+wz9jn7m/i7+Ic451/iK9Ev2o1VRofxV+NC4yLjEqPHuMK40rja+P/GDcaNxk3GBmOrsc3Ybuw03jLeNt4x3jOuCF0Zuip0Teid0Luh90IfhG41bzNvN+80N5mbzS3mNvNp8xnzWfN58y3zbfMd8z1zjXWB1Wn91nrPet/6wPqPdWX4qvDV4WvDt0Vuj9wRuSuyPbIjsjNyX+S5yPORFyIvRj6PfBH5MvJ15HK5Tq6Xf5dro3+I/jH6l+iF0Yuil0Yvj66L9kSvjEY+fdddF6skiebE0sTyxIrEykQ20ZpoS7TTxCrd9+j+NTRxAU100sRvaaKLJn5HE9/RxPc00UcThWhibUzuS1hVmuzPNj61qouMixEi0yjo0d480YFNQuSNFEqsysGesSbGiEMyRI9XcoUU0fx+ezL4NL1qWWOKRpncUwWCvqH6NqksvXqhUqFSa59QhDadD6DdvfBkjbbL9FWLVZTg49n6dmJZ+kIbKlBQPpiNN1RXdPYW5NOWSdtYjrZx/edtQCUbXF5d0XW1K+DsItcoDuP4gi/0ROl0Y7o94RhlKUMqfza4IW1parGlXCu2DAWWYd8yXJaylCXb4Ea0pfTEsGTFlpEfsgxLnWsjvdtW2bEgnxjzQiw4LG9LJ5x+YGljKgqlsBYCdUDqRNP3m+PLoCQAtygVc0z9NB2pn8KJVNPO6t39etgd1e3eSKxJRZwQRIjG6aqGjGgZXePGHa74XBnBwrXboOjTIcj2UudtWTcBphN3QDogYeuEHBt8qE+7IZuK6wCjjuFYjenLFzS6xhzXSlMEAraVrjwREUUc64bOFHci6Y3IwZwbulKRKFOh/wGhG1qvqlFltJqkOCSa009OBoOmQmDGfYF6OPF0O1Uort0JV8I3uImuNcqnzmoy9YY1qRCcTXSl4mg1z7EJ8CCaMpxIisM+Ar7GT09W8AEPzvm+ceUvPG2Ez7aSOtyxPWwOU+9yTCfW7IYdAXTox7NQCgVJ4QoQdGvKVsrwKNLqaFkrcp87HTZ2Cr6nhFJEXcenRDV4rYg2pwgsV6bMuXR4DRoG6Hy5G7k6nWt0EXEckVdvIkDVocf90LljKL9TBlD1uqEarBRa7nLIYxQ2tEvdOqCazqXCUVbcifDPx0etkGqsj2VF2T0pplrYCc/BbtqyFH2spqAmKGpgC2wJ9gJMXHRxHZbm1WismhhTYFhW3brWeG2KsZGgw/w1XKYannS7zMf52CwAhRQcCLr1bjASF8CIwFPoQKG//5cVhTv/Z1DfhtO42i21rtlRU4Zn+7KOYBEEAtsBHHkcpbk0Gkrt7XEqFI6DZX+GhIxHrkhaNKYQhsoIxCxKJJKlCyK/YpTlVILTOa2nnHfIJISdpg5tcanK6ollLoXx+S6JESxDdE3SjkPmQK2/ny9Kt8IwHZuk2hB8mu5oF43pxBJlBJ0bqqHU0Xl1isJB34K1uGx/dvPTOM1dAp/hnp40wjrR4pDGdLYRERyNIJCnNLyogqIWpXPqJKmmTgDsRa4wEfX3TylMCkyo6kkjckaLAKktIdqpRdonWOmZH44Xpc4KGfBR5RVeMOD386M1EzOdi7RyjaWxApsUQ/7gZIpIR6WON/oB7DUjsoUKlEz3oy4TUcQhhLhwVT3UbkzTlIFK8nQ/XYS6OYa6UcdoxHlJ8NC7hGKTONyzFNoSYFLpwrMcqgj2pDLdL/LtkEFzNEvbaI5n923HQEbnuLRck3qfwT+0u9+JX+dSDAEO9GVvCr0xMOmHmrIILv9d5qhXB4a5yBXpbx7542qhzk2R3vzCM7v5yTEK8tZtm/v5ZMSiDxCuMV/ZXX3oW735FMssGb38qI+Oe29MCrHhVFHvOthgj/Wb6vVL4JIpYUp+HQvB9KPjvoVpZ9VMBDzgm3I7JD2rNziKAoE3AEoAKiQsd68+qH7CPl9VFgb2e6VDrsp/z1xxlzvoRgHpRaUDFwvwUZ82A5zKIqc3AD8HfKqdRh4qB1zmugXuPJZF0eBRXUEPh+Eyul3SjXvKkKoAgT8FN1TAjgyuzCFbwvPv6lt7byFz3NS3Ou97+JGx+ULmruev++ewh5K9IC84dfewPD2rEuTniZ9gdCuun5XKvGv6tIUD1TEL3W6o2+eUqtKHCt09hVRI+a7c1hycWd26C9QMPhbwdxhYQdkFejDOCaMqKxANuj9AqboiA0Fkj/TOiFGtqw7GfOCgn1oRfDOlDI1/LFoIPEfM8bghzS0BNzB1Qt0aEIdrwV8MGQvluwMNX1LspGYXu4DPQodAT7WONb4saPy8lwFWVJsAmWwErFTHVqO3j7DRosBM/PWPmHzP5HvCpDm151hW776VP7DzivcQq1bM/MP5DyvPRBm8KcbXvTn16iNBM/ekCDoZCv3e+KqfnBbjXvMVW03zitm9hyH3tLBdXZ6mLWrP7jLVVuXeXlsU43t2LIfJ4D4S/gqPPHPTu725s2KkaIvpZilKsIGY9Lnw2r2/asRqySX6gzxUhBZ4/MpF1/RsIcBTdSguHqaD5ej2g375oms6NpLTyhyjJ4VMcLXjFqX/uWl9P0cDOZ2+mt2xpreolmjku9RWM4ItrKouMA82vVovCKkq3+Mae27Mgms6BhrFFY4ouEZf0rUc0edSxwLKv7YveyS8fktloS+plDKZqWNfHvLJZuyHl/j9l84cvwP7E7p90ZuW/ekX2xY9UHnmRe7F5ZMeq+z7mPZ9Cr749rJ169Y9W3nRqWq86fNdqw+u40bzeThoducRyh6NR+SLnHF0WdFBqHpqncsDjvqYoetcUcwoOu5VmL9RKg5VD+Fw9Z/pGmWQKdoocwdrrcBggnKAUjXMPDAqN+uf+bdqcRyTYLr95wWXqm4qmmOdQqJTuf0vIAdXweXrNRvy9XCGK0+Q5m6PmVdTR/gq3coi39MdwPbYqqsD/5wZxV5AvJcXPf83XhRsqWGKwakTXP8NDuVicEyLwGEBcO8F/hhlrKi8lSnqHRrFBUG5vapvKH4X8/SmFy7v58EG/xSvReqwxFq1iE6DQ/Y6E3sG5wiI4w1++RqhrTK/f/Fn+8xyLt2YT1yuDjlfcWOuMEilKFpTJcJTcYuOatKTH9xJ8o+M0zaGw9E7/Wix18w7iyZ5Bxjc8E9JzSdgpy/6pO8JluLFR07N8YW9YfBtoDTvhyb0YM7nO/4JQXHs+COHY0JvaEfAR2xrvcUL2MFPf/jGE+RmtYOfnfL2vfdn3unNgw3B5qcmnTD9k28gcMo/vvCV/XdDkLnwrTr7Lb67Mp8H1gaNn+3QDyvb6ypM1XhGt0LIq0SDA0ptZiJ3CqHeFuzHv9BwmhYHp8uZFzpHmdJDMtO+S31TOUD04gTMnVqmd3WZ/+UODA7jj3arbtATYKt+IFHmn6Enxtjehz9EaCztgm/zQL+y0eSf2sXkolfT1735Qbqy6AMEL540S4kol9rsciAEZlAIzAJlCmUmA7lDFJODSaXuiB+wJFXakqSEVtFlxIeU41+Zw+Y2Hpy5vdBbyKzve2nqIS/doEo2b33LTZ/efJsiF/10393bF/1bkVvfvxzn8C6QKXXcD2L85Dn39ZE3/AWhvR9bUn7iymsroT1lzCP5WbFbFDnfOWnbg+PuUmR/B7mwfNJmRcZOVeNJkKnQYBFO1p/HvMXVdegijQdx1e0mPl4K0MkP8LpxzurvpfW6pl41nUC1+7/eBR8K4X3p05U/urVUBQf2U3u20aFXNxX3UVC7hcdi8/k08b4m9Fnr27YroOIdvq7oKxA+B1cm/FVf7NUxDMBdt9LFr3w0SSVm1J9n37H/6itUyk/NdMVP3bRLcVsXvM+HPPWE5uqxDdwAaPWFh96y7e7bAHQm/WPZ3NBbSm/n2jP//uaBpArkiYes/V9qrgI6kuTIVkJRV7fUA883d/L5ssrMvExlGD8dLRwzmFuGZdTNzHrGzMy2RntnHjMzHjMzM5pZzxc/IjO7St2t1Zh3Z1tdlRkZGfEjEupnSTe/7Rnmgxu99DOO5mLLVr/5X9/7FYAffXUWS92m3xDmP73/nrd5xTPfu0GYY5ZW9MBBj51e+j9IWkb2xUd5SG8cDy3OImGk3HFnqfgG1oZru0HKj29EBRsdvRJLIHneJI7G4CpvMrb2SwpD0TwQsdewERTZXgRYA0BhexEwDmiF8gB4gC7Ke/QDjlTeZLQX2XT0U92wucFPtE/LUqQbNrhq/eQSLiaWB6ckdhMpviDleknHkiMVo9idQbo5+PLGOAMthKQFirhehGTyTUTSMpKWkZxmHdKOV7zoWG3I6+uPHPknzJndZEOKwLnoGF0vcsx8ixzD5BU9gVfTqaI/U1Cc0jiw4BU1TZ3BGvntHjwa3zJ3CLV2BpFyzHeNJ60dP4E88qwUE1fp4+5jj51qCp6yQXC1dztFfxQkVJtUH1QaOwC0FhpL0efqye0NaXglEWdrciBxn/QJr3Qa1Jud8Oqhsb0TDk63BtybDhQZ6C+nA/fWfhw9UUvPiGmHr+XKNzZ9Ai8qIWZL9MxweFEJ31XVm4MH+Ef+OnXikGxbsCHHI2cXFVBVSW07IPBBjDN9nMCaGABimbUzLc0qib83OKBJzkgIXlBiBBjZDsKyqkiwWJVnGeJBDYBLTmXBYgKC8wEsZKsfYSoUWD+s/R7S3FpHHyI/E/LTqYlLvL1sg2HkKSpOwUrykcwk37bH8uVKmcPCJH6amUQzIloSV7Vp/dUpUlUFyvHzLGhbdxAdeRK8PaZbNX4uW5COyL1lD5pLfXsMFAoEFTMncwr0cKmlUE1I3zFF1iJUljIG0YKB+zCD4FFAdpuIbFUlt7ye7sgUvLp0y8dwzZMeh51Im4yfRHVJUq1SgvvcJIpYHkWA7vjZECfs1fiFcgXeMtnD+vmHMNDL1fhFR1jT/fuaNADDJB81JaIJOkHNcuMZjQOQLs/BnVy+lC8f2dPNbJqiyCqJ7ISypCXhtUsahRr07v1IqP/nSX5GTxQzsNs9UdGTrg3DhFVsTG8SntNvqOTx+kWYCFY2gX9cAC8e3wDxXtnYlz2jzDCk5FOu4/xPx4M6ejqjAyg7JZFSVDVZe/3FEzraXGVKOwezduj7RkIQ4fSsuM/h9cAePfqHOzu4unRpZJDOvZC8Lujwg5WnaBgrL/5RHAbe53p/98P+SBBbgijz8a8kpCH4w85v9mp/2GnaBV1G673X3zdLlri6RCUW+8SVL3IlYftKzkt1EKeTTqNKRw9cSbsFOB1b0YVv0uTQOd7ENQnROSPlQM6KcpcB0DojEIMJOEbkM1fBb0eYTPv+fBVIsUvd2h89iCCMf1k6patfkSuXdc5870bPrt1uQ/O/X18XCzRKzqOlceBSr/2Nf/KXTzlvvYmM39VHf8nHp1iPK2lJLe+MZEkuadPLG3tH886n0nBuqs3pIxSys03uaI5wzXCzGW02S46S7PHvapZR8fGnUMWmo8a/DpGNZkyRoUB/wJXHN5s9Gw0VlRtN5ZYoPBVxsXvcyA2xPRnSzp1VfD6q+H1WQQrG1HqD/uOtDPVablLrUkx5I4Q2cfUqFt+U4o1Y/AIuDuXPiOVP8OUbzYjMel9ArSRTZHDIuLHtO66etOfKptS2vw4GNAIyzaVcjq6fWKzWGSZdxGyajXkMZR7C65QbHHfkiSIEKhr55B3c3MRReELgnwiGfhBXDBzPDyj6fa4Uj35droeED8LDPJqv+njU8e8nBBslFX8fK/7cV5Tk8ytbS+s++ZwRmK+nckf4MBl6e/NGvk9dfmL9Pnd+3Hqt4xEADhlf5X3SH8BySd1sYLyV1Y9oTEVtImdoEVPdMmPT6lo53b6lIEghcx9F106vncCh/eF1R8mdXAQxPqNK6JCTKaPqN5Wy65EPLkTKqTiQziMOxcAME/b3yeFNnjmizMfPpeEgUo3lXdkLYyyFEuySPh9wc0Le4dQeuNKkG03mSJMEElQAMpbPbbrkGz3HVfF+nGxWf5oaPBPBn/hv3pPRF3FORpgJ+5qyL8lPdFKR0O8fdXXfZEFo2o/gfE3OH9+E8zXhdvB0CbWdEzbTqu4pm+0fZqH+cPdAC1TLTodl+h2N6RyWWRCa3cMywyf+zuKIi36KPh1O5rCc6+2HXikeZ+K/r/nQK+sceuG5vEl7h14pH3oBcw2kuMSZ48cBuUvJ5E36UEFt4rNn97zLzD3vQj52j7t4x7jg9Ig7MtuPwjio8RxMKIvTJUXMTqdXoC91//SKdJEmDD3WlYoX/fMzymXWvBFoJcOcRuwHmQ3d/F3djnrdDQlcvZwJ60PdpAmc9QsbjfNijIGX//qTP0LHOBiY41djsuEJyMRzrXNRZcKYfdU5P8z0JFh3/CB/OxTPceDJlb3iDSlW1GL8GnThPblZ2N1uHsPudvx23MwWv16K70GbyRlW1ilspUODI09AA6fCLvnW4WS/xSF+gncNCvxI2kOXjF+GJsz6apXLpleREC5YpjEk1Vg8yqTtIKhZQZ11NJCvxHqOC5rVV5p8zanzsR45NWmK9qrzR4br6rK92hUOGkgKp31NRvcZvad29SVtMSGhT2Emog1xNn4x42/YTh4VOazGD6QEdtETV664/MsDco6qS9SkzkZf8AxSgJU8RVv6ylp1KaGDpIJKVkBm1IbNlBfSlGjPJ9iCf7mC3m2guYK0SWIWZP8Z1Dc1KCb8yCfPEq+TEP2GUvZwgE8TfAReB7rGCHg6gKcBnqUpnsAbP5mPKjRAlHMZs+bSCXZabQLbxm9GJ+jOv2rT8cmST6HUoJVymkGi5npS61mfdPRJT33S0afqOVqlcEUjngrxTCiQaupaU2xzrkRsB9h8xNiWMbaljy0rKJpKzGb/Byv83p6FXfxDuaGzIcQZSjIpthPQzVwDL+me0k6Gq8vxuKqjXDaBkgmg8EAol6FATxorXlKzAeQrV0zzR0n+WMmfkvOnE+AP4YE6jo/ZANt5oyOlwK85H1iL87U1ZyZYXm48sHT0aUMp6e0E1uw+sLYb2JtBiOcoybjx29j35+mYupYVNpaccNY7YJ3ifap4nkXPqSplf8S7VIykfKYGLadxzzvT9y4DaBjoEEcAUwzLTO7XmpxjD4WZH/NOC2gc/NUVvszOXyEgonaogJjIM+9iZlEyESUTUEqd6Q7pE7uedd//+P6s+66CyRwC4APHzvZbofbpv5uEy3+KVyVzZnRxt0upX8YEC7LX+8b3i14ycHJXlZzJEhoSipkSGob/nDyqNqzq33LRZUTXdiUQvTgqwl7dzHbVAN1OZ0hOZ6jlI9a4w1inQU6JIc/43WjCy5+a7WRDY0T84kbB7kZ3zeFTbj2nK0Ndpbs1ldSTgkbg4U6mQnoHf0C2ZdSJvLf9oT+7K/xQ7QePnQ3fuPB1/2ijc5P5zkEezgGSud71resJmR0gwMKX7xYCGIFO0Fnf/V1gZHfAKCMrCon5kQ//2V0jMM/+r782O4fdtwA0QHQuNF2rZ2HZGbt0B+xysrrcNXYwE72wnX3wdkbX7gbdbAd0MSEOJtXrlDKd6UaHo3fyLcUM8w7c8s2aLMrhlxAGfiYhhWEmkRcTUHY1tnHFRJbgxm+RlCxxluABbxt3Qr6rsMgomROdjqe709Xw14xKg7UuWAtRmhwPgIM61Yy5YTsgyumNqPwuvMW63+k7J+MGq6QzvARYEVOX4qVTgHS6Yc9ImjSlIsXEsg/jW3lrjDUMcy6pSuRVeeMszrQNP1qyBtPpMS5p2HRlEES3JJKtRQOZ7w77EY2FYj9bwUw4ChjicX+9YAnBVd/ejE/VSXRfwEA/4zd4BFoXoYQ1l8NvyxTfPHQa07XVdm1lSY6zuCom22gyalAgJrtUHoitmO0bg0W2ifP08buht9L8/95Y0MoOqVc09EVfUUSZx/cKP5isNSZkbdhOKPohrxRjzWUOS0kcm7T98z/it6TT9p/5gnz7ENdINhKI+jRntobJtv/oELjStyNv8F347wMA7IzkTHydou/ljGQ5sQqn6DHdUSiGPADtBACRRbCNbLz5nusjrQ4gqYTGl3qApADFBEMEo+sgv+pHbvoIOls9JdVpHwDr63irAx+vnuA7m9S5sNjtOhcUAEd7cBLeB3Eigw/Gwwv5v0a0cCqvxhzC+/R2DhIleb7fWYfvWzmLhDvL2UCLH1GnEhIEAiAg4AGBBRIF0g3waDmSycFCtwkDQx7veUxEhM2xhAlYah4HU0thY5O6HNcLjINRzhu5s3FajEvFuALGFX3jilnjYBiYf4uTtXuehBGcKjsiI533uj6w52jsGjFDQGHC7ZZ0AlLGkoigdSugJZduenmnLoYeU565UHd/yQOeukK7WIQvr/cB7C/hUKf03cnGtHqsSjrDruDkQomihjjMQvpjQlLwcIyUPoWg4XFwGs0bsgcizVxATfE9dpqv4BpdKa8DewFgeAp9adGJdYf0VdWrYcY32hB9o4ZQDT9vojeNCWBmtFfVx/FrKGwjohn/CQkN+5vMpfSF4ZfJfIEbM0yZpDvYlxo/EVoRH+3nPXxLmL29N4dVrKjh1r2GsmpJ4zFqNaPAETcceYHKwWloc8AJeWUhTYl6prpX12ndKmT1zLhBszsn94ZKNCNNd0LBvYjfHWoAaqmkkvDsl7jcjkG9HYeQ28VIJD4A1TbA0fPMsKk+p5SKiM/BO4l4J128bR9v+9Xi3W94UngLFgx7DxLSsBiUCGb1GB0dz7zTqXfHZeIyM+IuOxiLu6aKwntj9mVnYx/3gi52gYdWHEy2M8IsrGPv7tYq6UnzSXMclweaxNstDS3TlLPNnBJvZawvDn06J+2qv1RfFwy+HRGQfdR3Tp+AfvuPeUtTkBRqcBDfBrJyOQg9lbey1fmYhSKR+yfdhsh21a7zL8gJ/XYYFfxYkHwve3v5xL9y4JLxr/PFj3199cUtYC4K+vY+5+ts73O+7vZ+w/C4qem9XPTydCwKeTDyq0tOBSLTk4PUzSg+N2LbVMQ9Nb7wzD9kfo2bN+EJMjw+Cs9Gmf8Ls51GwntOD1p60L0eNHoQhhsDutdDdOvYt8KtY984t55r6BA3pRdbYYtTv8C/I3mJPOvLQZ/yr+Q3xr/Wilfc7KUQGT/DP2Sa9hZXtpqIXHmB/9wnvPJSmXxd723+nJpyw7rgymzJGpMoU8VXY5fj5QeFzw1NjUOXnRdhX4F6SMhvUWBOzcOlcllrLqd3PT5MM5/IhUrM+WhyxE1cTq/1V3NUpvfv/sZXwU0hb1b9C0A3vFA85wOe4IlNlLaVK160PHXHFf5d1uP0qvVy1b2NfhLK3twNmEs6XSET/d34JUtZ9BRg88vdeM+xuNzJ1oPHJ1q1SXXbJP7aLb6wV11r9RUPBQ9wzmWtGv+tbEu3ltUgUkHxmZLYEYz8OuUxXmdgd/ix0nR3rl5nUyxlWUZ+G1txs6bkx062sxmcP0rlcCtxpRvQ1zANYjLHFK5kQVfgTAdyCS7xWaVbS82iwoVyUmtJJ6lDrfVAOS6BooS3dqKkFDwL1EK6cCyID4vubGDQYnr9013oGBUmqJK+FmmByVHLQoPs0PRtt1NRu9j24Y2BO+yBWywCdxCUDaTLodhSiMgq27sTWGhsgvUGAWqqntdV1BvgGkAOH6o3kGJVEMRnFQqoGB9SVlJZGWArHN8KbP7vU3wH1isMB/kTACVdXYrpxxl/VlOMDJ58MSlR8pc1N4M/ZCPjg5OntC4xBGDkhNRwUmuShm75Aw0DVwr4YKS5HZ1nVUwF1WXlB0DlUtynrqrJmWDPyIIjI0N0NCARA5JoQFWXqPSjCWOykA5NXQLNTo/SE7VIOl0YdBFeA0GB9pODbZcn478TZlKHI+h2/RKy2qWktR5gxFPp9WoVQISk6YS57OYVRNJFgxYlrGB7Eqw2A1HFtSjn21x8LERRji8gXYk+aOBb6TcXAUbNRrk42gSj4bQNSQ5Xm4rHUcG1KOcWmSslANm2Lstul5bksthlMdNlwVpmuxzKqAlAQMhRxQpJVm5IST1y3uORQGe9q1xPWlib6IFJFeTcCFhCS8EGcOi2Tb8KpHIyE79kQfz6wzkGJ9khflwb41c57Bxr7Udbw8NFuEmfHKv+gGHAfdIdj1IeiQUSF39IoUQJekPvNBYoTSuMOoNmqGx8BRUrHtrcMMENyxQhh1Yhw/U8plBUG1ZbVwbFRtKqoq++9qaC/r62xkAflAW9iU9XWXohwyAUjH7LfdWIQiW0HzZzfx8oRsuW2zsnBZ4Guf34H1CJAegKGELuSRFPW7XC6wWG5x4qwHj3A9gRZrLKc7uau5Zu4yFL9U+5Gh6OOwW/pjcWq3raaj7skJfrr6TI4U3yJmsVFTs6m580OR0e8M5IP7LOCZYc8yNVQRevuuxBKWcPTe4SiF6OwHOxuRzPGojIpBn4iqZCVbgZQkNZj/ysO0K5q/yob4gNVtTniPVKH8j1oArFi/oYSqJ4g9yQI1QiTTHZ4OmGa1PyknxsIEXtpS0vr6MwJ7Npg7p0IzEsx5uLpTfq8GxrSRM/hyNVlxh1DcjQnUAK8OshAV8crDMIGYyPJb/84ytH7i65XMZbia8hH37kCIG8dApJix+0XtZ5dFcMQXTaZD62eTMAtgNCtakIV1ZatRrZl/4g0sxti2blL6WjAfzvdSZ4++CwuZVbQjovgReRgSMZZ+iiGXoktExhyy2mMRmfbNQIRmHOgz5E1oZTjxGsHLkhn2+g7ciV8jej6IJLmpRaFZTJslo2doV0Z+QQXeQudYQ+diP1qMKcyjGtMdfq7yc75SlCcgAjlK6XZVJFafjrO1wGiNbIMAymAbvG/ktGid0VTBh5q0IyVTXZKR0PJJlybnh4tmEakillQIdI4JS+tCTwkvxK/WeXMhwd6UPmOntYH5K9u+xfNfnhp1wFDC31bwkgjSk35RJnXNqZcv0f7OHKRioketwI0ROtjRa9sa6hpJS9hMW9QCXniIl0lZKo/BMNFIy1RrdfMIDObO2pi/vQhE+fAY+GAb82PXsOU1fTMhXKhvf5IFIorbUh7Vs/gzTfOm/rN9TWUG2T3frBZrT13TSc6MfjtvY6ulG4UY/buoVy1dYFNVa0glY0Kh1q30qH1r+r6iHZdmi9EQORRRVJjopyUOFPNfOTUprlWxdQB/WAlyKWdDmeufTJeFQGb9ABlEJ5+JCHZ3wNHl69o4clPCx342EJDwcXYCa/QIa3G1z7Sk5jLemgscXjorVmySfGkiTGAO/RD45S6EpclUcbUqKch7bCU/mhFpqbpRXOmPaIbhPqju44ez5vMBacplFI7pCaY2iv23ZCswohOMaPPVBIv9syNEESmdbSvFt55gTFj2yW1+qxTAHLraJ5MPw5uuUT9V663of8QpkIyKtme/lP9uVHm33sc605lUe7jTKptG4fUt5ZDvRocdoW3aAWc4Jqkbb265K2bp/be+FIYUZGFJ05/4Tb9zg3OEZVurXwc6/bdx+13uyTSC0TyuN6eTrGl7BfIZiw0kQAc4E+Aihjwrp8G45rJ43jPh4sduFgGWGwfLW4YrDYr8tgmcF1lXEtj1EVZsXtuH4Dx9YeDCQMLMZ/WYbZnhVBH+FT4RcvSWAPnluhyJXXUAqd+1j6DbfHHuVIwogBG9Ueo13jEsIKU+oUlnibrF/DLC861BNlx9BMrdCdV1Rjr0NdwTKxqArlWKHgnBtc88r23Msae0JsGaB9EGoszLAwg4zorEdLMCNAPYAZuINRzIM6y4sbGivfSl7NkdZG9mPZGYmtPpar/DB+FUXPYc1oTU67nBmzBdYlfitAVxIkw7i0atnLaYhYLN3SwDjrn99wiY88lGoRMC5ZLCe1lnSSuh5pxiVQJD1LqfRdNAbVwrawJD4se6MWinc9A+gu9IyKNKiSvhZpgc1Ry0KD7IzxdiprFxs/vDF4hz14i0XwWlHGBT3ajEuENtsJLTROg/UpQtRkPbezqDfgZSGHD9WnkPL56Fh4FQqoGB9SpqlMB9yM49ttuNnGimJuBQPEnti3NLWilfSLcU3qO7bTrl0qqNORBGkRZpq3UfgV1raoC8McusAg6PLzea3DLysz6YYRFigs/8f0/IYTpFsaH8llT6mrsMXMsY5TP9i0Z1RFFoCLF1ohqzUKQaTBXkVCVau49Xwq3XSo9H8SKv1/l012OF3XC+j0q4VOf5jQ6RcvoNNNn05Hs6a8o2F2CV/VA+/PfPrgdMOkD30N0yDnppLgoSo3eGBTrEAywY3DNRO1IsbSfTFpOvTSzQCM1AObEu2kMnFDh1sh01Eylg6jJtSOpUOR3LVx2xSJtVIpgl0d4510FIuMKZhHF5FZs4udzT6wCNMDgul4MaYHZjCVdoIgYVqwoScFkldLimF9MwL3N9VbiUVLqCeHSHAJYqKKSlFWoQl0Ri0wgglQQWsefV4sps91pM9TNBMfCvZIfie1w5+THk7iPn9eMast/LlviKFckDT4c0n4+PiVMlNSzOXPYYFHMZlakAqB7ocPRmEhPSbMJnS6TKQrapGgj10R6P/cI9D15e3VQqCT1hkCfV6qlJ1cT8MoTednVMLtu2k1jGq4KmrKXS6a2NGio26Z6wtWIdd5GBr5jJiMGoFoKE2kV9SjgquCJpDicZYp+prETWmVhYGTze9wLO1jh5V0KIOlmPbgKqkVUCSdl+OgGPuJbyhikvfjlY7gUJBA5kM79y3UOddIxgh1ToWzIelFrlwUOR+ZZFHkpMprmk+cUwyjCmQqp5X09UCuL2aIc5T4fMMg6DPnSG2p2Yk694nzwG3UOTASzOuhQXElMAKzvvpmyB301GE1m8OdXx25c8gwDgXgX8Cd/8tO3Pm/olJmI6b8nOKiyJ2nnjtPUZD1uXNe1tFuAXf+p7nJ8Tcd5/HnZht/br5u/Lm5HPHnYnv5hKxBWMCASoXw57gR0Pv8Oco5Rjvz57GPfFEfEs0qWMQB35lAN6BppTEvrKOYFF0GndTMZ9Bjc/QtpCc6XcSgl8KgF4hXj0HnXuNWiil0dBrGeTFLoWNywUT0wEihd1AQCn0W3jJS6JGtziM5LRT6yPUDKs2BdJdCnwf5oAP5Ulss4tC1xyKTuawiS6lHZpLyaFVKeVA6wZdTfdBl0aHLpXXOEx+1hgSMLSgnmlRmDQgM3Ag2lw4hknUki2z5QALOY3LA8EAdlXpZhTJUJWukHkMnD2x53kufkQAx6GfOCD5MMwfWzGTOqJc5qcdOC12ut9Hln1kq1brBX/mbIc2hxjA16qdb1RYzpHkhpLnAM8OaFxG4WdocMGlUztDmCGCOe8EMrA6+oK5Pm2PyFNr8E7nQ5vuFMqdPxUOgWkSbD+fQZiOQzJXQ5rPUGFHPCZJ9a3Xr/GYJJNnIk2R0o3AjJNmQSLIhGTfGpm00nySjwQ+STKyrHFbm0SKSTFgvlnQF89Qn4w4GABs+rwM4M48D3I17F+/onnCru3GPjwQqkHqDQOpVxOAhkbUkgsb8zUW02PiUsJISFai86mhdBXqvISXKeVyxlT6yLoza8grnSnvE0n0VCfOP554wNyDMSU0kzD1Xjh97XRUJc5FEjtHUudwnzMdr9R6ZBcaBMK8w+scn6n10vd8T5pUICGG+LxC9+9nnWnMSL+02xEyY76+ruQlrOe5LnLBlN6LlnIhaJKz9uiSs2+/2BVYXE6h5YKsuO+H2P85Vx6bHSfvcfhC7+yVSY0J5Tz2eju5lTLZjIcwjgIVAPwWwEC662Ibj2knjuF8OHRaOlKX5I2UXuGKk2K/LSJnFFaCGU4irZ0D9Bg6svRhFGFUM/ljG2N4VD/1yYMsNs+V7Rzpy1E0V2fKBZ8srNqp9ArFa6cHu/N+3KR7oDCJbzlbMsuXGs+WwTCyqpFzYcjjnqj5bXqG9CEW2XMyw25aheFhYBba86LDlV0e2XFr12HIo8Wz5u3OjiT4zCxhz02PModWQOrCT+EppPWXKHAqNS+lLKHPu3ukoWjQpfHpgY+SBCzcO18zEihhL98WkaealGwte84GN7vJimcOtdMtFY+kxqkL1WHoU0V1bt02RmCuVItjVMd5JR7HImGJqdzHH7mJnuw8sQvWAoDpejOqBGVRNlxnLoIa+Twolr5YUw/omd7lIi95ULCpQTw6RYAExUUWlKEvRBDqjFoHLurQPVw922BZamNhvKW25OxNUl1G1RFNUe4faA55uIhIZu1neOLVhA1eKk4IHb8AHXYq8mPAo6FPkKQ9RociNNJT3UgtPkac8xWHlroQiL6GIKfIBhAaurDUX4l3T7RT5UaXVYf3/7P0LoGVHVSeMn/08+5x9zj37vk/fc7t77d2dpPOkgZB0QiB9sMHEgGT868jMpzPRBIbv9oVJEPkYCaRDAjQvbTFqEiJ9+1yU8NIgiBd5NYoaFbRVHtFhxqABg6CGhxo0gf/6rVW1a5/H7e48UGakk3t27ara9Vi1atWqVavWetmoSQFn5ekpnlCF7Ga1caqepmrWhOx1eU1vbAO19PY0LrgnBRvEuokNPxwoQhieFUdPGvOylz7ZT9KKuQBSF2FjLSBfb1z4VVMqv6kGrHxrSuWakdbXbOt3vELLzv5ahQamgLy245VqOxaDdZcYjc3uRQyI2+mBGCA61+elWcbOtcQ0/lo1luplUjxDz6j4f9AaGIRlB7W0MmS6Un1YwKjh4bXsdfjWGBO5OZHMVW8BpNnLd/5kfS276fXmtoCG1N4ebOKlr/R8ceDj7PdVrR125M5i2xN7e61XFh4ofV9McXZSdnWT+2qHD6satlV4hxFVWC7XlUmvcOgn5Fm7Z3D8BpYR3nIUld7tBeq+C74YPG3MsBnYWxJRVxrtgfir1KsgmoE8Z2uOPAcNvFegId/xV5+r4yvNB1hX8rrgusAdH6Vq3taHbfv0G16AJnvHd/DhWoM61JGLLxAJUbXPPYYXOFycyf7eXuvIA5vrqLWYX9oO3Pdn6e8/7Z/ftvLkwb7n/tzCb/zOb9/3ITYL+CNnfffNh9s/eHFpIfAOuPJwxgbvetn7/uiPznj7kwb7zvrmS3/v4DueAGODN9948ePv//C7EbzqHz/+vv/4X3fh+//fy66cSX/hZxB0IFAHI4Ez9DdIXxP5Ia/c5GWHANIivFXWiiLkmFslJjqSxwAOoPINoLaMjyZaewUUajX4B+c6IJS3wgJltJ7HqmEXr+dRqqV8GJZylD8YcgOTIHAgvKxoAEWPyW0aRtXfwrP0J/ma/3XnAZjw6N+BeE6/u0zvH/ooB/v34Zdzfum9b0RhzR5nOiopa7+NFI5oplX88gbr3F/9T1aEXQP80po8uvrI9JHoo7ZG7osm5x1QE1nlkekj0UdtaAhc0MBO+4qGoa+/s0lfEY++ylP7+rvSV/yO9lVS1u4s+wroi0eYW3lk6eH3VPuKb5r45iF2+S72kwVD9HmcUnyrsAf7nvfGp1z+6fZfsosr7/B6eqvnBddWpslgwLh67Sf/6D9f+GefY5z/4m1nvubzn/vPPFFkMrz0G+/6wb/a+rs8gz75Ix9hG5tnwLDmL90PI5vXs3cbNfbpbGdGFABLL1U7+ZxXHBioZSBnJFNQ+Qg35whFNu/Fg7Uj6RvQtmEyUPjuuyI4UoQuWWxylo7xDs3/Abfvn7ml/99/+MjC6kf+I1r6dCn8F3kOIo/0WEL7PrHn4Ie+8M+3f5A9vLzrPR9809/lmNnv/L7bDjzzZW/gvqPhjLFs4jV9a1N8qETwoXJ890SlP601Q7p4Et4Dq0yVHilV48y3FQF716qaeVX/W4CWeTl/77PFTNoDPm8x+nfeabzAlHTxthtCtQanq4ilDWXgQIUIcX9c+LYfwaIybD7WeAg78L6nblnYe1Xuk3tbK0IbPrrGIIcBDH64OL3FWNZGe6+stIaCdXY6+KY3f+S7/sPfzD9ljV/ZQUMdD3hm+MGn/8OPX/3Ajqcg5+3JDX32qCBuLJIHv8qpS+99zfWPO0JIPfD/fvA2STUpp95b/NodGVLu+KUHj1RS7j3yi+/+yHX/2Ict9Wu6t1RSLv7qn/5D94WfRMqh9/7dKyopZ/zX972k9fZ3IuXua675fyspN3/sh7/+ovtfipTaS7bvq6Q8/WsHLv/Cl58qKR84Nl9J+eKrXrX9Ke+NJeXAX//FXpcS3vWs5B2v+vBeAczcmyop3/fED7zkiv+8oikHLq+kRKf94/afaYd7Kz4n8kSW5H02abDPfr4mDj5MIfxWWGh+ZdPakTK5xUiZ1EukTIYMUiZDEymTRwApk0cNKZNHGimTsQMpk7FKUyweWuwUaKZmqwPdlorDSiyvatiWSr97xk6wQ2+16zvswOQ2teRb4ZKyvYMH1D/s89hcsst9pLwEO8idD0jlEacCqF6mri7Yjr9P+etWUI3PvmxifY69dVJ2bzz7rXnNXSMWwl0bDJh9oPqtMIF/K1aQkOqurdkv6eZErV+b2d/dOxBnmWxdd5DuFY/tZ9du/gp2LZ540YVNBn0/+Of8m31NdAD6cKaAVH5w5M9LZJr+VuAn18XX9mWDgJ3OwS7VYMHrQJc475tjc5ebxSOIIR9xvONCRn6RLA+kxrLkjfLNHOQ//OQtYoQn3/eO8eQ9Wx1PqDeVkMGhLwi/+OJa0ei9h5l9MFPqmXvXFQr7Hnjrl//kGT96BY93U48LNbtS+eY64uocR81bi1RxSI/QY4mk5lr2kygHUZFEOWPQml35aKSHSE/VKvKtzJPjgfimZszbOHwtK8+bLihiP/mamlUfO1P7Lrhsx9kzr7n/x8kFr+xJodQa4LiK0kEuHtqg8wWwYjtr5bCNCn/VMJfzWeotWWrpeZNtdfYPAgvOM+7ksn/UWHdcfLbnlTZdPfzUjKccVUX0xFzpfmM+If0vYtwTyLY2gmz6PqeYkt2vOAtcyni4D/3+AbTB7K5vQ1ZSpYDCQ9PU9GyaPsvzJ/Shll3/clPchWIP8h2muOzliMemjqSHvvbxBsQOe2Rz7b59uN1437zddw21+82bttsVf8dw8XjfvPivDRX/jpMofmOk+I3jQv0PqsW/5ySKPzpcPN43L/4dQ8V/4CSKv3O4eLxvXvydQ8V/dNPiz6wZhDz08qHC9f0Yvsu+aQjd6wPexcPjpSM9YgffCKmKwNEez9Ce75pAeyDIwiSNVihUgqIRR31EvL0SUV8pF7MiMl81V6q23x1lQf4W56fQUCnxbqfpFYYydCTLESfdy5oKOiv7dnu/PP+PT74XFVCo2TSX5PEqhEQlYIXPjQchcYAJQd8EMAGS71zkprll0+R71t71wuylUTCXMr2i222NCCs1hZDrgawdVKo2NCuHBw/vm2PGPUOY8WZkPdGsHC4e75sXf+BjQ7Ny0+Jf7MtJvM7LkQr0/WhtqAYsqWL8+TZTA00472buPEUzCE8yz91mCqPUofk6XC3eN+/XxlC/PnASYLtzuHi8b178J4aK/+hJFH9suHi8b178fUPFf+wkir9ruHi8b1786z5eLf4TJ1H83cPF433z4m8fKv4zJ1H8vcPF433z4j86VPw9J1H8fcPF433z4u8eKv5LmxYfsKD5Pw+xIWHFhu+vwNRX9mojslbz5GzaGQZ6QYJkAVeVIy+7Xn1RUFj17R4YN1/qnCw9wxmdSaZFZC0Zc4k25t1frtLvF2/CG735p19e4Y0OXa+xNw/F/rSJvXFi3vsPVWPfgNiHz119C3Nvyh5uDHXrptEOXOj5w5X4Womf3Q8uSxM0Ve+QeCes8e6hGn/u5Gv86PUnqDGr9b/EhWMHdjPypmdyE+SD3FckrdnTZz+77XVo2es8+/Efe4753O0OamqyKdnl34eCdbNI/Po1vKo6qrqdw8qLPDjJcp74hMjjjF0tbIGV320RGr7Ikuz11yvO+gwM8thDf7ah6M6nbf1ffzVPGUnKbr1eY3euaNJvwO5+9kaJ1fjs0/IhGvSTeoC0W5Mwod4j7QFOGAPYp/u8GEGsrw+x0pWeYz0Svkv3e2V232T3Nbuv2W/1h/j1eKcGa+JJUSfGA3gI0BTsolAaU03L0+lDcfYL2g/sc1RJDo7iUp1z5KFJolzoZ29Cxpa3aRLFT/HHC46xma3JN4g8LMjRr+Gg/xDitMlm3t+Gh7G0hcaqrsmDKReAHChgDQVYRZwIzY1E2SJ2aHyj5wWTzIObe1XAf3H0Ys4Au3oiOMcPDDfTXcU0CoFigR0vsFBq21yNah9RrOAbWXlQGk5zJrbT92KEUI7zflOE0FowDsilNRSyEWOOe0bbdhsGgSlSa2zIAa0NxKwURqE1FNYwsMqSVuFDW2f9e6r2p3EoouJTOLYIbAWBVqBbbWThcHbsBmOFWk6g1G+Ia7w1AkLmhp7Ig6HOcT8/65f2sn+2VIlbWOrfVpu6WRsDaUD2TXz/6I+eq7s6eoMTjN4rH+VWKB5LO7JqO9ZP0I63wkfSBJ/4UjuohL0YJxfFQggmIjd8MhgxhkLuGDICYAihNsR/5RAGdggp1DP5Xzgomxq9bRkb9I8EhKBJEWp1Vcdc7H5BU4NesUUv1MrV+/iipVcbpdC6dFKt7FhzDxQDplyJ1KBwwANp2ZvQoCVBQ7Vv4lW9ArwRqf9GoHrLDVVQKa79m4Lq9hs2BZWbY28/eVCFQ6DyNgFVMAoqWZOHQfWm11VBpRPCACv7NwLW4dcdD1hrSIUzM2VWSVZoWfE8XfFgtP6C4A4kpjckDTnu532p91L+lT8D4juY9DaspfRyWy6+O/EtLgAOjuilQZ834B414IhijZ+gLTd7qHk1V63ZBLBoYFHlByyw44Zc9ktojrizSkvPZWm/tVrU5BW7B3UxhsUWq6xbdQtfTb3jL4EGpFnAoRnENdzswaNVTPXsLagDrRTtI1xY6UKynAA7kknlAnnsNZ6WjCgeYWGWMawNNZkz793jq4EvlKq3cszi0LD+7x74JmTigEhLTI7pLgBktNE/4K1om7W5oLrS4NuRhTNM2Om3H0zDq7kwPK8wz8vNU88j0qqtT++75DGlOkn1SgKL1fMOdyYzObhPWspu8yTzzMyzphlh+cIXw0F1SOaLGUppBvbSZvnmWf9qVlqQOwBcWywi7XgFxxBnMBDnpADSx3/pFXMAXsNloLk3SAxwQ2Pn9MMpmqK5H+4hUS42x1aA7SNr7nNLMhhMSdR82Rn+3nwKD26sqA1QS8aNOpTi71KYfejvvWZFWhhTvGnj5shUnU+hZiDNNLcynza4Qy1rtGhqjw/4TfNX6LmCao6Ln5Mecg1vyOdGWt8B/HgMsj7bYs0z8mju/ZCtzeR1mkW5ev3uAM8oA5WcUQ2NdjDy5QasLz34YajKaqN9bXG1tggzM+MHQPp+uUPI09uu1j/i+0wDcJAjvLtw7OrgRvfWjkUqAj1z8VZyVYS010EqfJJekkGtysfxM/3tOPHlIkpwbSRPz2qpHV202wCM70G4bhfmxx2Oedm7xGlNndUr8kQJZQN5EuhG4wE2epc4JJQbNdkdyA/LZpcIIJbhD4PfWKeZ+ALNs3iz9y/SIzDf1KHOapFlDyAmn4b6Obo9jVpquMS/nHt61gTIMcLPDMTCVPm2hq6bfYiHh0cZ+PvMIEdjFZfh4D0GBZfmYqiDWz0e2vX0orZ/laFqqHRN9Jo96vCTEWQKD+BVFogOmW1dMUvc+lkCxKzLvo7UTjUg1BQaMSWNAC5Qw3SRq2Q+TYroe7pk1XTzLzf0sgeRy/Z/umIKTB7Tp/thPod4Dpzvh8BbPGLwkR9Y5Ko+sKiyDudxMoWn6BlqMrAGlBiJ8Ol7+QxzRizkcWMDVDertUJBdIqivMNgn6UpRTdu44w6V8QYqyoOIG+3H4jNE9G87MiAeRgwfBQyOOSTZPBeITEMIYBJhFGsoaoUu4MJDmBzDUw+NFIwboZ43mP5BRS1ZxQDq8AuCwpl31BsYsCGHLmMRJez3v9oDT4PgKPV2D0u8g1lJLnId2skTxC7/Z9JjzVSluDIna6Qn5hSAdbsax3LX9fMMjGKhDtdUe3i7kjUkcoYADmNOwb8UNHc38/01qkHW3EUmNtw+BKBZDAY4ITALGQ6H5tG/HvTDaWMEFTkA/IudOWjErx1wmmykRQjPcWJK1gGFceOlPYxV9onJPjGzUrTT9O+1E/sgMvAsvbdlPLPNXlr3+v/9tfW/ul3Dj0ZylPlC99YbAsDIitiHexK0pdqYSgQ3OA7URIYAyAdZjJKpSnlUgwci46BJMDYoSYYijwDhyFF5dNuIZ5xwcQFZ3XBnsMn0oV8vpI48ZMZtJcbKIM2h9uuBQavbQdvgRbKwZvXwas0CPA2VRXzCB6V4OLTii6oTd6keZmOTSmMOiB+mH1WpRqzh3u9iGlTeiGNuB3d1ZV8S0m7UNgWysxV0PfmSxRTRukqzBhV6+DipQ5augkzlmsJx2qhDFOVyyqnalYsVLzAA/177Ol+mYC3yzyyicxnjmCqLREzNEs9WhisMeWZQ2lz1Wkge4hMl/jpvMPNnwZkjglkuk8r5gUyHY5NAOvu0/AOKrSAaOlIhxYU+r0ri8Ve3kFtxAGONR8ZgPmgdBnHbZgerF00oA6+5NYVs/zV7BF+oCezV/bWMRXdMRlCAWvjPJmzJhQ8G1dyS4z+kTZoYAA35BiYeRFthGiosq9qpUo7MW3aQ/yJavovqEZ/wkMNlZV25VAxoITb4QDuglf2BkXi5pcLXsWzqyWD5QQFv1aPsf/AX8Ut2oHAEbJ6/2v+irl0k/26TOSAB1feBzl3WGyJ8mK6ASrkbEKqf5sifZperxXTVxzftseXxCm+NCfgpVld19RBW9Y8nfk38xNdP4RngzVX8PRYoYWfY7w5NoW3I4M0l3VaJAwen8JygLKv3CA9ArsvTEGdNx1e4eN5m4emqvgw0s7JACnnWbbZYXvexAOinLqsfdpILt3sMfxUu4Hm9u/1+RKxtkc3XWJ4M29pG+6XFnxNdlS6/rZxlYo4T0gtkTu0lEHwAULoRjWoBUPl2VelRyisaOl1feb+tLSiwdlVtGD1UdqYZW1TZQMF6/yqg4E85k+CazHFkL0LXL6nUJVlzIxKS0ej0lAdJgCYF4INOKiWcbgbY7IqwWO4WsJuip9LdWyyr+AHV+FfrYnId5WO++VUh7WGS/TBgFJU8+EMrU782MMP4M6FtWcpaKWIPajZy74mgAkF6nfXVrJ/0KE/k/uilOhuPw/RdO0CPteBczQdis3SFEXFJjqtz4MGJW/UpwLBU9yzWAcZQvaPqHUiusj9e53lSXn5aID5bnB4tF0IBzptN1cdwhLiTmq+4dRqjv8ZlqGxkzL32d/4XjjJzadOdrsxsaJqSHtVMG2Oe0KVAV9m4iLO8kLjpKRfUyfmqvgMkbI680IFLAP11Rvkj2PbgwxGShRw5ANGShQJI5n9kwjUQkh4gs1rCbUWtEkNGusPJFaFtz+P7KYrQj4rTEeR2Eqd7ifnm/xgX8WcHkpUP3w4T9VHKA+kZfffYFx0okHWobaH5VaPlqpio88jby39oB+EQpAd/LSF7gzAWFOTmCJC0eTBIBtabq6fBmq6RS+cJmq4JRarIZjvUjTGiEKBFFh8zhKbr2WFqlcOCdTOiu4oYyP2J92Jjp0CeJucAiTAC1THf6VcNJlwClAkusUNXYPGuhKiQaFrkBNRfo/DcCpde1IAAVmXH9iFq2PNxMh+AmDPr1yvO7OgXBjJS3/KD41ozrL3a4sl8jsqEeiIkNq324l7ttVUABOMRCyXZmJmewI5hoKBPV1M/P7GAhbYQPfNuco9AeHxPbh4VLwcJT4r+1XEiMgy0i3ObYv85W12+yfxe6rRbyijqRqtGx31qgkkRu22CO6yBUiQ3uOx/1x1CgxOdt8lv/KBW7/y6Z948r6Pfwz/7rs4u/EGqzWDLbsI4bLzgz0kMbupVh6DkIRBL7DfUkSxCA1HaIKZgvaMtKs4xuJhvgSTDm5m1WP96gryPl0dA2ZFHSyESG5xvvdjK9YkpBqkKY9JLncdoHCjwrD2WBf1WVRLPxoG2N9VT5Yje/5r1r6a8Kl5jAfldcTuyRPIb6Q3E5mTLgi9499A6GXLCTZ3Q2RD/a6wWe4+QNgz/BY3AkkRnAtj4539T4MokXwlkuqScAM62WcQMp4WCwHl7sIYSiSVvOkVcOKLIr5V/iIwPlY1rEuxFJ5djzEVSoCCFGUjzKBlTufHHEXYHLbkEeySNuEoq4vQ6X4XEmfE7QJylSFyatZO9dsEdu7d96X/sLHtFV/844spyl6uhEWE9uq0Misa2pWumvLJfWvw8VBQhCL05w0YdLOx4MKeXKj6vTgZhgZuF2wRFjg8jwxKHbn1NYgzzfRET7EBl4vmcf/mgHHQCCZcHxVENwiIooqiQPoaH1dBLeE4VhuiReSBXR4UXPYuDOh982LoRdy8BpOxR5N3UwAgX0IBvJdzA/ZJ6E7M/r0SBDbsQejBmr+HP0wQFoifW4E4hYxngPB/2PhHvk80Dncli3/+WsPtU+7j0c31hnKOw5djzosrF3bh63b/5U/+jx9/MrQdz/x/33z6mb0rOOxt8AWhh6j2suZBGvqycb0OXyk2vsh+TWmf6sJk7zWnKoHIyiSOAgjKQCiE1nOPWRqiCYCg5Ibn6+BOPX0AwIIuA+wY3tX+7llc5VlWw8apgaS/1GjahSHTfdO1lbE+Wq94VEZdWVWwG5hIxf+qYIhxSk5zdNZSEassQ12MOcIhq997It6/8PMoP5v8/Bg/U37eF64wXopljC/xFqeNY3Z+TvHzJp/la/xc42fGz4P8nObnMQ92ufIZDt7FpcwK9mOVnePQ7Rwzr5kQtcDBQ5FUsYj8vER3sb7176iDPsVuh4ggbj9p17ZcENxex8p1Rz1fQhmB2x2gRHy81Pdoi6ZlG7LW9bL34andol72G3irfP9R+b6rIO5OnDZA9KXz/GMehaj+tqhYZtmVRwuueqRnmnx7RMtMFbmtxRZ3f7QHEjfnPkDtChIBFTfa55GDggPKuIstbGC5fr82vTyw1CbgW2DCDEl2zLEPICN3CtCur6AuBDsi3JzWbBBxflCz1bTm7EOm+IyFviBYH6g76t+ZEDc1Ia49FqemEpwdBjGluIV7GKu5rsGg2DqAwD1TMOVb0OW7g5zBBuKbb0P8vWG+XRb6/sZ12K5umOvRpOUTbVXfGIMB0b4b7vy95+3+r/dcXLmhSdtpGy3j77LeRnlTzmb43r1rxE2q5EcL15zcZsARcr2U8+F+IjeXDF592MK6dR631kQeNeBYqsS9wcTNurgSbOmEuGYl7iMmrjEhbn7Ct4sT4nrjbdFZxvGRThnNC/k31qW6rEugCHW3Bj25SnftWZIqAU7Sxhs+f0rTi2WvoVvC/y0z0n0VFjUVlnjm1IcZGj1+Qbo0Jv1DT9Stx7TNSO7cHyz1Vee0xpYYdCbfOEbGj1hroWC1sMfnP4uvJupg1x9MwWcSnrvMs6taZNwjrJAUAI1V/KIzSfg9EPrvh8asOPXfkF0f1bKfO2ig68D5L5GfDi/pFQUIZshLkvEjutEFU04101Nj5NuXrZuATrUSazDfGFGAeJxqbGeNiB9jrvASA91Y/FxTpGyyh4OJn1etlmiTL78XwDeK+xQagSIUhWI8sHZ7yqiBf8IkB5ClZBWuq2bhHs21mzx7lH7/h6/DV8gomzB/b1XpQkRXuBWmn++Uz/1lsGUiliqaalLbuB0HeSlbXKTSW+1mSzud8EMRSvsrbpFxkgjuLfufYLjU9GUsDSAuPhgvF7DQs6041XK7OiG+X13Xx/wXoWbEdZ08gEHyIopW0W6lyQAg1Ve4GjFRqocudQFAHsjo521gLDgkT9ooTuKlyegTQnMg/QI/CsXJWosCqiv0xaQJ+pm3UNclOF2uw2AVtZlM1vWwDT2WbXokmjXSD5Xf2YoSLel+GccGcjWqg4S67AcJGHh8lX0YwFSf0zq8SnI4k+Px0kHgNaoioLGpHEA+uAxemwKd1YHM6r5e2KkpunOi9WuuLmXjvu7vAyQsF5Bl1FUcoY7ShE+Eefhl9X6HnvL4ej/GZCtvaqEtjg3stiCwAmghQ3JULPjBwmb0KAOBathzEglCR/Y6XPPwqeksvMB8T7aGrknZsDTmKSpFKKfVF+9OK1jmapf0VqjuTMNXO2pBLoVoCa2cX1Vp9wjKH+kECKvZsigR7PuXQghj2q7ElQJ1+F2xWxOkn4nZeEbzOiVtx7zKOVWV9cd5289+6tR703Om+bytYIXaO2WqQWJZufoI11G17P2Ck03lWS8ndz1ogw9IYmqurRVsMPMuT3cfgyIetrsBRhpbBq5iQFIiUMqUGgo/wB9jWzYwBaXciJfM/fJ3f/YnbmJet2mkXbp8NeUG5cZ6Lqi/T6fKnryNx1n5FB6Ud1Ril+Exl0/3h8/42ELQbLDXRYQ4VqIZiArnVop58Yemqk/XYbxnMaJiOTCjOWaJhz6UAergAJ4/W1FaAYYJgKApci9rh6ldeaXWUNoa+Rvra/wSXdX2aF5FhzC5ij0Xxh1iO/4pKXkImzGzDIkcJ1LhGg/vDPBuhjyjNmVoHJRARqTZwyC8yVMYHvQUiNcqEK9WID5LgXjVKBCbjzoQ40cDjIOHCsfvr8CxCTg2h+GoTmKB44KYv9wMW7zTiys7vZrb6ZUsDOTAk0VAWEaqxj3K8Ll719/4QFAIVY835Ep0CLnDHswdrP9g/iDJ283l+xw+a0UF5Nn/wga9qKNKxIqjPKNmghhakcmgMbJhnNOYfrBiIpvCBuTcWdk4Wme16jJUPOw479MYRkYdnGpPga4NabTxQE6BdRu4u4VTWK2mhu8uuqsCKlrH3lSZtBZ/H69SWJ7yj6TDRLG/MpxFj7pNzk7ZGhz2K9Y6vxjU4XwtUXPBRJhRseCGarv0k7yuOnNCttUam0c+j5EAQjFtsJZ9QCiXp55Lp1bIk/vr2EDXbXdjGUZVie0AkaRW6tAM+AkgW6ct6gUduAVDW+B2iCdghxsjBcMYJx7znGlBrbVVAE1zXMkC19eR9gLV69S+2pp/npKG5p5tTp1SNK4U/hOfZiOvLXGvE0Ms9Hj4yF9XC24+sGIBnVmgDiYNACWD1kUMpxdztk/zAjG4ORJey0K8/1K1ZQ5NKgjr6lZfoy6nMVMMB/LLoRjkUF96MRrtV+QdXRUmeMooqJ1qMDCLNCtdVUzLcK7Z5ojKt1Xh7sDkLjxVWpKmTAm0qOtKAkFIMEYpt6Jj1vPhW7aLLthFFy9ryxCKuGUBGoqrwh/XK9kExfy8WoicZ/plC20K968n/eXV1YonKd1Yl2bTopoKUyUpVszprTHIuuStAUjKGppxq0sTMFGV3M1TRotHtJRppE1zOd21PIMo4mn5FAYBQqApNQ0uO9pEJ9oht5+dAwUpY8BCEqhMGcMU0W2XfieNWiIdC/jv24Zi/u/vUMxHSjHnqhRTs1uCOTdKMAtv39nftfzFvzxv6WKx/+KVfTv64cGg0s15VOFlf6e32MiHca583uh0CUONGvzBSRfouQJF+0oK5ChLuefJF/o+4FnBv98SOr4IWOj83zJOxxe5ki0VOt59qHR8yyZ0fMs4Hd+CzmwZo+NblI4v2j51Hx06Pj+Jjs9tQsfnHzU6PveQ6Pi8C86N0vEtNE2LY3R8bpyOzz8sOj4/TsfnaQ50fO4EdLxLGc2P0vG5bykdf/2jeaUNuhoc9rL/+Vp7gQ2St9wrb7Z9pkzIPdkmj9xs+z3fCyfpsBAE9CtWh0VFILoPeocnF5LVWPQdntxbyNakMM2wVs3w5qEMamrEt8ZG+jd5kCboIWMALSe9LhS6L/hrWAHvX44Bk2bdUxtplsTeNRrb3z1c1Vy1pu6mFdla5iZVkoxFOnnBt/aq+3ytj729HK5h/4/AevpULgOrhrmcJRfL+VWf0O6UgF4bT92FIvKMOtVvS8LzvGBcFFXRRBIpUP+F5alvqJYKKifkgFzY/yEzRAH70isCvDiEc8pPr2kk0XW+7Ps8+XP7v4VSS1I7JA+RXj1VfCzBH0IiJBJvkX1TNceNBV05RdlVVUegXeiMUrUcmWnLYsaW/kFTKTBqfjkI2y4c59Xlfso0Pz/Gz5nJZZil2hN/5lx921P6AkW06oUPMsom+azE53O2lYm20knZjOemAsRrjuZZt2UuVZcuiZGxaU15YrsMUSYp06QSAqi+JNnvyLhC4xa7nqMBsPywYOkszYOrmMp+V5rU0II+sOAKpgYKnlgiMn1AMulHNssHqpXWaQZpGm1V7Wi6EvcGE5e5OFWaKVWtAUZtUXanHstIVPZ7MrFbooxV11zJylhtCdCRf9z6JBrulUsCWBeA2gvw+jgrwJ8Vp/N4hGZEKKE5GY+B1ZRywzDLyA89Zn1rUUv1ojFsRiudd18GibHrrCx6XDCy5F3tIPmyfyy2qDsuLWd+UCxlvy8jhHubnGacuPVonv/rcvHmssgCwLUkzrns1wPWEy+6+54j/z5/8eCBoB+tZH+A0iAD7uKLboWRWOrrTZNZueDVo67ydInhOOdRPMT1GjEwzZ7X9g2wxqoWGWQ/AArqUIFP5FpuAUOtdbTcboQNlWjT4hr8SwDVm0Yp2EBPZqcMeKgaNu31CZp04zNj8pTAzF6wFLuVPt3zJlM+fOnD5EmgtK6q/anT6YgQsyphe6Mntjae8k+f/tQ/3fDlt95y1OgqiAEJt4kxgS17qTS2D9RyhvSyP72hvOGJi3FB9levkRMqx8Pdf/H6AwHYwxR013sR67YGVENrQdrLTBSYi2G19A/qcYd3j6C8/kt8eyP2bq/stTmm3GTjmGA9OhBAOw57oStIdNlwybP/EjRBOFXywXsYfewou1c5DxxCZYCTTk/YKotwWzmmEM4rpZg+gSvz8Dk04OHiuQFI82tTz4pCtYyYp3pLmEMtbRKfeYbYJdS0DfmUK7GDHDcGELtuMDGP5VIJNl663YgxFzW3OJv6DNc23/fyBZrTS7G/XgJy4OBO02vM3y/eVizyJOMtv7Pj/t4HZ2Vbwi2RpTLBXlka7VGTW/xgLazJZEPhW2jpwc+Ly1qJf/AeL18SZbICo6J3HPkbzpWGonZ9DXP6YS4nGeQheZ4WGQdeyviJ2YR08sEFqZiL6tynmbymebWT+Bi7ZBkmXD0L9Eaq3EUN+lAKcTeA5eTLWVfMwEI+i6ZW8fyhFQFhYMrrqArugw1f92Xav0C65te4m/mSnVNLggjVTqcmxna1BhpQs9UG1JZdQ2CNPSYS7fPnmfxeIcX3M1Q6XLp2U1/QCKltuHi92NozY+bp6zIgZBqzTD6uL17D3XuB3Hpdph6iGNGqsT207hqFR9/PGZjqIGcOYCq4mPcDZQbU0ycQyN73o1kVvOmL3trRRcYIz/UlRW/K+62v+5ZsIT7vthDd6g7ir0+wg/iZemavvCSGofPNu/cSDk0kN8o67fs+UZq7q5xgyd41lX0EWLZiJi0VC9V5pG0y0ztWLYO8rnQSp3JCEOB/EW4xDEGofAGwgCC0KdzApeqNvIO7XG5xrt5kK2nDrKENcxSQzXAMhr2n1otIdT3zeYqMyfwIFEQP36tUo7OGo/Tb2EQhUGCEanQNBm4BW6NUYwkUMKElpRo9M6u61APVaFQmUG+EaszyN9QT7N0CpGwYqrGFGkieo2iYatQM1ZgTqhFzb+dxmDVMNRol1WisFEtKNZZBK5ZANZYrVEP9itrp21aqkVapxpKWh/s2JdXolv1bqlCNnr1w2xulGj1HNXoTqMYSNYVqLJkz+8lUo2eoRu9EVKM3iWosmzFr6OtWQMg0Zuso1dhKyxOoxjJad43CQ6jGEho5XZG58SEgbX2/aDLSsj7Z8v2MuSpIoZIJxsM8GiIQFKW/tem2nqmDXke97WcqBvBuwgtrQ+Ght1MRo6bxNCcusUqy7n/fdoNVw8HYoimqaNQqQHGcmst9F0NHE70naBy9HZ9JvlxNbyGRyxtPJ1t2K3tHGammk3z9HBnysOQMHUtbhtYMgzWU6u63l0abIAQMVJGjam5vm7GipftpkD7d/2YfF2by75Km8UZZErzwuqC83HB+5c4fpA23nc/PiA2JnF/d3Ybju1uOH9rf6h44tELCEHHCB9T7hxahuXmQOKpyoKxXtCoasVXL3LoXTUFqoDwAE80mmQ279v3sD5GuRVO4gg3m5XIztoKXTaO+3j9AQEGl5bJx0ksGmG6uOS29/duuxAS6A6a2XOxlYeOQ7LwJ3p3TuqtFZrScQtVyGr4L0sRWSobeNsldAulQc5BPux3YjN6ZFOavmOVFVj1BT+HRYcm3XEQrF6EBddblplyprMVYvNsArI7bA3WowGV/pIrSecTvt53PSxAIQuAubVIGJbjWKjdMmk8hOjOv9yrm5QRjvtIfF+yIY1dxGFiJpDoUoxZkTPJFW0TBBHsYKJ2iC3ajKXeBO7ptaiKmyzFHFFgvHjbc1vfQCZR8ya00L+r0ckcQd+qIHx2o1vODMFh8i1dfUYOkV+GUiODf7OGxMiuYLNxoRdKzY4jUw40ZQYMQte+m0DJD8r4H7wm/J0otQ1yGFEjLcRIIYEyz+BjfSesM7s6Z95r1UHJg76Bo8imX+s2LZOQpMo5zO0eAShtHVMG1Zpkv3Z/KWOYJHmHeAGc3vZa37O3PBiX7+93n2ZufqV4eulyxRfc8Er2nEvuGMpYqse/WWCYdhgY5SX3ryC3pO4MAlpsnnv55DNwiAnnK/kYlk2zVaCGP8TyI0225Q7cMIoOrCyEo/FnukA9ndyDbHJIrJkl54peVIRLyFwNLcO+q1CQuWSKZgvZ+CRwm4rJMgsfuojFEEnwXhP+gypsLqvA2kUsoTdA+EYQF1ASyqAdMUbhU8UIgPzqY2d8JxxoDJQjJSVGHYxryEdMlvDCgTHE6wgkupDj5TgUi7kIKioT+vbMBXdTX9eKRTwgNifrTd/rsU6bqnhh+Vyj4IHymgJEesqmUDL9bZyvqxS5UDdig9POCgqCVVv3sfvOZSdCHFhPe4r6cVNLklrgiT9hWvb8YKjM8KBw5gt74j4gfPc1wq2YIhtTnkKGWvhbqzbFdPTN3wQd3y0o3hQMFZoxXHdZEdGI5IaQ6Hz42qMHQgmkBPOSKEnQgszeiZrlpnyeCLZjInE/b1hB7P06Wk9Xs5ZjsT2St/2oQu3U+tK2876xvwQVGZ4E9WMetFWAd5/L0YuPEe4x5NHbH0S31dWmGNEkux0Eit1ZeNhzkDSyNekUXCocTJExlnN6RBINBY5Ep2W8vZTc8aHWD4gFWIZ5d62tr5lbjly5Gorfv8fLviyx/9Fqyv7WGZb6Ea0JfOstSTsTvqUa/oYymarTSTr27OXbtUm9uauTovU2NtN/zkLobq7d5Hg+5ii4CPZTPI2fK1VyX6mcUZZ9Qq2w1E7VHMmusblurmT85KbPGgpMPq+anRlhV1bqT+wDXipUraY7eaDYXmSuUVuuuvOlAC5nUG+Lky2QYZJ8y0lwk310rdd2rOqxom/rwXE9Xx9wIBLYdIR7KqwHXtbIc6B5KhYr+9UH2aV3usKRAoI15gKodExegsmydx8FHXaVSeYYfMY9gLCU+H1AZ9vSlDkDXh2hR5RIS8wE1lH9pj58+Du39VbWiK4djNXv2foS4DK9ytaxiFiT7CtaZ9Odc61qFr+3zH8XGPdx2vd7zIYkpRQ0wdFcioae4SbUrh4gTH5qGait2rTLuqNsvP/XLT4tIyBLspSkVu05vkY99D/+RfxEF0F0qDV4eWyhpZ2m1MA9Ku4V5CMzGq1h9ROB2BIaIaeSCsXhoDoaSY0trGceAZUxFY0trlbPrPzdP1Jq0MZc8TlobmDNg8vr3/YtxhJb9ecWwRYJrrpGeDzW5tCaX63qRuL7BflFDqVP19FRi97jIN5SRJJERNSkB4SZvdQM3U9YGeV2zvtvYrNKuD837OkdLx0A2Url46Q4vVWMERZhuh+6moQOGigKNdUx7R7pRChE/tsCBj9lDN7WxAs0dHTQpQe1RPiDBprVbk1i7NfZIrWns1vT9fApdadOUet1sjQEqHYGSjiVGPYCdi4bhzL7uNrzU7rnL2yDawseDfdSj1sgsxrIFRIP0CBSn4+vZ/8KHcMfVBGZjYFNh+tXsD6B6rDxMqrPFZL2iPHapQ6+b92vKmZsDeMB1ATQb/Ln4pwwm8tS17KsqfxVlH7UPGFTvKTjK8p/2DtbSlwcBbomV04xGbs8mJEa/J9/6iviWV6YqhAS9Ag7uXIF0aF6dWyH96LwJHLOBu23gPg70r/ef6G3MO5lA3cgE9Ir5HOSasqQ1rd9kNavZqh6ZCweHWGwP++1ntgNMguwv9B4OtbK7lQIpn2VqwAd4tmBIB1dcSDds9dQpAcGNMicn7uZO2KdJ5uhjWbj6LbVFL/o9/T97Lc9/xFtb9LHEZ581L7G1Ov9WP1T1Bg8exSD72gUo3tkEFB2EZMXQRSJwl1RqBG8q8xRAbSXSyYLNA67pxD9GMZ+c8Ub4qddcyJmg+wUGke++J8pbQ2qsbDg2M7g6dAnchqYgYLcSh5jbQwXvmxfzDtgLcM2e0ovGLfsW/uNfv+lXgj+56EqAjbH6Qs6J0cU2nQEot0DUDFKRDFDooMLK97K/VAxX60ghwB1We+nAXsv+Svjqv/e86Fq50TKf+3genZcLYIxd4HayNwD8eWTYxX9xumtOqKdrZpkwGqiV/b2mp6B1eck7Ag4bDjp9ABxzULQlC3/frbfg3+9dXGpBXrB3bUBROTMHFFcVSweHVb09HBRiWkeKgivdter3g/SH2Ry9nrXaC6J2oviKxkAF2VHChg7Dq2rQ3Xdn086gDlgDtX/zr2Vz//DB41tL/9exHf9LNxy/FVv0Ot0n8cKQPPRHxuWQl37Fj+rXBcZIm9rIh/3/2iVtNYjCM+yYt8pl3VtbxVkAT19Zcj0x+4MHlkFxqmjIGMpI2ezprzuEyL5ywNw/FKqzoe/QcqBJ+aYo5viiM56SQVNUG9e6lVAeYzJWyQFlrMoyBU1jqqumMfmSUeyGzohGR4ems394rbQE0DbhNs3KqSOWHVcgtfhGuqnDv6Y30APK/tp1cjVKO2Luy830j74MipHTiJsutZP6d3Asr5+4qdQAvX0hRU9HUvqnUdM3ph0i/os5HF4b6lTAUjJhOZLFZnjCF96R3FeqH2B0MDi7eV/UH+YFIdF/Wl6faFmyMSQrVZmWnaJH2XhHVR21ZUzHtUqlDZtzD7v9mlJCCzOrSnzB/BgdWlfGlAtmLthxwWlgdEodllfzY2pQvRvGKjUwHJHzcpAvTL4z4YJbXHBJmPiForc/X6b5fCvN5dsmVp45HWppPm0Dq7NAy5h6W4Eh2zYG0G+eZmSjrVC3QSw0ZKe5yTQFAfNCvo0WRCdBcGVezrG53T2gwQKj2gxOvfNF2sKhLoe6/Jwd4FC0w5i1xG9b+FR8Kkf6EqP1Wr5EPRS4eEtpDAng6drXGrstzTDpp2Ffk6aZ1jYvUI4kg41iyjimwVcxETNFnez1mEqurGJKjE9Oca7kArA0rRLPnGRXbelS7JLKu8J9RfivRGFTUNqZtFoo7+Vvun9R9todJ1GUfc5x8qDveOBkqP7UIgEJNKrhSMZ7aN/VshfwjSKXx9l+b9jdh/LfFJcbglg2BLDOyO/WbHu5CwDaa2ZNiZlaj+wEQLDwMSxfLXDgtoVSv0f2AZ3qPqDu9gGJ3QfU7T6AQ4kYPHf7AEgtZSfQudSw7BEYHWj0tD24oJ06MacP0sZxeR3f41vTWZoC56+9XSc/+zy+ITVuhMikyNwNcW0b4z6SOX7axutWwV5x6GDSdKr7Ay/FooDi8qxSnwPiXwsQZ/TMBVg7MxguOBkpOMZ+KEEXnNXltIzR/VAD+6GGkWkfZwAq4PdL8MtHFu8M/OrKY8SM13ZZ/fkwAs77wuBaxY6Fqn3TTyzAGdG9aBF6QhE2i3oGeieeiZgVOrZAPjQ1GiLgy5t6BgIdfWhbWNKLgzYurg1VARzCTFnhWwM/U30OKNLrotBRkWvGfZyEIX3vab18WkrtQlraAeinUfp3m93+jC3fy0OaglxVVtFQtTs7eMzrcSFQaQZquusU6KGp2qWcowiBBJkT1uSkyOJMBEAv4JMBLWhkKdeLgEgRzWK8Z3Ut1fFGPe4QycS4A6SmxDgBZgcY0KFMB9PQsQBvepiCHW/ijGZQLM2zx2BKJquWEVBcZMxeYOjArQF42Re0ATz0FjFe7gdKCocuJKu4tIx6No4bKxc8ngNDvuPn1BAo+YYe7lLtw9aQfCNUOyl2HiEvedXjr0nsBDaoXvZFzQAzYUMmo+SeVNUxdhGv5361Sg+7BzXOfv88cWroTlvUsNmdoRdX+u8Pi0fVN3e5L3lO5WobNj0OSBW1dXw0KN8qikNS2noRHKHAJQ+K0MEwrGyPDkNMkv2ZbmYJdur0BcWEgyN5IFOouqHh1iGqule65dkyMyZLHQE9B7uBDMlmvSAPZw3REdMH/wj5J9cHwFlarlt08jUMcc3AdsWvunDVXpGn3dGw9gOhantDQSFtWSjtXaPQtBBN9ShaqxpkoHioaTF2ybZpdQoxs/RNT6bQuphbF0I6ii3mEQrXKpAkr4p66+kzoEy8qQeLf3xtdU+oRFsSfWcB1u0LH+LVFOxRr8X3YjkSd7LvncdTt+mDItB9OjCKQpi8oABX+ss8xziP2CWVVAD/ApERZX8vcuk3Q0IVVgxCOvUkvS1XZfm5akbxInTS5MPZT6tMQN2mVXfgBSDLf1f2NA9OHx2Ms6+jenu50h+xrIGaMMVVRuahGB521xQX1NLVnTGhk8jp2kFBJafKL9R0JkXwdN7FFy6zkJwyIjs6WF+7BeX5lSzj5fmwEajlZaKoCzsz+HnMSvaXyGEu39c0EcZvzjTMDJ4AgELD+PmxXiM8Z5Tvft8PHFublet7P8kTwbgZsGYwvJg3EMe1gXXhd7VBew3pfQkR91hW+EvKlQLgcscA6wpCIUUmlIAN9FJ4pXyjIVYRJdnfWmYCE6KlPi45+mazCLVWSoeXQ2pEmFarWl8NTYQUUWz95xyAwmIiW9WigUaWDQTYqj7135v9HYq2FxIiCmHhX25eJqrM6D6FYIAX47/HB9XYGLH3qcoLeag4UOXEcueclXoDnue9ROUZsq6YKQrRhQAcMBYRCn9COKMF2q9kP4tLAtnP4RdbZObvVfIWDCcFSk0unyj/DVnVHza88Hyueb5YqdBBj1TjTu3GBhJ6OrEWXODNjPu7Rd1PV6sol4BSG0IGFg+UcZWbrZLULytoJX8/EcE/gFvvI8CimGR/3pCuykXxe4VDTEruEMVrLWeJ6aMpralFKWqhWByhhVwVzgy+IuBvqxsafFJkxMVPI/zcfIZavN2WCzrYMYLtyS7lMqafeY3e3AUiwsZzbHwP+CI4nZO73LgZLnYbPKqL6wPO1tu/ulJaxJqnhjSWE7iYS3srxHYfYz7XC8Rj003OND7KJN/sMxU51KiKvd+aGG5uDmJgvXp+uYN0jZrZV2W2zEsUV1LMKdq2KV5FnbgCpnx9i0eg3O7qEAQvssZaauDDs6/pQYtDzztib/G6cS2Nmlhph361J3rYHnSiYOFW+kEhRiL7BxTmzIKtKoOo+cmDd40iVpt4/ACHKjxdCJsCr4OABZCHISkTCV/z/6hFAttChYGnBrNqim0gt4JtQYlqQdmCpBBTOtk/IaVQvli5ZE8E8lTfr1Y3YYVdrbFRpFLMJiZe+N8p5Eb89wKH9imsJEOd8pIeavcwmp6MYx5VyEwV1xWxWwax20Bgi9ShIrXpDCyXmSVVETpwCC3N7mizMzQU93GI/y7jvY66W5rRlX+W25zPScc5pAfW85DQyARYlI7p7XrIEiGtgfx+AaKgkEEBgwT/neZW+DcPcel6xb171CHsujAyNEehwCKk2Ut61AW1NCJTTvIkyasmNQmmvKYZTItGn1cVSTmxSOGZCrNDjEk0Sd8dfKFxNeKDdhEpi+aOvk4XmSQOQWrU0kkCdY5ymqS6650iT6dJRKlOE514o/MjxhDo9AgowRgF5cXglMOOoMdhh70aefynqJ4HOrihoqg0QEoHoqpzH81gW1fEBl0gtamrOWasIJgygKzij4qi5YsfUps6rRwHZ5HSQkGc7Os6CZT+tdDjAAo6GIgiXsmBZvyYEosFej2idH/XASMRYBjaCIk/qimEIlAw8jilCBEZITSNyJ+Rq0UkWSWCNAOCb6i4wCP1IYexhDhVnlPUlmfb6ru37JXiug6ekGXtiYi8I1U0Nu7NsARk/6yCEiknNneItOuRDqMeCRog28G1Hjg9eGav6zLqrfA0YF3/AxcDlqvv/tl8RmfvLHn8HbgLN1ixcuMyrwT1KDG0153azGontKYm0uTOGvb0+/NMJ2ebmjK8GAvI+VtSSYvqLyhiagIjYmpgevKbLmSgYFg/AQgsJYHs8dur3O1pFn09s+1BWUA9tsX9iB2zgZymlHEHV2U+GQOOM7oujboS1DFTcOoMHFYijinQu2rgNLyqKzIMYs6DCIC3zKxMEJdYCZTyisZjw0sneWzwxzw2+OMeG7jZVY8NaDF4veN7bPCNxwb9Wj02OH9CXMC1kz02+M5jwzd0e+G8bYx5bPBGPTYElFjHG9ldN1Q9NqBBoWvQWFdCNCh0DXIOL/5PBd8djwx8b3r1IwTfx18l4HvLcnLGdf5LmFibv6nSiZNXVen4Wm1FCUkgk143wxUSKwuYsmUvzGNdYetOKyLBIxHun+piSxARGVR1lCUQb6AItjVmysV0NCZzMdM882b4D2UFFIvIcjZvUoBzO7GAppTScIxR339RMQ8p5nw/WOX1fx6MwWIfFrhSLP5yfojFo23W4y1U44tfuKslN5wCufjlXtGGwHqDrzoi5Epn5L45zazmvN5jXGoIL+MuwgpCWzm0KKFtHJqX0Hbcn3oBQsQhX0I5mi+hgpu3QzZzO4iEi853ykuuL6fIS6Evp8rLsr6cRrP8slVfdsnLNn05XV6268sZ8tLTlzNBRc39tNP1ch50FHFJLT+LzlTA4OVs2oWXc+TlMXQGXnbLy2PpNLw8jpCRisdTKM9z+XJZ8QTaLS/n0TnyPB+Re/iHt15Ej6Oz6SzEXECPpccgcKEm1ehUQjPo8XTug5/zuExOR0AyPVZuuV3ONXzeQwlIOIvOp/M4ML7twxdn4+c8+SwrzufPbAtCOo9QDJePaBSA2k/R2p9Ae1C21neF1ncBXYi4J0gcd6xSGD4whSHaFrYThdW4K9oD+fDq4rHIeBadrY1H3G5upiusxomS5zGcxxUm609obj0GekVkBxadHTSjDMQW3G/dQl1EMsZxZMtXGYXsql66MuV7NT8tp4l/3GkyxZV0vjNNvjNN/h1MkyDFrAien2/H49K2R9sxJYiL2EZpfoaZEhkXOG2mxBkPfUpk1SmxDah8Jm3jGahTgnGRSNB/C4e2S6gHhJPQMtBfJww35XRB/9MtXj8OLxavd8rLDjsXZvlli50LeOnZuYCXM81cqCD5rjEkP7WK5KdVkFzRYLfiM2MBooHfSxX8tsO1m87CSAmeaZwZ+NAg6/mSDAT99Lt/+OLqH4YdePFYeoJg78XVv2IPJwoSSnWKNOeRjT1rHN/NnLFYo7j/eIP75w6h6/n0eBQIrHUY9jhFVzvhFPcnoCs9XHQ9HZh5ukXXM/oZSNI2RDJeGKqu+lxb9BLomZSCIlrU2sFoGPLo4AnqcybQ5jRiSmao7y6O2iLIdHpJVc/gck4VtDqVzlCs2C0vuyyOzfLL6RbH8HKawbEK8uwcQ55TKsijoDtnnA4qiM5RaqeA2a1QfkxJv5Ru6NgNQ5ajzzo5yJ4KIJ5qIbsDUsIddCYiGSAamcIf7vML/mFwsVVoleSkNAcgzQgZaOYB+O3yWp1hiQ2LGzj2New/F1ARVbR3PAAl+5JAgCjcjqjj0wy9B4oLqXU+4Z/19+rijWGG+lG/DlhDvQgLeY+z8dsy1kclmLmi9dX5ufKk/AmKrbkh9fn5OvnyPWLaZAc2+DUd3hqIxzIep2qxp7lVEXl0+ZyR1wALqGQ6gx/B8KJ56hBKUH6WkpAleTlb6agQDsbYM+2iSYy2p7hFs8YLYChPrH/FE2m3vFxE58jzSYh8ssEct2hebBfNvRZVTleCo0sUl8k0ZdMl0ayke4bW0IvoSSXJuHBoRQzpQs2rC6Wp0ZK4J9KT8Z2ue3Qx7cXbhfSE4QI0FWTOFbBL58EFltqcO0RnHu8KAIXR1MdotBZwEguiDxG32QDOpn/tefF15Kn0MHiRbgZ9HMQGqyrDU7GcJqjoUQXhY4K4S5x0T1zjxnL+4dyw1ZR8heYsQTyEqWwpXMm+iX2zE4OquB11XuquLofY5lYknka/x6dApi1FVtHHx+e+7ZPKY375IXgrhdB/zFsp4sKKt9LuKgwEisD/an5bOYHv0rd/8m2frJW+S19Y8V36NqRwJD/OcK5LD7zOuS492SqdI1MuL7ueS8Dz5XiOuRuFzDW7AUkjHkdvRFwtfa/v+RC+BBXhS+iELxIdwolrxHEKqkjGA7XoMCBHHmrj0Wz/aUgXYZ4KUyuylQAPjuUHcloZaShSDbldwXKLwFYQmArQ4zHJVbCJ6EVcxsoJNgXOZewEyZUAXJtbbepmbQyqgqsTaDwceNWIxoP/aGo8fNb36ieL4zpwRXw8n7zxyfvkPZFHXhRULw04FglFPOqVSmIZWhw4SiVVL7wYePXCqwfXw+Mfoynqd1dHG2IqyMkwDwDK8hHqA/CN5QZW9rFXuZkRH88RrxOs/aieVHJaA2JwmD7ee41QmlW81q/B17mvqyHoG1AlKA97aEW8yQ4hlBp+Klg0pwpq/wUTT2zbfOkNFds23oXmfU51CrL7BZKCarjtdMcDejOAYciPe5HVWuXz5KBdQFEt/mvDxeN98+I/NlT8fSdR/APDxeN98+LvHSr+/k2L31qzl5t4xn9TngiZK0vLOss+ZS5LfOKT1x9EEXpfYivMzIb6cfZ7B0Y+vdTzxy0NwUfY72vDsteJnXcfU0WwRw0IvR6xwwZ0v9fzDAReZ2wTYeGDQxV+xe2sloKgqFIJ7bhmUXDJx9+CyzBQeVDcq15D+cmXH/8ail9Lpx0l69curEVpOieToYVhgurKq1CGWKNUHTWln740T/xwMfLzii6/e+S3hp9dEjx3ZX9u+sSfGlYlrddAYHan/3ETF+U160ZLnRTbkDLU8pK9Bq3S4GtHPZ//rDije5kC0DcEVQvyZWhO90XXxF4hAukRim7O1nSJAThVeVPaLxEIcVyqgyKUTvN7GB19YNlAdGiiAA/Epj/EI25qALgVTxQ2yKSsjR1+LPq+Fqne96RI7U12iw6r3G/WOy8V9LxxGD0PnBg9Dzj0vPFfFT1/6gTo+VasfGMIYk9AnbMzPSwKhb2ssAkAmNygU4fTRYC1rE4R8V+5lgWld3n1xZ39LBpVRILdFGvDwVwYZIxQq6s6lmUMmGDYmNguY76uWj6+aOlyJYXWz9Nv1Z13qKVj6UIlUoPCAQ+kZT+HBi0JcqjnMa+6gv08Uv+NQPXT326gesNxQfUzSBWi92ywc5OtyRrrj7qpkckvzj/g+056i1akVZaiJS8+XgphS3S68yR6otRijusNp7a/f+01+zlX1VenJrVK55xgETu1PitrHGT+VxeyonL8yFuf7ID2RRqhM/vhdermb/NO7RC6pvb1cPcBTsuRC5kyU/L5ZZNCOP3CSqG91Ug0dfpG5DRrefY/lbF+kufDQr2HZkv5ypkovRWkzG7TtWUFpBbFW3pLXvqDUvg90k11JXO3hJdXAI6Kf0lxYIefvRI8SzzZ4QO4+ZQlklU5VuxfmsjieHftkayOh93quPbvbnU8Mr46ngwWPcULJmFDoOUraSzQgBUdVocSgUUJ5WuSRzJyv+hG7pf+3Y3cWx7eyI0wrG+V9GduyrCScKbL+4VtpZKD3SWsq07GTXlWeiRj+w43tu/8dze2v/yojO0dkv59w2PrtiIyhBhY9bP6dBnYi/BzSUllyZ84vI986r7bDe97/t0N76/9GxNd75GM3PvcyP3Gv7uRe//DG7mTYJ4+uDnzdK70/iJhhfaXNgB3yyiTcEluvqIjsKtpRjp7JCN91I30R/7djfRvfmvn6LKMXnfiHH3ki+fvuJH73X93I3fnwxu5JjY7vy+xb/JYPiDgFP1n3r7jxAYFuA0bnLKHeHTVaXtI4tI8j1Vxva9XVlWojheKnPtndL8uFDpM5cY27qboUmt128uTFcEecbFujeL7ZtdztJZ+1Iug2+rzeHrOmLBDFrkEuWfSHerC51vUu8gjPLvmmfTVrCncsqDeEKiApnn8xnFFbFAipggPbVx/D5rVP1dhZPI6H22hBXXQfzFyX6saBBX7upef5Jy5F/eS4H7A7SWftbL5DOo+khl0zM2gP/53N4P+5OHNoEuOO452FBM+FScdyRAnsN8aCvgpN36f/nc3fnc9KtuHPz/B1vAS2TDskx3Ebtk76OGGnm1ArrP53iF8JGP7v9zY/u9/d2P7Fw9vbJ9wPA4UYsVsAuepg3X0EUnX/soN1j3/7gbrc99aJvIsFYxOXgIf8anhF9zI/c2/u5H74rd25NR5evYtkov+vRu5+/7djdyXH97IPfmEW/Rd/tGO8i6bUcoD/iMZtX9wo/aP/+5G7Z8e3qg9kUfNKXaJdh0AahTsfFgxLPzs61q4ZUJM4180yWcocvWPjZn2RuxHJ8bumhS5PBbphrJvutXHq4+TvG+akzxtO1Tk1CWXoIeCTIsNcNqYpL/9tAT2qR97XeslwXXxSypGC4/xaXSk9ahdLFj+Qm9v8inC4LyOn1BmuFGfwZpHEafc6HPBh3yET+cnDOcges3j6MwFb+ZGVMwmAcLiYKio7xP3fxv/yGY3TYade/d96T8g9o8vpqh0J8O7YK47T/A86OcN1O2taPmAV/YK6XozeyWeOXbH99eQUl9hNdaipT56bg6eV7RXoXv7Ksk2JfDx5dK9xnQoEtfgFGQHEQHbq/gWCFKnGKbAo/6hQO9cIuhLEOrus9QWH3rzgVjmwN9lvYJH5lLZ0ac49E/F5/D+YrHvwZrrIrBzoc8BVQ/sJxT28q4YPpx/WrHF2HGdlZs0nsIA9iYybgsmbZq9WoATcs+gCdqtWGiVuvIFedaKJUzWHvGjlS/7exGADQHdaS/363yrjRbU6Slxc0ojQWvOV5qz7i9lZvlWmP3UsrJiOx5zBQFQHFrOc7mNupwX/NzBOUPamu/ExYd8G4X5TtqOFp0ydCu1gMb+qbiVuoNVBPPTaCcHWHF/F53K273T8cohgBR3z/iVaWewCiV63J/YmZ9N2/JzKM8fI2IUdGYGDgIfQ6JS3wz09sA04mB5RmOc78Dd5tbRDlW23k2ns279GTlryfPtgDPzc+mc/Alc8svy8+ix3J3HMcgen59P5+Z76AlS2yJkEw/Wglp+AZ1fhlnbvQw/kcIyzHJZOh+h4km0iCcr5t8HXfxQXvbSHnn2EfkU/nkwxVDgc7qQLkDsd9FF9EQE9pXJfAmleGqZ58tQ3d9LfQQuRMa9FPEthjWfS/2KR0+iJyPlSfREuogD48IefCIVXKTfBcWT+Ttb2VO5eilnLyEaJUi0a8N30T5UoF/f4eNr6PQ/BZEXa2RQ7K0WyanIxCXvnVgkbiRot/D1UZ+7JR15IiKfqJFBcVG1SO4dMvGXF7ki7eWRRTwW6Xw8zqc9eOwBPgDfz4NTkPP6MZTg6bFQ/Wd8eJw8H0ePlydfspHnufQEefIlRUzA3bRDV4zTaRcQ9ww8zqCz8TibzsTjTDqHrwUxuj4G5osfQ2fhO75BNnwX9RR3F9VODv87k+M7k+Pf8eTADdQCN1CfhselWCyA6Lj4pxPidHyPcCLXr87GVKCnraK4nVwnQmcxBn83z4dTeV6c9vDnBI3OiXMY+09lOJzFMDiT+38a9/1sMy+eSufltQlzY1fAyFyZG7XK3Fiszg2D8hfRopkXtcq8sAMaKh7IsAKlTbzOuBK/gdyC0297+rPu/Yn3fvFi+yyexFhQPJl4YgDh1eCifRZP4UTBLy0amCgIq7EXjU8RNIOTCKWW0+yJdrogtmwf9emJOl00s0bvMt15slRrZ8oTteoLpUiNHEbrXXQhShtBa0Xd42P3Ljx20VOB3U812H2eYO95DxPLz6HTgXq4K8r4dhbecBv+DGDpaXg7jc7G29mM7ARk/258/t30NHt/tcD91bPBHwGlh/D8XMHos1e51n4NWM84uJOLyPPHB3sNYtLjGW2T/Il4grByxscB7Wg3o+RjuFvn5o8FgqLzOVOEPGREXWREPR/MYAUxFyuIGU5AQod/SoKriPfEkpzq0Fn6W8UAjkYq573gZMcMo7THjNIuQF+GDs+njo8awPo4OypPoNNlqAD53fQYvPGNQbydy+OaYVjNbdez9YOcCjrl+QX/2NuucGWd0ym0g2+kg3ow9EPajgtO24n0ox6MYz5Gue5QKYxSE/bY+4e40lpSlBmNPYDYyWsvMbvNQ7/At1vPgwUnsANnYHzPozMMqXssp/Pjcfw4AzQRcY9HOtAlRNeY9Ua3z0M2NHq3WRTyJ2nAz59s5lNuliA/N8tikPc14OdPkYv1wJmQdqNTel25usKjIUV1mX88Iqpr/RMQscst+GgUzzmz6n+XIpgs3sUltEteLjUk8HsQeVm5hlVX/afbVf8ZNvlcaZpdbb/rZJZzUDTHIlxK31PSrn3Ur+CmdJj2aX5d7m2tj9VaL6HL8K0u2PR0egbe9tHFEwqx9LRSyA7bdF3AZfF3a/yTRgsBndQJ5Cirm0CYK6GZK7tlTuy29+fPMNbidatYw89TdUk7v88Xy/czaZjahQvyamXxcZywS+0DtnGJ+HzOwlPo/P0IXdbDxFB/f4+leWrT+bwBX8XtZ9qld7xeIPwD8e1rfMCK7ntWGEFl/5ovguio49ba4L3qVp5WEIEe2khrM13d/qP71zGg0AmmCZ7ScSEG56OD59NTrRXNo1tgrm0Ovo/naB5yOm6htfgGW3iwhMl/sJzIT9zD/V7yYUAxm7zvpw4As6DwmTNSimXyYcoRLuGHNv7z+4uabvxxFZHr54Bs/AF3bPtV1sCNpS4270/Fo5VvgdwNoWKLxBdPZbKyvy9rzpaN/Jlc0+NpLt8jtWHgKKBlpmI3B6sCMeu65Cicica3HaFnDiRQxEeKOtUrFsUfnMsvRBV7C6We5+MlKR7L4MWoY3S07wzxQC+3y7TVSe/vZWILwRSdnzNeiNDiQiHmskpghoG/QcnD0oRdnAnkTsk6l+0D7Z8qqDrPEzh+IFihLVcLkpyvyGeasatENo62/rPOp5CjUcQiJ1FMe7iJMPo7MPb2PcWd0Hn056q1v8CbYpdFGNArYNPjEft4KwZ0KLJEXZGrAO6lNGWLSlPmT16asgQZUUeFKrM0L0KVrgpVuqVQpeuEKluMUAXmqme/I1T5zr7xO/vG7whVvjM5vjM5viNU+Y5Q5TtCle8IVf5vFqqAW6ZOjwfGSFe6j4p0hfluxoH5f33pynekK9+RrqhYhXzayhPgaYxpC0bA8tjjC1jOoy2jQpQar5GLtMvY3oypVpGZhCuIqAhS3GYUj3CSHIWycTnKgmyL4cfueyFHaUOc0qatyLPV2uiPaEo1Q7BPz74BTRUFQaZ2mFJoDc1Ja7I10W/R5LCSnFST4Qa//7HaiivVepuEp4K9+lkTn+0b+2x57CuJzqrR92t0RalF429Q9RNWkVFFnBOYqRpz1twPjm+m6hJ8rertq+V99uVVMRjh/IPCtmH2GjSlk47FvxbxD9He1XGsBPjDVgICayXglY+yuRJQG0witefoDJa87gRunf9nHMP3ZJ3/AnbibK+vNEq/q3BGGq/IaPw0ylIbemsxfm+Li/r+fkPcDJUOIgfwpVF65VvLG1zC7bE4Sm1ShD6leMCDsibAKjtiQnHKEPWtc9FDAaqtU2TmaBHwS6fI7Ku/5tyYFdMYxCOViJl9X0jzv37wm3/P4eAIfJ+j9eqzFBxzsGbjbFvLgPTwEPcNz4NBEfFCFojHojr+2Lb/rNKcObSTgguC22N+aovnxOPnSgFHkFpbXf2FHbnlguAO5OOURHxaImYjVihwv9WyfhP5O+LhrCO9vLLgBToSHOVAYNw7qFlfQi0cNwdyMUezSi4aFFJCMzSzxr3k3g/K8Xj13vUHgmIeuesbRbC+xm9R3+8z8vMs545FL+I0il6Y/UHVuqFzrEjBeh5gsLpiU3HW+QdbkB3KnPmAg0iXgaRpbot8xKOJkaOFtYFFlw+vFb46fh6sFYuAJDK2NGPe5a999QYtZXQHgwGgKO61FynlPGZcDTJlP4M35+/VAyzR3GLuUiW3FffDC2BUnpZ3aC6vW69QnadKtowhnunXQ9juXO7HOjHO82/XESzdyPLkweR66FTkj+dS4yfh2oino8/PWX4vzYHd5zl/YEIqw4lexyK2ntJSkrqMSnjI3sjDHPc9ikWLLj5PFrAHxJtTvLEOPO8/eaVINvZ99ifmfvm7P+uzA0f+hHe2RSN7QMyNNfmD+/gD+57y+z2V9xak7dI5NwXzdkkTqLHBrtVVNB8bZzjUqHrw9sQjzlTl+7WBDrw4RCymWdpbDp3MxjZN87QvS/gRrnxaMImfjKQYoaDie7WDR4e8yvh7lGGNzmQ8w/4djPlp9r/VFw6FCsAQgJ7jt7kVDDl843nZB42iIK1oQrJv+m/Ovv6Wn7/mSdmHkJTPUIgUxo41j0LoVWYf1m8odnGKMVpTpjXBII1o8c7AS/4sP5bBFcyg8fP8OJdZBT07sACv0yK7FA+oNQrbQAV0i+0K3DysC0pYLHQ98hgSgJY3Dq0qfEDKWtlR6cYMG4HJYzz25B1OuslDmoKui+harh0K7vCoSxnc4+xn71Gt5xVLKwrq7CMoCcb3s7vxnXxV9DALl/UkYKsvTpIgrwebhhZtozmkbKcFPGAoPaetpWl+4m1na3UFSTuxnvPG5G7PBI7ZwFEbuMMT+Cz3E15Cx+dRfgpMUwNeOylfybM+7D0V+WmgaPmp6sPJIE0MMtHhDQccT8eySaDTTMCyt5wWY4sU20OSTPi+jE6T52l0qriOpOVnIDHEfsaTx1F8L6Fj+rgbETj+OYXz0Slc9JqH5gzPJUUxtE38y3vWNaW1Bn8qLQOw0rcOnYpTuVg+6+gnVOhzgG+3ma8t872sZGw77TBr8XruaVGnoSW0DMIvJRQZZSjNA0CkvCMOy6r+uHPE5FTgUVhLwUtS4ckMJW2lJTCHO1dkbE478dAWPLQypqfmmYxpcaIxLU6hU044nMUjGcbJQ3iaHcLTUPZp5RAWtGznBhXofLxfZ+2p3GAzmrHyTQGG0UH9xRbqIXns5vVWCuhUzljxwFsw6TzoIV3TMG6Yy3Nm8h6WKTvLbwf5TScwJi3tRO9RK06dD3oy2gvUzX7T8I4z2LTkeMwVS2g+SAltWdFv8x14X0aIlCDEIAjAPyUA27lXuVK6k8GKmAxCFIIQ246HEMsWIXbkGZ1qJvryoz/RlxVDtj2KGFIYDFHsK0oMWaZtAPF2WgZ6dOAIbQd1VoD0eHRKFKGOnepK+C2qZEAVof+Ans560vnOYOJOSBmnCoZoUTrBQc0Y8BPneWulyN3M7p7no/8Ab7kFXRSOCb5v/RXsLRT4fC0g+y1ZM0yMLklp9lFdWTVydHXFnj0j/9l978cQ7BoA3n8xYl7Q51NonxZBbRYpYVE9bAm7V20iqnGttAs5FuPJ0btWRvqk0cuTo7NJhbQmZE0nxDXH45hNdCZg3xwGcDscTPIwOuwKt5/24RNrii0kN/jZuKyHHbma3IOZcHgXIPyw39E/RiuzP8FvHlozdlzaLhS6se+nn/pTd+XXJ3uth/J7L2aefTeudVGNgVNxA539qZQRK7d6iXC1qrNyQcCCHEgoSlTgHiqrWadAxQUBGCZ0JNItf0ZB9gkUeEHwLHPSFuj9p0B9hCXkg3/PPqm0SKzcFQkee/XWksmQS1ySN4Axz8pjbRL5jN23UAOXw14Er5sbph/aUw2t2eDaRbyfidESH3PAp6RqU0Irv1zsT3DFYt5Cp3RE3obVMdk7oJAzbKxnn1I4SX5usb9SgpDidcw3rcRUoWUnbq8SUFA61FQ0CaqGgs+vOTQIV+SuF29i+wd8vraPipc4PivjbdwJZDewY/6QTIzf7/mQRBhMvXvGoqoa7tDr8P27oOPDlR3Qf/dffH5gK3WkMSqVcNTBN0YQ1thnmGRUIOeRj914ZcNhgrv2ritz7PYyLtPhgY6GgD2q7CYiEAoILu9Wuh9kf4Z8WnHfw1zK/lxAx2ncPwf/v5xqR9d5uEZ2LZ512fTBaV7jJXFpUMQvfYYDuuJ/nKGxkt2ryIzRORQUidBorD8NOAuBN1jNB7Eilpu5vCUCFfH3HFADsogGpBODIizvijHeDQkMpmQnvFFk6+W9shNJDhJMl2dJQ4uQQghopteIQ0ccyI4g8shaHiJbks9IQ/JZaVQ+1z+m/hmm+WuYV9U1juvDmsQ/usbJhp1Y9HGEsvWCt0ice1CKK9a5NPVWWyxgCYxwNiPwIA52KRGVMHXqt0TzDJ0eXrqy7m8tMQqCHsv2wpUytYUnwWTcDlUyIn6ERW5VyQr4hB5Id6AGtoNoQ2617aTl/JRgLxya0BLtlEW5wjzwgtmVI7DTaDGPaEFcwy9wpbLGnsaZKEI6sp4mcOBcCdbWRP2F9n06hZXGevkurMk4KD2dTufc8qYnCQp6+yzO4FROQT5+kM/FPwvFs2Ma0qblZ5mBgN8mNAFDoa1Atupo0GncyNYNd/7e83b/13sutk/0zVS857vsEycUp5fRv2WfiD4b0XtFNmSfCh6SlCuWfuQ9xz5ony7lx64OznnNlvX32ydSUBqnMRxOKw+LP2yf6Au6j1ZzGA/8hy58Ys/BD33hn2//oH1KFz76rvd88E1/lz/ZPgE5xL/z+2478MyXveFD9mnjD83/wZY175+fbJ82/v/7Dx9ZWP3If/ywfdr4p/8A/v3ixfap8egDVA/OHmvktZ/8o/984Z997kn2KYV88bYzX/P5z/3nD9mnLfyl33jXD/7V1t99sn3a+E/+yEe4cWd82D5t/C/dn01PT19/sX3a+Eulcb/9Yft0jTyHeDw9M2Hskwfze8fZbR6NT8HTzfcVuyckPpZ2AxVP54H7Q67RN/H2yd98L6GAB7+PT6TPoTMIBZ1BrOujn1XSz6CWTAPZAjyOUbjOr2mI51ng1Pl5Jj8zfp7Bz938PJufxNMuF9mKMBGPk73HNUX0Ap7PTv8TZI31P2cGEihCoWbD+p+nU52FaCQfcjCzwVmqa2gwKLJBPs1pZNP4PaPtYEn09P5cvCTFE6A2ep6KVNEuprUdQ9HYXRhFmKuy76UnqNrouXnEx+QJ5q0lHTVHOlBylXbQ+ZwJEDm3n6HODs7gOpTLGdw2KiiE2iip2mikDcgTyqU5EUXSckqE2qtmaATYFecq+T7X6msm4FOSsgFuY2BPv3eBkDAVexkcQe1EK5hoKhczV1ls52grTT0tj+SgLN9KkYptG7ryNYXJQit9K4q9PnJ+FQ6xIDXReLBlfCHb42fEZuX5CQHdtZSAYzrIr7DhfSOexnx0wC1GeLmIn69HTEXEHMyLUQD2Y0jmFI56IQrpByt8+n2ef7Xwf8Hqef6q5uQDqhUc8zyXQfIZcKoUrxoGt6Hc4bIu5btX9QAkj8VXjvqCxnKklSNNVWUbYhAAjVOT5nL+T6HaKxc35Gi9x7Uii8JU+9UVlhFf92A6+1mUgKf7fkrA0z2dEvDhUjx/2pBKUb6w0l8A96H5L5H8kF/KrPHIq5zAFYG0Jsj+Rj/Y5V+dA6qN8/yz+AEBKD8SrMzn+RchqMeTeyT4JQTPleC9CO5GEHfWsedA8AHE7pTgAcSSBL+G2GUJ3o9gV4KvQ4Y5CR5EsIUghNvGksMq1QVNsy9qU7U/SESsnr5qAyfENsoY5bMTRjaLgn8dTkZBh2uTUXEYBeMKCkYWBT1FQQyzomDkUJCRDyijg7SKTA7rPIomYx3EgdiROEQLhdqUiBYYRAvJU0SLFNECIFpgNiLjiBboVwELmI6LaJ4iWojyT4BoAQVVRPOkNV4V0YJvQ0QLKoj2pUcZ0d5+8p4VwiHPCt4mnhWCUc8K2NXcN+xZ4fU3VD0rlMfREbaa/0a+FX7yhuP5VvgppD5MHwSHbhj1QRBWfRCEJ+mD4OpH6oPAG9YuCK12wc93Gr6c6IdyjOhdF/CfNU9SG9pZqzTl6SpN2adve/VtD7D0Vpbd4HlBsEt20buwicY+jcFc3YZnOOK9IMCa91HMSuDETbo31V1g7MTLeq0mvmDzj1Ld0VJRx2NnkYitGj37ll1ikwIUC3pYR+nprYOidUFAKJfSQZGawqlJ8aBoiiymqxFHiqZWucfU+LO6TyfzDVLx0ILb1F5b029TaiCmSU3E0IQSWlpCrCXYplFqS2hpCTHFk0sAj8hdTqyQyB863lT5AqS7Xpry2E2NCV9gEFDsAQrA+l1hzxKaEoxEY3I0rw64oY0AMmXkH+E2xtnPoQmKgz5la9WYmjYScn6l8bcC2Pp9Sq2xT1ubfdrJ6yTShClZcKakxcW0aTPo0TMx0D5aXUdnXwxco+xI0RoCRUwtLHUC3iMY8bUBtdarCiEtRLfWGBPKD5+jeJceLtKy85ylaAICEaXD3WiuacxkCKQVCESjEGgeBwLoaZ5Iv/PpVEacYdIATBo0TQIDe4kONhw5FlYdi/Bp0u14kM/wmMocEGzK8qYKTGI8uuPT0r1++DrYFGoBmik1qXWkmB1QDCJ6pJgbrN1Ks8QRc8ThorUOPB9QypNJql2jmSMMYh6Iw1ZXBdf8hoHbpEg6q+obkIAOp8clC/9svEov2hTQHFcgvVjD0MAibpsbE6MAHpvRkYnHRmaXBe+wdkyjT4BqiJdRwHcAeGgcjMP8IgV8opLZTn+PmCFK+JOIp9GUqgsGxIHEIYE0tDXW0M1ngsjUdGyntUJuR8T476HkrhR/JG/hmREqPZKnNJ831D0+FPzABui05m5fvSK0iRGZZwLVdeLw87kS38ZYHyniW0pNBSHCERRpkD53pGgPGORN7VWGYngCMRKMDPDwALaoDRTRvCcY7ACTjVFqzZGeOUolAhNwlAA1j0OAAC0dyovyaR1mhoswMqGOZ8Qci155RNo8dUheRRaoLI4W+JdYBiXoUhSfft6sXYGwHpKAGSicRMhNAO0GX6Pl3KwLgKxjLvYWjeUl17Jmv+8HULUrF+O1htPpET2Qm9EP6JGJVuKt2a0oQqPU9eTYiqA5NSO0raGypryEpoL247hUVdr4LU8kJW8wcjcFk+rlZAyUlvhaI7ZoeVQalNbFzCf+u7JXtHRZF1BQyhHpVVrpzfEKNWXFaROmB7WxsjLuYKveFMNxKDlilC0ic8bWRM/t9l31DLQkOLiGMOGgMIc42YN21bdEhbJ/s9YRcKCqQvnWzVUo/1VVOd94gna84dFvR8btyEbaRNU23XaCNv32cJsCjVZ+Uiph/CittPvZ65Fa+Pt2y9maEg60FoK3n/3Uqfem50x/aE2ICxww5BEeBB5WOxSg/jk8+ol2CKoAjE19Txh4f2+wV6BKYfaLwsLXmNqGwDrNBwLB58I5JnjZCQrTT3gh1PLwJ0BSp7wyKbBH1nePPIjkQ/KUPUZqEQPTKQT53vf+D376z/7i2v/5pCshrKKY8V8VssSHrzuRxYM3KKhGW4a6pFBddJXtiaheKREZlJPWNlGU11VnC99rz9yJr0DnoaonPrTcPxVHHu8+wiqxOxqUxA5gZiFHAJQplwmsAn75xqxb5OwcRhXllMNFvFZIZ2UbcQQLCkiff4uSpDoADD5XCqT62uBwkazldYPfyZEiofgqWdxBbfcwVWp5gNadNQ5SqMfPIQQx+Luyd0GwlzGogSGp87tyOtKAJkfEYPSRqSZsHOejEPvzDfQOxfdvBGFxe5pU9zQtM6xJ0b41n5IrBqmMLEpCWLl0IkzYiKFB7SNgjkKaoohDXbT0VmTPTBZuUanDnJfBo06UIxPC0y0UQ/eNZx555RtvjJUXaCiFp2i9iNAndDyPARiTAgBS+dEHBQx1zS6Q4uwJstdH2IA8SRWTvfKOLuDPadYy6oGg8HQ4dJetaxa2eBg2jPFaniCZjN6LaVCEonTMUZ5Cmxqy9nSqw5dArc0NkBvIkU8izTpxTLULKlvebIQpRaaUWiYTo/y/qVDmF779hDJvOq5Q5rAKZd578sCKqsA6WtsEWOEIsC7GEfwwrI5MhpWGdSEE3GgS3ML9DDrRSo6F9AByFbiFx4MbgKqwAfhaCr5EH6E+ALfBceG2/giEWWvf1sKsh9mpN491Kqp2KjrJTl3xiDoFhBzuVGQ79aM+lkco/lj5mIrG9QRNl4VIGoEY3glb/ufJVno2oBAbr1ukyZzdMUhXiiXph+JgNxiiOP4mk8gfpTg4ULp/eBa9ZWgWcdtBQlUo8G9Db24/7ryB1eeHO28OjKFYUEWx4CRR7MUnhWK/dvKDCcPMZjSPfOTl0YTB1DwB9PrcgK5xXuxV1z7iu+F839Bw2h1SpHukTQa0f++1zxN7Sd/agf2N4w7s+5Ugft9m5sVRFHoow/m1j/PkBalbwbixr0t8rC2tWA1HzrmV9IN+EGIvYE2eY4TLaXRZu1YemJFOLBwL8x+rSMna4AsnRQGO5iHkrJyKxzgNj1UOhY+eAcghsB9nb6JJq1+DV9Qv9a4pF/BiPcinmiwbHQQCg5H6mv2yFcZX5rhrPh9HYn6jOv4r53di53f2K/hce5ZIwUXoGjTWlRANCqsNyu7QEfly2JBt1HWhHkvgb3yHOKrBFwKqitPeixSQtY2i7rQtcq7fKenljfKNWIuyjv/zJs9gJwzOWwLFVqmkujagxnrRdiJkvUyUT1FbtQHzdvYuhSHYTki+mus0hf/WWIY1dQtNlfuxAVhLx4q3oVo+l3d0/wkl164+MgoMK9aSUFfm1JQhmNmvojp+DVgEWLTx6FLbbZemjhTZ4Ah6N1XWxZGsa7dezHBX1rjtqmEBi1XtsQam7qsZXNIbDNYpo2wNXZter2zE0IGHkBk72lSV22jKDRHQw4OhdSjPInl2pdoXJPs0u0JtDXVMqOXKzluUAglSIyJylrlQMCuYwgEj4Fqr7t/Td3he6KiAu9iqwjOo2GbvBqT7usWJodKXYEo3mOrvlgWbw31x1NCQ/OI4PiOJO4saExeOZWro3TEPJSYQ1mbvkWo87M2ZaF1YC/nRQLGxc03w2Oo+G10z64dX3sMePvZJx50Z2LmGTwFoH58elm54VaVvLAjAuDEG5nQpsc9tWPuZlx/UrT5qPbv2Zn4HzLMNVJGmn/cC0MLo2ooWro4oy6sDJeihcdQhWzY3AZ18OK+72ESmZaQ4oCSlggAN3TKWk9RsQmNKBvyQ4/K1Ci4OjmBOx2tmY0rBWAZ8KrlAQPKYM0EvCicyHOFh8njiB+O/s+6GuAXJA2UIhMSDE1MZjnTUD5DkkzjeyAoRpHnQhpA9gtwuQCpERVpUWYy6GSzHBjfZrX672R1wXscmoDxfccNHbiO3zn5NibTqw3sytD/pewG3XPx9FP6FtRZaqI4/ZFU/u9Zqe8aYV6DSbt3S8AxDVmmgrOHIiT2mx4VAaMgFIhRKRMvXRStQjXZuy3vRFi0QP+BJ7bf9mjyyXzd38Ll8T8v3Nis/dW5JAEZXGSRnAUo6QWXanjT9LxjIWtU9ijpc8Y2oETAz6zqSEkU48k1VvgyPjLg6MNEBS/AJJ7jiMXtRB8bn0Sker6ue9zLFP5TH87HLs/0LmNlPOXrjk66Dr5fTg+T/1/ZQ5lMedy0O/NCW6VcijxAY+RCw6aZSAO7A8Hv2+usN7mQ/qUQg/W8Phyv+wBhXDFbQscV4G+GL+5P44gIfXs088MrD34CB/R3af6F2peeaJTBnS9nv6sQxZyl3Kqr8lRf4uJDt1o7h+9dzMrHzSOlxpo5/QsTXJAVxnl7U9pBDqlKxJdhm/NTAIiJl0k3umAF9FmfGc1kruUghkalu1VxRt+7E0Q69cZsIv+nr9Shzy9bDrSuP6kYsVb38caHnD4t1fYWxn/0BPtUETZURcnBPDz7KBw56gXhJjhM4Q+6Vxwy/7Y4ZVEA4evQR+ODJx245oQLnmSjUzkTClsfMXTsOPmKXPcK+K8cdC8ftHYfj9sDgeo7BBWkvOWsfiiaT2Omo3C7HVBvZLj/Ueq2cSFXf5Ec3YOF+caAV6jjGRgVUh4KrhXeh5HyTP9cFp7rZCqVUPEJ9uF00xkOd6aKYcnsBWju+p37bo4oduhbam1+YaBrhfHBpDs/kAP64Y6o/OsEx1euxu7ZGFbB2k29vknPjzNxFy5C4Bz/n7sdldqvV+jvuRllo/G2pwgZyql9hChXtwFLU1eBvEYCll0y7cA9NblJjrOt65yMuGpxbvEfVbXM8CnNwkL7aw5XP8RPo1UtnEtecAzXIB8csR0BApQnVD9UszM6HQr/lrmKRI3uG3nkqThDbB4G59l8nTS4SXJPD6USszpixF8NnTbNv8mT4sdjVUUyKQUIIOim6Ye5josAkMDZFiZTRVgZrShXgpaRO9cpXhlIS6mA8UH+BrUmeYawzufcJBSzRmWhiWEzO3CfskAxoI2rCjoLeFlPQRPjxS9AGgGlgnUW77bpV5mgrfZVRiyqNg1klSpVUN6V509g70TQfmWTUxCkdp9tTOuwrgvJ24R0XDaQDLAH8+BOve86b1ti9176f/8TTnvYPU//tIu5VZqi+3t2LYPvNe4HS/ndiYHB+wX8Ap6/jp+qyqlVeRNLdWLpbZCqs04d20nQ5ZrIDooQu+waVMM9Cp4Eauul0x8kLq1qlrOpTb/vk2yacdSDPmKzqk8jLbePHJ2tOWvUxTENuNP+HT2NFzX5rU0nVC5/Xb32r5VQfP66c6vd0p/b0KjdSNXsVlKfNwEqZ6w4T9YhZjo/dDsLtBxWkYIC0lopzu9+f7NwO0ACH+lThYlF/WK0/tGs0SBoobIhPyhZQJHGoBqvHJlyZa5Vjy1qWK/tBzx+X17kV3Hqx5v4z7gYj/v2CYd+CTnL3MAW8vz/GyraqnGxrjJHdXTKyYfaH+PhEfOtxu5ucfHeBeNXufuHfcgIacbGumoGuqQFkIIhASFdsDYVmrphJGutXeNi3cNJhm5m539ojt5OauedtJq5x3PIkmc01LJLqZ3qaXfgMXN3dQkkNpQHaQf+x/NrfnTOfpSp/GJJnKkrojv5SIerIzCnGXgHfGMo9fgSrOVoRaLSf3h6EidFhGefK0CwnGJo8UYB8DK5Mrf0Hyln9T+Ws+r5wcE+5Ef6Oz0ceNYeKu/JyZSmSRuMTilYAK5BMVZy8WmmbovZnUJ6iXouvWBVI17tdEWplCgOct6xWXREampoyAgpP4Tf4Y9EPYDwGV4/FOm+QtyFiYCxo/qV5inrBJOUxeAOF7PAF/OZ60VLxryy12mm1fuJTKzs0McUj6M5VGQRz8SrSwYg4sd4Pnaq340WxJXuN56k8DQs/T1cnkh6AZ9u34ylvaB257XefOLjKKkvaLMc4yyAPKwafKBBW0asaviqiAZhKYBxmzfqg8AH+taJatDY7/Z0o9sWCBLfIsYQHwpIn9PdCLHj7z9wgYkHG19shIcz+l8ydPgQNmpgqn3JAqiJvlUIYGFAeRSiwb3ZnmK6X9tqs8HXV//jsdQ/+4pNECUUNysmx2n5cLhfZHG4e5Y1KxtFjgyZuJ244+FF944h9+/Da0GmA4qi0CihKFUmmKEuPmwlYu3gwaiZgTa4LSEc21hEeHFEbFxjJbH1cnA0uC6eusn4q6LQJfU9XW3WtagU+AUhRA3xZCFtmeYb+UUeZAmu7JSJ+RFXbXfwfOnvbj9cOXnTP+S/L2+5ooiX7iLTSrBE9+mnTHT5RcC2naUqPUDVmoP3Mp6Wn+UxZ4MVHs18SvJ52+TM2MKcZ9GRgvZimNvEf88PtMuFrXLsN/6e9V6pCd4JZHNMUbmXAIIaYMhzBHUsID4R2TsXpa32VcwSVE7vQndgZnjhUMYCKBiLlCD1ztc3xYz7iVrAO6aAgk2bBi6cnbpqPmUxbSqBZ8BKMHcoFmxzKhZAiwBYk/5VShHDsUM41jD/RNnE216ZwpXoGB4fN1xraYgY3GCiGgpYM0NgqzUHckewv8O3g+EY/0KCHYrB1+OgiBFP4+VFW9a83YVV99cP8QT8KzLKmDWNzG2M2Qg40ht/vbfQhThaJPbunxoVaRwpkN8CxWFR8Hqv+RnPFmLFYA3eLOEaTtXSFsIu6u4HUcn9YBEBUn62AOIMsumiNECfzuoeNVMSgblQagekzP0D13kYeUj0P7OIJooTLn7uv3jB0h8KKxRKjT2v3p0WkdkiqTfGxKOmMkRZhAG7zQ0jOQNtRkbW+UgOPhSdACaIr5jwTB6QGjnyZ4COpSV7ujx+utkBYVsodNMidT3U0JUUDU22g+4hat4AhY56mjdmngp+I65AVLKYmfyMakiiZ3/oHBPJ63RwGiLkhPm6M+zg6V0OobRwFJ1DpZWwVQEiRVUZCDzfkmMxo1pCvM6eR3vgoSzgtD9wPq9Kpu48vnfpXasVnT9CK3xyfaAe88Zm2d/j94FMqM+3AyybMNI4tZ9r9v1WbNNUO/E5N59qB36xNnGwH/Mpko80n26GLBw9tsn2zds3YbMPCPzbbdAnXtozPNjKz7V0626qclF86i4epOS4Ncd/CWYeGjs66uJx1sSJJbGddNGHWHa1tNu3iydMOEJEyYRWPNpt2kZ12gKVduBvpuz3PBzPMQjNv30tgnvYnbtRj31ppjGi9DF9UCV+2t8qfTAyWdrvWeTX2DuceKhq+p+plb0dLMKTZT1rtofUjVJNPdAPAEeQplnDCresPRfXOH1K9CzdRvfNGVe+gLfLAsOrdX7rNt9tuR5jm/0aqd3913P3zPbrQfwdUJwmqhynE+tyYEMuvain6J6mleO0j1e4NhyV+virCPqxPXhqEdhHaAAlGn/s/Zgi3uiuMsdd0M1kU7hjOol0CdKkP1IdgUZcjE0i3ayBYRosuEFYBtF3M1OjNwr6K959RFdWqlbtNRbVwCwGs2kxW+2iXZnWHuDw1E6MaazzOKP1vtXQjjMCXJ/riyxO++OVetHRd8JIhSdLd2OhU5QEbTh4gm4R34F2lAZokO4j3IJjqF3eOfPEB98Wd7ouPyheG3cFirR/fNfLxx9zHd7mPPyEfg4WWC5EoQwRIhImaILSMUAOhLkJNhOYQkiozhFqC9Qi1EdrJITzP4qccKU2B7SqVdDrPLzLqrO6H8cNpVLlczDw/n5UhRvocTe/P5/G6S32fBrlvjDzhbGqBIpp+AZxv0szz+TGzul+srfD77H6qrxaLkIeAXixSh+ZB8vIO+UAR3/K5cvvZjGoNx5FdPCjfIp3Ll/oCLLQtpM5K9nfGnH4G8ySzqyuUokYxX+erStgx5C86CMqnRQT+rUMRKLQxCLUEsPirQtzQmojT3UFkSm2aWcl7fUELyYzZ/feoGsVKdN4WmobEYrYPWuAqX3aV11GrOzOEUX+0d5Ef166IWKdmLv2Bs1KGlVr4u7SHjGonty6WlCldkSNG3LCf4u7PgDyagS1gPyuDqSmxtLVNisRNeOWTEB3KxUZ8QDP4BFbyiu20rWIaOOpnzobwdto6lESAEwav8M0F9hmAbIYWLNDSao1oAMFMV+V+Sqdyx2dRiyMUd8CT8tRPK81eajx3GT8WqYPswqaQBRzRBGN1bIrBxY8Za40epgpFwcQRXVJr84sGitUjUaJ67pMiOukx6wz5BtTKt5LD42TEVtgU8F8nAoF+q8VexXSrITprNUR5imFwm9SgTL9JaNo6x5rvh/hj7repRudrSh7aMldlLs71VSlxCxAR5+fkPz9vKF7OCBVhcKjNpXxaydG9I+ToM44c3evI0T0Ipg7fff34/pGPv+Q+vt99/DX5WC+nLeiHB28a/vAB96EmyYc3Ipj2pUmgLqtm2kk10mtaMHH+Xu3eIpYnUBomXD6P0xwfvIj9EbRdCoKBBDHnMQOmbJ4DBsIRpThkV6ogOxKj5lsdWFrEnJhRsV2KyNQYCaFFGcX+AyWJUvoEdJNXtdCg8uEIzUFOnSA+JqV0AFR4BlSYW0UzuPo6TCKlpKIj9eu4R3qj+DYPT4owuh3pEF9T91A5x4GSoUYBXN5zsFjGVDAEK59G/AHAvMjK9hWzI1MLA/nSFdm/BRMUwbaL0cKA8NxtnmSeMKowjT8lZ/NceUazwPhlmldytijkbJYWT0zO+HGbx5ARJzyOrGFm8ueTaZpmyobIWUYdbCFncFEE5WGUKObyZzBFdb5ajYcetxMyTi6ElIxJODNkbEGbS21H2iSsJG8aFG2aFi5Vx5swl4rjppYD+7QD+9Qw2IG1XHvLULSUloWiVWCwCB83hrpN09Q4dfPH6NpU7tP8w6RrTLUqRA0AjCoAXKQFnoARANgCAFvSa9Bxh4bzDg1bSpP7HRx/CT566I0DTM8BZnoEMMuCjzgfQ5vwp9g1JWX2aJohMQlP860ASoumYGd3Oo8gZoE3iMl5ufSt5AtGbaNFiixqzmB0FZUYQRnZCDE1E7PdchRq87oCPxAeYMpWg0XbBVtmgSGzJYaAbk2EwcwIDGYZBv+DHdQ/nDkJZMGfYzF6NIM52cISvmg4vABsHXVGZ+Vu9WYQEF5IPRroS6ZeDfSlJg4BCMc+Zl7m2434KtBjVgjuldGAPNtDFF5H2ZHIeipQLSZdOQHM1E7LvQzI3aTh3Rwm2my6TmFbMlUiplgvBuo6iKebT0eAep4WzXScFVxLJ826lszT4VkXMb51SEk/ka8zLxqeeZtjzmyVkUDzlXfAYqDyqRzG+nRNExRyU27aLH11LH3cXOQB9oN91w9mMd7cxBkzPIs6ZBTiWg/RrPNwVhC/67VzszT5q3kHJARsoJqwsUuj4aTn0Jc5s3elpmTB/rW0Bvg3/tDtF3+SZmxgDsR0QIY0Y0M9hLpM44TJN0c6gTvSEVmo04JV6YyP3TjEMZyIDKU4JizFMRHVnDhGNmTB5rWEWgvaNKzzymIfb78c9ssXEfJVdF7lkn5V5xWTJhInWGoXPxQVe32E8kCakcmozqveonTiE8imJ0hoPgth1knCWo8ai3gc2vZQUvWBTwLaqnOMYXKwHj0rREF1dw8owRQKK5XEKo+tUSyVVOGLzb3CN1D4Dh1mxmiKgahTMob5NhWIeeUj1EeNfJWF+dl9Y2rFeo92DMTu7PK8k75EW/FbWUtfuxQvQpcf9zb515lhHZZb3DzCQ78O78pD3+x46JsQTI3mw8gXt7kvbndfvBlBK7cwIpKRD9/hPtQkFZGUH4bCalhZA4Cs0oe8XooPklI20SglF00VdBjGtlXKMdql5GOqlHd0ShlIJoBEaLoqOpiRj1R+Mcc7I7S5ypdTk9rk0/Tzi/lVSjk0zyz3/mKBWs8vaquqrzENSkoL2IEbaQb3IEZKrPKFO2Sd8GVjJMGang/VQJ1kR6/Kz3NOxlADXecCh2QMDZoWc/+wSDvdx0jqN1bOkDdRhcTnKWaopBbdPjy/uIZscQ2JhT7WxJkDFqyEuuKudRMWYYnX2AOYjghcbZ5XmOfllAJa+NPJWVsRk4hb1OPZIvF7HZwsCkcnqFVlFGqGUUAiwmTYkJphE8iEa4YdaZVMwpKKRNQsGdUcl7CkfEOtyiQ4187CJDjWMzEwxtrPnRQGQV+u5jCZ8BXCIGj4cjAIVtm5axmErnEW6eDddPBujMAbgE6pbqAld6ewrx9iEHqgJgK9uBKJPlMj96kNgIKDJcsYUDzCoPcMg45KBavAJrSMFWOszVbrpGtEDNikiCsrnXmzogXPH8mUe36+rHilEkduOFJqz8+7D11W8DAEBMtidO1hCwhq1J0gIGiOCAimQW+n7Xll2+1B1G9GW2n7HAe6OuFrlJZjUauIBeoK9kQn8zQQLR4SC7QB+TZNn4xYoKVigdqoWAC9kmYzUZoGEeJW0XRVLFBDLVpw0aqIBbDyNvSuNhNYjGNL+lPe4zNCgbzr2MPIQWMG6IqNmFjqwfx2bPGstnIi1tMyNmOL5qMtD4/aLFIXf0JrxE0r728EaWlOWdpYJleD4lEyAylBTaUESjRESNbSHbKOYM1JCeJSSrA0JCXQTBktDUkJWtjkTqs6u48xozqXPg1Co+fF9k5FRHMYEkdUahWiArIiraUtpZBAwyok6GIL2KWmFRI0VUgw58Df3hz8XZGDzBmikzLA+DHtIBAbY6iK6ePESGUE1UghRF0lRHqFZ3pzEpSMkCClfytCiPScvubAF1MT7ABntC6Bm6WIIK+ICeYcUi4qFVUxQdOICaqYucWBpjsCmkgxsy2C4Tr+yg0vVjIhkJMwVcUEi9gLx9Q1lDnKWxPzDosJhO1R3JweEhMwttF0RUywZJkC3exVQThHKXBlq8GjJcEX1cctcWRi/6dH+l+nZYgIug9vRnYpxZ+CrC0Am9alv81wKZf+mKYfydLfeNSXfr1FCnLOadX1v1ZZ/zebqqqEYtGSA7r+xxOnYjphKs5RbKZi3Uy5dJP1f7oSSWlew5QDpsm083Xa1Yan3eY4U9cJp0TJbrOdeKBDGc3LWuC2/ZhzDTfn2uqzlxKVEzQkTwySQU39AIsnWjitwwSWz8kJetwEbaoIYLdTT+UEulZBTtACGYEwNNHWqU1pKycIKg4C3hbyCXrAzsYm3/CDYgRBF0ltbIaITOAwPKHEKM+sdD9CHprVoMZgHRZ8k3VVg3cGg11QbDYmuPkcStQVf/W0/mjgOX1q7Pv4x/DvvovFYzVUlS7jkdr35ef+1cFfu/+eJ18FgUEs9vFaG+uHcdJDqbi0bm+s31aaO8RVP7mYhkGcQkinUyRi8Eh8eovONFot3tVj4hBxILHaXFlFR+qKPsahXyNt0Au56gcCaj8f9lwwok5VVh1gFs1hDSLfqC3dZK1VdJ4BGZRaulAbJGJvPvuG5amgmcuIItZPmTjKMAsWAIQc4UCckH8Vo0HGJIuiNhdU6kQNisTVq3wqqgaVt9fcv4n6MF1MBHWyAzcCP7hZ9PDER7i+eTyBRvRQBBrHF2k48dFbJoiPgn9z8VH1ynR0PNmGuzL9D14o4omXGfVAUN7K1BQeLJJnBqWn0wPK68PqliDCxhNn/Xwhw7EhwRE/ra5JP5GLMtwfLuJ82Dq1iwfMi9rFQy7MQrSgJE6kN/AjaFIJaNKFKd1PvkK1RIC3bywSsDS7QRgoAYnabQ0+B6CmgTWMWXP3Xb7kBWoSykplglInUrGM2yCaeF8vDYSfXSPZyCgRiplayJ5MbxdTfT8MeP7CVewyEYKoy3rIloxkq41nWwXuyXUhkIFyWoTZPwuGedm/4ImPP+EBvTxo/b1cJ9HoJw8ga/YgfpF2qDQE+qnAh5t/q/8ZOb+OdZi9uZubP4GXSBji94bkqYl/tTZD9f4uaDVsAMH55U5/BdVDni5J2cb10mwKsutvlIZn70MM1Tn5vlC80yB4d8ik8gW42VWXi3D84Or8rk0EkqM8mYch1GUx616OIosASwX3WKRF348bGZgUD0BHDu17IFzJbkBGxPdf569ImsYfvd7GHxiKf4PEY4cKxGVo1LjnyqORBxu9wG+0R+9BSuxFkyJ3u8iPlJE7J0V2J33emhBZxmgj6zx+j+iK6V//a2rn/XcgHtT8PeQsr5Y5U70+vsG+dsMY3vbXwCLe9qNtvcA0MX84nv9HclC99E89f/i2YewcmPaPgcZa4QswkUNoUv2BAF3uUgz0+4WrhGYvaz6YptB8mc3XGsrH+MIFr4Dpuu0r1x/k4mGiIAa63ggs1JvJ93pqiOVufqKw7gXBXRzEqZqP4fqSfcn45QGP4urlvF+PI2gfwixMUBUje5pDxoZr0Js1xzxMkGVMj2x1Y9/v/sbG6+P7zuML/I+Xf3968ZqxTLIx6DOA1z7FbV6vOEgmF7yqV8Yf2ksueGXvAb8IQHQu6cklytr39AofnSytK/ug3tjZGcNQ4WVmPMvRxACL5YwXkzfZEE3wXPIIz2eRJ/5Ta9krlKaAHF6NGp8OnJOp9P0a+0Ly1bzN5foNp6khP/Lg00oBhIbc5WWvFGpSV8xFgrV6BFqL0lvOiJIPpNMrRPj6bi9PtJTccUZqpeL7y/fsVahAjVAg5XKsRO6eZIRZydFPV90q9fW85o4Ky7WLIneHrer8V+1DU017KuqZWAD33XoL/v0Z84ZNitYH2UFphq9IInqctwFtxPGbh6X7Rjz5/QCennoZO6iLiifO9l+DEtQy11l6uyzQRSjVyKxQMGmk9Ko1GoVZkKHFlrShqntqKxNi7xqLrbc903zf2AhItclyC1ZzvvZGraiy6fiC5+P8pTL5dbLKEi40OHsdvlrCpDw92H1+cLOPoO5wg4P6olzK/Z55qWFZtC9YI2/39XNePNZ8ie3msU77uzkJxsA+Y0y63OWL9fn/9pzP33bLLdd8aI3NSX7g1Xf9/K/+yW0XkQuCvT7mK8G4E09Mgg2/Qi7u8Svk4mv8kh6OQizxYZX4VTXbz64d9cXsltFevcXJZSfMPp+L/ahkqRHC75GwKrdKUJVbEUz7kugmp2jzIQrXhLJygnY15ZhkDnSSzoF06ei9Hh8DUCmsgd3o/LwzDIug3Fbse+CtX/6TZ/zoFRdT2EPimwUf1vzVItoYI3HxEImrOxJXr5K4uiNx9WESB/Y9ZBLHT5A4DKclcPeDwMUnInAMdu4RwFyOARg93Ge5rO0Js3/IzwN3A+TA/7M3+6kbrcW07JAE1YhfIDE/jRj9FLOgOrLV2iiUAkD9YtWxJk8PQI2Zh9CSOt1TGJFy6CgKmCJdvjCbu0Bd58oTy4ds+HV88sBNxkCH82fMZHSbul+tp3qXS+8iyQ1vfnovs25popIDp0i3/zE4NL3FcL88YYi1voFt/cGI3/l5AE9PtqmHIpUkiEuqJsKhqlFHll/FzUkfNBK7eKaNhlltwUZWyKTmIOpuGYbVr/qFoIA9GTUNZf0C3+hqs6ThOfLv8/w2RREYzbyDseVnRvEGi1SCfIYjPsFVxs7VquiYCME39VII9Qo5wuGINX8l+2k0pGgof4sOwPfQHEU4CLgtopQ43L8t4hFCRqjgSrzGgcVFXKZxmk/jeCr4b8TjqE/JkVuKJsIbGp6neWpe2VsTV3PVW9dXyp6DmiIeUVM/xZzeJ6ls6QW9wA6iyNv9Yh7PpFiAS6+Amq5Adb0E3k2EyipZAz+V7ofit9y1b9Cc6H/za/hC3iYwXE3NohmbilRrBkXM6uV0QVFKV2jGuESgzkouBwsrKAwL6Ryjq2Pw0TgINvAd51Dog0bNAsZiVG85X0S8WNdbhiajGqsQmNUK2OBtYqsJyS2H27QwoPl1oMIMqoPOIeq77YvXH73zVV9/4ze44k2MXAQJjhpmUW2kyx1wA5uO0aiLxmJ2m5iPlDE7x2K6Y1+1RmPkVbEEKFjuL17jh5in+Bu3Rxg+5dZ3f/5jt7z7819jIUDCrx+/Rd4hE8CuIwKau92petPPfuagWZDUKaGvF97EsIacYapdLujGD11BBGOj/FFD7D0jo/pbM9nO3Ssl1cTFI9iSmLFslCSzhYlS2va0tt/yhiwTdtJ+ZkxS+tknbzSuUK1pymNxFJT+LQ00djuS5akWirpjZjrVB//rs5ywrpirFBfKb8qowr5WkVSuBVrf9QNlTurOhISbjmjP4AibQTaU6H2cO6RwdaNgk7OJWRsvv5hckH1kJSBlkIu4uSoejJT7Jrwt502dCil5aio6olQvizVL03wtYZhyfqhp6DYjuxsjv7R0VomjNA/1hhQuPvG78Q6kDk0sGCACxaODR5Zn1FJ6+VU0VsTcjcFgBAbGXMrpewc0tQ5fim6bSH5FBoxKsWxATV56WoTS0wItpXH4swEI+KcbrPNEnt6AVXG1EAdFOvQF3uo4jq3EtDaYbgoYKESLV/fbCJjkKI2jkAte1UPq4cE6P3ziP9APVU9g+M+YK1/mgF9XQFnGcRpTF7UVmhbhfF2oZFNop0rwQRH1ZivIopLDJpNTNA0flpSxSXVUZo5VtA5dyZWAK23sFm0R+6KZlY0hxj05wu0XgypDNN3nWYf8GB3bMaw+kOScxc+zDCfPwd2WuhwL/Q7beHH3/90186dcz8+rz+ddHQ5GPlFj33igG3lgkrLz/Usk6U5NUm6RiZ86sPj+7E9eLbwLV1bELkaFIniVbZ8TyMoQqyqT9VGHl0vkkLdIGetBgOyhSbvvMXoEeUf9AvUzLODXFFkPFA52RVTZsujgdYY8AHSWTyzmbhGYHbjxnD4vgAE4Gsp6XD2Wrrk3FfMPxEw6sbYNedxr0cwtNH0LzQ4sJdhgA30t499e5XOzvOTRHM0f4VwcCXVRsdeStTHoGO2mPUSrZT8HgImRBkf5EqV8eUY+g5F8nur9n3s1Lkl+DZSw/9MI9+/Gr/S2l71RKSWESnPZX94oLwxv/R7R2Vc1ktctSen/5WtQnvmuBIV+q2NpMuuXOvKa0P/zA+7bzODEZ81bZmn0/zCmsIzQhXQL1bXbMz8shS9ZZf90bmVjtZNq0g4PwCkxHDB+FuwgDbL/iZbpBXPyst9Q67G19P/xvIk+5zwIkgKcmLFhaRGWWLv7y5CFSqinUiSIOgG1O18rnzrO+frACybZAzb81003OqtvzhVEJOcK5e777FoE8QQ2cBGYNDVhb69eDqdLKlDlIVWB9a6zItl/Ftn1uqgPdMOrygQiuV1qdiSBXlxGWSuiYyi/e5xbzF0SPHdF3Byh1VqIGvvuM+h3X4oWlI4yI9V5itA4dREHmmbkRbBNBDj73ORb1NihimCQPY/4aY8tPezYoypnkP5koNZJx9x66OklUMMQUz09zd6kAuV+S3tT7prIuOjIPmCBkugxEFJhIKytJVIkyrMrJVHCA+qDntyQaOQBNeGEA/ac1HaJDCfovbKnIR4d2BpVYhzYhEATOEkT1KyjtfXbwqNFbfCwbaN/hlYMO0HQjXmXcdvUrFvNFgbWrJO+jmKgplGnsJxIVMtGdVC5GF3nKrWd6mvVtQjLoYDI2JNz43G3H+gWksTev/HZPFCz/62NPCqN1ORBCV2zMtZyxyDAKptYPA6s+C2w4jc1Wys3s8vCOJnRwh2+uoQCx6n8d2UPuLBG0aAqtcOoW9r9vXvXBoIMG+trZVlHpSy32aTIZt8LmZ8EfmXv2pVs3gLTZmCI5/f2EfOCos6/woFxe2lyPyf2Ua3FVfq496f2Gk9ONwHCHuN8hQiSNyi8I6hIBlex1XfgGKqwvzcPLf9flgELWV9lQi4LZXRksJYdFVFPrPkoclAo0yICLhy1n8HGLycqyhqHLz6DDOav9MQguGXff/rq/b+5/fm/6GFPgFR2WTjI3mqNahC/3CxGNPxbBxSsc4/t6YQ3tPJy3ls150Ch8k3PWc885g+dLqhOcKKif2MHR0WMGzLVQzmwcrhKUfY+JBQ6VDCDwpNEFFEPsUk2KChzGfUV1jM/z/8Yzx2choljQq3kY/5K9htOQlOz+4Xdey3qrF00GKu1CA/v+9qDn3jxF079HJs6i6rIXIjt7St7JubOi2BuZTfF3FF3FDFTq5w3fkSEPC/z/IlLn+qFh7yF1zVQNcbnsMvmoMqvdEGc06uPSemPJitXSPhi2L7Sj15Envqn+dCNQ6vjo7ryvn+07Guqh0lHPVe8Wqv/PRxCWxrqth17SyRWbkGTPXMcEOJjZUAw4BRwwQ6+P+n5gR6YySyDRVhUggN0K/uGvRGsdkPST54gG74RQW740NmHJEkK+AMUkH0MvxRsDMCWV0w3lttnJkYb+vbsj3+8PzBk4F04T/P1AK8qa9R6yl3X/SX9eiIX5DtBWekRaU3WSN+IaL9apiScn8tiubtfsSzmyECJ1QP8k7djMz/WVz0VQ7QOG6GpHgH+qjdJe0QBglMr1R3o19SYw1CvEEGBnvnrm5DMikhXI2VCJZeNDEL/Ixts4DNKlVfRxEM+i89S7aHCbEDes/MhZQwK03vCQKX3FVzzNFW36RvexFMyH8cPnEQI3MwB3NwcPie7wysCc9SjgvibPE14j2fF8Ifw4f01Ffy+zrOSXw+6v9pohZF2A98e8LKPA4pyEJcHyjL9d/JGkPI8/7mAr5Za8bprjt4iPXoL2eWh+Li8ypzsgRToaR6KaJWWmyisnMJ5oIc17TF4zWFu/cXm1CvU1b+lq39smVUVW8f83S/oUdhOPaBaVkH2HD/M4YU6LiYJ3VvDOYYE/x7BljvDgqAAxZE7LAtxWGYE+VotorLhKG0/mCd8gi4Pn69pe3aht9UTsjcDCGOxN4/HVohLlD4YinORYAKWgeAcF9MCi2nB8TAt3AzTwpPBNJ2jBr/+6BUCRj3qDeF4JFL4xftZlfR5fejMIKJlfU5ET1MUDLklfhEx7pWYF45gnn4SbY5346e/DxHvfIt3bpPk8A4brTc5vPOH8C58iHjnUzSMd/4Y3iFyDPOwnkxCP51qjz76+emH/CCU8x9ZPP8Y45sHANoxPw/l6ameUYKXzKyXsVrqFalw9fg8cS6whj15JZbNTcZZ+WTiSXqSki342EXgbMrjRnXWtb4ONdQyh91QhW4Z1VXV2S9dz35G3Pclypzd5VbKc7iBt77RlKcRLBdMytWQXPAqnEHWiduPs8fk0eR0/uQVI5zOKzyxVWuxNtTdeySmoMyVG9na/7ydProX50eY3axcqH6JnEYAI6+inwhhV5V6d1J5cR7wrYnyJ3MXWU/D+L8L+xt/yFw/iguRIRQPANKOW1Gn6knqRj+APtNez5iJBN9zi3LXhO+t1qjvboSW+k1Vz2X/AfXX9ET29FomPl9eIdRsV00lGoxwP/bOG59S+752DVmWyTdZdkoWv8xyOfaKQfpcgSvgzrDEQ/qNsLLmRVQahQ9VlsDxCAeIMsQHN7uMExrJJr0dbnn63Wh6ZiFHfkUxVGtCARJS+51GLxPYUaFuYfrXwagiwW6HbJN0BVhPDo1R/ziKZIIDKnZD3DJCErdTRxq6ovgMqqN6C0B/lleyNeUMxN+UsTJKcsESoWW5gLof50YUX9bD21yZmIlMokxcBQ02dt30cJ7pUgHKc0TwVU+LswFeRD+ufy4kj+uaKIKn7M14MdKOFmisXEHDDlxnGGBqHWf+os4Csdgj+YtEjjZX0A5K5MBTbcWLYbXDoCHqMAeeTpwTVuCpKjEVXt+7hD/jB3LVCQWuyEZOz8R81dM2VE49B8q6mKZoY39OkQat+yWzEdntthrz/OMmWC37cyEE2ybFYkqqSt/uIee2jkXtYPiYsLxJ13Mnqfl/PX+yN1wGtyxfaN17VdwrS0fpceLXdT0zAjZdsnVmuFvWVZkQhtg19G2h17huDIGd2zRfpHW6rkSMNIJr5taByouS/UVDT0SSIQXeArrzuAEgc8tZTUBqyF0kDnMqJqB47zUebCjm0Cp5+tLAC/QCGte8qB+/iIvI3mK1xQSJjJWsUkIr++WG3ReimaptKQdGlPblfod8idLJZ5PkPZVr8OszhdyIbRePUthXy+vU5LxmwWQ4SOPqKxS9iHHIf5F49Q+uwelJzKLzp3jkvfOVN+IMu+rdqbR8hXqtAQuUqzOyW8Rmo5rlnkx0YKpgLge4RJQXGNWpTL0n9vgBlkMfpLcfl0uftTsROt3fiRNnCS2jDLPF1oWOfx6zkt1up2Mm6qyZYApGQds9NBM++5DuG3gT7xt41fsG3onuG1z3dL1rMOSrrU5h/xvD1wzeeuP4NQPv3/yawdtunHjNwJt0zeDtyFtL13w/vq7U9dldAtlhuxw5qfhYkd4mhjoVokDe5ihSvI8ZV1cRxISFFo1Mp/o17Kq5ir919k0pzhvqQOPrKH7nK59y3StuAL75im++4ps8SL20LPPDV3xDSPFNQopvHinhkmw9fpQY985rn+TVrCVmpQzSB5kcRqTtZguOxf4Pspnyjhu/HW2mvPPGk7eZ8suKjb8Amyn/BrjIGf4VcZE/UU2+h4qKX/AjTFYPf9duAqauIuOc8rK+0nbcPHeXkyESYenvCne2SC43Cl85IuMXGv4lecp11+JK3AnAEJ0YDJNBwOvsRp4678kB9iz8AzPucnFe/JQ4TRt1DRhsuJ0dJ+eqqgJQYXBTa44hr9tTM+7BDdxFOA0SoHAUQJQH5ZXygEJcIhwD9dlVV074EfRTz7uGH6GavU9xIkcYN444wgiP7wjj17xAhnjClcza6diZPIUOvgUmjN9iN+Fn12oq/Q0pgpaQObrwUKWnkTL5uMnkq5Ef9iivolkAVnJkkz5Tt34jX75bv6zeDSTv4V16ec+No5devOqlF+8kL7287GGZpH5YLf61G//tjGgP+0jxxL37jSM+Ut5142QfKSFamRzPxvaII77Q2th+O3xOCDx0r66sox4p+0rfvT7x3khXqkt74na2f51Mrhfx03/hNWal4Z9r/t/cN5arU6maLlW71kUokeJU//8l4znhCmydtuvWSYUJVf9H/ev6xPB60TXIrwcj73kUG4sKfuxk2ot8J26ybS3Zkl2rt+koXPc9QyPg6QicyBD6wyBYDy33Tb7fdFoWx/ySHvXV++NH/RVzlE9SWF12yYlRrG6I5OcoHFlgx4a/y3qiydXAwKhOKBRL1Vansewj8iQP9j1fBK0mzslRahzGKkM0jQkY2TngYwr5wwQsT/ZZYT64JHxWtCnkh+pZtEf0LFBY0eL2oRi7HicvkjUjVK3jsHRrWj1y/UgSqQOUiP8sbNwdXbceHEfFOCM/+1s0Va/BDntbKqLs75CmMru92Aubq7WX8DklwKYn/TFu3RV1qlf0w41FBH/f7ugn7znnm2eeifvmpTx28o0LEd06z2AJ1aGq6zKDQVqXW/5Hik2v9qeuDdRYz256vajMlxfyzQF/3qQ6l1OeOl4JLqQ8p13jeg7fQk29Pq+lPcc1n7u1TvXDA6pjb33EFFnRRG0eWc8TYEKkx5G4cwzkiHBuHpJ/gSjkhOZSaKiwBwMzpDXxQNAXz+k7V3TiZX+PwdBRiDcYSaIqvKOTg3dUhXd9CN51isbgHYmEm+FdueffGIJ3swLvxMI7GYN3A9cyhuEdVeAdAd6NgVYzEd4RwzsCQzUB3g2Gd52nrHgnT9WQIAVOFzq7TyHX//I52Acoqqv1luzLSDK2AnWjsVcEyuCiANHq+SCmwb7RE0NdNjkFjjK1zK+gTLX8cMzdLa8oU9ZUYB1nG5IUQqly7bW8Kkp8disyychr0nuMfqTG3neOfiYIZHKpYqT2TOL7n3qF+0YTrF4k/2f1Iv/er0jhnM660+T40CsmKPg5CDgdwtjpEMbjOoQuXVJBLx9iJYwukCXqBx/GB3oSEXBnjuqrbLhEnG5tlogoD9LhEAJggrUoHVPNHIoQCvqCJGQM2SQuFkkVHqE5qCB/TF8w4MbdqVghXiGRnUP8pGBYXzByssgf8PxJLi76Xh6awyzLSuMlEa/4KYKAjfT9ozeOu8H4NnUoeOyRORSE5+mTdijoDFdcE3rmOpnjwkJHTFS5U3kysfZTSVBXBqjJbM94VRusEf5qODocMJm1ZrBCKzGMTuC35MMTBuyDW+o4cO9eF/LV7aWXxHYO3udUibSFxj7n6372uLcyI9wNV6t5hPCXKuHPOFOeUkqqJd5WKRGk7hDeNZsmCfdwc+WLd4x8sea+kCT94vbKFx8Y+eIO94Uk6Rcb8oVwsTKB+tKUkqbm1ubf2uRoFKpYVY0WHbnohcwJFkmfiP9Y6t0wk7+u1vK1PXmz5RmLRLhRhuABDbbkQAH+F1C6miYNxaVJ8sI864u1ZRQjDctnqIMBm0WM9CCfU2unTT3wnFefKmh8sYj4Li0iKkGFyC8nR/2v3SRBxN6rwZCDn9Gg4Ksa4loREuUcQ2G28/sC8d9lPQsE2BGL1YAQ7K+L7wRIsLaIJft8iRLqUra6IkYpl/lv6ybmw7aJ/a6A8JxsbZ1oe55zJV1Uwp3dQ8t6x9QnZuyk0biCim0gTEuLqa8ElsAodpbSUDrFtMRfym2uHO1zxwoU4LOc5JnleYqWKA9gn8UO4vQHv+wVcAXQspen7LPYiYrMV3u+yz6LU7jy4tQy4bfsszgNCRES9vK1oq9fbJ/FLi6IqyFJu2LpR95z7En2WZzu0n7s6uCc12xZf6J9FmdoWnEmnckhLVoZPvsszrKfU8QhPCTY+ui73vPBN/1d/mT7LM5G7Cf2HPzQF/759ifZZ3GOfi4dfef33XbgmS97w4fss3gMoIyUQ/N/sGXN++cn22ex26b8f//hIwurH/mPH7bP4rE25ek/gH+/eLF9Fo/TFMDo8cQ9qjRYm3ztJ//oP1/4Z597kn0W50pBX7ztzNd8/nP/+UP2WTzBVvHSb7zrB/9q6+8+2T6L82zKJ3/kI9zQMz5sn8X5NuWX7s+mp6evv9g+iz025VJp6G9/2D6LC1yDI+Lx9gwC22dx5oPfy0j+Ka+48MHvK55I2+mJGIlTebD+kMvzTTb7LJ5osj/4fflFFNHjCZ9F/Fmkn1XSTyVFTak6IiAiCdoRKZJRiVJUIhBZdMkpF3ShychBjArkBp7MMNNu8zRDSJUBQ2vykQEjDA+ZwSADejKAJgNWqgAxJ6ISZDurfScBWRUAEeUMAmQ6kzOdqZkq6dtAnkEUuyBTZwZUUbn2xCqokuncVxqd80Y+L0RcvAUUB+ZYtr5Aztax1VYtceywE02fo5H4AhYrn8QFF9TCTQY1oUlPAqU51RgTLLZzT3nsLiIJXETbJOGQSdhGkSZEsNKoiy1t1TbwN5HQtEBWGyHn3AQuelsl+ms2OqKLMHgmGksCorm+U000LWMfuUxb4eByq3MM0GTGuB/ykQI6GYJvxSlv8WQQYiHzFyPhrHwvHpT3aVY94gjRfwrD7yn9OpxUXUxPWc1ny8rzbtm8fKnsQL7V9lMXjCYou/VmZdcYbhPNrggUsNb0iR+A8zwy5zFDOeE39aQby0rwJNjnfkHh8wlAUYhVL8akZfJRhg+DkdUFQj+Cs4etNJKYmUTiIS/LWRrNRSYX/Eh0RxI5MgFeFH2szW1prU8FcGIegJ83gKcmL2WSK1a/9rBeK7ubHvVWaHGF6xf7taynDyUBX83SgqNASJeVXBS+E+KQWh3GCPuG+RQfUqgnvhRWAblyXO1E1FOQ/hR6sjKgGRbKjKYROU0NRDq2pMKP7K3wPNzsBavAtat4Ek8O3W81aQobDWM1skezwtUUSxpTcBO28ujyQ/ZUibgPmVMUUAfNOkXtG+YziuUKujRn7kgyZukNVbg2E+85PL/wrOVncqLYFEYhtKUfCQYVwvDk8zzcW2hplbqKWjJsPAOXKXYuR3S4zhRefh4MEDJChmGcj0QVPCqIk2LaJpGKiDYJrIoiKZ2aR0IWEkB+C4C8pS9svDqOa1MXcczNWQ9C2s8u6ErZlcJ0ZV67sgWtNMxclwB+KgTktsUwvS54Uhg6Pz/8rgSk2k7XxgLtKUwb58ACzpGOsCAuaMJKsUANfdNzStFggfVPy0nLbnb6BuxEjDohb07sLvYyuf5ARqvJR8ML3JLRfZpeOPMoMH4t88A6tVSFF9WzMPdn0r8NowjOEHCBvmppMNK6tECtCY4SS0fEur8/5ukluGgCT9qUyRwRnmSemXlWtoMiuYXtTLW1n+DyiciAQ5EGh7IpZCDClkMoMtyUpvDowJwETPLUzI0ja5u2bbYNLYmlBjwRi3WIXOh1g1ocg8d+3BZWw6pST1gWSymL51J7jDgFuE3pblOPGaN8qp+4trVpilIjWb6yaPe4XBTDgXS4bU7ah5ZIN7LDRUcFBAnh6Df7TRGWTR8pZvb9+E0Xr/z1Y36f5LrUNJfZWaPptQHN0AzfhO/4Mgb3eTIsAM3QJamOHpp2SjkdRJJSRhlDnSPrAIp610mHb3cEtdrVTx6s4XIhDGuJKDUWLYKM0uy3rH4ekMJTsQijFS4lBlYxyzc7dGfhMX2+H0y8r+krLus1oxa/BtYajoZFzGGt4ehRF8xiZ7+tV9HEzmQeVy9vRBSvpW8NWHlDd8MfG9kNH3W7YUnS3fCdlf3zZ0a+OOa+0CQ1HSVf9KU4qpkpkb1DRH1YwD3y1IsRrhVJ1P0e8Vtg3u7DW9XOW7AuyIp7OW48ewXyYwWRinDwq5UVdVFplMFxEhRcKRMXsaqDaJ0dJUDkxNAd2Lbjj5fxk60WPuDrw08f5jwWzuvlRJDkZh8P8e/cqDfSBQzkmy66NiEgaTZv2UQouZPPVaECtT8WlbmNq+/01xoJ9Fv5T643Rvw37pkFfcNVBh2gL40M0N1ugCRJB+jeypAecua17jM5jmGhxEfn+Ud/TqIm69IGxzSVEL67Er4PYW3AR8tgcPDnEXQGWT98HTvElzj96uZK+HYNQ1z5MZSg7T6qsQgecsENCd5pIu4E2yc91q5hBuodj4MegphEakgOL8CHchbBGrmayrsgeDEFbqhaUH1+IQXGGuPVlftBBl895UXUUkzskLSoMzV+bl+GgSKDIAFGWqJwoSOgQC9IXIGg3qD4oarlvixvSMpnkJIhiJsiVnH+PsQmoiWoA6hbEWpoGi5Fq17t76peLR+V5Qkel3OxOhv9FbzvLeciIhpuLsJ5vetvsi5zCQxMdS4myC8Ay+ugTleJemg8ZGKsXt4yaRpnEwn5Z/i192NiOq+TmJGREcg33azMeJxkdsqcRB2vG5pVB3yVdjZlMKCPin4PAwW20z1qGnvxAlwFEwCwO7tTSGdL298uJ+sU2l1Hu1uqDqJwSTHcwpErkUk2IzLuVge6JMK7G31d4JqrJErhUyA4+NXeWXphFsfvfhncucigHS5iPPcUjSNFZ3g1lARiU+IDt1YBDWDTI8PtkAyvyWBtbQ1r3kAO0nClBE056JNwTYSB5LrQU6VL5pKGX1FlVisdCvRLx+ynr3i4N5P9nt4uEiDjp7tGvrtjKXNv43Dp6rm24Y4Z3fVgwgnWxmF3dXNtULkyvMZ3UL1gXCdID0e6qne37Kbxcu4RP+b06k6Wx3h0YeuHaqq1FwqhmJPQMmabnn6L8Bb60jXoS4OR1FOxP0AXq+bAP+eHQrGHj7+T41xJaMCqFpeLZxf7LpzEJlgKL+FHfGHtYuO8v2qiU3XB0+odo6C8YxSPXqWP7VX6WGy9UwpsTEV4OfGOUSBnW0O2OYP1gYgtAKdz+ZH0L2bo7AFxwSFxoiZMEgV7ArDPaeYMmfUseTeCokp/VlnCLoTUftiyftBC3RyXMSYCxH+MXsuW1B1cpq9PBMzTbA3cmuQJnKFosa4RZp8W48Gy8hDVNjEaDaF5g+pooV34+M2T6391Qo41G7jDBo5yAEvbTfzEAnWbPPkTX593a3pwF57Vxe6YLeFeG7jffHoQn97sr9j1i2raJmuPjOLsTwwg+gde7jtHdbxtRoQ2+1w+siXtd56KIWb33uL35cp7m9+zyvsUv4fuXTjpyGqR6tlC/wDlM+4MFcmMt2DKOAW+FJC/mKUG/KEWvliuoyalOH/+U7Re+6TfBWQytPDWLvMAueXEFI/9+ZyeYQQ0pZS3jce80uEFKVo2/F1qyi7dp0Xs2mkBv0WCbeoW2WbPS8SSEV32qGe3qzCFIfmWCKllNMQegZV+zOPBYhY8FmgRj0XagscW6kIE06U50EGapRn8sR7yNNQ2PQrU67pyGihL+zOv/QmkyYHR4eFWKv8AYin2V+Ire2oTKMAU1hRyKWSXmXk85q01kgXM7wUjiDmgRh558K6AX54ZDFU+QzpYVl7XKe+tdMburWBTViZPTUpul8ntScmtMrk1KTktk9OxZGqWYcWd7JjawK3zhHdqRx/05IA1HDpg9dwBq6q5KVsQkLchgg6j6R1B4gGADu0VscU11DLAjadATXeEG0dMnjk2sFKvntWWXrUxUlS3p7W8Xjlfxp49oPWFDc1+H51ZS68VuwXSHHzkMdp4gjaenuxW+zFK221EUqHg7mg4MAVULaCV169kAUhf4HkTF9AaKHLI6JOR93zXJjE+7rTcdZXU9bJr723ChRt/RL4ukh8bXSSv8cLJh9MYDz10ZUrJAYTJ1ydO5VeJfwSuq0VgtRH0uJ5nXKjv2celvhidN/BOv970eqUG5LmqXL6HkzD5nqn2mpcLSEbzumjYyn1cGOTs/wT5ar7uwDegGJ+nQBVztU9v/BVtdTjbgj/jooPtXLY/n1bXEBF1uDhMuDZ19kMRe5ZC0AHIZb9Zu0zkz6EqqS+A0V5UTfUuV0tdEZpvoVg3oUsUaYU9UfFzlwyL5f1FxhVkPDxbyV9FjTi6kD4U27mLmFyqF1EnFrOtrEIWhBemm3gBeQddi4VDzp4JLcHt1L1sqRQcZfLMhARyS2NriG8bdWiJltFAfvbwzP7Q0HGGiTq2q9OWVWkpklHaDG2lBPVSB0JfbrtH2WO8GtJ5PwAGut0PtV5fq/VQbcsQLAAbRU+XRdN40bObF32tK9pRS5QrwG8TmFoZFAxJpjDhGADZ36/aKvNqvsgTMGYC0DjPpMKl4S4s4bFEGerJjF+nuo5GhrFV0NVVeyRBoxJqAFUa1ORv8qY5boYOj37t65AOY63/0LA2G8PaNrA2ojawNatga/tbjK3+vy22/tHDw9Zd/kRsDR8xtqLoidgafjtia7g5tirpvdTzXupE8KDJnpuNRYSaQ8LD3kQLjAo5uh06+fzEkgCpiSWFxy3pDwLPH78arAC9KdBdr1wUuDmobns1w8FqhtcNZYDeJcxIqAHaljUtgdj3TIy9fWLszZXYD7sLXTd6lYoPeuMte3El/drx5NVK8tXjyVdUkq8aT366c5LgIndVvjlr/JvlSjKNJ7cqydl4cq2SHA6D2Ym0+dZ2YFXr3NYk+4R636Has9ue4Sv0KCNyKrhyaFFaymDlXmdTOTA2lfkj1UsVVum9zQgnQmDWhqwfxZZpEnfTpZdVlUBXr8KrD6hB3oCSszMZTfW2puSNSnSTHN9HEHz/7KdOvTc9Z/rJbLePD1z2GG3VRtWYB4g7rIEW7ezPrNUJ7EQxXRpVa2pTVb9santxyJpaPlWRLOhJCGdzWtZFpkPTkdm+kf3SAdmc6tU12INDrYliOPbTxsvMOwFLe8FtWooQ9YmZSrfFvaYvJ4izWiADEcBDZ1jwlacUqzUD+FniumCPmHNj+0DTWs+fC2OdN+1yOguSNGuq1cUA+RCRVE5+Soupx8SBMbL0N6wjnjqQNJYyMDtlOb1dTd+IlHavcNvL9kMMjbR3QC2yw5FqDzpU16+h+/EZpGBjha3yGn/UYR3/6lil1KyMVZP4fWisTPDoRWsYN2nKiDAH63VdWV/xXnVZD6tAL5+tSnnk1JGFLLCnACyWs/iA6m5fdKwimdMRtxb4D/z4/1d/91PWB3xGiH0FJfk07u3qAPXr+bQ5/upbu75wJVNX3LyEZjcg1dJVpm61q5tOCCgYiGIFrpiVDbEufWYgjaXZ7H/pGq6Hfy38ZAWqQiiROwVU51VAN1h5PUVWzDrpcU0ziI/N98CeocEiLvd/o1zVok7w4KzI2MLqUgNGXFJ2hRK4+In1puNQZ7SAYrh7sV4JjjO+eYb3wEk10V1fbToXoAzByJAOVD+Uj25+CBdS9HzguMOUpyNF0JQLY24PjWFQ8Z8IE6HNMcHsvr2Mp67BQMom7ImiaYCPs6Q0xfiRXn96yzf6zwlL7VpisiV6SVSabSnqeYL9Pdt423uNFeNVCKTAQ3vgThMckJrVnX6qlzebDA+c42KL/Iy2B1dkwYpcekFFvgTbFKk6TxOn3jHxo6NiBujaZgh6Epw230ByoiUhOCuQe3BOtU3yeTTINEkoG0KXg+nAlPW0pgXmmXFG8EAAh8vUFY5ZLx2k2eeFRsybTqGMLWIA/FJu/zzsrGSX2rhncVwKBaVnIk35rimtgjVVu9QhfiyVC6K5aM41+vi7tGedumoftdPZu18xkhdztseBXuWDacpMxi58z4VHVV62JC97JdwFcLu0hMcS+ZCPcUtLl7ZgVLegPCzLTTkEQWgZ+sJQGmsqwTLwybeqVeFteKhCDQV7JzoBzFmL4o6A6oTAmg0csoEDNnCfbwJ328AxGzjq0zIRwFis5Du4rp08olvlThle+r5ol+3MT6FmvpN20Cn9uiglbeMQEEm1fk6l7WSCp/U96N3gM8UcTiggaoRQkmGrCmE5neaUgATZkA/TSvLldGoluQsFGwYulkqAmSkqWgLHDc2yOc3NmqOGmeEqeFb0xYoTt2fmRG1BO7jQpraFoYTsW59hdik7aSu2I6xnWbZu54lb960DVqroTjzCOw3+m8Fuaq15V0vl77y8x23ZYSFFXVQByK1UVbN28rtp5cxIUg/1n8Jl96jNk6FlAHUKAEX91qUcJmxTiJqImge14jm+gTuFlbt0tzKZ2QXfyYBfB49TqM4w2/Dy0zXg52cEexXRSpjQGQoiBE/XoIEq7aI5WjQQrYCriQ1z02jm9Ke0NIFWs1iqDpoCzg3ccMU8eU8TWLka8VLk1YHTfKdSrjk3awUtKXnD0Gk1ggplXfItyM4pEutiRsvpcQDgO0Wep9CiPBchQ1cCJbgxz8HA0qpa/yA3PgDttRa1OO6mQAQPrwt0Owi6ZdJC5fhEk8lR8dSsRo1UN5j5mfphfhZnw/pUnM25Jq9Q4CjzjM4qF6pz6Ezix2PcQrXsFqotmyxUQCYsVOTnJIvV9HEWqwZ5SgI744vVFNKwmTCL1XSlm1PlYjVNZBarKbdYEU0/E2k6mucQlYvVY0YXq4xSWYAIf8dfrFzeSYvVFlrWjLo65Xm5aPGBIGMScE5Xr9xFjC9hBIrG7R9awqbGl7CFoSXs3OElbJcuYcuyhBXf0iVsgQoAd/47S9j/5UvYvFvC5v9NlrBCl7ACS1ghSxgmP5awqY1iN+0eW8LOoQ7g9xg8vrOEVZYwR3/cWjaWdPKLGmFRIzLCjmkOBggKuc6bugE+7r5p8yXJrUVTuhZ1KCJZmWJdmf6P30KdolsofizROXgwwuJxyqOxodrJgZ0TN1RLcuEgp55do7qIsFdtTtE1jHJEjK9RPTwYD/A45Tubrm/FivWdFes7m65z8NhJj8Fjx7/L9WsvqpEFCo0yJGunebXVa5pikL5USdmOMnclpyNsWvek1W0nnqAB8txx/C0cgkbzMj0ShZ7x4jt67udc6yV9CcP5VGmkucYvqnqX+/IOUzmJnrwGoI1qphoh2LYXpTy1eh+IFenEqB+HxMk4mvh0pawiQGlE8ugaY4VsbUOFm/YMTbVfRLNXVeaK+EhRH1X9hSlpf20NFoDqfBHGlyMolOWVysB5zGsBJL0e/z25jLY5e3ns7uL4Lc9lxdUKp0IESznDGaXqio2eI1w/IuNhz4voDjE8n20cUZfADgDku4aAjDgqpFui6ZZWIaKwMxAJThoitZOGSO1bAxF3bjkOnHQnRAvfFNeBdyFLAd87eob2FWviOv1eVq12988E79TaXu4ZbNXrYTjoD6wyutUL1GPx6kH49UHgw7F1xcBoqA3Ug7xINb3OUk3qXRT1v7kdCmqtF+khBZqiHn48tpUSwFG44yhjGG334I6nZJtC45Aiu1vOZ+sySvUre8hLnii/WR2XENqqcMl3xyuQNVErqwlapSb2AxSXSXH7+2vB8yjMfglnKdJozDx+qElWqVbt1Puc613Gtk8kWKRKqz76ADAVHmkYkIz10iAOa/i1qF9ZMEoEhGZzgGPNB3qopZ+UteqBvrYlk6Zmv4qa0bXSoHOc/kIY6hB4VpX5WFDe7YGaogNoRM7+1Figln1QfVD0DxROPbgO9eDigRQaE2LuNdJT74qRLnMbj7PJgiMUrb/LaUMH0Ibm2zCbKFDLpRoEbraB2zmAY7BrKYB29I2e2se+3zzv1OTgKJ5V7egNW8AxG7jbfHIfngecdjSGpNRct9PsCpzoEzKGaoW7Dk1FdIXEyYL46yJfifkSv4kygTidgFQGhQb9TnnDJuPQx4LSzdedQWUcQIcwE3geFDVnVwqwujNY0TpDxXGQbIpAxDB8Vb+5yOb0WZ2ea8AI4PzgrM1FcLKVXbfdeVw6EDidA8/pHHhW56CqWpCAv1I/jJRar9Qp6EEq+jq6zjaqzl7Fsmcs63iM02I1feir/UCooxtncKLX22Ygc93OcvIUdhTUkraoS7UiVTNLaSlAba1IBk22sejIlNqibUtynuAs8T5f9o8dDt6twQyNq0GZWYjCjG5VZqWZ+ZwSrnkFzALFMhvxEHfjLYRkQBMJtUAX1Hg9v6e6O6Jyf4S+8PsM8V9pwibF/eXUmrBR5+4zzJipIrq5Lh5PmC5LxhoAnrUJ6b18mXjrBXUtlJnAYk2XB0qY5AW1H0ZNa7GmTvVSOMCNGuEiU1rkL63677y5sYMm661yrgrPLN86yWLNNtpKy1CU307bJ1isockWa3JYECgmWKzZgYTtEyzW7DSWQ7ZPsFhziksbs1hzqqYVp2FXgqLHLdbssp+LMQw8JDhuseZ0xI5ZrDnjeBZrztzUYs1Zm1qsOXtTizXnONsljyHukWuwNnncYs3uyRZrHrupxZrHbWqx5vGbWqw5d1OLNU9wDT6NigkWa85jCypLML9yPltW2U492o6RKOi8yRZr9iC7GlzZzt1/DOGz0/iz0/SzSnpBipqomrMSICVot0w7NNKgFCeeUoYsumylrRziTBY5FH/wkP9O5z838GSGmc4yTzOEVBkwtGarK0T/2z3BvA0ZQJMBK1WAyB2iEmRU7fuygKwKgNO4um2ETOdxpvM0UyV9SZaCOTFbSHPMGo9arDE0NW8qQc1h6K8uzuLnKAGhT2mLWKxJhy3T1DR9jkbi69hrXwAlGsryGnXU7y9dINJhoTF3+0UP9mgKxmYJbKclSbjPJCzRaZpwWmp4W61pizRDt5g90zh9O498IdkFjZd8nilSA6e5226pcHy2VGJUM5d9EN8ijipoqRLVRdRpwN0yaieilqgYEcFtgfBlC81Yfd+2MX+TCr+qKlssprywXCmeiISz8gU8SOyPXMS9uQhGbzJ6Il20mvtSXT4vDckXpYn5FulB3sE6g8XAGbnRVWhBTMdo//I5ahM/LrCWKXK4UauplABiV1k8LoD5UoiwYnhwBmx5vnacIGtkTcFHGUNuC40kZiaRaI7KchZHc5HJtZuLmB9J5EjcQpdLNTWaltY2ST2hAbyJAS91YeSmrpgsfZmFpQkxcpOtcOWUWgs3NSOcalYt3Gw3Fm5qxCHB4CYGsWncwxgLN11YuMHDx/imiLoI6RfRhcq8tcgzhhYaesUpKVI56y0VvPoHSjau4eys2vlHDfUlr4xW/2dhaVVTjKnV2Ka8yhlN5W/VYCrgaBVT/zbwoUnlxBp1q86smmMwfKHO5dUeul49+gOwMmkZ0ZLY/f3W84pEN2INSqjBPM9fuQvWSGmtchLYIxiqht+hJtg9D6J1jxEezqvkfvWP78d9KMeJttRcJjhBX3UyPUqkeYUw2Wvl9aUPr4H7Nyql2T16IzulOirZ/AN/6ANqHREv3v2X4XZcQxQRs8MCuWrj0fT0GaVzoLwBTT1RzMzTqt9tL/dlzvgOs0JKuCnGnAxAa+oKbAou3FqDgQ2QoAaQqO4kAN5G0aqYG7bhO9gTcmswoPCWgdw93qh4SA5YTPDfWHUdw4bN0B2Y/KoHr+b3dX/BPxTKBbLIWGThBLEdzg+0zdqHUafGg+qde6plN8su9brQmp1Qnpy/zg6J3eSAQ7dKyKuIIlrmQh3YVDRJhyoaACIIxYMjUq34BOfkeLBWaYbyqVXRxE9FXuIuprn9DraUP7SZhwK9mb3+QAAw8P7v+zmCH8/Sx+VWZFEqZwcW6Hux78FtZhwKqWonLLnguzKLFKwKtJf2UHZcbl8vhqsIkRLskfuaELQ0pJ68qbsLMUKcrejqWbjNpMiqmuaaPZTDuZY8ULckKNGcfyVIxii3qG5PjrgxbW5ym1eWREWOCXEyVDH1HAw2A0ql2KJJnhyE1dBNOQjzSOKe9Uz0uSF6rdlnQBf0sqTHgE4pybm/CrKmEmDsHu3+x8lOpXvZ/8IgSdClaMF/XVXRzYqmJKmSLnKqj0wGBXZmGkFN0dQFvOFESP0xUMSLJO6wPr9oqsmiZvZ3aLNpML5Fk7UIPedMyFZTm6ALXEERgVBlhEGry1uLrwt9WIUatwdFxu5zTGp2qo5xMo4lORzCNVtoRqIB8Mse+l71Tum1fMC+Ufo1rCbzCDWGTFo3nEnrxrhJa5cuqRgsNECWKPuftigRyFWboab5Q+J4oH6Y4lq0a1Qls04Qj6N8p4MtyV9AMlTbs79BiFlR+ARH82HQ+mgNuBdB9LNnM+NYwS6KCM+ueSa4ni8zobEit2j5mX1OSqcGgN7o7xGx1bnIxhVqHozusLVuzv1i5L5Wl2+e/b4iXOJ6Xe0yAKCfOqPZVaNNfi39l7NadZXcXVtnxAByNIfVmoNcbjO/whe95kA/hcdAtn0kV+ZjlZnomFAMtMsb1SsgddwKMaPYUinPJDVoz+iKu0/b6B1/KMf5baAY++ASMdor9Bx/Ci27UcMdsYTbeeH+PEPsy309skf4Bg3PaG49tLelkDKZbRzgM6MqF9ga+SJaZNqkHjQsEatz5pbYfyy6zC8bGhZDnso0bAlp3M62IV6LplcoY8nQLo8WaQG0S+PsIT5fBnwm0rgSbEOkipU8dnMDrgSFNi7gr3L4rj3UTuO8fiQ3lhElB+6TGZo2GWOxu8kFFD3Zfujry/XVmRKIAeKYFsDFckvtkXwdO4wlFGtRAFGVI3khR12FjxzJe3ok71WP5INJciQcyb8CvAhCa2XoUBk6UIbuu9GG7i5Dx8oQD7k9ms9XxLLkjurR/I6+L+vUDpzp5juoMKfNp9jT5ro7ba67o3njdcugEdWdMcRT7OahN3TcrLhHdSf06g2dN8dqcjCTbYGaHERbcDhfLxtU36xBuG/kAVuwd4G88sQNmj1hW9TsY13bwnBC9vJwfocezhecYFu348St+1aCKzVTgHIcq5pZYYa8bmrOYy1Zrdyegu23hZfKFAG/oXP4Hfxumjo7knQK2rCTSz+FOnlCUwZcO8sj+ro9oscWENMeq/3SBqSzY0f0GXUBxQCH8Df4+ekaulHO4xXXHEz0QB5dQnfr5lTeAZd20TxtMYAdUnnIGJ7uWN4UKoUUydDoKfjcEA63AFT/NAWYqxVvhSUarn2a+1Tqaf7NmiNG7AyyaW2CGq5KLV6JlJbsIh2pGi3VnrpvwVMMtCeWgqU8JGqwU4mZB0VpLDIVRWlPFKU9UZT2RhSlU+GVB2Jjy5H5tlmvmpysitJ4qqI0CldFaYW6rmFuPeuQB1XpRVFP6/BoqKo0Px4zvI7hsVxZwmZNgbqcAb2GlrPp4yxnTbucZePLWdcsZ81SU9r1s1suZ9PlctatLmdOU7pO52gVYovkMcSPpLKuLVJ78romfXZLmsuIJY2Rg06p5F6mGc1oF7S8ZxY3/rSqe5hQrxLh1rYEj8QucdNDS1x3fIlbGlrizh1e4nbpErd8wiXuvpeXS1cZOlaGjmropJbCpW/hEsftODmazQ35zhL3LQRXqlPCLnFuddNK81gL/bdY3aZ1detupjKdAYCPwWNnubTpIvdit8Rp890Sp9TfLXHaz4exxN0waYlzo+cqH1vdUOHk1Q1Ne+Srm6lynE7tdKvfxPSh8se0y4bXO6dDbQxUCyF3l4iPs+nS1WryjsstU5kuU+dQoKvV/y07MKhRx6o/nRj96UdnR7aTAzsn7shOsQsYxUbfcGRrRomLV4SctI6pEvV3dmzf2bF9Z8f2Ld2xnYMHtKm76MR39m+qX43aMBBYhly1eLM4VNWoHt3XuYw7xzKO7/VQ+yba1cfd9yG4OWd+Q0miytCxMsTAleUJu8Virp88UyjT7MhVpIBxNhFQ1OExpMKMKFATfqjngxiPNnwLqOcDHPZVQMsBNQGDWJrDjIaqJnY5MrVnaQ5TO6BZUHatsSzROD1QQybWjMyc6T2lF6AY0yyeD8lIKyHS5RZIaVcWCVRG24jQIl0rtQ+5nqbI+QFFNAd+gN+nr3ceL6xybpr+juf516oJoOyLN6qqqG+Ntqj2RzCs/eGLS3Xoq0LYe+yfrj9YAwCzL+Fr8tw5JlTp1fevwCcU418beaT+carfulntTISou9U81soCtELU7wYTSif22+FVlY+d6wPP+p7pU5+dxYt1/ddeL3J/jc++pqcAFQf1PwXPBmN+FCwzpMANrCtKHHVHjAw2KSGNCy8zcRG/rvbhuhzH3lfz24rxP6ku6qvuJ1ui3P2pt33ybXzC7YvhS++F6k2b+By2/0mkcCQ/PlljU5XqsjH7mFgoFq81wcnWGZo6E1HbryheslKo13/h87gA9Vcg30UUlL4ypRr1J5ucb76C2rhoSDqTnp6UjUcoD6RlH0dLl/RENBJ1TqShLqtJ4NxMdNLs9xBXS1/psWXT4Nox86K+nBCLxoA62WbsquiNq8o4xVjHcKpm/e1H2c+DywPPhzPlDKr9CHQHR9Axp0CeDrnhD9LHed7LyDtdPfmLhR6Bm3Te5zcLLa907Zq+yrNu5T1zTHO5sUnMVAJIzETFw+zAysGwRGK8QdG6qJ+L4qhVxJduyslgoP2QKRFdWQSw8BoS/J6vAJd6RWjsFPr6PXcjfV/pvN1opqsWf2DegShi3s6zV1DgX5HLjYAfhrjA1Y2ng4eJZ0yq6YOHC2WrXxhUoCXFemRNevlEooEnoak+pUhc34TylYDclYosXHB6ozdkZs/5qzB+I0NjBFann7ViuFMagBdR6JVHiIM0IGiCB7dVURXzooUlsr6S3QLU6Hs/BqgFTssiTG+KQzg2hRa1IzSxSY6hF7Orvyd7o1GX/8wf6V0LtfAdUn0TtfeuMeC9i+ooIlMDYTvxENVxsqoRkdiphXFsakAjA5osUZ91x6+4BqrT1lgchcgVMSQRMh5hI3dOHak9b1X11pLrWvYyfrpAGFtJditgIdG5ZsnlpoXcgliWEHEIXeCR9YRhrdnzU6qjSrk7q2f1VKQYHvQCaOB0o3XTg6VrFzWyN6LOIiJkLpoUQeMN20VthRSUQ3mAX7kKqSe7Dd8slctrQ/SOXJ+KCHWUuy+KtGOTupIiqLb7y+SsTG4pkIFrVrMCeFPPfkFtQ6DeuuSQld0MiUYlcjek/ITzlF+F+EqR34LKh4FThXkRaifqqkT+TB0x0AGAmhpoD+Bj/OsDeRqAAzxeRbZQboLUjqDMRAy83ALLcHkMjxbMauOOVKaARLMrE1Kc1XCrMDVjt1Y+ncmbznTfXh1QEihhPQJ3JXAU7k/JomDRz3fE8lfDCHQeJ+GRnfCH4nLGm3tC/mVVWUmosWNekMGIAGv7ACzeklswpaNbctaHe6kMHuwB2usJhhlRXaNC7vw4i9icfOifTfJgUDjv7pTs+09fvf83tz//F8XTZPlyZW+9iBAzcI4qDq9x3MDtYCT5yOGBYzUNggb9g/EKjMh99CtcZ3a/Xpfg84tYdDDIr3q46J69j1XgG6XV7mftXTdKVaFzYcgFQsGroQ7BQPLVM5eAyPLEYDTb1JY1BcIn6eyaax0XIqsA+2P6ioc7AS3gW0sR1wG/Wp4Ym0/QUUpwcWWkJCYCaAWWmHXU0+AE4K3eMejvQiZxzxKPGL0LGCsUAbHAst1OYI2qij33lgEeVxwRfFSGBkIL66S6D7oPl9wvW8FaD5ctuWDrWh6WQ6N+WHJhGciD8hnfC/RKa+i+VTMLIAsL1BJ7+uuVVepobcgarLsV066VCpw+eaLepPqbcurU//SrwaEi3mhvekyBNOleJIn+pi6MZZnl9+euaHakGqf5vkSrric6WRoh9SoqKJ/wAlXRm7TE+sqHQwsyUCbOLpwMGWnDsz/+8T4F2Y1Ct0MKy8ireoUDKbngVT2WFUbZK/CBrN1R/8M3PgkanyH5V1kXexFHxy9awaCVeW1OT3Ia2hSibcp8Vhbs9N56UBdKQrWNAnqeVVuWVqyJEeVG7o5+8p5zvnnmmVdWLz25pgeVpgtxcXc0wReHPKqVflKwjvumA9wktWWRC17VY8c6ri0UryuEi9hmOTpQ/4FgW7mcfY+Xf1/F5VAKnKYn13P4FqoPtBop7TnIcdhRpxBWGClh7DVFDlw763yVNEoBfQBCVSu5IxyhzgMITu2rReW8rApB8QpvE4g++pCEHIshmThIJkOQTCuQrFtI1scgCeStnwCSCZP9IUg2GJaAX0r1CfBLHPwAN/JyJmfYrTXJgg+aYSkneKluDqHkDFI0DFXcmWDWnmpM8wxcvwNXaJQKZAu/B8rL7xwQCHqX6cQHNytcw4bne44ppwr1UrdN3gbIUgWqRrQQOvJWUqe7P4wlL9O9RVJe4GxJaFkv/4K8vlIIkk9BuT10tNAnv0oDfdc3vzJMb3wgSK/bZF/j9WF4nh/sFasIe/CD0b+6z3jQu6bwtDW+zXI9Z/FcFq93DRouHgPfLEZodWsDMcFBNLpKI38WkPMnQU4dMCkAFRgOBHPlZdZMCs9ebahzABbd9PHuV3BzKSxfruoZlAkdzITgb4BRqgzO4UF6Ts0IpF4lawp2DNIn8k/3ZdPtP0UffQxSeh5DER9krxUs9bN/UJPVymAKPI0jRPRrBUqYuAL/nz1fN+b/HxM6CTQZs3T7/0JkAYZ1UkSwrn4BiZPZ3QXSGpVsoBWNFVl7WF7xj6i5lnZq/QFkTdk3dLmd4cKyjwmQk+xNAvr/5XvRuIxJuvF1d1OiJi1TgZN0ZUiLN3BavMG4Fq9Ll1RMmpMuHr3qrGT/jKx2T1/L/kVfoQQeyH6ir1r6gWw5sZ+LsJ8jsFRCtwLJrNt+6O6q00u9Ko+4QNRr8QixcRH/VAClh+/gOUBuvHOz3o9mUaTOyZA9D/ip+xOnV+s7zP4vGFw0QRrgax8CqZN8mfcPSGdMdzxBMfcq3A12VdVtDHBBEC9NL+Di+12DDn7/zXaz7+tm38es+IZioRNnBJBl7MV+CW4lMRQPIgvIm3RaB0Iy+8pqWRxDSiKNSNLnGrQl9AYPfCTQDBWeYITAUksfEMHxCDO4pImyAxfYKkuHbNK24XrS7+aW9jPTR25SRY6nNaEAhIA9ujdWJKKgsvML078IwsZ1sbBiTm7ilXYJwExLUQpbfjvwRStGMa0KEMUoqO4pJYPeVwnl0rVy65Cf8b7gH7BNk/Mq3dDBpUlutb8bkunM4NCNTBjzJnHw5tcgaATnLarj0RbhXrCLvOrFDIIcf5DD1Unz1kHeqZqa93BHJw/5mbno1AV1z9WhbKNoD8CvejRFCNVQ2gA1Yi/g8YP4Lv/1RpJO3CIPgYzaRyjgj9cvQDvwyTTid+WpZujS9BFqrxdtlkJhFOWiDr/otgfOK3TXFlKzwl00xXdNkfWfhInkbhl50HD/bE0ifdmUWemC2ZR5zvJELZ3nHzcFatmfywzcOim23zXk7wmeN+Y4Q51WtJzPipfrob2b1WfzV3ZXJ6itUl8yNw4wi5nLMlWkrRq5Ct/th+LWS5Y7t0fLmXqr97Sn3PbF64/e+aqvv/EbPPSl303d4SnPoYJuFZWbnbM90AYeqyRV73SJA1eq8xM4+U0jOlgDVj5QvkRH8P4V877urqEVeqFNr85BIuPOO3RMQg5gLOvyhJ8AujT3raMxX0YI1B+t5EGtti0oizZGSFAJB5KRKiBbTu8MQpHHOKAd891ahV1ABZlCI273BZPFnopAwasCICTPdVlvcqnxE3OUQyP8bwR6pSyYUtXXKK8hkf0NOS2T+2Ou4gIdpJCvKduiN7ToWNjF6nFTGTBnQfsLBplIeorgSBGuG5+J4WCwbphG7iZ5kKnXtLcqedavtb8Qm4k38PqEajwnRyqSI0WwTqDBEQWVGrC2omIWmEByhhPdESCdkMPyeZwcixUxS/XLQH//EaN/qOifCPojJM5XdRbouObJ8GwIytmQ4JWJd6fE/hrQnuLKoV/REMQT48HN42G+PY2tK+ar4HcE8xuTMB9FG8xHJRxoTML83Yan1Muq3goYKqz0Hl+/6SGae4VNW9DL3i305R7fCyoULXT8HPiN7LWvmMB0qRQ2GuLpIsfTReM8nUtHqvJ0D6UK3JPsrEj21yG74hWsI71eXpVdI9/xdhEu+X4QXzu2LtJ8QcnWQYsLWGzYukjZugj1K+sxga3zuVW/KeUG5pBCDEXxk/xhti50C8Av+SFMr+EM5hGhMbBWEBkB2R0eMfh8fFyOJ+MyEAsn02C1lLqGkwm3GpyJTwp9w00Id1gS7hDoG05C37s9P3zEK50crY1CgPOrkFx7GoNln9RT1ArCFWoP9XruSA+jST1EkaaHKJwD0aQevtnzwgqHHyomR3ZXoYYT1DEzBGkhuu6brQrieI+ntzl9zOUYoUiIfZD9pEwFu9EpdwYBXoHOYHPl6nh1Z6BssB64uH3CPvDQx2qWie4ftfxQqBsF+LVEC7TR2SEjVVDOFrAe2zL81Cv+HWwZPhkFbWHW3IYhcAQV5+ChVu7rOEuPcSZunDVjLvfnVgSNTUzMMeQuE9fgqd8k1TnpLEnaSXVzIGmSIEjZo+X0t62ayIbIQcjLHgD5wjain7nXlF9DrQgacn5/O/HfZT1NBkMvp57qzfgdziubHiqKDY+pkuRHyDmlNvT1M+SUQ5MO8wObqM5gNuKsiPOUyYTMR4by6CTM1EaWR4E62IUHNhHwnAW32u777IjVJ1CDYz+nswSfwIcSXAFzGE4ePRRUpV+GA5AqaQYZzIS+31PbVw5aYvoC5cygh/kMuCy3jcoCuYRNHqx0INc0eTz8qzS10o8ZJh7sKuy5ZoWysqNrNKN6HiP2CrIKk4nFqKrz0UaWNk0hasqobQM8gAzgohb5IME08kAX01ShWFbGjG2Ujo5ulLZNigXR0I3L7sk7JSzj2CxlN41ukg5bjRM2+6UA9TATL6p6vtPksyrJu8eTqZK8czx5rpLcHU9OKsmtanLKsZX+fdLzomuN4kyFH4cmjq/8ZdVZcfWMzsXG6jFZ8L4yrqrjUCtxAWy5UPl4wA85/6/sNQaDI1RfL8K1PBZ2hIKxDPIpcuUxReDOzdoZ42gzj50/5DR9j+eF16pjsgyEysmX9biq7NPe4YlrIME5zCEL6Cg/BjiL5Bf3WRGhPZUdmGTXzAPeWqhxGuwQXA5uNvcCaUI9iZt+q4lIIEr/uhfDuK3a64jAAddgFZWV6K4Y9qWIfgf8uLe2MjQmUFh2r3rIDoMIkPEWScXSSrI+KOR8SxSaGnLWLPWIw+u8OWJbsk71NRHjpBTmLQZ4m4tuUUuZsfaGsbpD8coGF5yQFijyFTS1RW3so9qUqg9XMHJP49gmD1rrqTJg/1UXyRqBCPRZm8miHzrtVElC0aiKZMOpSdBjExqnCv1qBAE6HVpUirL6Xvq3/skrFaKOMaXCIuRYp1TItZ1AjRAV+FaN0P/xihrhN/mfx5H387Pu1Ajf9AqnRuhqeUiKg/sffZXBw6+YpDIIYGdrrxhXGTyCuFr6P6ruyJ0+6FPe8Yv/88Gbvn73N56IeekbZb+NQcGrU9fJGiSk1h0d+eArLiwtkzkvsA2zv4f8FsuZO9HwHl2NmFuANWP9AJ5a5OwKLIpgRbZ9yjeoTZRQsxj+2YqtsB7bkFG2CilCfuF/L+1lA0T2dxk2zuvfb9cmT5lWj/REJkPodL91vj+HEAshIZysNCyQOQCI2p4Gpqfm6Ebl5S2qHj5I4SrY8/XcqebWjgqk02cDzpvY79FJJQxVCMwxxkK97HbtMNhqh0dSiZ3BhVc53dHll7T12VsrO2wzpmrzyrMyR/6gr3TEsuZW68pXFbyRcxYfxkR8Ur7DVIrTI3bm6E6PPpBHibg8bLxEcRo9EHu7B+bEIEhssaLPvhzXbmEz4SIb6Msu5CZ555gLTZKI229DMNUv7hj54s3uizvcF+9AEDvYtaaKHA/Ecp8swaY2kmDDrHeAelWqL4tNIEb4zbXtGLEHZvrSOGqy9bkVlDizkr0d6UAnxc2cYbSRt3TjLNoHTSBw9jYkTuJ9qbU2UGNsCee3dqwyANgqilEKfrXND08NwE3xX4eLlhZQqpx6kQkTi4+0duoYlanCKy2Eg6NADpR1CS6ei2vsPgdwQBFWjw9qrSCFO3I/HY330r6AnOrZV7X3fdgOQxQCklY0hfNuZm9Hx1GOWOAr04UPEafqvszs9fKo3gYYcuCaB1Yf3m3K04pR11S3ZFKxDs4UsgAW2OiYOprKzQMDPSQrsCtWtyim7Dz/QEZTSJkCZEuWuIPKOv3MGOgGspS15dM4iNnwck8HQyHPtWAdwQihHApXylm/1z41J4V61eirejkGkqMCjdR1mMc8wJjPYH4OkfVa+f6f9j6nV8yqEpIW2QbiznE53OnDD86Jg+XDDxZePm9bcfRi+6QQ1RcL3ABY8dWe83zhPsvmpTNBC7grZg87E6znbkEnHDflcSGh0cHpOPu9PvmolLbQIk2B31vd/+uMAA/O4Y7OVzwu5W892sL5/Wt65tYQ+AHR9a7wWJ5Vu2sBWJRx8VxbKJMjo3reoZDj0Z+pFZrjEXjeG59y+afbf3mxfdI897qYpwVaGDf1O9HQL8woLo6b+UX0ltLI74ftU68cEVLUtO8H7dOlGMO+77dPTSnQJIFEy3Lh9okMY4CXwmgLp+Gh/5WmfT9on/h0zAowfzrR1O9mhn43M/O7mZFfZ+x1CYAea+Soid+JBn43M++7mXHfzUz7bmbYV+MV8IsTzPr2HvzeCfNgC6zWLrNB2q3Upa0wSLtIvYmGflEAIbtkXqAlwmcwWrqgn1XStwiSybW5A00FFsoutkjUoaYzz6z3Iw+0gN00T5phTb7R7+9oaq9s5jbmC8sKjAxjlmbwd2lR7xWZqpxO553h6TslvMCUCvb5ed0Kz0ox7RdiUuPQtuuIXC0EVL4ss7dn2qbRev98hMDJUTBucC+Y8nSuhjyp8U3OpZSFFL6Uvigd8XHJUgmuI6DoNyofJ6TUkcW4M0w+rLgk06bUYf8d7VAKaC3Mapvsm7ZRe9W68Ys//eb59OORfU6oGCv2RuFhjdgr+uqsaC23Z7xqW7Kfqrh93rV3sOa8TbPiaYgznCZAMCUX0lhwRE2RHk2v9PdytwIdoNyXMZ26DANFM2JwdLNBG8fmhz+Ibuya1bEzrMuW4RLu8/It0JXbMg4sOM4z+NB9GPjQfUj4ALgJZIopIyybhZR2CkYJpjkBd5195bJELWiK97bjdNe0poMFV+sVMDgwEs9mzEBuDrc+A8shHQsZLqG9p5s6xsR5Jkgtz2O4j8TCeg5VJIKRPmOkYX90gzrt+JJZCvJtfBbi9X3axpO7J6JJgV+MisADo4ue4I8PK9gvUPg7vATHBLddFhhNtBx5VTiqUFVuihttgIv1Ho2+RrlUauQ+NE0IcEatwYq2Ac1v1rgX1/GqfR9/VB1vH04vJDdeARsDT41q6uuiHV0fOcBPGHZBUcEVVK6jt/fts1hAXhv9Efss5kF+u6AvHCB5WxiuBkTbVZNVq6GuUGp8jcDm7Wv2r1ZmH1iprF7WP3SM91Bq4LmERSpGP5kAhMAFW1/eKXsoUA6pnjcnrVD5YrAX8xj3ublXHTeR0TtfX2U/kzib1EBVZZBlWk0NfZQvjswlnQKZTgFaBMY7zqlvn9XIj9ingFoBqbNGYAQgOsvbuNiWlnojGSZDprsj2Qe9LM+kBUhUzjXtH7obcIS8rY3NgvgB8SnLO8eBUGgg1Kz0FG1RTrXr+o6BFpQn3UCQzlEfc3RKJXXinGyKAeLAMcp2uxX5oCdSPkwkdDOzvcwzsz5pZ2U9Pxrlizp5tBIzhRyxxIGSc023qLkqxAjVoifDNNG30JSygVzTsm3qlDdyfMLoHGfSUwf40lFEz327tM5I2rTAbJpm5TlL23CVZRvNAWhzxl8ZxLZZ3nL72kTJ6ooSfic51z2FNiuWZWQ3eXK/SzcYwQtfwO3E8o51E2RLtyDmJPcwtdbyVnVLBylGC6JnNWprDj0+M6YdNim2v+eE2mG7nHbYL40efFzo+cPaYfYAQuWEmqCpxgp5VVXM1V6oNjAKBReXHYA4AL1laKhQbEjIkzxUIY+Ps9JLUQlOoWGqhLspqseY9Txyh+5juGAIb0ZgjcXHhJvAExNvTf8sSX1I7PkP91PtM3Cn/+4CnYpmMYja+ormTSTb4FplG4wmQVdbJfq6v62t41aKmAGBQmUySfwWZogf2802MUvg08GxxC1+baMYatvd7BRNKQ3FlUWYp8dutrU+kO1s0cRetknt6l427ftyG63CjLYsb6572QZQN+2HgukNivOEUsFUc1OuxaFD9sYN3ArkTXkSpuC+cn9bO7xeZLAetFZMU6BOWql1pGjhJRscGRQzcsQJR2ZeKXYByCLi77gH8GvBPwOa1pcmXtYGeUsPkoBiOKUYPkDhrqHYVHO0cON1MKCZI/x9K58h0VqtHnrJUUfRVumKnH898NYv/8kzfvRyPf9yY3zsYj4nqqBAVXe1NdwGv1IF1aqwLmbWXUpGFUv060cYJBc4BRMcAs2sD7iBM3nLHJVpI8WEPdVQ8JU9NU+Ms52T5ejhs4FSYT1dB+r77D4ib6kfPfGznieVeJd7pvKhbtHYxQCcfdjvZAxSHEOhZWtrskXo5XXT1im9xcBjjZEpolv2hd/3P97+V8/61I9d1dZhMs2olwmYSC33hiyVtxahcphsnpIZkorTLZehghGK6uQZR5W4o59UeXFf2i54K3rIvooIW+uVsXEHlxSAN6jS7vvHaPek2P4uQz13lDq6WWFPMnFnxHNSfJBb9wEO3oZ1wCtnoNl7lHTr6ZjXXwtWV2R5hgr/ryENmgscLX4J8dRLAUaFhp/pj/rQekSTlPQFpXaFPV8OEZKfRFRx1ONaHtkMFBnXA9BIUmUne51UaHp63ohestqA+MCJVp1/8L0QXX8PNKvF5JcKgJHvPV4eS5S9qT8uc66LzFmtW8mpYwwCzpsYQTSRNMejkmYcpqgtal56TG0+4a6xtO6oV4j6C9WMoLlunOjohVfrAkYV3vxJQuakFDLXwNjUrFJyHSlcsQDM+l0M5KGnZN0CdamlM1V8UQBolcb+S4KfuDzbDWVcqDYci7a6io1Se13M1slo9a1Fjj/7mX8MscC/V48MST8lL/t1RBQV2xZ4GOzD4v1Nn4sQ9NyQnHq4xD94V9My6BH0ImqiKsQ/ZZJe0d01nPfc8/xzEeJN7B7ewe7R2KejDU/X8CXn+ZeUB4TkDx0leqfXfuD82g9IKLj8/OByruXuGqrhX1fxlxCFXxd1P6Lw66Ju9DgKv66B0Ir2LuA/Tr4ZyfjN3me/uB1R+M3+9/Um6j2Iwq+LOipRR6tRxxCF3/6GSPipJuZ/Pfy6Bon1X/yWUWNHZEXNDajj2HTEDMv2wyAzSl8MtbGns76gmaqzArY4x4YK2K/YuRjqSa5A3h1q48WOACzDjJRu3an4WokHRhSGgbLfULKgbRZOESTnd2+oqgu/H3nS9Klos6pdl3ZbRGjgKQzlELAlknx+WA+iFElcSQO/ywscdSqPJUH7775WT418dR+ZBzYOmgLVM0m9wfZHypEb8vXLng9NEaeDGRn3FSg7VLVLHw9fPZomUJnB4orERJweS3uRmlDyo6q5malWpuiVUph9pKqLGZa6mKG8ipoAdDH5UdXFxEsRUjysi/lUHqLSQEvUv/OrZgGL9FQ7ghKfNFVbn/0WqpYT62iz+1u/+e9BGfPjYdWBTlWz3bYWYZQSqw5DbNwmu1IUeBkZp9fqKA2qm1dfg4/mcE8HVjiC1VIlMzSuXzKjN5lwjGgDqOas4hwO33VRb+ge1izsia4e+DzXY1/NbAxOmDUjGRT+pie5qShV2FU1ENH1hOPcyYss7BlRWl1hgbqKl4GqUFYOciVeFKr0LhsAsen6GpXra4D1NbDLXGouaAnOW/4rMqLMOe6M8f5BDeQWAAVlVVpcIsVRigylHyfsnhJnlMNCXZnNUHqKK8Lwslx1VKwpNqZPw0qQbvI5nnJCbH/PSehAQtfyd0dFAXtKFchuRQ1xeVxLMSycwa4xQcBvBwHcKZd3De5uVPW2FKmgMC9zP3uVkFAZfx98zV0N3MOpr8D8CkTLqDyqvmXON7IP38hXkD9BpBYwO3A1+YTnAU8DWIlRh38V+bgksar6NHd7+rxDU4Pb8ax6Rl6z32/YwJ3mk7vwvNdznpGFgrW0YYmoQ93VWBHSVsX2jUBzvIef2luuHXGgpYwAfVXSviNY2Tf9N2dff8vPX/Mk4wQ/tJkUQu74RsGkH2V/iryq1HA0WquaE+GC2X4B0mq8Z1RwGifIKVaxhsO4a33IR8ZU7/p6RZwVYI5yH4xjpy7GU6jDhl9RtmTDBnLH08Yke2HIwBcW8A2oVIly+3vyoKqORkF6w9AV+wMzw1e9/1jXGNR3zDdXOVyh+uohNcv+FFm1YVgKrNGFv2JLiZ9wpWxIKVxP2QIK19MPe561j5MU/prRM+QpvlGYq2YY7yOFU7Qlv2IO4ojbiW+WxbSyLDwcL9xzX3qTC98syyD9EUcAyPnLisi/sLbIDw/KexEFWFx05VQDCB/ALR7x08w/i8bxUwTC9BcCzchpk82UzBeF2b8gNf2g7/njC59zgaX6fKG1MNcPhRIwFIZcpeqChc0/ct3tW1/4y+rgvQvBKnoBRk7UeaTNvlBU/uniZ5Eb/Eo0WPgevdLFVB0/2X4mIc9TrI10ObRqlZI9Ky+z+0MaiK49nmuPp+2poT21k2iMbvFRkpV1hptA9CcPIuq3PB9+rgRcitVKNH0nbQosXQ7NbrByAUCXLL08JG4RwW+i/VisRDslKL25D6pGVNLxq5ho1zo0pgfrOm/KSpQi9CQNSXd5xsjW6Xv5kuZ6+gOMFROkCRCkG5+AfFVQCYqRKORhqUwswPgm0GtEhPBXoT/l6MTdznW/MJtr9QdSfpY+GItIN9BA6D5nF5IdgoAXIWdGkYSvkHhXUy/LOxKbfRoNEKHCz37q1HvTc6af/BxAW4ZLEw0LsdaUccAerwm2QLbWdRUDiEO8UBVyE64aDj2RLH7iKYGsyahcEZpxNNBmtJBVjdiTnrY3RcVqJc9MBwNKpYuWMZFe8sutmN5y1yajwFyS70hOEcBSZE3PIr9Gdl2kOZ652xywqPF8IyaeQpzDwWnpWgs8OfTIaQpXZ27Jp1PwZxSjkdJ6ivjUg9OgUKafiNlFmqHQ1KrM4N04ZaOM4zipo53JXi98+QzNrNH0OvKmVh8vQksjBpjRebi3am3NDIryX3VJs6IV0lgzjHepsRdGJbcS/qCPy9zS0Rs//fP9PHB9VsCHg8N5BEoqhUTZp6QQ/9lFjPkg9jlg1Ov0H/qp3/yHXfddPLhKJl36G54XuvXFLS64RE3+rRwFe129TRcPXToq6waLUPW76HjfKQz1WlFgKj9yC+wZ3gKtOFgzpFALH423nyZsWzb0jPc9Yk+ozZUKVAi5fb6bnYdDBu7UKnH2Z4COyMcjdHBd1rt4Ra3EAVNkO9y/S1Guvu8t915yzjdhqw8DxHQn2nfrLfj39YvZH+vtSapXW7UtobmE4Zd2EKOSJMD+Xbgio/w/dZSxr7pdDuc47XZ/xZEFSeSZI+aka9UEJRCQchr6tmUvj36MHq+J5fmkX88bes3d1ihHNE21Mc0PnuQUVPnBA6L0L5Nqo5hyl7BMDV/H7Zf70Mbd4nYjwu99vBz/kV6WUqsbQyUSz9E6efsLphLUvKxX4FiSoFIpfhym1FtvMXUrTem1MIrXiykcqUxRCmsdDUrwhy8J32Iqejg/zfTwLZ+B44tVvjm2kc+6+aCKF2HuQUdE5kaLyyvmwWkEUnaxgGNOab9SJfRKyZLrm6SRidaxgYmCRWAGF3QmINa1JGoRE38RsQcjWrSxAXGl9wO1FhR4qGi4WLOJyzSU3IpGDjchs3mBBQ+9CdURQVMwUGiKqYO0okp7Hqxxsby/IEqh87JRzNP84Aj5NAfkmNsozWLy5BoAmfriSt4DWfZojjpy9t9BLBg8sCLNoivLhKdbfVn8aZpRwRZ2v6rYeDI6Mlw6y1E3UqQpM64pmdnTTmqPacgMGjBDc2qznmrU5frO47aA5FqPzHnDHuK3+ZN23xq3VFLtgd/iACiqLH2KBRyEGPG42TBfNRvmX2QZqz+KwqYc8obXWtoQlrTB0ICDvt1p4tsh/SbPmgXo+3lszbr4xH9sVriu36rMHNyXtfoHFQ38seaT6ovzDGuoOKX/YiF5enWVEjXHQ22KaWqFmqsbqr7Qoc4q7ma1h9fpPBIlLSg58cc85KqegQpiauVNzHJEpco0auvy7DNK94YkL7Dm2UG7+Fpae2WoK32/euycQROzstxjeust29hQtxl0g8Kq+mZbOBUQi4wpt3GO1lEjqcVMpTvtCufZpg4O//lHVfIE2BvFrB5ocjKToUExTTN8drzvh9701+fuvfQb/x+5IC9gU9nfSN4ZOINZIb96t1WJn6uPv/zmh57wnDtfxUvX7Dq35HvPfMXec9714MXUXl9bO7zvf/z15a98282fuxij0F4bqP0hlOq+Q+8ybV6x+feDSisGJnTvxWvrm16wjTC46hi/ACh0QTEI/Qo/0mUvYKTWcyMfRwEtXot1ekDCTd4gd5cC1U6DW5UTF2yoXMs5uIY19abxQMCxbd4ryU1CX85DG5y5pThMrZIz4wW8AV5VEF1bbvmrhJprsJej7YzJw3VQtf3cX1ZDShTJLv7PRT4cD+CYeQ09ODywMr3lvevlXdUz9q6vMQfwgGdcpYcqVFeiN2TZONAjvNvrDOHRXVFo+uBRCGZZcAPdCCx1ctczsPRnKOJXfu7yc57w+tn/ykxNXO7CunvlQq1XXlml+IiWhrNILqauVtzqFCr2o7v8Bwu/6dAFXBkF3DN8qY6Dt67NSbQ5HjT9cj2ySD9ar0PYBlENkKG89XbAL2mbrjv3exP9hYS82tzLSYTAXTZw1AbusIE1T7h4pa44JlNWSEMjJOWYZ+llrIc/4I0G7har0JhsErVM0FKiRKrMzFOAhsUwpXTNlVK0Blhwj3kDSl0sotY8XqhS3OTtJyBAyme0sTaseQgIzsKKFN6UEOshKO6wY2ezG9AdJtSjCjhTKknuKEikGjED7dDOFZhhWSXseUAC+KFJ+L5tldacCghNMcHPW1bzTrelyhzc5+ng6Nvdno6Qvh3D25p9y/jlmH0hfrnbvuzml/vstRWKn+FWCTDtZoTj7H/pblvfs/8tb5qW6crQrOi6mHs6NdHARKcShk9UXQdaulqItrEOaQvXxtUsiQrmSV6SQblfxXaqY7mjtu5W2wZ6+t7Fe7KGL6bUx9uwPlOHNVwL/tHJghyR1WscVv5RaCissf2uNNwFU+liW9QhuVioGA0KjKv2gJvQ5TSOnjIxY9pVGZDrmLHHwnPUkvI/9vzYaFuoIpwzvO1TICxGqGIbvXOszp8Claf5KsYCKRU3/pzkmTeKhZwro9FwPWny4PAXQgLFsuwGNddhRqpmwcsl4H52xWJ3HowYwfOMwWO7qdY9tbEumb7FC+1mTDqlNwpFIZJ7U3bDag5Jl11r88QoFDfIz9WydYNdWRl6Kmyi3mFP1RpaqM1VvlLXQqTam4yYUHJq59pa1I3VmX9SKS8q9a2L96QIqk7eyzAFvwQSbCyGwVAx4H+LBct1nBcRZX5RHatsjIMPPuWb9l/thpJmfrP2/+vpIrV5hrIV91+Hiezq/JGeXtY1rSp8ClQtb4CmQp9SX/yK1W8fgpOfCYbs6MbDtrcgtsjunmQcy1mVd/a36s7+Vn3c/pZLl1RA/SFXA82Uzkr5yWfxibOx+pfODpf6bDBngnWcmZd37ffjV0p/+gp+L8LPJSv72VDtCv9RJK570ActStzKRDDVlVyKtki7EFeXWYpHWNTcMfeoBdZ69mtqAiyvY4SQPa/zc9QCa+yO4H7XC1UttaoiEGtH66g6NEoBxqkB3poUQHb6TVbXDGBUQz2JoOchSGYTOgIsXe1COUEKIEokjr39UgNxdUw9hupfVfUGolJvIMKrWpqF3kCECKc3gJeCR3ZYb+B7cY5+0DMH6XH/HntKGSNDKH2W5qPx2i3pVPa50ppTvJk1p3v+PSgQfCmWY9Ryiq557ginNoGTi2VdBfiB1zhePEtVWXYBO8XGAA5+uoCOGjnhL/x9VKuyblfgWKgiNmStvZvB+fmlYZGdLJ6mcP+vKykW7SZY1TuEdrckeLMAAk2gyBl9+CLGDAZzTir3l9TggPYhgruJslGA+qB65hVBzcqc6/3pxeUGCwcS3d6Awg21ELnPXqodVG2/rGd/K1XVYZkn7PsUYrVFzecCbMf9elAwWJ+rp1pSG6gF1Q33dYWEld+5XBHrKu7KPTVdpTl4bKhX6MfN3r6PP/G657xp7fMXD7RfRtb5e/xetjXktuqN+Tkuy159i7RECrO/Qy4l9ABp9vd4NyshJUBtXbN1brXw6D8GWiXAY+yHsvvkC+A1BgA+wsPV8/w9ld7trfQOYwr4qcCawst65/n7pGrtE0rYnX3ZlBlBDCdN1dZ9BfFKsHbqsUmkWBs6rQNN7laSl8eTW5XkrJpMJXTx+9zsq+YUc80b1q9wNMoZmZoQC6p2cgoWXxhVsMCBrHW57xQsnj6uYHFRJXnveHKtkhyOWYlyDXyTV964yL6GxjhPFQFcLchkMikcCzxS33khBUXNZPJcpqdaWwdUg2EdoJF+AT8MeahGbijUzIWcBoLqcQD5x30Q3B4F4bVY7yq78qqLkTIanhhK3wxc6IY7sYQBFjNr/pFFNDGyWuOuqhC3nn1RiDFrD+E52Pf3F/zzN55yzj9evCY2ZI+480/roeHW7HXIeQSnmeOWYgMFgfH/4WZoEVU8gdQVvpWmCdOeiEdNb7i/m/bTq/azQaN9axy3b41H0LfI+uZIgA0JaYecb446stWBBR6wYKSf4NcVJ76te4pNjvS1SHpFXagEB9CncUw9GHkVu4puIRbDYYXq52GeoDLf3RS5sogvrGUOBh5VNxMUi1Z8BLZ8Fz98lFaxNsjpKJogZe57/Aa6BzoPfxJdCRGH5hBSn2sSmlPTPCJ2eYAreRH3AtqtdnH9B5Wv8YdKOOfG5ppQW5y7x6tFvJF7xpxLZ8iFmE8xxt7d2RlSSNDLBoOcf6p6MOQ9Wza/sqrqFoq8itlBTxMG5B3Z92sfuurOL/+3v+VzsB+Qf7/m9BBErrnOJ5yLq7D88Bw5c9TUvbceXd+3tObx/9/DazRfpxEBml+1/6yVkGeR6PNcs38Ep5xjeGIbCuSlEHo6nu7qMNoWJ8NxnAwJUqjw1jFU9AGXK3tDDZpUcQ6ZpdHRqZpDfL+qRinLkZUqWHMO+h/O3mDduMK3pfN7BnN4G9bRmR79UjDJHNDhQSc1hap1Wc1chOhXcOQhVTSolAuflMEkA2OoTNlhtXoWIkoMJOo1GB9mzIHgxkFGqD6DvSEtTOCSKLT9o3XA2MoDo0UbOhtY2PkG0bjrrnHDcsZCW8SbY5iWqw+ZluPYSE3LYayprkbfxCCxbNFE4zypiPY9nGl4eshVHzc3F8HYHEoKK8bmImtsDoULS3NYFbFx6bqBxU3uwLjaY/Kd1vjmLYgqBuhCMUBXt7r6dQqdrj62YNpc3eSAgFFDt0ChfbhNUkDqZye7r+Kwtq7KLpG1GqYeQp3puTvUW+31vtesoIY7tDdn9verCXula6tFlH1dIjAiVmF3GU5RMeq6U88T1WVuqF59U21zQ6yLQp5fiLJyy5oRSCQ65bIFlqmNx85YMvETkZDsjV6TMcq+kS79Nd0JB6KcJp6ASjVfRI7GOLy8fnuS8tS2crPWddFLrDjfq6iQo4cRHnvQX4jMr5bDCqDDKoXYLWX/BOBgUIe2J8rLJ9g74I5LX8z8YqACVXPOG1os5GbnionlOc2RpxyzayimBfU2jelztdjZrpikNleI+GLKmv7g9qaqXT61kXdG6IfIjmPKKBqiIB1DQBy4Vb+afwBgahljE/kMbvqp8fQZDN0sD0nl2FJFQS6iw62bgevVysWoIzhoXcs7qa0po84At98r+uE0TbMVy8CZHNvNIHmGpmTIBdJNGDRD0+YY/Ud7Os+NWShFY7D6JCMSPb+Iq32XjZcloEXHVeqCV/YKB0dyQV4+tKqOuAJbAAu8uh/kWfeF+aJUmUf6jbIpRcfc5M3MR9HVlS+61EFLpEztmfFyXmzB+HYpA6gWAbFFxGe5GrVnMM7lM7QlnwoA8UWB9BogPcBgly9rAkjAfcaeBusoDN3HhN6Mkn9f170qL4IxzZyOU8XdG8dz+9YxtNxaj7ZIq/SwvSONcCdT1eP1GFXHetN2pB4hscXiaC2LR2wtNbytVa8IT6j2MGVHBuMVoq9ztEVsKk7rLFrqR3yo0lOEX9aJNEsB6N1Wbs+SrBV1sY20hOvuEUK9PpcMy6OcY4sk0RKMy2zbn29H6JqcCFYQcLs3px6HQg4VjJ87+G8n1o4Jt9FP4bvjl1NIeGJ12Uo70LgiUlFAyISIEM44fAX3Y6f0Q2KKU+gUmK84lSSzfT2N27eN22cuSU5TogWKTbirRaal4SvkSHCa+5EAN4tI8sWSdrnk0/BeyTdLkTlKAIrBnM8ujktG4k5XagmlBQgkZIc2Q6flp6g8Ra7Un0KnV01d8fsufqcYiTZ2RizNgKhqYeqvAKSJTs1PIWCw1TbcZq+aEAaloALA0M5qV7hM7a/2hl/Veo90Ma926KQaj8bysLnmP+SWp7Q9x60/Rptnyn6/x30JZYwi13g3cohznVBsGOpErzKGoYxhXJZzOZdjRrZaDq8PY+V8+47xkjIAO7B73EE7YdV4J22xzq2XMPANhsHCqsy+WbVdTz0114Juc3nLqlojWq8VEwOwiai6lPyFzkNR56W4anekIxeeYGxJbUvTDNcN2KzIwgaqo6fLtqkLeFug0pjlHNrYpjnwdnND0qdW6Qe7RXokMJSclsnpWLLCzvAglKwa5oOYH2Eqi3i4V8ZN/BkZRWFJVvDOS750OBrWXIpoBkORGNq5ooyBqaZSQyrF5dz/DbADVbsF8+ANrwD8bZzjFGimx6s8r2nzzl903qUpVJnHlSFBy8RKUae6hmdm/a4Sebd+Y5BKkk9TNIvT6/lK8rzlLfTyt7J9s2juVdJmXIjbOJy9Vhb7Jbuog3HISVGeUWzWXg3cYinOLCDBc4yTEALBn+O/rZBLyfqC9QJ7gy0YyR42OXKzb3RRUTReJhZB78SioXDcHoBO7KAlRe1ttDOfKvXeZ/HFtnKCMgBwEDzLoz2loyvrInXcpfQRdmAG8AIqA2DTAFh1wlEPcT2ZdsUOjdMGyjygpTyWZkyjGTMUrUgX8ZzW7U5E02MLcbGSz9FWlLiVyM6OLSWSb5k0BwAJTQ6RfNXkOXBWZQ7kORTh8YVB1BxDMWPxdaqCrxMRdWoios58CxB1Bog6M4KoSkuqiKpdCKUfQ4g6rYhaGAyddhgKprIoMXQHFQZDl/qMlPxHFkPB88yh8LnjY6gO9FZaXsm3K0C3GM5mC+2kaYuh279lGLpUwdBpg6E7gKE7EbdT47SBqh0/nc9IM3boOQb6BzXDHRY9l6QmlDFU0zJilolQKlFR0vASS+cmYWleJudjyZP3mLX+RbLH1CvIutM0Z0U6Mju5WHxSgDbIATvDF0WprxOen/06Dy0wmnaKisesm5HbmGxMiVuS2X4HS9mK0HYLFooA9OHNIMx8RVVIJNTDdnwWC+9sZYlTgOxU8cZOdHZndUqiILsFbzdw9q5/kWgVepMclOFE9Vm6TVM4nQtBaV17y9O2Ud11w7N+3sTjuXmqhtUbxzmUbLI/h4pNIfOdi5HtdVVcKwds+VTplnlqQ5ifIqsIJPNpadHUsBAX/lqGhbhV3SeAfQbeO/mn0r42dUSIO6PV5W10qUJRqGOFuJ3jC3Gx+WPnm06I26b2pkLcDgtx2yllbrdWCm8HNK0f6vnB2hplo26rj2DrVtkk7t4LKe54r2sgu1kZzxe8vJOARzYEjxnAo+pLJ7PwyI4Pj4yyk4dHxvCYqciQO2TZmuToAI1qj4mUAb+UAigxg0XcHAX1FG4IxWIcBDGKZ5WzAASGkInZuCpIHyrg2v9qgGtXAOdpJZRVTwPaRyZC0DZUjeeuFYwrwCPiJ83Y0wBv/DTAowznEKOnAQwOwOXK3lCDJg5di6cYtCYHPOrHIQXuTK1NUeVILSO/ckiK+VvFnIw6tvHt8cZn1ObGtzc7XtsU1Wro2xrTSSF4pZq00etuVO2RiXNeJERrVLfxGcc3XR8oGsCGGxd4NbilUpfrov0qhocphBrofqXfchNLRfG40aR0+vkFE8h2qc8y4O5x2hTFq/td/Dka33aW2aqoW96d4fas4U3/aRV7Lu3hPHCWQqd9oWzAcJsRaD1ftoVVb413h15UORD39Qs9hqkOtfXQX0T2OK1K7mM9yBg7s/MexpldOH5mF1ZmaWhnaXj8WcqNPfkzu1DO7CiaSO5j8ofIfTRO7kP1ubkJufcrx9KayZH7E8MjqsJDz52iCjwiC4/o+PCIKDp5eES4BDDkwzaokvuJJ4h+qidrFTWF9108ePaQWsg/b6YWgpQTq4Ug00mrhfzzSaqF3OR7jXHFGp0HSWGtzvF0UO9OIqG3B2nG9FSMHAnhQjjO1WBFkf/Kc7Wgeq5Wd+dqCYXoXlxeonaVRVzZflNu3tB7MWpxKVT+3IeTPVFm8+VAstBjR+vEtSEmWClCBnmE8kCaOS5Dy60i6YQDsh8Rgxyb2/xzhrdwSG3OA0M9D4wElSN3VurOAis2/w556r/XN75cAvGzqS+5qDqggbWqC0bVQ6qIuj3jBVXyKuaQ5/wIquK2y1+xPBfiMXTfJki/S7pmbB6pbqecB1rREdSspEIXsTwSkf5mEICZDybQ1CKYpGmEpofoqbdaeMzeP3RKir1iDMoRT6QcsaOk/0qUY5L2Q/QwtB9gydGifXxc7YdokvZDjOlwctoPVdr17PQLzbihFnqvHbHRG1W9ON074pPpM84nkybJ5LkHQbPHjfuSx/rfYsmz+lqyx6Zql6JdZsjrWtP9IzV9ydV0v6vpa1ITJgn3G7fisOndpc3Ss9Ykb8r9cBywYo/cojoele3IFAXQKTDCm+T0gM4PCCGjiZlpWO/VgCPf5R/yi0xFCBmlKyYtgccDUcDvo7HYgj4g9HiapiBO40GZKk2Ak9gyb1Abx9odzMjO6FHYFLrlmWa3+3qKG+TNKtS0sxX4UqZil2aqtLyFMehQNEGfeUasakeEJ5lnZp4yPLg59UzUUd0bT+MCTJInABoulOWpMoAAElva4J5Boo5ON/CYhQTqKtHCSkCyE/WW7Gy9pxJLHVyTgvCHa0hRNaUcg8d+OLalVK3kokZbLP9d1cunSxUBALHBpYicUSRHcLXu2gZwT1NdPr+yqMPD+iwitIxq29DyfA4AhIMpgI8eIbCa/4rAav4bAGueYoJpAwHaHGUEZjz7TVjRyR7USeB4+HmaPlLM0VwZw0ft0+vlxoqm9/2nr97/m9uf/4seN3kWwMWcu9cvxYbOkBGkmQJlty3jvrozfBF30uxaGUOzR9YBNJGK0fTwhiOo1a5+MvN64u3rTv/ZSogTVUdqGnxA++douu9l30DHuG7k4VcxnyO7fyz/6sPA+oyH6K/cfpwZ98Qgev3aOvvOs6Q2dDeEwknbGPXu78FHNDNUV1zDI0A8hsw1rihFpQYIRVN0cYp0UhGCFi0jQ5TOMTVCy8wd+TTvGDIzZaSKq5AnzqikkYV+OTruX6paFvy3KLZ0uijHudKZoQX4rZETkXmB/5YVFjL7eYi8/NfjCrr5MoX8pU/L0qqttES9fgKBsZSWb+faCJJpWem30TL8kxSh3q8MD4UciRfilwP6oofi9wXyoqfldwe0VSuA44c8N5r828GELtOyHE3mFMMYjfGfMO44QdG876kA+BrpBVE750JE4gymukdduDkIaVpuewpudTmofd+Kt/35Nv5wO3ecpEfwJrV95WF2yica6xSg9tD7RYT2E20Hum43h+fUoUUZle0VgLkKpPhl4A1Celg8WuwCil2gOYVYIl7n5hRiHcYT9cvDjynK8F2m23qpvAUzKoXVw99W3VaCt6ViB+0YrMuh2FZHak/RC9FdPqrI2yI3BqKSdoALa7dxCo2rh0eKU+nUQX6a+3YHdQXPWrLWFttXaCedRjuQOztS7KJdTBNOH9Zi4RJJ1As486mcoSRZdDqdXr5c2VvH5+ZLOjpwIkBrWkm2EDtcNDdmGcR5WWBxSiXhFHNM5jQcmlSX9opf3lAPaaTEZe7KdhTcAnHeIXuEHRU9Ra0B+0ItqAH9Rvm80O8SROQoqDiJEvTIqWsZurOg3w3sbzD/orSBMEcEHxH0NRJeUDQSQXFapOlzlPafu1KcQV10j88Mz8R262ng4y57QX6WWpg/m1O7q/kWmoaR/RCuds4RYwP5Y7DIcurL+HACSJDJ0CYoa7fOtix/rE6n/HEUU0EmulbkmHm+nXnF4zH3uAsTFHXOxUzkJELgGAL49igC+OoO95X7p+Wv2cyHPJBQhtlZoMWPpcdCXecJ9Dh6HALn0dm8rJ7JE+UcpsCPyWeV3grAnIWAFKeNyvLxYbQQp2VLDJYxo9XlTS4zfztiNcikSoeRMIx366TtMKmaYQI8JWLPDEIGzB/apmUqOUGh55XEgAxxoWWth7Yjwrn2QZ344glEHLCZx7Mtoz24c0QYS22P1L3V9Uer1nZ8q+umrUAonmt4bKM2kKndh/hDJkzbuCuh+X8z0GzTWnOSCqFfYIj11pJI5zl/THjVMqVSyqurAJnOEjpLeBBtA5lhxTX1RaY+lmRuMhgi+H/KyfYYX2l/AaUlaisy6sr0eFk0H2dXKLTE+I/KaZtbl+jx0uTRXmPl2A50psfmOWRktB1NVdN42jhwIWXbFjADOOib5nnG/xnIIT/XPOUptgJ0/JEC6PG0bHyj2mnBH8v7uXQumoLmoVUKuu1mZV1Sbb6RhXUrmtzmuu7ztA3HTBvu0DbgVqZ0iTMCp2SdxKguWKSbB7swTx08OjSDx4zyELPkYU1mI1gikpNrtUwNS6XYRQaL+NqgxXwZPOkYOQGgJlMkZTyE9JmAMhy5MhsVEtPGiCq+hRzcLstCm5ZNOhPfktpkgKWCDWAh5v+WhQGCpQUSlRwOdPMlS2loKV/gssJiCUUpt6RVLSu2SZUkVZ5HyxZ5WL8A+bVeCkewKKQnSNYMWTU5K5MzZeiAEQSPfdw07gnXulUQjRZGGxKahiwfpyH95z4abVkGmFxblkB+Qkd+IBk9Sfi0TbOSRx9EWjtp7XZiubleJUJbT4IIbVNeEVPDz7dyTST9VNeTI3XpnM/5k3xJDMOEm1KdbRWqQyegOiAzI5RHqc4S4oC/SzRXaV8X2f+vIkTKvgupyUN++DyKcIhHntWuXCaP0XBTWuIoBwJpSRsKoukhAkEmX2ZJ1bkgVUqzpvLtShaIeUDZwDH+wsMONEa5ivw8CVCe48lV5edLIGM4TglZYqhRLsqtFvP30Hk60MV5Ei+RF1CukVzSE/i/xyNpD51vcp6P1ws4Vl65cLCZWIkwH7cr90sxZ5fuKueX8dP27zwBCKC2XWUJT9BmoljiBiSF7YDWYMs5V7unM1K7bDNwcHjD52aZTo4Tz7RU6sYnw1RN8Vd33tj08XiEji1ZHqEbShiA2L4iE/F0eRw1uZx6HiqB0ALJzIatx5kNbiY81s2EEWSn0Y0sx22VnI9nyOsceaydI9t0DmjzyMyFrceZCzoPUopkN6BelnVnqy+H8JJBMxsiuMalxkdYQ423BS/qBy/Ie5RS16yEuY9CdRsiQpMly0oRLBVhStgd/VG/stc/Zl8I2GBfdmPk/Ye5gkcMjRhCFudDUvBEoIOAgpvyySICf5KcgfIJOadl0SIor8qSnlJYbB+VVDg0VYyzDbAlT0a58cpSIrfgjrVvvHBUevKlb89Jp7k9PrUHkinm7aPcl0cwo7UAhkYVCDrh3Ahv1ihb/HEhsVW9jPtiiEJf1vBC5uUQXjLzcgAvapWNZ9826j0tDzEXsT0IzTG2sRBULONxSQFbPeNonefMxYIUQLihy/EE3H98nnNvc93M85Ke4lmACDAl+CdQBKXtamrQnr4sy7JG22VJq4iB1Iuo7ugMlHdg/lU1/3dU+INyVwIwG7OR/El6keddW1pfCik4LF741gYUQaR0xeGBOFbwCk50B7WD7ADM16fvxvVj76WAzZd8PWZurFAdsheOYhrAb7F5uxdvRaNybrmuJwl1qjshea/A14q/8tk9Pn7XuPRVsebow8zwitzdrH0XPqG6mo17L4wTS8wP9/b45dE2jojzmrNvn6b/EviBc2Zxh7ONaLU0P2N9WQAu2fXoadsTg49wtGv9Xcid49rpwUEfR3Ac5OG8X+muvtwrFBnZ5RAu0ovikVqAdudwaGKXNQVuwxBAeg/jQzeblxryr+pV2Zs4Dk0g9O0mfwUOLtBoNRZ0u5+9HC11RuhvwCvT/bK5aAeeYfZ1yOC1PSLBxwkC+TBvwsX+MxILLeOjqAIffsJT/3g1NcElxs745SeR7qq8EVUizfkEcfVpC0KerEnpH8Qoonyh1DekvThXjnWodeRXNwYD3LC5tbW6IfqtOkLXOG8j42Olr6/AK0OYB9kgPCw/XUuBaNEWMR5XDIo6IzuCzxqs4TMEr+ZgKM01BiEprqis1UsXJoOKeloZXruILZEu2za9Eo0w4Vch3PfYkVpw3ZgzFee55KB+Io4bVINF/SDkgd5jDyv+UTBn4dcWH67CSfEz0mONUHzuOOPG93mVO9SwE/MlT0+u7x6UJ9dHDyNovOn0xWbUoTWJ2sRS6JqmqmnQSvgownoQflMZDO7S4JAvnWOVr+6thO/XMAyi3WaD3JojZfBuF3tQYm/WNHG8oyfv2rVUu3mf66a06x68azZNkqK+VPni0PrQF8HB9U1Agea60uQzN6fv9eycZpjfY154LMs5fbfGgTh6YweGBVvo+gtPLbbCfCfg8Ud4bnhKBO72lAhUKNEdXpUUrXlVWnTIOz4xuhk2B6Wzm5uHfbExAftc83yWsbX1Wxfnzmqt2rjlGoZ7ltdLw1x5DCDVxaY+xeq7p6izAtDliN73+r/9tbV/+p21Jz/nwtrTKdh8GWB/jkiGJTGYdP8jj2MukuBfILhHgscQPBdBHAPBihiCX0LsLgluILhTgncjSAiqWbJlCd6Fz7pKJvNYa8zcp3OuxparMXGfgs8NGCHEfkH2aszuPFF7tSiOyU1ex+PFeaO6lDKpT9xSym+wPtA4gqtCFMOHqgIYSYXv1tX6OvnG1Wp1XY11XQ3OZpxSulylsQYjmMeBN0PVzDnDr71/8F6spT4WUb/i0UwR6X5fZTv4Qgicgk1JiXYe3drwUPCXvOw16LkxWqzfm4060n+o0IXE2HiENfzyIsYnE0PRghNStENvKSfufetjFO3om49H0Y5pKiF8dyV8H8JKOT6qQZklvzhO0Q5InH51cyV8u4Yxgz+GEhDk1misEDcX3JDgnRpRpWjomqVPa66bSmnxrtk0SYq6rfLF0eEvgg15n0zRbnel4bN/XxRN2EBgdkWFz1E5GO8cpWuxo2t1gCpWulZXugaqdgIihjmk0Hj6/3n07LVCz2IyhjSfBT0vRSD4YEZASFxRV4pXJKTE7gg4f0rYPn9s6MPrUFKFtAyTFczniWTl9ccnK+ru9xGSlYNvL2fPvW8ZIysbtx+PrNypqWpVvRK+F2Gdvh8og8GBt46TlfsrXx3SdAmvaRiI89HbHQHRWOGOXPAOCR7ViCpZQdcskbgZ4QpZeZ28I5smaVE3Vb7YGP4iuEPeJ5OVNVcaPvsOWfkOWdmcrPzkBLIiCITAOxA4WbLyU8clK5jPE8nKoYdLVm6OWcAQlf4qR0nKtWaqHS4nzoFbOZj9NOpb0ukhiW56vLgyO144PjmuHpobhT8yO8ILa//dIf6zqnh/SRXt9xwf6/dye2CxVrxCHnq5wGwPzys0W6fDbkW2x6BQQKS2ot45reCoev2nNzBoXMTODSdMEaNQ87mbtLERFPwZ8pD6aNrjbrEUsTVfdBG5ILRTu4qGewXLHsOw+n4J/T3w7XLjBwpGVxF6AJGXSDDj0D6E0AqdLOg7Jsswfidl9pYrOCwLrlGsHQqynxF8rvf580MY7zxG8IAEEwQPSrCBru3Om2Yj4FfFaXhrigFMbAEaV/Z0L9DcfC8Qb74XABZfVfjGkFeIUb0ZLcDbc/FzlShjxipk25TMoJhrs5vMFAv42zE+3l2o/sVo2Iz13c7pUmV+ggJ5zrFvIKIIf1NKu+Zb/yQ2cJQDwhQb6nebPLmQQJ93a3pwF55DAglbwr02cL/59CA+vTlwzn0l9gOeVvQePNVbMD7DCuEm3KGhlebA0Epz9fGn3IstCYBMcLclArESZyECsRIBJdJqTYKfu9zMiUCznWCRxuWKy9r2TGHV0p4lo46hUCiZodFpIXbrTKWA0nsk4Wb8Zj87QnLV7JraXi6/1pJ2CdW9gnwluMbG2hjBPUshFClamcibvRJuvNnxqlYLNMN7qhk2hjJoA6y/Y/SjdKZ0p+/jvv+oQUi9CfdJtSeZ/fyr+AlxMJovTmu7RTSgcL2Iy3uG/PZGLEdrRf1Ka1l/PXsD7rTclv0sHoMi4ch4QMk61SvWXtcgIanxrD37u5a/+JfnLbGLm3IGI9p5cHTfPBCwgvV5PuAeqfcUtCYkU3c4Xncs1zApHq07RN2hrftibr6ru7553X1fiZ+7vvoHfqzmC9V2gr/XeYLIbgYAi4D4lpUHepMVIUhVhNuqesuOVfp3MXz4QfseeOuX/+QZP3o50/oGEiVrE0lduAICDYT8H0QRyS0sLeX6UFplRlLCl1F6Ay7mKmOUBeQUg2Zzkwte2dt0aQENxWEYdNTRjN1cvS0yxGSrozXr2c8A0m98gMkye+sn/rukV7Qwv1pU/x5c5I4pwvi0cLSWZa+HGUhgmTqvJj/7ScSIi9AvBn7kZLrH+L5T4qxAfo3zgh6XhhtDOHbBW0qJYSN2mvsBaABpmCt2hED8fMJhT3XqZ5TAkBN/0tKQUAcQpgRzN6QEZKBB/Bnk13F2543GLn1V/qemNb/rm9+87pvqOuMBu5o0yV/FFYyhVSW7BcixhAbdDW8vQ3YC2uq0TW4BOLyEKwv8ZLiXBvu0nQGe2eEi4/mFlO7hIoaFwTUxiEEcvUYpj1x5xhVzTMWOzhFqr3N1MfEfY0J2q8x4OZs4ECibTrHU6y5kSIH42cOXwc2qLV1fN8dawOuaook6C6lQpIQH9WRmzj88pJnznZnzf+Y55U1RFOk1x5f+q0/6pJz0YTnpa+MT3s72vKVTOg+17/mUAiPvUKK8RTJRIFAjpSQttKme/SPw2hIE7kmCngTm9mUi/nwUTTrUXKUphbA/tm2mQPQKfKU2mKEC9owyiQHY3QVjlWzXAfa6WO0DNHBLy4TgjwUvxv+Lm60noE0zBBuxLRClVoUozVqiNAei1DJEaRZECXe/aM4QpeduQpRmRonSPw0RpaYhSq0xonS1lOqIkoDL0aVW6UeiZfxIPAy69PqDD4kufYcu/aQHT0aPNlUiHwpjgMyNsh+h+on2cIlu4NJPh6GSnG97ghMagtN6eAQnVILzGfSaUgFXKuACyRFSU+VdAse74OJop+RZ/FWFX13hpyQjU2JVKzyx4We8Q5004ZjmBmbj3MyMJRyzVW5mBoRDHODPnoBwTI8Sjv/9yirh8B03cwLCETwcbuarjOgv4dRdblsvkmSa6L1KtWhqhCcyepCA6etBzwRuNgHsuUVUfS2JHPxGT0u+3zzv1GQ4yhyWqW+YDPfZgo6ZAAYHPlOlqZ409SnX81cZywewTt8VIOV1mqKNikzg/tAE7uVA+mXfC8e9ChhVkF945SQ3d6HAcsibXui86YXj3vRcuqSCcXgIFYD7gB+97E3IrI7luC/ZYX0VN0owjm4PeX0lhJgakKyzGFR+7/Hw+6yV/cZpYljxmOfDY15XvMJYj3mKNjEepce8eMxjHnco+xP1mKc+DZEdO1Nu0ZDHvOp+8xu+mPdoXDu0Lv3cK4fXpVZlXSqFcEW9FMJhhVIZcmWRqssKhu8apQzPLlBFA9cS+ZnKerT5UhWapapu1pV6xeIHtuN1zE1diHT2t/I2AknREGMKCZkvsdhgkUvcIueCXESCBqfl6jaQlqKFbchYYQCLcyRlOiWVhRA2BxO7jKGDeLSpxY/xBS2ksLKgfd3zwa8apCe3diQY4WWVfN9+ePiQ6Ta8q9xbk2RevhnBtI9E1PYO1AEhpUTkDespr6H2VYAu5Fv+OqLmf+mp4kKiVzjDFfCF4PICYxyyIWcVwClfVa3k9rzucrHg4MACoa5gI5ch4lAPYGdLONnPK8F3/ho+HcV6mKj2ZSrrZ/M4jvpSJhbwyYdnl5qMyRAyicPG7I+Mk7TmLh+2lzXEKCFTRdfQZmUNxffUkjV0TkM4f5HL8jXM3D4GETWINYbsT2Sb3oFxsrp81id7Of/EpXI5Rzgd4AJeoXVNjgvVfR/5Wk/Mj4T9QEhNGRAPTFJAdZFcmtU3MbCHYht/B0iEe81zt3mSeWYjxu764oozznkPJUYr6jDfipDWXwc1C/iBWatO84tpBsK02q2oix9NqzqsrpsDmpJY8sVuRVPAnKIumuIYPPaL3dUpLJhaqS2W/9gIRBvlckpFW4ZbL9MOjcojaatrYSCO/gMp5MoigI3ZaURoSdUW1qQHONMAqWwJtwFrfdn/AiCrrqYJzpJhyu+wcBZrstO4mlqykF8gCOeBR0AqYq9wRAjpDPbK2n0g9MHr45TK2W7BM1Q2D6iI4u7ytFDEtqwBiuw30DZn8cJ3RDZwpFc0j68UU2DWA1VJY9WNVkAh0iuWN4Kq5Y1A17cuk1fRbQJ1GLaswUU4bojLXFejQv5EqxqdVE+MJibCoJaY3DB+ZtQkkFdCpJW9X1gr7Qxsw2o+0LfJkAgdJCKKpKcMDweB8IhC6AQQqMIAy2ygNqUeCSDyAFT9BZ5XccYTOssf6nqRWSPyno+L9OTBoTNsc3XRXlAHbrgSU4SUmAL7Vnhy8EegS6CmdwkpCB01fbPv+ZPcKVLN+gv18J16zUHsjRNj769Niv3SxNi7J8Z+YmLsnRNjL5oUudtF3uJYsp262Ranm7uqm20ziJXk5WqyMwbHqemFDCRrvWzIE2R2G6rSBE1VwzDefuMMMj3b84Y/remnhh/zkLv2MHM/S5tlnfEqGwhRTSA6EKVXcwhf1MRdVa7ik/fdeWC+IF2u1YlveoOHkktXyIFyrOAppeQAzfCzNasHr3woMDE7ovAw35XOjAN5RSe4QQHmRtWZMV64knDYmfFFDAveHhinvny8+TV1CapHgXr8wa1YFyLgo5LNXBcPXvnQXRf/P6jdGa1Dh7A6yMd4QWPVmZvHPz+qLxleMvPSxUtXXs6uETYR9DShAf/nuUX+WhLAEtwEZXrATq2jIVRaR9OwSAL6QqEhYPCyt8pYYft6u5iPxATH9s7Hhlanuo8uJtj+wbEaPz/GzzrS+Yn49/CzoQiOc5BgBfBp6txroiNNQVOMLRa41C65xtEQ+dlhoRk+lUkXjyQB21Ga4iO0ZBj9ErwRdO4Eg97hSf3ZX7orBUNp2duUCMlQFSYaQwxk46AhQHuLFh77ira2WsoopuD9UT8pIprCZ7Da4rqSp8Txcg2Kn7knzvojuBoSySSay/DWE9NUuB0PzDr8v1CTgp7yS4CRlgKQN7RDb5cZ3AIIWtS2nd6Xt6W5eQsNb9FDae7F35LmJps1NzUCE4XsWd8GkK0fD7Jn5W1p7rcPZONNIUs1qBT0ha5mb8JcQduu0tszz+UW+BABJbjgBO+n5KFIZja0QHVa4Ks6T6med50mvsNogWXD7qEd1XfuoSfEYp3QRXGqpm6g3yJaXunvTeRvFKb3eJXV/15vePkXCuRYiveppAb0aGLs0Ymx75kYe/sEFgqAnRR7z8TYu2oTWzYx9ujEEs6dlHXXWM7qcABSDs6DKA54Gx7LCYV37cSFAesmVsfsnbIAQ+cQkSEiM43MQ9WDuXyi2lEkTs8DwnM3BVhqaqpZh+UlEYfvGu5CyUeUwdQIt3hqM3JTMYVVR4xZXhOJaeCWx6UshYG5ZXUR0TSukJpqJlFICB7tH8lTTM0fbXvWcK4xmtjMp6gpn6jbLr07spr9slJ/V6lsFMRWOreEOVg1kk5p3/uxPLUyNNPuwojumrpeNNFc7LitN03pIJi15JkvENH3lFhfoBgAn6KaOWzAb/Yr5qqgGhKW8i+aONF9YVekrc6dV4taA2kLNc3mvs0bs85h3rzaBcMup4CPM3mGbXHV5BlK2sTkGeijKwiDkACc6tXTjaOM2ZSag1PD7g64SNOUCgEJ0g97ofUrYjzM+sJwoQIvMO+eWGWGeFdsNuviHwuZhPTyR/Uq79X8hXpW9fXKqu+YTdnFenI/WiuQkurCo9RJRaA/gmiK0FutniIoG4fCVxuLkK5UZOGCH3XPvXrcA46m6rn3va88vufejwV+xmpaSjSPeSo9+JgnHCuCG1ibaqIEFu8Xw999j+rYoeY8toyFeQNtQJJgsJz9qeEDXea0PGpz1mIK/JxBP/H67ImaVazC8cDZo3SfQitw9CuVlDNoW4ZFNK5Y2uoZN6M2HtM4416R2QlgCKct6+4M8ZMFLdXW5LMk0UeHq8vnED3WimJeoz82XEixkN0hdG+R5siGOUTzJrxAs2V4nkIR+k/jY87D3xxZo/kjIrbWQaQONWAXKjHGRRWRWohsUYos1jyWYWfTVwcRLDrHmBSTTk0qls7x1gLf/i4l1UDziulFmS15rBSa/CO3qK3xQCdy1T/AsIMvJ9cKDPscuDg5KbHMs5LrWNG9Luim3pFjnjzOd3KtJOpVt8Opa2dLbBDFMh8TYaLQXOPpqKHWEcR0fqFGOCCbhOwR2BRdWUz1ck6mtnBNbZpisZEaedE64xRiU1BbPV5puY5jEAD9lDyzmaiuqJ/0vHB8S+WcYSfaswAzB0JRT33Jww2AbwVhkiiLUvarus1FbNXRNH+fR3ZnF2G7p6bzlXLIBs5Pztf8slczBvKxEWvpvjKRh9tletm7lb0iv2oz/z2I/NeiWr92Aqp1EwO3an0eW+NBEYgT+7XDeYiS3UBBIIjoYR88VyrIgnVAY/0I1daF1g8bG65VtO2Rb22w7mICfM4xRwa69X8G5BKbehP4demTHpYgHgRREn3IMeBhjQBHsy+vpc9GaRPvAPkGjdQkIYBWTuYNQRMIEhAZSi3C+OHFxwsEi0kpFUmfKLUYIbTiHRPza6/Zz7mssAqt1KSWE37xtx2WDV7PvHr2DT27eqvv1U/Oy4R4ZndeJsKKlwmv4mfCG/UzITcM1M8E+uMmRoQaAooVnTAu5hwlQq2u6lhmTGhnTEixmTFIBsHw8UVLfU5IoXVBPZ09PoVaegyQRjp75BHiIWlm9ijRq8uEGp9GJw+q74Cqr2JTQx+ZEzQJivWJw/oK14aHxf0kLWrD3x94uX6PDCo/e4iy2X+ZaXlmbxRBdMZ/oYSdRZTZyrGt6rU3LggOzRKA4I6rcVB0cBbumwZ6NA3BPLj57E/FiHqKJOcaiTwIC4w1jaKVfQqZKBYm9CpuL7JH2ScQm7dS6Jzc3hR3rqFxY3n63gE117lOT29EtMnDZZMpPK4qOvuLDIz4tDvFFFx7XcTXPrgYuVnpyfljYx0aM9z6F0PiwM1fV6d9Xdhvh3rP04o5ABAsTj5Fs3mHpuFqkzoQaRjfJTChr4ahE/HVCi5i3t2MX6ZZylbQqim1VczO7/ENB4RaJirsxPnyQVDNTIIHEGwhqAcXIQdrusrNUJJ9YOiYL18wd0eiYkp7ytX1W8+j6WcacFogRzRTUSCsOo2fKfUbyAWv6q1jk3nQK11ZPYkPgha0rtzUBefmNSNUoQXVBuqoICihBr4/4GE3JjBvYpwz52Ge46/Wvs9yL1cleAjB5zowXCXB+ywYEpU41Pr8orMh+6Awf1OqWpC4QkJXdDX7hyR7B4c3ARgfiBWArtpWtDChDr8AqevZh5Fb0QZT9d6QrZnyYNfZWto1RZdYdHD9UIavcYYt5BK6oj8Wis5cWDrI6Yqb2F0+mr2o7hq6BrU6jFhu2R/2iTMlaDccp4hn0dDhH3myUfDzKRAOEdB1dPcn/cTvodn1fTdPa02DPCJOF36Rn+J7GqUyyzkvLCf8a3JMbFjOGI5BUB9YznmKe0UHtSogMn7c9sXrj975qq+/8WVAjRI8ByLYTZ/SigqfMOjZUYGxou68QeUlPW3o8gzfcOZ0xCbVIO9RIpKKZUogUNkq2hlijs+TXdE8kzqwJrFsrOqIfY/EhoidRaw67eeAEA7smSS62M5NYhPdkANhaxRL5CzHFLRSADfsses3eOOtQhGu/ebZFbIQn6LtdqPHRMMEFdy0SFuyj0hvYzhtuX0WsIrFU8vNs6LklglSpEDm04MMyRwyJvdqSpZsC0++QZ1HoUHbbIMQ0gYF2qC6bVDnoYGp7lrVebit2mpbhdBQq2YrYJo6mQbFDjbx5g2acg2aqjQohWt2bQlClbOlTtWHaFL12txywcgFGzD8Xprtr7hFZUWpXiFqKbpPH2Dz1uD3DO9reYMiWrgFW9kZCnR9WoOPYkwNmcm8DPVDK9Xv0rzZ9NOMLKe1clzcHOIPVMdXoYEe6GzRyVTEI8kBpQqwIiQPUMx+E0A7PMh+y8gOUpI7sQPCyrt2mPc7JmkGgsy7glyNkAV5TjWl9dTNPoocVZeP1KMcuiy30ALNVGgkkmZo4YiLQXXOWeOA/ysiMBhQ1ltb445DMiRqdYjF/dmEaVqLaah6CDaLG1R5wQu0gXZuCPUuo8C6QKFSbBFBxceQ5WnQ42mljMxQ2b3fW6LIMF8v8UoNsahyv7Bs81igln1QFZ/VcFoe6c3LInb3ZLF7e9ZEeXXdXPXGc49eqL3DM+9HbeCYDdztbrXKldAPyJM/8fV5wFyfvd8buT57n8l4u29KOmgDN+PTjYpKbWBVag+GuIYfOpVa06rIBO6wgTUEwoo30IjvVtr3A3vJBa/suYX0AWzrtceJKSjD64W1XeoDj0Q4X73Tntg77Xpxm70pk6eH6EBVBAEqv++pbhOM8kUruZEKnWt2nOXt5zODS9TW0548wmNvrrfDPxqBv9fqbtVyAKJK7BvL2He4WDkAQWxtNKZ/IFzJbtZdSWyutWqbLtcdgXzz/UMq2gFj30rJ6odktI+OpMfCYBqIOi6IK6WtoZG2Rk7aGhtpa112fknfo0SkrQ2R+edN1IAkJ2mFduKItHUKa3VnkrQ1prpKW0NqiSv8aETaGk6WtkI5b0UT8xl1fE3wfwV2Ho8ZmqasKm1NIJRFQLIoMbNXVIwOVaT4NKPaD1NAsun+6yJju+K39QtxS6Q70hkhsrPEz6PDDYV3qQEhBeS3M5qyxr/TeJmHLydQKj01Ef5ECmXJ7FjvhyVFyAHQdjbNMY2VYQZJxQzKzgDBGf6xrl9CnERk8HaTUcPc0VZC2UZkm1rI0rJu1tNRqWL6h9bNqAhUlbbjRVz6jbscRa5gLNfm7kcnfnBSrkjxYTjy4Um4Jf3ricr9WpkUCh3b30GpUDa3utlfLg1dJnttbet6QW0N71DprEAjROc4BDlpgKLDIhwuHFrNJyo+HineIxiUjADEiEJTi99C/8I8FDUFACy2AAsoVpAV8UjlEcTTJ25ANNyAIoJ+I9gtDqCiUegOC6MX0sicC3jyDPB0pGn3/qJhMxO32YoMHTPwxgcCALOp+jtdsaGxWqR94jgrK+jvXCH3chFUC+Lsq2bbFmOK4KAgVwVo2OreyMOSW8vegOpBySCFp+aG04PAFfzsVtwYu8CZGm6CO+AfmSQqeuhY+VkmdcE72rTWNdPHCU8nnwv22qbM4q699wJuAs1xk2bQHpwlQM8YEzfErLXnlabOFupsSYVMUOC3aBZAmSUczTixRUcd8hVytlu0VXjBD2m2Sm/yUGoKq3Wg8LYdxkZVfXwXNSjFpbAGdXDfBysnCGgD6heRaqHn8/w6UH3yOYiN5JgRhEalH5o54UdmtMmXRLFSfDnhZzcEHwUPq3C73LjOZb3sTqdtuZtTWqvsMwASwgXVmJPSKAYqZOofNvfUf59QzEyRAbRWRmNOUD9vYeSnMCSOG1wMxtg1OO/r0RQkS4tGftXYC9/RLfiOqnr0VGAqb1PBmimDNYMKlMPK+U1oYA62vkVzIL2LleRFO7oxRtd1hxs+3Vf8Kmb257MCDIoFueV+nvZTDzIzrnPO4hboPA9+ddBpdgix4PUey8MckhnH0IBpbUAqhRZNFUw25bqAY0MYpEVk/WfrEIz41w0pHvGv62BhRBbhIJ+qQqgIjX/dKVNyOOpfNzhJz7qh86wbUnhcz7qhc2RbutM12tubedMNpbsBU9qqbNU4051SZ7rFIi2uVRzqTolD3alRh7rcf5oC/5aHxqFtUw+02tSQ3YyqSYNKrAr2q6xK8zRdnkPIo+Y8hrKpMKecOHWzvHUFLTLVirZUUzWn0bOVMgLblS3SMI2SoK04Ub3sYgkXSdC8BPVOynU/5+pRs5KlhC1NALS6LUMhxTLjn5kBy2xlZ38+I/46ChZLs7IL9YD47NwRj0RvvAGLr+HKt3JAZ0dCvrj4uKYA9kvmghGf5wLmYEaphGbV92SmOjHGP4ig/yxDSzz151Mtr+pB1yF0SBkY0SlRqTuCwWwrtZ3jpYVHeWqNojVnL5vCWwY0p7waaHWmszJDe2bxmKUmjMg31eMjJSQaqzN4zJAPRR+fUryldtIuV9aERBjefTfc+XvP2/1f7zHru1KZbVSnxUG+vcTcOy4aaFhbVvCkJCU2oouUU+hkenlBTcgodnCGlz5N3NC87NKKl0S4YYQ2jJIoqMxDtqD+WTIyNsIvyX5PGTcwMwmviYXPEKo0MUCuGz0df+6kErllvF+RT+Px/fmMlJQ3dajUIQT/7kDHefWlHSKyj8UOwAz60RbWGA7slDL2E5DaUAgkTQ3KcSjmMC6TzJ+1epJ5wCAy9+9RWVuX72b1G5TmlI9mQY6phVFqqcMD0RZZRI2L7gZQHg3hlqpo+brlGpZiTFMT/pbKltlU7lUPEiLuGNopiARspNbGurQZO8VbKTRKHBBSQQQ1JYjNDfSBfabRHdXSRDuZ4srXoFTIr2Q9pUxzZgJWykUFh18NTIupK4tWL89QPHEgdHzHi3UNTOVTPZxYhZdFePMBbugO2gmRBsSOQzFGgzy0ZKFVSuWbSgNQe+jG4hZYRNqcnapVsRqMrbmWT2Fpl+2QVzTNFWviyrkF2M1NHRZCsDYwaMA9TpT5AoEtAK21gYjNnDDr6BoIwGBI1DWQVq5xzi6MPq2p1ni+SB7GRjU2VAut0d9d2j71WRliXKGj+7zLysvCJO/YcYhPpR5Mael+wFeRJ0JW5EkBJnMwZCMaHzLJMfoVeNsPUXEELbcTFvNcLcYc93cQ0AsPkO6amOz3lcfjyLd/8m2frMkBs+uQND/QfY5H/Mfny2/jfKiFH2dc2sv+AAWUDXz4rcs+pge7n48aotZndilxdadywN9f1BX89uzMJ3+QJ0J0IrShgUetgEqUm6dVhSG5CO0GH0u71cMkTy9fbOQdveaSsUuYfBrhG718Rk7NxTPnXKU8qGc9LZ93MfANVodvxdgIWOo4j6MIZ2Wz/BBqANFHU1/WYKxjwL9OxdIF+S5xKjJmWB1IWewLd738d2XvAb9o4ASULzdq6Yycv34EZa0N+a61V3cjuZruXNBExs94jBbi+xnKpN0c5n4KmdcaYC4xw6vuXrTMRMsMUSYpcRJdpHkgOOaOVoHitSKKuDhY3HBNBiQEqOKAGK+bNpgWeVywF8C8GIGrXAahBZywtigta1M5fmukHHDNsg7Icxa8NlYZUT/Vg9iEDwPyFC8tVXtLZfom1cuMoj7LPyAtxQJxxSwVP8wxKpSnlhOdi0r0YA2WOdHi0o/G1zwft5xV/GY1L8kfPhhQDQwjnPOG04poWAIVDr3qV3eNlQirAbfC45VektRsR8cLZ/jfWkTEDwjmKZQnbN0x1XAVV4KMqeD2K83QoCbqt2vpfzLmWg4p1QSpq5FXtYIHU7HkM62swYxj4QNh+CdxeUTRi2obBT/XCrwc4ZJvj7z6sFaYClrszdYQvXItwt1Tb0OORQES3UsM3BYhr6ua1cg+yidvZB/lrn2qD36hR+RXcMU3+6hEK8n90X1UpAknuZvy3W7KJ/+4uyk/pdgRg3JDNcDJo1vR19Yods3VthzJI+m/s8QIpBrrNUCSSCaNfw6zeCcBj3gIHomICCrwiC084uPDI6b45OERMzwSt7ukiCxKJUcHaJQ/vu/xxdLNgLtguPdz9wqjvFHY/nyNm+u7yY5iBmiTYDcwjrsOMxgDmWBM2DbW05981LUoE3Nd8HRfdHsDzlbRp/z4CfQp/ykI4uvq126mcBiUioxeP1gFNyDeSYn/+GQi0p2DyPbqEIzsz5PKmaxDhqYLppBCD+nwkkuldH1QNB280wqkUwdpXFgApNvkE/9d2UPE2gBWDSx4VJ3fsutzewecpbEGVSwxxrEmvIA6u1S5VShSBNeSkJd/3gytc03uNJpbxOyjxE3he1RbTIk2DzacvDRgCalRx9aFGp5hakgoXBFDojFf8s5GqssmV5dt2PraZX1tqQ8SQVNHi2PzFuJQPRZBjAelZel6n0x0Ce1t3PQUucUoBq+NDT7dJGINANMmCn/pTwWb6TK7G8qBVUmGFDFijtXxxRoXXmbiIn5d7UMTFdeRruY3Dsp6VVGEDVQRtuVDTe9TzHB6LF4nX48tOJEC4UQ/iRQKlSNlTcdItaX/RM8MxN3TydYZap1o77CWNetXev0XPg/CzzyyEyFC7oqutZx0VHWtPaNr7e7w4/hUH+6ibvanctiot08iYb2Rhrr0+vmIFvYnlEO+1QsC4ZDLS70YwgghmCiJ0CEMrE3KYzXpYbN7pQIJzlWhWA/1PVyNwgojuhu6t9ZtEFi9yG7eGlixG2bXFuO6VB0oVTcXXdLzqqqUglTa5ert+bHLCKlT85RNCNQ0Pzaq5vnpyWqeupdJxtSRP3DyOrZAT9WxVVQb17FFHt0GOTVbRb5Akc+p2f7hsJqtJc2xIc0RiPMkhdsQpzgGzwJ7TBGAUlTUbsPjqd3GHBWU18tbqn2b6CPEQ9KyPzqu2u0xpD5M9fM/HlU/R2dK9XO8jKif752kfl5gijKirDwMHXTV9dVhrOr6oiWq6/vwevbJh9qz3WXPwuxT+Phb0JMfqYofHomNiCI0ViLEkgiYHv7IqU67Oeka0bWNeJ4XynxXuXBgrzuWN67kvqM8fX3CntAqpgFmXMzshGC2SaAIE0nfsz9TPTYhrrFSl9vqQcqUb+46sZymSsfP0muhene29JMIWSNF0Jmo67Eczghll58guFNtLxovAS1VpxC4pdQyO6EC2xChYAFIAugr5EvmEibkBrA2m09RlHfkAMWjtgwyks2DHYDBiJYxTTuFxxR1QENV6TOkOo7RVRyJXqqbYV+rhHNFGF39hauKmDLeGrUhjZA+z1CoLhgRPSXKmQKTok7yAU2tFOn+wqgTzOGEi7dU88jY2b+SL4gJ2BSviyxs7wowii1csWSlFrMnS+gndTi5gY3rN/hWwTV5j/s5v5/LhH90qqOAaD9E/gD1NvSH2uJobaUwcNpuI/f3f2JFo5oSVevH5p24oG/WLhPvrqFkLQqahiOGBG/P7BU7qK5ZY0Ijl/Rlp7AvXFWq8OopFtYo4UiaeeYSES7xyvCk1L5siaZ4BugQ4NmRC+UF90OFex7thEYuLeJwZnYl+3OduYAHiu9SRDtWMZANKKxLsZjMU8cdbD1QbRlD/IAuyloYKmt587KunYg4uO+o2JlwP+VRKNeV80ud827P+cmTQMqNq00rBSxTKG7KoJyyD5QYQGPjrwvPdoowiA3aBkQgvBHxeQ6G0bh2CXR2Xup5LzV8R+C0OExviggNCEkeHhrg2YuOIToZko/m+ChpMmNaG2VMj8ANrX+t02KIqhfU7/ALd/vkLADBXWywqomqTZOpVsZcUed+6Keo2jPaTzXL7Mm2vZ/B3FAEQk8UqQGnOkzbHas9j+839sMXQbpJkVy53ymhszjUVeOTqADmkPVgxtBK8FhdLDN3yzKTiKocZGXYOIpDFyOHtuQh0nNElN0CPKLsl7BqgBdALEozNmU46bMGieuyIOBhLNIEagtFw8IMysXpgBK1r9IQXfUAzSAOcKz5QLcP+hGaF5FWrHp03DwnIz++b+TnTvaNrJZVq55mry5ioXbO0+wVztPsix+xp9kvD5uSiKtmRg0U/3KiLdC63FIdMjZad8ZG6+PGRl26pAKQD7kaYHJnpfzkr5zhUYZCdo8zPFqXsVXDAhj3JLtNrYGKriUaqPlU/xBWRu/GMg/+Vs2MDuFM5C5vDZsZDblpR6TgSJ1wIXte5yeFw2ZGY6fM9ivNCNL95euCih6v53aX6hltxMzlO5yZyw1n5vI9CDoJv+75WHYIpAJ5NwwS92kOHctkqmLKU8xLolwa92GsTzmDsDTMXEOoWSmXrxqbFkg5FPJXzPmlbEOH0rNrbMS6RinoSKukM9h9qbstfFh4EE9I3kKuMzWQ/1w5UG1j+cGapEeZUsUyknerFXxq5TF1jHED4VpQuMrjLWG3BgjcjezyQBaNRKmtfv2F0PyEbhTO12eorSca0Fah6VVk3CsNmkcLduULfU9k+V3+2yKXrZdkU8qwPyDaxvPU7cecv8e1zMjK1gNz4Oc15OW/rVz0ErcKX3aUhjOnsExb+wnYAyktj7maKXNc7dN28ridKwW8/Ozm+xtHMUPwQvxyh33J+GVNX/SaBwuVt2kF4h6fFPVxzi1bf/GKT+SLekbNOsa3bvCVFbDnIx43eIpRT3oxJbfJa3JazIRY2R3wDa1nlKv6Ege179vwtl98xsfc8Snp0TZaonjl4XUK18LGOgWoPfR+oU/gJGLhvmm7zs9Z2iKjElcA5ipAebC+rSVLscFosV0U26VFhViSb+GSFhVis4wnqs7Bj2ma01N94GMBapPKdGgH2EJ4QLmn556AvJ3HE/Tw85y4gaRGyCinGM+iePDLHhUP/pOn/c4Jm1qdCZlyOj50alFfK0gZCm0/HS88pwoV2QFY9D2DkCSg3MEh0CMG1gvk5sgO8vhV4MYBcFboUERtdORcO7lZyRbvexmaiNpDDQ5lPyeuGnbgCIl2sMZRkBrpHNVlVECUPGfx5D/4sO1Q2Wphk1rdboUUKgORR3hVxmUFCvrOQ0ZV/pe+y/OiiinAWNeQuhqpis4WyX4g1BDiCJDQJoayah6wKarjje9G8OzaO6Ct/k3vGrzq0sKPOPtc1XCgSkTwGuNVTT7AcGCMCGc4EC+w5jxsOPAyWL270xoOjPu3WWNRMTKEMtxqDkft7Eg3sr+2xkQJ1fEjGLMj+PmHYUfw/zhbf+9NY5ayse+45rWe45uPehXGuY9dNKi6cMhsMr6qiHr18OtzNdMVzrj7s9RmoF4UFttNeSzPJK8D+S4Eiohs4XY869YafWys0YsXAdgSVAmV3pgBKHhKy/NLHuNkBG6Cbx6Lb1KRg4nLtAhqbdnf4luT1X7asDn4hopwts2KxfAU0RsS3cLxsR4kkLojK8mB2HjslXpRO3kd1IPb/b+uTgeKNPs7VC2OkYpsjab2ffyJ1z3nTWuf5zqmKS1tmA9k/76hJ1yTdML2fe9lH/7de7bFe/lwYyb7W7nOnWjvCKaiUZhr/qzmANcxt1G0TcrlzPg29KroBvewjZMPkQ7g3ujGvpfM/fJ3f/YnbqzWWswP1lxv27YGVpZpj0fjPNex1RT2oLEExQPpG7Ne3JKB+yyF1esjxQJl62+s1MhXyDK291z4PRJHNXMbAwZ8Rvw+P7AdAatu9cpkEHQPNTQ4bLuLK3ddhwI5/q7sPVv9KP69sZSFyGfzCvSK+qXX5L51PeQL93u/N2L9Do5bxYeepxzkA7JLUcN32QduNCXi5GXBjQd10Pxp0fSY4WB2H6qW3ul1nwwhn8vB2ZmvgitJ7ENmBAK9D89VDlyNAI7aGL+O1i5DS9Fy7mw/yX7mgMWLc1cUGlZHej17H9IoQhr69MBrIFd8j2BpTcjvJdhDQSAd7FXSauXx+AgLff/3Xotv3lX55lnlN5cPfyN90JbVdEPqZxvaAnntf+I1o2VRWVZ3tP5+Vy1osZ5tXYWwUmQ4XOQbHlaRCkhR7XUFgtpnr3qFK2l3WdKusZLgqDHCXkH299lXb5QioHWrif333YCGvVFvtmtK9mWz/tWslf/JxIU6FGRfQd4Ug+CNWEu8bZK1xLFYLI4qU4YEeoL1Z+wcxYriF3Wf6HZkv+UNfeFOpT3MDTHg6swHIvZLE2PvdrFqf1BiPzEx9s6JJXxgYt47xvJ62U3q4s53ncBUdjD4F99PeKFzqzfWzGFrcUUkYSUvavNXb6iVxpLyWOe57n+xoOWRGpEu6racrt08mp0jXPrA9h956gqpUNbKWphraGuaKD+BOmyitYuJfVd/Ihbo4G0GcW0fUcId6eZd8utnU/JFnZA5RWYoe2IDHhEHIpznIQCqqGV5hGVR+ya3+VKt1rSniU7yX+pqZ0KHbsaU5A1cyc3QZQsFcGnD/UrTuwK/4gWJhlw4G6GWOheuOP/lGvSKkScsq7E78VUgwXn+D51M3q/Zk5pnQTyVlf6/YaUhPM6qmzuZEQ5Q3D7AA3Wrag05DRJfiys1ZAalgs3avgNL2+Nvvv3JR0U/aZObC1o2+eoc1GnZkHuFw1G9yJDoRYaKhhIlruYjlIzeZaiTR/zHOwsvdW2e1JpccCCGUlUE3yjc3x/6qd/8h10/9PcMNigr4T4ZWXrkpz86mbSQWTSzf8AYlNzcP+IN9Y6YJa3pZWu9nQBGr0qMXtUOoPiZaj0oyonl4v6bvRVl7YTR0xX5n0AT8jqn6oYAHB+jRpz9k3D/ibYNexmVhYb4kVtMSWlWDhMd4+Fu1sIMAVL0aAjajikjGk7kdOOFNJwdZWAmINARO516e/YItdYfCPIslZpwgTaTCQ8yMW1qtc1NoEYud36njbk/4sBlPW7//aWPj6IpJYFrsudLnH0aQSaOqAJSoDZu0LuTB+1rhrL1kCPmW+Ir0gqtUSCnTTlgE1CbpD0AuR6ue+Qz2tRrdav1QvXQFRaZtqytIkRclTAXkpscbW8iUw0ydbRwWmKxJ55bEbHn1AbYbudOAXYGWqrQ39bbtoyQAvt766PA19LmAG0ZMXROFmfYACSfixXZuLLQ2lDqMEhEQV2P0XDak1nb5hpWPWXdj74YPy8EfoEviG0/zuWgqxs34GPQtF0ktgRpHsLHuWe8oJi/sHYJFHdxLnD1NUUbvs+l9g5iaY7me3CSjnBnP3ykx7gOvReeyLKv6yTRKnnA7VZozjCKMWw2tVdFXthmGKnVTXSB2tnfocuqSvs1uVGkdhv1poF8qrjQwX2zGcXFtmJmlpobyCiogjWkhbnZvbyS/bMGjTWxZYRO98PzA8KMUHxJFF8EnrAFjAFyFOBcvlCoPbQCU3CfxWI1DqRpbLa/y6r4hGpPt/M0hQAQdbO5ipw6ndFzzEfgqJ2cxbydUnMocArYOieg4FBFV21oOQC11DkvdzsUKeadaJaxcB1aWbhlqWg/xdipVxqw7JoNhn6NaLnFkdmJPIOBmCHpZqccC90yZMWU7hxmuevWFNICHgqAKbYGXGR6+3QGb3vwc26RroAYyAREDZQiPC9zyDekB+QOx4uV+7YpJMqpXE8F7PAtP8xnY7kz5M40N9CJh5xbO6uyHF0XQl0XJmy8GmbT1TabrgyI6DZdmGOjiBQragrdV+YQE3T4tamv95vXZPi1PvSKFpqFaFnNN34SL8zFveeT17P8P5GqvPRQHIbXhbD+VnVWFeqnah5Lhigyczaym7vIbO4M1ofI6ckOPfvyKzTmQAZljcMq6BIvMSDQmfix39k3Kx1HQFgTEkdSRSO3ZGCOXmzvlV1MdTEj4e7SypoXua9S9QK2gvsQVQ8Kg7KIgbtRO6pZqDr2B8QWqq4kYBUreRKjKNbPJAtOZoQEg/yvmtvDbXv20WKkhAhYjVC1NvLGsD2gbOJ94U6PGuu4A+X6iGrzCGcnw/2MIHIY6iR/WumdKr0Nd9Idq1CdpqBdmVWSs/Kkv7yTnqmCypyYmMUyX7rySSSEE2J+Eq8LLUBeDqYgHcz+5ZXOzeEDeiQowFAlv7buRYZc9YNILGuyYsN48r5K8iXjyXsqyReNJ59VSd5dTaaw4unqTV7puCZ7EA0ft0tBgaYcxxaFy3RS9ico1MwnYXPi9igIr4UgfeS4kGE7dj3AOZriQjecujxuQxjh3j/C5WB1T4BhpNjy7ME4zx5RMDjirtMdHYxw7QEF4/x5oCAw1iCcKLGIKpYu6grfStPkUC0Rp27ecH837adX7WeDRvvWOG7fGo+gb+gJeVDdkXuoZDuk2w9PjULXgQW4fzHaT+y0FSe+rXsqOzL0tUj44FnmNwfQp3FMvcP34snWUZzSqNv4FKpapw5BjUX1OkV6A0NXN5BfjkvAGCVGoQ6FGVVR0UvNvqGEZ6QKNRIeW+8rda0m0pOi2DJRBUwUWTcQ5lM9TvFLzwPZN6WCOhpRL72QDldX1GWnqHfRPFXrUA8jenLS0qbqWl2xj3Olkh7RZPOF5SqCUv9BJa1sG1dvOAqYGbXKXZxqRKKdvtPgQ+uhPelUnP6r5x/HyPOBV1WvQmLvw9Vox8AlKbSNuWtkuHal8FRyEhqzz4cCL5o06lVde6OYHsl2MR7StY/4KIdjISsWO3L7tQ3mRFDmSah6wGqPaKgNkWrcO1vkPnAVtoXN/dXStnBkbQuDMxdXSTeUSs9D9dZPXC+Uh9DyYa37mKn3/twzInoUSWFF3z5Gc6v69ircq5ocDqVUAaw+atCVucHp28eqbx/JQOkRWVDVhL4HeWvpKx/lyzq8WKIjFHCgeknnJ1913Es6D1ex/rGeN1k/FyZksp9RhFVlXIPiX2yFodwuSK6diIi6+QgNZ6sTrMJd1fk1MVb35zCJQFypwacdiOmuGB/1VMf5DOgRhbB6IS4Xf+wFOV6xXTAuiit3hrC7ZGHB5iI8OOZ9LngKyCaM1lAOjD75EzcRAblTzhfzIWelBcOdDG3KNysWAfQKTsrWeV1UE/Ozugyp8nJMnjaJYjVJUXSq1w+ziWZcmmNmXJqugdNqjWCQ80/1nI2m5LrdtFaXN+UkrHLdbspet5s6/nW7KdxDKpruul2Tmptet5vi63bNlDoTrx9m8qG7ftgZv344Jf3vTL5+WFXLmtZM7vrhieHRGYLHNODRqcCjY+HROT48OtQ5eXh0GB7TFUHsFE1Xrx/i0zGOoSnIhKmyNoBL6Stw3Oh0G01o3941iP0HfM7MFrn1IlvbylfRN/WXslHUN58CVeTuuODUIxR+A683E35PWeG3Pyz8dq/kWxYsG2fBsqrwOxsVfvsMX/5jCjNVgfmk1nAGudAn7fEmc4sdqjt0hQ2UCvvvDUHFI061re6Mt5oRDbiwKePIKDXWQr3qh7ObztqaIsE0tV2DqD5wsIBX87XydUjjlZFDV9NKZ/KmeheDCpMyixuFTd4pRTOt82WbFhDIdgjzCBWb9OGGWMtIKFZTmn+v4gu9IzoDEm5dOgELLx21aXh36EXVS9tmhcMiEYxe1YalD1wSGb+qHT/0q9qBsmMwKDZ8NTkU2hBUr2pXzIqVF8UpPD5t4Mae/NXkUK9qRxNpZTxyVTsap5Whmr848VXtgKLJtHJzeERD8Aj+1a6uB5V5G1JwMle1fXvNv3TjP3h2erpskMk66FT3OmCd/xvscz35x/pe9nJwQemj7txGRbqYFlU+7/rj83njDi+UEa3ehPwcIjZ3eHGT7zVO7uZjEfJ2y3kX8Ss3H51vEX/UtwjOW+9X/h+y47qTU+J2M2492p6TqywShl7LzRuWr48psny9j30q2k++3kxQwOiuwaOG7gkjZJBHiIekZffd4G40BmM3Gu9Q8N2VBfXrgiFHt5HmCfbiCBmN83B9rq5e4xLZo6CpunnU/yzyFM2pOI5rnh+EqdW2LOyWDuHUGtE1N6Ob5p2nZoRFXXvV5EcrmlyC+UKPHAJFwtjEFW2NcfUUU3JET21TQVMhBOjZj72RJqVjTZJdlDaJ69TCaihMW5tqkstrSh9qLkEXIXQtkI/CVKFZ6aliY7WTrpveWDfjajdN26B0mnvC3+vtalNnS5rgOXVPNF/0HFynNDFxiRrhdESklGoNLjt3Js75i4DSascBCAfRQPMm4AfKMUhcz1q2r+nwN2nlGmlrwkgFIyMlNATa/0occF9VQE1+dgMoTcvHUDb7i98jcAv1SooRLd+IHChCX1/hPohVzU7opo+HZHil6NsIPNS84bXXDI9pA49OdUxR9/U4g0PYgiwbG9/mBDT2wC0Bdg3K8BiHd61anXyh44kPJ465ieVQJtk090i7aapSeYrTEHkGlFTa7jA2xYxtIml6pFshipzQrSZl5sxfa29Wa7efZpVuactDfDipW4gNtVvTmg0tH20wTbnKwZWZ7gVUn9wtNGK0R8kmPUqlCVTXHunHIz1KJvQoMR9O7FFie4Rs2n+0dbxHWga2SdojrX6kR9qnsVFS0E8mLtN5B3MjFaBqLehxFTvsiPhVeplWBwulcLLLPz1Siiubf4XVV8WQmn6QOuoFOI7NnnTz2VOrzp7RiYZPx2aPVka1SbPHzSkLitrQ7EmHB4XzV2ePIT1FqoapeMq4Q3JEuDf0gKmP7khCQ5leBcKTo3I9ajTRBxGtNmcCisQGqy9XF1qWfDU516vl41hIUQgbZJ6NfKoSeLmAwIOEJ+7jYjz1W0BJ2UP5NheJkrbC7WH+PIzVnLb+oSEqoCW/unQZg1KRLpeJxqr3i2ESmCoW1qkhsMgTNEeXcnBJeETDa64tIh4nheWHYpJVxlTLdqugoYiJY0lImu4aSamU6CEPWDXN1MyTVDoUjLTFfqbbeYslyaSCXUfcF1qN+dDBy3V17IuhxmubwpGPgrGPTItCW00w/IU2NBzuSqJdCStdCUa6kgx3JRgfNX+kK0H1C8PQ64dpeqcXRIJXlU0MkDjQsK68akc1InPIoAc1SAuLukWqBDFjtUW5D/4Wta5YKxEQy6Ca3AfeyXdY4XzcBWsMldDG/ObPdO9VF9yI8B4x1voUm4aqWHngBcFJ9ER7EKIRug5GziCdPwFeoVxYM3x/DYy7kpeijttYmMFjTa5ThKbiUwqH2vhZ34tc+wy3X4Tg96O+f4lERcTvL2JatiLaAKpgE7Plpr7/vDzUthAMyr1GyEaIXGFpqJ48UUl7LdJwrBlWtJHxtbob0clsDtuca6XaGH6FZC5T1fUR4HJM9jopHX1zHqjRcumCMuIxGiokQcXM+m32enyp1+DrUrRc5y29RcZanT2/w3qs2yHboVjKRk3fg+NHNdlYV0sX6iX1Q37gy+kC6h3eDbjZBimPtLOyLCi+aMvjwie1CCUxhOwoyoFG78krOkkqGjycRYEiBdU0l9t8uUormQgpuoUVc0pucwroj1ZU1KtVjVZQxJUqUH6p2aWzzYorFPAg/3plLP09P/DE4SQFbs9YhV3OGKAH4jDPVNdZiBOzQEZtCKUi1A56a1zr43BYD3UDbQY64jIbsGIAVE1jci7tia+5iga/K174xuuKPR9SKm+BF2hL4/EGDjenSIarQi0AnqkjLScUHgZ8gKpWFir+Ni6shemfJkEoEoG+lwf+hE3+VBxFI1t8X4dQT9ttQ/yx1Td05r+AIn2vM7mIKm9A/sjmN0GMq0gsMujENDXE7iKg/TgcaVM01iY8QtMm9ZrtOAFV79E0l9uUP9Rg4R8C2wb3lVKXyHVWWf9hHmi0sa6nXrWn2jrlgfQYTw91tVLDw3juckfsmFbXLSQmLtHk1qIcl+VqcNlDoc+YnFG154CEA6qveRN7xKz9dT2ru2Vs6JtIqwm1I+OD5Y8P1nH3+cMoFmor/GGoh1UZkrIEm+OX50QefgXarlm+ArQCa+2VS0KEGxmUMJYtTKUnRWwZAohKxdR6YnTuQxKK0HIANZdr/eo6mGIC69orfIyvgxsIHyOsvXyHeReAj4mGSmhbviXA5rElvC2kotwKrISgS9y+Tmq97se5IVa+2Fzz1GCAfJ3+lO+Hek/b1+XWB2vAvkC5erx6Zog8tFWd0BQikh6100uSAy/9pLoOcuNNxiIezqqxjuXD1FGoaGI5wwtumEd+Hmi9phWRvEUTWuGfXCsSJf22K8oQpm+s8H2BgqSCphQY8EgLC3+IroYT1suijlqkW35uRMFqUoeS3CMt8rpNi6zLkq4ObznwPt+PjjdaavmcoZPHduQwmQAlbhf532t0U+pA8hHIIc4bjuPjyDh1mYdbVh1DtzscHUO7qhQextBD+wJpn4IX+C2tCo7TqmBSqxh/N2lZw46rdkc3gekveKyfRr4yvkAlsw9RCyUVuGHOyofcq9BYnlEARgSYQ5jK1AIPs8YQMlbajIiEPx9m33i8sYERBhUDY7ZNTxdlpvTXTt7847Faaf/xPZ//2JYJ5h+RZ8z+47s5L4Pylnd/vuWsP/7Uq6rWH62uT6TaPpu4We/fcd3zxJLMt9bd+qFXHc/u408jtZb+t4djHfEN+LZqHRG9ceYR8TZqH7E/0fIjPnyEph8xglVThSjS2ir8+6WkzddBdUMdXtu6LnqJ9SvgueuJqCnXFTSPLCbgyFrbwxLIzPYJ17qJf/YZBfaiobI7ROUpBbibjTyamkNxcddQTJtjljWmH6/KUreCJFWPkPiio37PrxMbQCjfp85Gno26TpuWDck01YZcp2XOdZogKGwiiM113ZFSu/SPBue5yrHNmtsh8xVNGlWidBGZ3FKqYdGeF6YIl11wVWMtz1KtCY3JBlDPUf1kNRQzQ3POVQpNw7WBdbTVQQZl3yAmnELTFhjRRnqq1oisIptuW2BQqaYyv/ouRBirStS1LFAGjF3k9/BFQwCqQzXMAAlNz1zjsqqfdwdvcsGretok55cdgDHqdij63AktmbYt6VyzsfklC84nHoF35VvwoHyJMpPQO2EVyydZxXLKhR7Srht4+6rQW2xF8T1a4kHcMljDMGb8soWW8bIFebK8hgdshy7ks7RVTBjO0rTgwhpwYcD5a+XLmgw1MIMRB48SI51ZQ3RVXIfqoGYypJVrHxw9Xbl85dI4nqYH6xhBbrlHW6VVKhrKpBGDYacYtgWo2td97Ug9JObbt4zWsuWIraWGN+dDGTAar/YwTR8ZjFeIvi7QVnUXqvN8Wz+COSydkqRTfQ4QXs5zbs82OXuvy+ndNlwwFATYDjskxt7zVkmibeBfiv35DoSuyXfSHBWoJz+FtnMo5NCpPINO479d2ForsQea22dxOls7upwCwhOb75xOQ+MKa5LqagpKW1VXcD92ST8kpjidTocFpjNIMtvXM7l9heqgwln/DM1rgVx9LbxaLlxq+AoOZ5y+TR3kFzXJ50va5ZJPw3sl3xxZjkBoz4Nz+Vm4VTkSdzYF/ftqgL4q3TLHyzh4Zn66jFNN7FudTmezDSmYj0r5zef3s/idfCTa2FnAs6Neo6WwoygMxJPOyE8nYDDX7cEFdmGFbjsxKKfSqQCGdla7wmVqf7U3arfK2tY6pdqhk2o8GsvD5pr/kFue0o58nhvMaKMCse24xypjVHONdyOHONcJGfvhTmx3Yyjl+OoESLvP5ZiRrZbDK9hYOd++Y7xNZbqn8Vt+Gu3ChnAXbbWCvG1qLngbdY1XSNxgE7B2AA50m8sj6rj7l9MVCgRrYupAz8zDGokfpar1sYxqaO2ssVTGKzfXDdisyNILqqN30mxTu3jrUmqRcwFtnKIF8GQL1QtfQoSUwrSphuTaUHKrTG6NJQs1y+fMsqyGDEP81MQc0eHstbKKb5OlN9+p48ZwmrO3ALfaaTOHW4Az/Ki/UEjWAv/BRLBwWQSKh5K3oi3b92P9R22jZFEHgmhhJd+FVqhlt9MCYPpptE0Hp6BdeUdpE8z94ouiRLE8E2O6c+JD1ld84mhYKiqN5A8vaLMg8rPuhnVnCGVoO+K2C+IUp2mcNlBGkrYZC94zaAavlSvSRTxnzBUImhlbSk6FTeccJea0047v1nKYtk4epkJgu00hfZoZijnSe9UjI1bM6ADpOBD/7bRjgfVJHcMefyy0SzkRfBaG4itSVyFu3y6asWOx41s2FtsqYzFjxuI0jMUuxO3SOG2gzD6ayWelGaep5Ar9g3Xr0+xAbJOaUMZQTYQYop0odafeeFUQmeFY2GzWpApQw8PuK7aV82C7zoMC02YXEtVKJ5bxDmPvPD9nHMROowJ05kWrNMNMIHKiofO5D9ABbIDX8K4AV3Zr1U7M03ZYAZ0BfZsZoiTozC61X7oL/dg15BD/QHl5+q89z99sE/70wi/POy8n35WgyXsryfvGk8+tJO8ZT95VST6rmoydpN7AhfUfe38ckdlKaZ/kZ19VMdjvCgqHC6p62D67ejnHjjKKNRJ0cadnN6/pN2bi5nXxS9iS/UvYA5jdg64FpYmTUj2yf5TPZUmPce72JJjgdrUGG6JTjVPtp0E94bIX5GjWvbxgoSNYDdvGGIevxgc6hknLM8ITdydwLmSieYYLbxeTcnKzwt3FE/jDOeEPY8ITJzn4bjc/8QXRJLOd85yScQ48a33dZ6ToYkYZ+MNZ8O8IzCGRWvkitfMueTA5a/oO77e47O7RAsyo5ktsES/vKYyU5cYefQv1YCdV+4KBM0/Aq0Y9gK7o9e8PRGY7lS/TYr6Vuvm2YK+hvT1bIeTEPOm0AryQ4ROopxXQdon4srG0CkqX4ZNZIg7YzGPZtBF5T9pUoFfSFtS+VWvXCrV2NOVbXzvvRK6GWdtt/IBtXpbqFcvaqmW0CN9wbARTpjnZRuEL01h8tcQ56sZKLa9EXMe0iBYwNoSzC3wtrH2tbF9OW/VtqIngarb3MboZl+Dl3Dk0chkkaLkfGHgVZcsKxgYO3qeNE/4Pk2c3+gmToFyYh6UGw0w91Jbn1FOu0CEKkbzvoB1oCBqHNgloBYrIsiR7r1ETu1vR4GWAxbTgqGkBSQukL5wHkEU/CoC+sKBf7B8IVnLs1vHs0hZ5bqEm43nA9lGwmgZGXeIyKyHhNLiYvhRrSd7Ddn9sIgE6E2YiunvIN5P2gA3c55nA3V45wZb7lfnFrd8u68YyTzCeeW6SZeUk2w4wEI9I3uNPtxNUMAhjlfFknRI8WMoLLqFWLKkVaMmmNfQUq6QmkprmqGfRZBttNxVSbQRZwCIhX4Z8mpyVyRkR2rQVbcIgkAiN61zZVkEoKsbaUTPt6G3Wjv5zH7Wm9AAibcoSplzNEgJtCpmmbBU0RzO9fCnYCwBOnmXbKrOMjj/LAObRmaazbAlxoBJqwJsajLYJt6GeE/X+75h5arQa8wuZF3AW0csXoDFnd289aj7TrU65nVTYOoCNmiWmw2LMe3s5F+bAf1FOOc2hC9tBtHuAjKSyYxGFfTEvRBzLtCScQnOakM8RA4BmkLyTZk3uWbyewrGaB9vmq0G3D12n7KviQWWW9gRnp7WcnGbH6Go5z3TUp6U7c3b0HeZhTLduOqZuPLOR8XRDRiODhbitknOWZs1IZ3akt5Uj6RnMR/2TR1RHM6VIWBeKMdFUhiThGocz8ZkCh/7W6tlaYNnSj3g+vAv3OzkzcUOXwlwwdMFIlHfEFPTqBtk8V7B93kERwgW3Dw7Zr7qHldv91+kN9yGTwdZcsJMamrtKX754naJ9N248/q+/+tcXPmmw7yde/Ec/e+bP+1xJKbXVL2FbYi39rSRsXue9DN2wZpxhRsIdYZBaP17OA3tBHvwuwl34woU3AqMOoIcwdTxaek0vk3OM/j0D+Dq4H7962buZvRGcMUw8J2A11QEzNos5PNyl7JNENYbV/ICauQ92mTBxuGvCGC3+klukPhhb6tuimjrhKy1Nv1Jr4m2RUOjHqbuvyaPOIvOiQ4FIiPDWpY7crqSMhfmd9TIvdSqulvXqa1CrXf1kI8j35V46Vt9OPqVnEQc8/uP0yqVlOY6E4efK3WAWE0+paU1GxSHzdlOw8XmnX3QgWpax4ko0tFNDUemAu5XdBpCrW/Zlmrog0HxwgVG9oKpbjzZ6zdVRGx3O5EAGl2CLqUqHp6odnhrtsDbH9Hkq74z0eWq4z7i2Xrkfzn3uYJvtYCM9zk2POVEAoh0XlKo5XW1Y9W4plloExRF2QmPIeBw8rFXxEKBslZhDJkxCHVolpqmqiuJQNXo8uxajmFeTLnz7Yt443iFSvDgYIjGV/mEzDnkPmvB5aFLuQ4u6mOo6mu7v772maJjMDQr3+O9J+BlcEGwk6p7lrvVh9ywfw7u6Z9EkuYL+CQTTviQK/ZGR34/fS4yfcWMGrdHnOMlXNNncIdc2gX9Nwa2iIQjcbQPHbOBoYi1qt5TYtbGOoy4eG7+/BwKghqwpGT8PNFYkPC3bvzp1sIZrPNVZDoJE8jmIgFxKphk85o7IYRYFNLeG0AwUj2eoLlZ+LXvR4PbXuK3w7tE0b3fjbc2+HcPbIft2FG8HmjRltUym0I15lSPXefPFA8L7gf7elapDFtPvO1ITWLOBQzZwwAbua1qw2cAxGzjaFBFbvoRKu9RlWSRCOxHqmV3gNC3LfU/lPbdaMOnrNsBPYZcK7GZoRtiAbTSLPLWgwglgBJpDubZSbzxXvZ9VwDlLS2hVD4+e3QsmkpQp/JoqJlfQ4iUzL3fjhczLfXjZrTBnsFVe1vBC5uUQXjLzcgAvNR2SjLbwrDTdXeBWU0N6IozNNpoBqkh4O/i3rUJKFpGNNw9gdkbFKR/mHhfbkA3AM2CZgPh8nsKf888/gbncivBWDuNV6kZ4HGrAoXw+FfE+RMSLgj7UxSs2m8DYLTQPJskgXmpB0zQzTWHTNNNNgdM0c06h05SJRx3ZpXTIl6cvWBvD3Z/1b9jWYwhFHC97syxtdUhwCX7GmMWkmqULG9kvIpkapcuJbzKZv79ODSwUX8PzACuT3FcH+E8P6PyAELK2XDWstlwRBh0O1mGjtQHtl5vQSyZOmBtc0ntg0fGQhjcQfp2G70D4oITP829Ug9qx4nj2Nml9QEnposX5K9uNnz1F7PyV7XL+yvY+Yn9lrw5DT4WHFfPaTcv8TSaasGZPeHapCUGZXpjKfkGALJ5c5sxtWTCAUILEDfYsb1Oz4vQDX+P0h9PnNMRAzEi1YpkV07Jhwzz7E1jrhE2ehOryiXO/d+ISuZx1TudgC2ik9+lwBcuojmo9MT8SVpiRmpg34s/EsR81cFQgpo+t8mujZDRa0ISHSyXkygbo5THfaXBgfBkwUkF2GNARJsh+9l3IZvJkt2hySolWy0sxTJpDRtkqz/LAjmVreoeMK+T1ggiQatPUYdhHgTe8FlCGf/YMBkDRmjTKKzgTYne53QLSd1PTmQs4BlTwrwU62I1A6HSZnO2LsUAt+yDAlosb0Q0/j4hX9KO+6DrxvLo5pGACIsFlyxonUcwu2PCMKHRYWtjwFYBjr2DfQ3cYN4TrbywTD+wlF7yy53iUB1hT7TbOjy11H7ZUIe6V1tyJuwao+y4buNcG7ueAMB/8BGX4hDz5E1+fN/uSHhzC06Ldh687PzjomxLWbOAO88lRPI/5aMOdnrQBsS/Uela1uCvMN5fra6aVtzRrQkEVw1FAF6RNesa/N4di/BpmB+AhArXhN/tZOY0IGA/yEI/deaQXgpaH+U2NvFwjA9Cx76+eJWnyaiX56mqyNiM7huFfwgl3aJAJg3kk/Y9V6+5Vo/1qeU+bnh2Upqpru6+wTVyxyafJYgfm7a8ats53ki49P05pyOic8V/AKO3j71rfMaeNvAnyO1tlTpUpvStTpnRthCm9yTGla44pvQ3BVL+4Y+SLN7sv7nBfvEPZ2JtG2FilaACDpORpdkSIgpv/VetgU5Y57Shzmj2zmG7XlC+dAe0LC2jf5XPcyYMeTt+EV9W1Gx1PNLyIvHN5F48k38Ipd2easlSpjDp5j3zwbvBuTDPwxKdZiXXutyE/LXPQMrfMVeBBYG7BrRCtIbQVzO1WaoFVaJXMLQdKH4BCYWermlrbmWTitJ625AV18x2oeAI52QnOFWs1Ams2cMgGDtjAfTMmcLcNHLOBozNU5NtoR34K13cqRMx0KrCspXzpTtthfT0NkFA2VaGwVSVSUAXg13E2dWYo1046ZTxXq585wECRAYchp+BxCp0KxudUw6YuKpuqYjJ9OYaXzLzcjRfSF+5ylU3NAKiSF8PbWsmL4e1QyYvh7UBCCzpClLNRpJ7ABt0+RTsDRFIc4PG+hQQTEForUQCDf1UPoz887AWy4ohenjsoR2pOs+AfsZ7uzbcb3GCxa4I69U0qo61QCpLyryy29RinUA8Hto/Ugjbku9BmlAmBOS0I8s6fZDl7ymI4LqVd6Mh2msIfhB40IxzqDC3Lc5lSyJRS6mG0epQpmzpVLlPPZTHc4cNuFX5jsd287N1LLnhlT+N1H+6CV/UeCHi6eS8EHq1u5KfzbMG0x0V+0f/ZX9KPFcw1CNNOdzafBjlViAn0dKHxQOzbykMQ8xaMwnbW42d2QQtQC+zUUXvteQYWdiuzuwkPx7FsBfXd94aXH6wpKmQDodYuy52a5f5KlnVkQThzrPsZyrpvN2PMpKLk2ukM4cnXEgQNU35IX5QrPyAvYMu3M1t+e6LctqV3dSwHo7x/x/D+Hcv7d7Rt8H8s7Ylg7GBj39nftfzFvzxv6WJnB03auc7DRtvXCsregtx4GVzApfo8hsAztGEXF7oxwDwg3IWSebCevQEqsrdlP4vHoNhF+JJ2rRMdcTixxpjfl6WDtrsWPCCWNU9Rat/C/GOXs2fq0gHv6jxS+xkxVhgvsq9fXwpBpJyiA0PcDaitkH5STO9fFa05j6OmKeO3EDaf9jj8CCs02AXJBaFaciZNP0MdFxzL8l5ljZmvrCQ7Hkqh5OdbysVlCwXZ7TIgBTd/O8N4mp/hBcF9ePJkvBdPuiC4expHLejYksqxenrFg51lsJ4azqLTvqqnL2+ygJx4cdDAHTawZgOHbOAAny3Jmovau1Ct2obQToTsmrJjZE0pxtcTrBQnXk8OPJrrybxSfF1P9OWQrif6soYXMi93VNeT+1TTo+GWnSv0RReky/VFl6q9MkbYE9IyxJH82M/NS0BrL+3ls9SlZVzvKdXzoIeG91O55lzBxsDFaWu+wgn786VyTcgXOXjfNFMsHCkZX8Gn0lbOVpyyQosc4u+3qjzlNJojEzyLYcVjn9fe++As8dN774MsoP1/fKYZS8QfnkZnbSpqOc18xs/KZ60JyHUWnQYpy2kQsZxFOxHeaSQuLZW4VI6uTgHyS08gDPN5UTpFdMn6oVsgger5UqoyIiw/WK2Wacmsnjwv8l143j2dE573T+egTDxvcBF1iyxWW+w0gSJ3R7zqFtN0prs7kSmxmeFCx/uU72x5omN2Z5bDm22mpEjO+9MKISgqhGBxQjFnl5M9LSc7HxzLXDiLJ0hLz7qxgp+dn4Ujbm3cDhFpthnz87PUDPMO9OUbMCt9jVwSm8UCJqiEaY9839KpPy9TH63oMnqCkcTUz93UXxyZ+kvfFlO/qE79ojr1i+rULx751N+x+dSHTu4phttrgUOjWZwLo/tmwrZKYeg5m8/YrQyxcx7adJ2ADudUJus5w5P1LP4BEuo+Zht4vW0ANVp9Cg7/GbgyBXeUwtIrsN+a7RMkzrl0MDezVWWlqcH1s4dx/az8bFXnSGWulvgNJRNuD6ca514zymIm1K5yeusUCWwqPlfXBoipUXtMLIhECeHQiCNPF59t97HkJVhnW9g0pSUr+0qnc+Ehba+UQmRefLzscjZdK6VSBAbIpd7LqaNVgY9iE1HYLICjg/8qiE7vgkIlsAksGgefLsGLOHSJhPZwaB8ldAZO+RSJsrcqX+bqlzs42ISiUD4bygp1D2PkIBr7iUyNTDRMLFlJ6Pb0Is+7VsSuAYmvkMNFRBEEbhEkbLsPD6gmgjZOrMjYslvRjvQSKHWKhGDDSAi4FnBn78FrJ+2T3ivM/kjInxEZaN4apC7Ix4H0K74XThCpqA2rYxVl07YJhEWIDoWmQ/APGuEEH+VHzoqfvQM3nC6pwK6HUAEkNR3YEvhjZLaOMVmGq6848AxJbb2L1nUIlQE5kYay7UopD9m5sr//4mvIXzGubUP9Vu4J+v3r2fuquO6QJiBO7/uqO4laxVaAh+8ycY2dQSqV/ak0RC+eSvY85GfpQALbgqhqWPj4MP+LbzHMUcHJw/zuYZh/9tsF5n/5UGG+prZ9gusABT2SQag8ktGwHsl42dcBxtxXTwUXGaP72fn+uRz0zvfPgpj/QnGTpgJDNXMTnIcUcdVahLyt9uGNCN0Lf+EqXChfYWdZKMJO5w9bYnkA32SFZqwztcomZoo4JdHKwiKCcjnuzKMmeKRh4oY07MsAXI4CacElbuLAZT3jKh4JHi6K7xfbDj4SxL3HO/3QE+tHEZMlLDYBWkVqvytA2RF3YGjXWxOdq7GoZOUpEoJ3Yyj0iKN8NEqar2muf2jdBp9FHeFuA0XcxjjkXXFCyVqRDIyvFbU7IJ6zk8rlxib5lbdUG6zVx/3b609T2yBoC4EpTHCzV5KJix/oC2Otz6/NI1Q/MrCl6X3MGP5Zybak8Wyxx3W1j5vaVLMnfZ6epMnhmvx212FuAIOS/QGwFeBWIyN9Tw4JfbWbsou/xv39F0kxQf9iyEXKcsv1NN2PEzwv93WY3WKpYe17ERx5Dqrw9P5J1Ya95uV0tF7LgBTB2Pc4gqt0vPgcVgc/P+oHLOVWlQzgAWTAaj9BPgQkVfuA04wBtBCP+hGFJvlYOdfkBcNmVLwKFKjIwMa2UIfTEHO+6ULygcRqAEbx3JiHEfeW8DnO/Xp+4feJ+O+ynkw0jt+5gpph+4yT1T1oEemt9EivyocwONBVm0Bz6vgsE3dn5zJlIQmBC1iWELiAloR2y9FerE7ryRM1r+wPlY6qBR6tQU1j+ehpjTQsJm7MWNSpprZPiqCXi01p4gDHmg+UeOkn2sZEq1I/gWFFQab+fz78vvxvC7+/94fu/0TVRVj83L1j4joZy92XoYU4dgtxPL4Qu3RJRRMfWiUgXViM9YN3ugU5oFr2y25Bjsl5lKIYC7K7Kkc1a9wk1syhKu0zXBKswLrkIi7W0YiFJ1D7Wf7YChxw496iSpHqgTwW9OAnBdUVeMgU6Ts85nrQBm1BpJ2IzbKPIQvwSMg3KKc2B5W34KRMPZQHYtfChLqEtUUd2zFwfkW5Aq0A3+maF+JVOwPDYAITGFURf+XyUoTW6Zj1TXQpM9is5qtcNJO7DevMPkKGUDomLUUztAfZu4TX9oftUKV7PVkmwHd72R3IAgNLClM7K0O11186TlLrI9LEBKob6rYQ44uHNFjghrBM8Zp1J+UhguMRDqzdLx+FYegSCrQCteE5XE/63ehzZrqMcXcm3LQmFCAhdTlgLcIEEqUAZXim76wzJxHDrFLFS1O4uQqIqkcraRGgzSkcMgbYz6vwXMYFZKB6dr2HX//w5x784Mc+86objnIymC0+1ic0Ovt1fCh2XuDCqfCxObpXzgxC3KPbUFSBQmTsOI6YOQ7swpgdqfghSVQbu6qCHblgwwWb8C2NI1/Rxk4oghp2Yy1vihOrPKj6x8gjp4at9nYE71PnGyPqO9+IqAfyHC4yb2xWDPL3k02a2XLBtjjFbQ03s7WWt0/UTKHHlvHas5eX970Vv4QVNiSidGN9yAkPVZ3wUEPTjhQNaoy7y2hQzRUbnYwvHwzaWDlOT52azLZRe7CmCix+9j6MvutkEZV5yQVZbAAUU5Glr4ccwX5cYvEU+X0K+Khi1AQMxinYyJtAGhky77h2TsBaAg2rQHeQpOYa1fVMSC11UKhubMyoqKkc4yNNWgoJkNoJ8tQs1mPg3xsxFV+FYfWC6Dz/OPpWy/5cyPW2SbGgiHpRdPdkP/tYqHDXMfs1XZgc+d9jfIeUt2t9JygB0dJIb+wya8qxlXrf5UdqyhrUxc0Vr18f96DjDcC7VnDZc/fSkb+fVK9SeJOmjZp01SsWPFe8oQsW0RpYIkyZcLNqSqQssZYCi/seeeO47028koGbEkoKK8pgwb6nLf7wC//4qW/hsEfxYL30q6wfrb8RJ3wvPL644Te+1eKG33go4ob3D4sbPvDtIm744EMVNzzLh96bdHoj5/S86vOo7wuCGnylVbEUsLpxhAJjjQqYxgiW+9YdZ82I1v30oOcFFS4qUGChN8o3RRSoiQa8JhwjjSTVdPOzD1U5JL/kkHy86swDh+QjwnFIeIH3qWEO6WJwC0cthxT0P2FpRaAcUmA5pOxoyRcFm/FFH34YfNGOkqK0hikKyI6Si//zeKcvRFNQLLMG+2M89a/qyv1A7HxAYTxULCStAtRh0pAnQvY7qgYMpWd/JftdvJE/4Xwi1Fu2PiFwtw0cs4Gjnpm/4t0Y0pXRNS82Kuea/w774ZoNHLKBAx7V1abnBrNVsljyL/gjCI7q1Ng/YbE8ahdLStZ0Sq3LCgGKcSc6pQQgwqEGh8QkRUvoAeLa2n1qiL73VMWXYIALP7C7D/lZBsWVjtGjyKdVUZw4AZcqYP1EpjFuLqeInadp04Y5vvcgmtLz5jyA2mUGJC4OJ3o4WvZollDhLUWXumu0gCAt4pePMHDlEZN6zgpLZmgWXxpFoDYe7eotprxTtQmbUgMvDX1RoQ2aqr2ZKzuGrTTXhMc0t3VWT0mGxTQi5skj4x5fccB70aVKB2AObXakfABxFj0YEfegBwmqjkf4jk+M8R2TYrmck+Q7PjrKdzylpBI7KyzGriqLocndSvLyGAfiWnCxoUby6NdXeKIVSpy4y6IzqqZoljhiTtamsBKHfbAfVDSik2ovcND0e5ZaQoMxZA3G/h5ZLrxNJu5u8ghPMs/MPIXcrQzr+vpYpNHQ7PeNxU1zhTVg3rDgH4wW2pFY8H05iGAiF38l4A9FTl6CfTAaGnFDKarWtnf4NUPV4pSA+O8yyG0i8sFhQ0jJxMDPG1IadlFVR4lNoS5pNbJlLXTgU7l+izmWt1K9EkwtSji0S2I5nR9QGxXJNMyVVmYOhEop2pVKz5v8Ud60EygzcyDTYVWTJYxqeWOU/rXQ2/HxkVFoi0C6bizft6i+YenaWrkJ8CHAMOaziiZ08cVQMWDV2xhQyu+VnYPQkRRNTXE8qSZYBLba4kCaW8R62QGZQ9KXBC8Nvs6fN8xJgCEZEQ+qHfL3+1FQLjuKhglGd2jvfSAcfr8z5AH01KtBf28eVIcrFPu/e4VHgRHs+0OMjPjMVCPmgQiUoxUKiZ9I1QFTX3vC+Kits6FGjwyCg48uR2iLUicBZL23kYdUzwNzOuAT14cLBduv2bDLS1hZcaR+0u2w8KNKy6pN8UHIlTQaMNbSO/0Y9x0AQH9YPDsBP4qYRR+7KSI8yTwz81Tb1kAcXSkrjpaxrVRswTG+dLPlknV7X6MW4GhsT2EVpDqaPaTNWn5E7VvgTuXSntp2VT+RcFRtvFSk/I0odKJkfmPKhNINKmLWAjA+zpySZ2B5gE/YNZ1KP5Y3Sjqj/lYVWtaSUFgq3jOojbI9NdM3hxHOooLrAqU8uv2sUEu1E4TbQ3rNdo+J6nKUmHnGcZyHgx0PVCH75Cucl3Cwl04nXH2HygFOEeLU61kQYUSMSHi5nPECyDoATqGkPNFTm+qYBH0ZFzTh9IAbo+2zp4t6DRhRevSorVMxcBMHcQ3iv0t7yl7iMJCaGzgQw1u18WjjJdy2WBubmsaG0sS1oiVHY3UKMeChNj4dFCn/HGEyFEBqLkaXphwNu0492vRPg2f+hlLNPMTocBFqwR7z8giKLiknxzUw/k4zw920yb4kTPBUv0789z29/o+sZH8jUWCrAy60B3v0apmAa+wyV8aPzHhXacn5mjkXa1CT+RozYMp3eLC+UN5rO2+SsWb2/bd/zEyzLuiTLTSfwBX9301wRX9/EDkm3ZlqtuhZWcFQ4OiCAW6hK/y5c4oS9X3s0cb4X7dOKIdAnnK9cmQiJAKhuTxRN2MNCqDvoVSCkF0+agK8+/4qfspHX//Fryp5SyR1UgrjEGZrE7SiaQmfOosdWT6rC8+ws33wmXkg/Qon9+uOR69fn/7D7z3j1ffX9o73y6U8nH4pWfec3TiKHukW/BPfui34fZtuwT914i34J3UL/p0t+G+e1Bb8qH/8Lbi6IHVbcGyQss8cdwvu9s0PccN9ktvrYPL2+tgj3V6ja0zAo//rt9dhdXsdDm2v1x7S9poM000nublem7i5puG99VF/ZG9938S99X0Pe2/959/yvfWtQ3vjNb/aClrJ/ld1a+xha9zdfGt8klvhMPvfditME3bCa77t7G9Vt0UYGW2GP7418obfb/f6vtXHkUkS9K/A+9AGiZOuAE0MyIcJu+oGSeKKCEgARgzsj9kgqaqELy0Frx71AzEu7VH01E03SEcrG6RgwgbJNxukQDdIfr8zvkECzZD6CTyc3SCRLqeAYzC8PdLJAtcnE7dHNHl39K+3G6JHuBnyHuJmiCp7ofDEe6FHynL81beO5XjdP2zGcnzuxCzHPd9hOZTlWI8S7HNBWxp6vdxOjWPeCdiMl1V5jDuYx/jiZjzGJMYixIy43csjPNe8PB6hGTrhsAaJnQJPnwc9SiybwTidNw0Z8UTUJYYGqE4eY/sYu4GgpSaNTdkNZTLa2iMuKARrISxHrrfT84zTDnliHYlCntzI79EUtTigTAW1Ngy7AcOj4DLmzK2YTBmIWVNta4zD6JQZkDjGYbRB2OZoZlMOY27kzvA0zfGXuJZBKcgIDogPovEQbBJUK4RoN5HWEoatxXEYkoNeMUcRRTR3ZU8H6RBiYoolJqYQZDY0tKTKQ0DAxXdXPX7GF/DQGp5ibgJPMYcWG55CJYgcpzzFMW+Yp8B8H+MpEPtweYovfMt5ijd7vu94imNVCRIa8CVLpiYsQIFRDcezpkIcPCpre1LyEX72t8pHWFnPZHYjW6nk5NY4c+Sh9xLdYExsimes5OCZmWdtTB2q+koTl3+s3CqS6HvWJbC4wIhED1unppPzmEDNuEiPe0XdzeNS1zfoB6v2UxrOgMWaP4VXQuUAjvhxrDspIXcVDczJimG6WsbCYyg1okiJjlvjU+kHL6Vyn7PNiVMwPe8yZDLrmat3rgM75K/qGxiCjL/p0BQmICblFE0PMQSZZQhmHEPQoIZa94+ZSFi/4soEwA39zFqOWZ3orO7IrGaJIXVGV/uOXe07utqn6Qd9PxA8sF50ualYoYyKjzp4xSfcoEgJOruz2KWWSzLwiEJCORueXTzDVVxgzP5e3c0juoVoH60Gfah1jMGRO0cMjnzAGRy50xkc+agaHEGiqyMiWPdZzd4BkVrZlD4HJN9xKlfX1c8w+h3aITAuK/pxtRJfOmL7l92nplzMfQeVzH1qqYdNBGPZS8u9+0uBcT6HA8U8DtflPZR0n/NabrQI8whK0qfAjou1ej/RXHXdmJbHk8wzM8+acWGNR6jW8JO8KX03i2QsBgjVx3UKBqHdrokFJzGpSCnUFhknUxi3zfjxXF4v+EG4nAv9Il7VUshIQbs38nkYPZ5nT5gvyBcc3i9ygQcuzrtOn2kL7CaDU4QGIGtl0hzxH1/87/U7UBQrlsW5FsrfSil8fG3DIxPbtqFWIraniWDrIsTfpT2eARu0/cigyCkXqkCYrUTLFGJglIfEQdyB+bxAj7kGH5OoyHegsz0s3ztt6dDLogL3tTWGQlxNJTX/sY3yK4utvRz158SBnHaKlrfWQjv1JiVhwd9hS6QFoXUhERV6U4EL2YlCco7gAMeixaFcxCxwTVJLKFLaIWCgeTwS08Vi+1qe96/jema42ZkAZGtxikJtZxFisHZqCduI8IaathmP0adA8n0K17gL8SGuqZzKVefywXP0Ci1XsE0q6NgKXLlbi9O0Jqlgl1YAeOzSCqzbn1CTUUEeIhllC18ssA+oJXfhT+eaTxUe51SGgXjv2YUo/szEksaeQQXtOJKfST3+Lj+LH51r8rNpGW/nUA4A3V9/Tv4YxpTd5OWPFTRbonNWiiW+cwA34ipVBwqWcJ2lxwJFHseBx13a2xiC8uPX8nPJQHWaA93V4gm4u58RPxTmOzX1VIXNqQqS3ILkXMoNSHYCJECUu2sl0NsMlXMd0A1QC+Jqc+rwO9cXwj5ARqHWN6fVzHHFp2ruTcYYN6LRnFCTdQiQjJq40jaWfjm0Po/Dd0k4P18S9mj8Hg4e1fgL6DFYQy5UxJlTOOdPFDAUUjTJnDpFvavM4SAnPZuvGKmeHqfsplOw+yFwgNt4UmynM9G0pNg+KBaPc4YT9usU4gyHKQWIVZUv0ACF5mxny/p78y5XJfQD087ZPA9pGcYTQFRDWODYJlBjVCrygWMWYGINKxVn2E6TEqAKF1rKspXBL/M0pVPy3Wn/Zf1r6cIeA2cX7brNudMr8iOuHNoyVGjeFqidRqcw4UC7WZuW4l3czSJ8ITsHy5/AdV7XfxmXu5I/xvYFfduqfTvQAAYsi8MmEmVCauPC9mNeRHPXoMlbqUun0BOuefdNIOwffsMexPVDwRs8yHYKqFecpq7+FIJbuCOLa0ztziD+u7JH1Y4Md+MxI82+qNLsJ5242RgUNP0xaLrtxBPQ7kt7HPOk4c5cdNKdwdDkD/DC3Pe5KS/UJuQrdDoluJfyWPL2Yy1HrWeznSQZiwtl8YEwoiFcC9JhzGCs/RAU424+cTYppH0Glzl3hl+7iThYe0MxpdYQ9fFf2Mw02ov9Uge2HF6AS+iSs3gyPZmmfrhX6c4cHnO2Vz23hmF40DyfmkPNQ3O0YTTHcUV7hQvOn0ynaasZoLaZdAav/1NY4EQ6/uSbMAIraDDMM8OjNP+ogSj+ijbpxJztREj81XAnOFHk0D1dc8+GJaaz8HOKgf9ZYDNFjxXUIMcjyy92BAToJzOQLl5Tuyc6nXUM2m71x6dgeN16Xy6iaAKj2KUGZKdosYYA7TXr1qZFX8xFb5fCMQF2ycLWK87gG/F7MRmODNaOXyfuN2Ig8Me32+YIR9tYjLQRGcd32UOudHyXguEMR7LQEEeyuPozaLu0GPbRtc8FOr9NJfqofiJZMuNwmkgATd1mMuRtrWbitAQukWFS7FWL71qzod9ikDzgU/uFMiXRjCPvnTATtVFzaM0c6n8Ic8+XufdtOOs8mXXf/vOthvlWG55vKZ1H54OD2kMXgL06l57IjBI9Ln8sncqc2k5mBx+fb6fHkexhZD+Qty1/j3t13T3+sYSfWy4I7sRz8YLgaEJz1BLbxSLwiQGEKX7mDEPpcGw55ynaKq3+YeGc0XbiACAQAgIqppItm2GfpCiKrDn291O+nj7oedF1FIiLM/JW8NwNdZn9xD+X9vC+pwhX1fu+OH0P1VtafT8GSb2GUR2pOK4UsOju9SJc85a8TyvqlwprikIokbz4ooj2A6GhtCU7RA5yEwF+H/jiYyyRwZylJXbS2TaiUNNuvcpzFjhgn9B8zmvajorquh33zZYZLZaWnkBF5CsTVETuCcO6bj6tCIzc9Qu7uQ+xuY8I44A4eyWB4kt7MA88tr3PQ7v51a10F6EEEIMYLKAYF7qk6XJTV/LplYUEjwQRDYRaGOomQhlGGwc3b1azxnMUIHpOjKpCPGQufQbqnU5CXQ6FUlmDmpS+HxYFRPiffU22+c2RbX7zAnFmoEKGe0eEDJ9xQoZ7nZDhHhUyINHt/+vEyqdxVciAi+m7tIgqHJKy+4l2v1F2v/VodR+db51099F2lXGEVsaBcS9b74Q1k2Qc8dBWOnBWln+wpqcKJUrhKWTeswilxJ58/Ko7OllfZOHQpQIHoXL6iRUjEOy9MZuKjKAuElGJnkuEEg6tsAR6OUn/wFkQllgz3yLVblq9UXtsFRatqsZdW0xsiZBjip+7IeuIsafKyBOyN03RRj7D5RzoilhjVuk+fLhQur9IaJr4j3nUeSO5EI+x8yhikTxILrp4ZCLySLQccVG1RF1apAR/TLVSllxsOTKAPWuRXCwBHku0YETqCu4mSy66xrn5vEoueurJXGx0bTWl87dcUw9njhpDCR8f0JKcDBRdtkRULPa4cA4RB9q0lWtJTC1qA4pzi5d0WyLNyvFLwoX01Os3F7IVhbQ5ggMcixZzdyC5WERBUkIPRu0ABprBIzFdLLbw6Wf/Oq5nSoQLS7KLTnj7yq+LBcscyjZ0aQnRqKmru1pYk4N9qkSTE2w9EyTLrrZHXHZ387K3V8omW3aXyJS9HWVv17LJlI1kI7SIKAbYFyBsyKEDosKGgqJ8h/oWpZzX4VFBw1wJhox2iMtTDuyEoKEKlFPWeK9u+j7FAd74s5PUaQgBFGemtRvT3I2tlW60bTdOpbZ2A3wouptosnYDyQIiA4IecYVghbajJnEZ1KFEa2ppTS2uafr4gzGNmqY3GYwt0vaihU1+W4y4Z8WuNZb1wNS9gFgH8zQFZH4GcFv/U6/E28G5eql9XdBlb1HxUudTZufT6cQ9lb2Am0EOLT3MgYXS97QpjFoqX8pP37TYXVzsFjWzVXS5Ev7jfcCZvA8gDp+JfcDx64NMx8cf7wJatJ37w7wkave5XGKoqLbrWn4mM+YBFbwkwVBvpS3EJePJRXOZcnq4SGcS6VTs8o5gi/QeoS5t4bHp8bM7kW/vHpHWUpf59+3g37mtKJc7EFY60OJRB6lsBWkKxFZodTgem5YEFE2qT3gwLZFQqCXcwkUhFsSN2kJLZtPSNq1FO3XTolVZyC2iRlCOVJ1hCKjwhppHIZMdDzKoBzNqYv/bpv/tk+q/Yot6mEFtiiMyV5pa806Qi/l8m+BKy9Q8APgHQmF9WlT7dgK1PWKwbffaQHF1l7zS2prkRbgrMZnNkBgDb2uA31IJPzU8vZ0CVAUda/4zcWj+dgvTFh48idG1RSEtxTaB6al0BqgW3D9ABErz2hVEhNM3YPlU/nBnvoNgYnMrrCzmW2gnxaqSpC7NzBqZ0jTUUXjgZAvQFKrDT12KsAzZJahtFqHRJUgXIIYsSrdUzVqvb6c/98icud23fhLO3G56C3i+2/Frnbnd/3+7M7eJfrRO1m1b1XlW6Zvr281722Yu207ST1tnYhcfhrs2RUF11zaGbsC0/9vctT183NoUs8b9s/1YaYDy2FuGN3Mfxbtu5iRJN3MfQzBVpbMQPzXe9Yp5Foqc853SMFJfShHcyx7ACPFdmIoPo6uLGI/nOh9GVzgfRi9+xD6M7oliz2qAO8J3rPbQHRlhzJjButmXOwwY77v97OuPhl8jaCkcx7dR52H7NvrFh+jbKMM1pQTmZHRRi7N/lP7JVjvGoyX+tlJxyK7P3eZJ5plV9oWiC6tWqfKon4iaex0KHQhp/XVoQkT80EU/UCXrNk3rSlx1defuME9JLPnP0IUSYE5RF01xDB77oaQizuhXtFJbLP/xtGqjXE6p7JG59W30Ho3KA2mra2EEHoEiKeTKIupx6dOI0JKqLaxJD0rvTMKGwE9l9i8AZAka451J5v9h8DrGO9PV+HnuRO9MV4x7Z3IqRz/iVeVSkcbqpdyMHx4aFBHUFlVVMiG1MAuXOmo9MRKkg3OdCPjwIJrLQXpofnWObwj3uZsZwv0n1JZ+Pm2kMk2dgkfZq/tq+53+BtTEVqFfoooXz6UYxOoKffshfft+fbtc3y7Rt336dpGsMnldZU6YyhCkKTvWpBjRz2IFJLG2h7VmP0P6eRwBg1CrRYrhDlah/vdCOxtjtT/SohQQCkXNoQ0LfTEBQySumGLTfMBKwhQ8S10PU5odPCgl9D/h3px0EM3UtiPLRYyNFEpzKM5ebbPOSX6JzjvWBk9WveMHsN/srWMbjI1oIj2BuGPGzdZZnDxekc+pgGe+710i9tEXdePCYz6r+2zhypmLnScf3PGckUWF1FIBWe67Mns0j4mkxPyAR1uoh0KY6VimZeZyth42uuczK9TlmHLtI7ZfXr5c2VtHflMsHR0M3MqGz0NIj1Qf/AG/2MZv2y7pVc6ZfUx2n3ruK7hEx9SvC6Oc+ynNVhJn7c5TPbSYG+oAz0V5olDyKRXRX0K+PZ+oC80URWAnykYlIQopBxFiMupwtqERLHxlohd1FDOhZovGit8lha8dUXN62pA6ZbJfCqXaIlHJGflSfZ18PBIMUQLpvZoCTJ4O7XfRr0UFjNlAzeSpxUxb7+Lw+gM5X0qImKpG1NGCuoWoboKqwLEINY/Wfb9t5JJCK6RUdjC8+9KmbBOIeQjK7JhZUSV8bK+O1VbFYxAdIf7dta4IUle98rqB7xThE5pfEWrr4K3NMzu2BK1MFPrgBtW9N/zhsObmixj+vwTJc7FNocqPEMdktA2LZ0w6XPzJWTCDKaHdEMRLCEYy5xCCYzWQVQT3qG1MHWPVH1czmTCy+BqMtYWWg9FZeWj9fusOd7hHqisZUYqupFbuoocNaHCRiCq83B0hDYvEUO+TUU9mRbF8ZVHv4SCUIzjAseYDwW/zCXouXTY2NmMhOBpzv8Zoz0ajPmGj3vdKG3X3SBTTb8tv9tJDwZC5znjUXCdF2TcmWZrS85z6kCmrujNlVR83ZeXSJRWdfcjVoPWdlfKTbzqzViHVsgMHS7NWdcK1BGuwmOrGsBWtyK5sv5xUSQUSsUsqFSNXK9D8RAcqJq4i2POkS9EQa+JK53mAR2niKhgzcRVyy38ZLSdmsrBXQPa8zk8Kh01cxU5R+12eGKB1t1Ji7WFdEMqcSgFJGoJPWCSHLHoKbW/+KE7boOdODQnu8g95QDH0IUb92fUHH75Rz/rw5ZXvxXWNOzy9rwHT0EZtXVf4UHonjUWTtBNinja74aC9yxJvdpfl5Qf/HVj2/M0oAIcVuQvvjnEEIO6CW0xFsUOeWvw+iKd3AQZb7q+8eFhL/erh1+dqpiv4cb2YXA+eRShwyCxeYM3iFXH2d6/EU+xc1y9gdkV5hjwRfkxsd3DfrlWrrS90PAaWMs4DxBvsu3laF/FBmQ4j2qIXj9OtfR9/4nXPedPa5y8eoFixUMM7yltvwb/fM5fpUkxfsT3jYcFZo8SwhBvGfOUNd/7e83b/13u0DrO//t7LPvy792yL2ZZg9revEDMyFGGeXaKtvkhbfS5F1LKWJDSsduqVVd+FB3myOYiArS/GzwuxhIB1jCg9T05PGuBkmxRlXwfEkOeqIuD1VzZcQXmojQpg8QDtUcPoX6vBidlhodx6ui0fq3y9Tam6EhFesaivFRI8qONQha1adYjIFJn9g3HSubyS/bMEdaph1eTQ6X4IMxkCh0ThgP5GYM4FzmaRqGk9WLeyr2jHtHyZOLooccSB0Wsst0+6xjIWC1qhl0im9L5VdpPc3JAbJi7xb4YNLPpalR6mWFIQqByN+XD/xwscA9ukBFrzIcdeZuIi0ZbwBANBWYST4jDJLGz5IMaogC8h+LL993684ERkuKzX/ya8FXHkA/ysX9oDwLE1+1XARqhnHmxeS2hqUQmYNFybHbDId7/cNZAvIuRTtZaaFAl6fLqfnG/y52JvX6kLyInSmkQfjvJk70arltTXUiS+8JHGDVN645eLTSfN3oO8tfR9vhdf52BnWmfBp7DmShXMKBaqKWpQ2zdWpvVAVZnDBAxTIgfPRQwMlaIxPhSWUMKuX7+OhXeOK9uEBDpEie7i67r2YKy0E/qavVa5uHLc0FHXfD7KxhCiurAyhIkdwuwAcE57lkjBRTjUIG5+pSuq1FRtUHbPDSdh4+R1B8cVWGBcZciIii5iFvjefp0AVNNpapfZf2wGp7BbXN/dYRxWe8lDlRzePSI5/ISTHGqSlPsZBEVSg65jeocrarRzrqjjkRW62S4aFMOIjui2i52epp5MpHplsKVb47ZulKf0LkZHMTjTexrTwp9Mo78gGzBPgIHE+yxQGi2Yk9d5sG3SYMr4HUo3uglZQLsWV5zvXclUdCVb0ZDN7hauZBHwDCF65y92y244oo6i6GJeoy0WTSka4vHRf2Q1p2U1YG5NMddQnAa2YSKdwMxaZP9pfBoEXr2bL6sbOygTrKLevdKcbWjHrpwP4HMyzs0KMRyxQ1Ra7GV7qHyKDcWdaL7cIKXttBPuyPw8QnbrkVDuaO3A2a2U3yB4CEugKysF5jzE5cXSgE7jbHXcQFOxeHgUtAwvpDYx9EX8ytqXmhq9aGgF4vJsV9VNSUKJODLbRQFuiXIUXp0zM0iunEkvuaZV1wv0AH8z5wwcb5X4d+Aud0SLVqlskXZwUPvewNt+UUqsccfr0qMG7aDaysPs1Baqj3UKUHvo/UKfQCnUqCydhjioQxQyKrUKwFwFUnxiXaNJscFosTmKzYkUYklecEmkELNOa3vIwvop+G6ron4NHINBTKq1vXSC675dxr7u081IdPNkPFdxer6L271LgQadVjyLM+BW7Qy4VRNw5Luk1ZgpeGCAfTGzoYzLLM3zqMHulsp7HWt4JuDS9wxy7hKwnokhMvb5VGFA7QEAhhyAfXqBN2cUqfFZdBadafSDcdQKCjGNHyEeEF4wzFuI4OdplGoo+zmh9KEKGEHgsAeb4dJn9PxKyVyNYu5FT/sRuCu6j/Ss9t63nMRZ7eveDsK89nZ3Vque4R/5We13zmq/c1arKKhntWPoBkz7zlntwzir/alG4osWpx5pjtCHSPOZ679vH7n+i3dlyTRJr/8iaLwMxH3kKQ932MCNsj6OoNYNX17iN/jte72V8qyXo4bKyH5KxC11YfrsPWlrz4qCvFktcOxrlSkz85cqEUvRyhZNMjDTlqPIiPAk88zM01CtfvJM1FE1bIWJIVdUA7lXHuJs0gpk4e82I7Vv2qFpPGaoQzNXlXdFnLp9JgeTPDUlllpgL+S8UCdMSw4m8difT1OgB5NST2iL5T/gkNXhnQYvOG322R3hFfk2e+LaltE0EFI+v7LIelwuism0jGrb0PJ8Vui+akxH9AiB1fxXBFbz3wBYEOyDAxCgzcHtB+fIfhNH5Nn/kt23s0dAcyAOszRbxhyPRsyo4yZ2X+NTaDYC5Yc/wr2eEShX14GZYfoxQzMV+jEjZBuFbkq6eThikG4xJxpTqLO2afAB7Z/FcVT2U+gY1408/PpNSI1gr0oMKqqdNL3RosfwllH5i5bqV1y7cJ3Pv/a41uOtcJUY3TVCjD7miJEm1eQKvRKjSYxiQ1A1ITwz6XBQVUFvouURaAseEaza1dXuTB1vYkNC9kF1gk2AWDA46e/G8T5lsudGp/BmBLUp+M0MBmIyOfwq6mpQRQkW9qvCSUUimadI+DkxODHD9ZjuSRaa0d3k7C5/H82eXbsE19hmUQTf8fcNiVXl8wVl6RYlG5jSLkiiFFZsoTnxyb+U94yj+kQOkHFlGyzoEi3TvJBLbr8AqIsRlz5GYFVR57lI13OBLZx/blXfGeTcRuQTUYpV1uR22P1sXeGjJeVbaZ6h0jMnHVupPryt1bNCe3SVYXZmgjg9WsBWYhnYtFxaywJgRN8f21vcUoR9gq44eN6+ilTd2pIcm+AKgFi+WZDhhMr8fTW3ryWFUr5o+7CFFqHM71X2y1tlN1cHl5DnhGctL7Qc2cqiV3XEhzUDY4XfVruX45lQVDZqjBggMZl80KB8KIkEEsCfSPHHapUvW0DU82Wubt7uSOepx0HTbrztzxcx4NQzzefPVr4teqDDSItKFIZrV3zSWruolRb4F5XUS5m3hlUWPqmaBaDRgrmUp9hibxZ00eCuYI7snQAgfy/XqxMHXkK1BTI7FtAMvfIhnxRbJ/qsbwgbiR0reiH4PYEQFeq9S/tBhe5cixw71tztWBuAqfYo00ngo/NbpbXYxqJpwOqtFRomtuU9hR81BPxNiI2qu9WmbF7zzOxs65TpjcemmtTYQTuoqbvVGvX0npyZ90V9Be+MGSuI2qOkQWBDdbthrU7NlGbwNkPT+gbbXHJAPgUjPh0MVYcC9IhElb2pHbOaXtrLOrodcfMyaZ6svhEaSRxoWu0pY0RTzhaBSaWMv8m+bP1kyLiQb5J8OVa6+nzVZoNk/OcPGuNp5sBJLeOZaHNed9F5doP0/cL/8xG3tdos4FSRMkw8cfMF9EWjJ2yN3gNzknQ+lmEdAqGgKrsq6mKOCO5i16CyF2mrDtvrbVBCQraEEmRE7luoeYt8USotblykNy/qorBgFizGBsBHDRlL241p0ezn0LeKdD39iYpLC99MNQGQTjVRTDP+hWP1L2y8D4fQKatRIKpnOOZX69yO14B5crFOnv3PG6VH4orFy37jeuMN4//xJl2ODMjTW3zYFl1Y63HI1+t4eglvTkI9ObyWg1O49HsXulW9GXd/ndmMOuuFBfJnqtntjiz9qtFnCgZHiqoTu7qzdtE9e9/3/0v+delPViQuExzYlalX9fA6oAb+W8sOifG5NWpoSNKOlJkH4nt4vWg6R4PIYevkwgY5j96+B9765T95xo9ecfGg4sFPzoIZAbRI2Rm13TU7iNh4kk1JmOcI6BJTKUczlBZ1xFpdzgFGOOTXlbVswrl7r3LfvuiG9tf+Ib/pyZSSe7myJyaushSXIGHUFz3KZ/gc4LYvXn/0zld9/Y3fAD5u4vIxGTpEnZWVvx++IJ9zDU2EPCMBgAdDHmY3gvMx++aEZP6TwGEdv5QwJ93ad8mvfODWr3z6NU9+TiHruYfrM9nvvNowq/r6u3gtbclN4bFcLIjsQwGiYZAXAIwBZIBWxHKHYopijuBACcEFq/nVFA/+RRcjOiVfIC+3zJkthSwEbe/CtJkcROCRqcyE8i16Dg7sbqjTb4gAY/s5KywPCPeNtkCugsMubsGGU2Hmf7iZhHtvxRJj4Dq8w1LskJ2TY1AMiDiSZ18jXL7/7LY9tBQ9wOm/Ofv6W37++icRe7JOgAQf+YUXfejoroNPrlp5T2ieRbnY+QDzl7gih6UueCUjc4yN1hyUGKdpFpm38Ii5zI1qZlz+ZBUqq1QEs8wgY+1+9N1yh6ssyuUCC7/bzvwfZsUKPY6yh1N2cvjGVTvGFgQAJ5t8VJ7dYrXqwty3x5y+O+ZUU7fGU/rT3Y1bCrJ/fnn5pR6t+ly2+h9U1tYamFcLi2Y/hE9RXPrZ0OuMW0gURVVPWk6e9kPeWhie4RNltRoc4sAfXIBZp+TIUzc3KsU1gu5Ip1R1C/mjbfEHz2lyDoov/Raa6JEHuvqZG9zBnekneaLVjSxqeQ3E2bfNKCJZ3xXQCvaExy01XbDl/k8pF7lyzZUnKSV6dps3bD+a6AdvJfHHXoNSaqBP1SUVHW/3TeNaBUsuAQWUJBMYN7R0y+JTRyzlxpSC11A35aOHa4nAAVxk7NQ9U1AM3FDWO9jU1JluKxG+yhllrxmP1qoAFq+YKk73MY5jVYCbl+4rwPToumHWampktypmMsRcLuQR8KxmX1UokgfIAq6qZFc1qfkl34/5XMAts6VBWakwD82sV+uCujuV8YjxkDNzp7lVg1KVHn/jhf03+6mRh1CkHBkFMiaBHObYF5JkjkGzoZaq4lsfPrJCOXVeFdZH9SvzuOS3AF2t3Q15EalCJMAJhAMUzSgrstftW6TzV8etygUBgUPSQlQXEypVcNCS5QniRQUl43hVayAv+wu0DDiDWSltVcrDYXIeSQ6GfjTEe9atTEPvrkBkozwTP8zxS5L9AYYxLSNaEru/33qenPlDkAL2/rJe9lc3allIx3ivchLg0hCFXr6hoi7W/f1sB7ZIL5PVr8nosn/Y5Lj6r/XECgZMyHJZqhCFKcv/rQ2cES0IdDZU4yq7B9XD01YdlWz+gT/0AbWOqD3Zl4nLF6o7HrfaeDQ91aunKfZsDYqNOWsP3VHlV+AgOCOV9lbXokBMnqSqW26vfjKq6t1kaSvYZOt5JrApzAUF9jy9gSkvjHPd+cj1NoqWW3rJhu+4aEAtXojDWwbYYFUXYAr4GlFf1SdU7QPH5dkbMZcxzDrQXnYbIgrfKRXqSqMSmeQhahYFEzWLgqpmUXAymkW+1SzyRzWLPI68f1iz6BcOjmsWBf/mmkVvOjhRsyiYoFmkgzLuEqioDY/dgZdLtJSimpTps3mAJ3O3RprmKfVCO4SEuyEHsUmrrWrJiy84iy6VCqPpEye6OHrxBBdHSjmsWg5Ylbf6Xn2cuzDkoyjv4hWBYI9QycjiAKrURQB5sDAXAVACjvv4r0SJwKIE2u9QIkINAcV22RM2SLT5UKurOuZi9+ehZakgKwgUA1Ar/PUJg4wvEcKx9Hn6rWzblWxHIMotVIJ88gjxkDSDDQIpcydgwvi/Ejb2x9dI38wyFC8oGSIKKv2i2DvHD7/fwk5U11A1Dhzg4NAXRFCVF1kMgXbZQHffWH8CywZWVpB0tTT1T7zOhzwF+9d7l6BMPc9grdT+0QNA1NsOCJx5soYg9mFVVR2y8ewtqKpTxuFcQ+IAk1+Qyt5+8vgRDuGHtwl+BKP4gf7fN4wf60P4UcIpAqT+jTDkzcfFkF9E6sOc7r80Nt3D6nQPT3K6X31S0/04NMwbpmGhpWG3+AHOYsLxyxWWK5wKfL8m3PvVKwWUxaUNz2yLgzuwh0Bih+1Ux5NhgG9Zwv49betr/HYGBRLALgBhk/15w9rtbq7k8gFFmp/HFoa2s7cKuoKMg28I4Q4u0kgwlMBotV8uQru3mQrc9xQJwrsSXIyNS0zs2xE7dMPhTzwvdmDB8oaOyM6RM0Fj0/D+ZDRD5ag7Fo1EPGpCCRBaxggLLZyDQCQCexugtJiLgcQztPBDAaggj7EeczEAeky1FSyxqkKFD7CbjinR20YBPA76IUJyPaKVWglyXXYY2lZV6fwz9STixjaoeWDgqWZb0NEa0F0dcs8NuSCwG+rhj9xblfx1FA8SiwbwR/KOki7VFBMioEAs13MpqoxR3RIupgDqxDQwKUirm+LeKSOXftjTWahjpN5QCJqsGhNY5/HkC7as2BbiBTDiaACpFaouJfnD/fZNfs2d+y1vuM81xNrh4QQDcbRBmlMtwmbSesmo2/5L6DUdvrmzUPHmo/t2qj+9jU7rgzfqUIroc3n786Zu1lLJKFvHlaIlOONRA9U1jBsr18V+Dd4nGVu+F+QE6q3PK9ribEMh0JI+aFGNfIpaqhSEd37D+kQNLAw5zyXUnVHLCBd5XsuSJPRtGhie0TQaU0xDYAbwhGyrdoWme6K9So28wz80JcVlSj2a/etQfWIaoMAL+IU8YQkTDal0hJLTA8RpCHGtUAgBOpWhHWi10bfRfnl5yhXhTWptqPrtNOIFhA10oYZPdZKmuv+dvrQIRRBBNXQBXWHJnu5aTFFtTN0OeZRmvyzoqqfCRQPaCRG190NewFHNFV7X9Ka84m6DpnlIMBwt6mB24DsoRCl5ojT3HH2TPXUlETKjVg4lIo/aOD+C86hIDWgCH90n2a8osUscsXsfrDs6Cuc7zB6jdr5Qu7iQ+FiIXlidK3HlW1+WBx9FRnkt0JwonSc7iEtilpI6Ja4+JAhW+OYSmk2ydC2s0rT/8yf+K/yhy42hW39J5YWGTdSHrq2ui76meJqiX6H4SD51FDtQEYS/3zpOsQ6mUAlaE+rRT1mBWLDQIgIMiW/LQSmEq18sVDDkCREU2eKqJSneZXfoFbp0xB8UhQ4FXxHIhhnoZNkAnMqa0+GYIgxfVB0+1UvW4UslR17Xa4YOdDETR04AzyS7Sd1fdgygxN6iGeqaW7UEgnauhSOjl5oh1+uROr1U7Fttqldtqlc21S+bCjRgsOIL5fYV1JCoGSc9EUGsZVZhnhKVnseoODAIGyIDsFaz1rU/WC3MF5qg/YmqCC0UQhqBmo3ZUt9rDLM9OtohtgBRuS2JQUgu6fVlbyKCT9VT0qGLcXkuCSRGfRInvAKZfgX8ipWoxKem6kv5Stb51VeyDsxRsq4hiUsUvXWWacF1ktYwRj5dJJDSU6aw4CvAZHI6yLg2SPE1wXKQlg1KRxuUnHyDGqZBK2iQFpxQDKZFgQGTvCr9xotg1Er6hM1u4xgtxiD71Qk3ct7c5IPtRqkxFfJcrmpMHX1nqTF1t9GQ+qj4SZTTpA1JnXwadzvSVLcKhaj8BYRk1yrOLnAIruL1UHcm0Sru+xpVIN2UJMjjyXLZgHm6pjjIycXxFEEZfCNvw6bnlMWJGIIixY4+v4mgaKoiRUyP3FJMUXoL1GihwEztSmJTEptlYsZnrDgYJF8PmQve7t0OOpUYaeqNPn4P6OV6b7UIVe7yDjiPuT1YgTxO1F76G0IgVM57r6cldIu4L5MTL8tP6+m3X+JUaLLiWxx/l98GVb26QvS1g00OQQPYhiVgIOytiFT8bk+ECneL1QJtHfnZu/UWmTr+zqDqOGAAZAIY/0z+6LCzbHSlEGSMCnpUii7LNpnTeM3CR/TZq/CeZ4o1WqV2zQwt56EpVL3bndlSZg6zT9874Oa0+AR2uqyBpqvnedRaP7zvJXO//N2f/Yk386H5tDlbvOZJ5IJ8ej4N6F5CnjmQ6XvZ+1UPwrQL3c3WsvfIUpKRb6KnK57lfk2329yeTJo7UHhN87fTgibvlY+nKCAYLoJiuuS4CkdF3Ex72RfDRh3EBqTjR1xo9uv4el/6E/+95XHP4N9KpoMYs7g1Ry1TfAKuVMVMaD1+s3MlqXiZpCZss24wnhf4jtXFDxeZS++4w+Ii6h25zWEUcB42iSpZruw9EBSxEGs9GxmuJ1t742YfBdg3XiYu2UNCD1rA8mzD7LGDDZ5qiNVuBPtx5oWuaA49nFB5s56sQBp1zMPswPr2pdCe4iL+Y7Vq/PsO2vijQ/G/UcafO7mYXWPRXC1TQ8tIHPV8uFO00hJffWbyI9PjUj3m1fM2DzQqqh6NxMOq6xBbIiMz+4YxNugJ4y0D1VKH/snkPDHFcvQtR6wUrx2mQDJSjT2mSepaEQl+YQkJKFQ6f2sQw+Cyr76pnJ9UyxsqTY0oxNnwnDzk7ozcnw7lTI2bLfwKz6KfBUCxHFJUUV2JS3pBLshKCvH6Gxkt6vthv8Flr7pcDfp+znvJXDelsV5CTDeKaEA+Kxx7WPwq3krQTjBZXbXHhlTAI/sAmjWA6lLi2qzHQqJEIabg3XdFhJe5vnHwnnJ6r0gNoI/AJesa2sJgBTHiYGqCR9b5gUOqFmusBLgLfxUOLZs492qa23H9z9aMwhqaoicV5QkfhdUDvtcEAQxfBI5Hcrdbh3wDoujzfFKjXHd5F2yqCpPp6XV/J6SrNSwiqXxzp5fH+NpRVT/7oEwOIA6wU3MNa5XU1LEg1W1u8Kvn6mXRXRAD6HUjBpya/xFP+IQfNpPbPM/fKQxRuGGo+xam7s2N9cJX/34YrAYF7gAv4GoO2ZSkmmIOXSMgfBPEYagvbjH6EBp5/L7EVNdsKSaKu8z/a0GE+aHOU61uxL7COB7AeXRlXsvGDedT93nPU6bl6aPOhONAduF6FNXgjKsrRr9QpAG8IiIiK1JK18RVJ5eXt2UStAgo4/IMzFISc8dgKA5IeguvkakbzbS6Rq7xWLehxQj7q1Vj71aRvi5vwmL769lPqQEMCkRH3zfL8p9BT0wli9mHZa36+Mfwjz2/4csa2t4kp3MGRDo8WIchOSkH3x21Bld0tStSaAb5+75vY9srvvgfeNy0xK9x88t2AB5lPC8xaZkbOmIp5uJA2qp2ldJfCOuWuAViTX7I6Fiynvt4dvPgoQ0pbmMOq7lFlMggFiE4JLk5JIs1v96LyRUqhxpBCgPAgR2DkzBPTQsyh1UdRa5LRrHo8Dhmrs3ZEK/jyzU5iG0GUti9xjs0A7mzvqYuUOQ+HrLh6DmUUQ8rlo/hVAGqeWqDXkdelAp5KSmnpVwB3FhHMc619yDvEOywoDyP/IFwFiZ51951ZvFC7adejLFf1p40EHqHuOa+778nu+bHzvjCk7nBsoQoLMBrahuTDfSsxeSV8XpNu5RQaxXRa6iR2kDoNe2d+j5Ty9L9hnTFJ/+wNo2CgWJlAEYLyyEfnD8YJr7x0hiD0jpP4Qd8dzyhTjQFCkXdUat1Nf5yzMsbqGfAk9e/xfhcDNUdeN/DH1O7qX5G/Hcp7vTEcnWZmwA9afEr7O7XAS3ENOP0ysZaMUMzgzWeNapAl5Q1m0DDBr6OKTJzSzHLj9kre/glDl9ZzPXK+z1r68UsogfywJWgjxz47/f8wQ/8LFuK+e4X/tFvPO0Pfu3DrFqx85ZPPvEzU78L118/8Es337C245OI3XLR0//l89/4e44tZo/wx3M9fc5U7xXNHKEZ8isxg8KlV7Lqrausn9hrVvCCikGbNqr1kTpXzueNAx7ZVtMcNnELgiIzzDZMceTUpYAs7q/InampjSP5rMxrhTFp7sVB3nWTdaa/K5/iQrsMW3ChK0VmuIVZbhOZGZRzaRxdTKE981wQLeK/wYBmjtsr46OnI/1oQ97RphYYLkYJ4VrRstLT/4We78xe4Mc6Gs4+Cp1RTdDUYUMY6XE+/e0Tffp63/cqfr+rtiuFuwOplhP0feRx6KO1lewjZuGMGbZGXfnAjef0lZKLg2d8YQRwvynEXCtF3coGy2HLb5UU/6OqDa9daJlzRmvVLHbGQynopP0ke73oanlixo7q2V9iF6lt6//sa/kcUhKyW5FLm2LSXsVp2Rsl2pOE7LPWMlz2k3p0+XrPBw2wgt3snYBfoWa1DBirS4HKtjhFtc0q8Ub666muEne4yoEoi4pz2Et7zIlCvQSYP+JSlrz0lxN/7rqwSobCUlMzUsZ7t7LhuyiEXSbSt66eysT6lsiehvjNabrVdf/T59u4yvdxF21+vQWJ/CZz4tS8waTo0UETEfvyFI89egv+rLyNB+VTeCR5B485cXM8bQR1mZozEfVE2HIUFaY8AhglNAvVYqu9CLMn4E+IH/PUwmOBUjxgPDgSrZVFdUQxLSLQRYKCRAyQs5ayuk9HiAmnRiyUSXPDSSCtFG3wStnlqQvsQM3zePCMx2OB5vCYQwcguZzBmjSDqT2bR6nxiwH+zRj3mAVLp/erqxuaJVElFRCuwPVKLBiSb3G40xVusKvd6HGDaIk5GGrksy0RZMPjSbFFW4kCUJdqkEFZ1WwnZoEZdTlZ0nFq6Dg1dZxSHaeWjlO7NJ6a0WJleMRhBrXdcMSABk9JQKOJxxw18IhoWk9npNECdvWIsGBCgLJEzJVJUSVJH1CTmwhyp72KM2gHeUA9AdSNEdRZKxfXmeGE7UWs7nPifAGYNjweMcajbsdjftPx8KVfA4o31t2woMjRYZmXcnhYFoxqsx2WOi2o5qzZDKlBod3FPDGqXdaTXRukFcK9ZL8itDvU8/bQ7gmpPrZLdGvIe6ebLWZbZoznJH/43v2hxO3k1ZDDi9TptGp/Pl1YXmF4hbO1u4oiRlProlEAXc8G1G2a7BckewAUWlj8Olv0BBNJTb3KKgezepVVLyt1MEKdjQKiNPwMcieqw8rPW6Ikn5HrZBlgmOA6K4dpGkfuqxvMTmysDzjnDEZ8xthV6T8Wk83yDR2jIa1ULOOefa2+AgX9VQ5mlvLNUuj2y5rtXmSr5plzRXxmNG2eX26OLeVUmUEMWW1dhAc91YCPcEUWBwFwC4Ubg139TDwBb6EQsk41kKRXZI3YLjSWjyCWph6udG3lMuCIapui8pzeE6zLBN2OujCDoUdPCvQcN+HBRrLNZ1peQatw0pmrfR+xmrMD1YAZIZ3WGCQqcNPN+qZnOHdLW0ltSlbAfarfeUwU6qzQVNX1PBfegkTeuPUgw/EQKhH/Rzv6XR0pvEzRdh2nRdq6Cuk8bVsFssA3jKiybylrRMnPRTWCM/xydfmyxm8vrr6VwcOmSeSaxGCX+pdxI3E7zYo5X9wO3EF1YFpB8wAe0ZyFIWACMFFHbumqUzwAHBV1b80zPBOWvvYzmPnJZ8SCqSAnUjLNUOP0bp4YM1kU2UMppOyUDuanEHEzc7FeNUU7+PNC9wuyeadpo0esxRnnQwY2p5i0nZU0bYP2O0/sdGnj0WbwX2fYWJ2P/RYrx8vVS84jEKjr1eW2AELbJDd02wpdtU6vTmoK7UBxiqJAws3IwEWfMjiCd63ZNkcbYFul7ZCzRNcUPnSFf+4FDEqBR8EgTTELfqy8iT0y14xWvVhpOBUSClkVmb7/h/M+8finHvzCxdgX+7JpyoTk6S4NAHdE4MPXCYtUJQq82uKug0wZFF7Rsc5Pg0IL/lh6jad4YouYHOZdnfCg+rtg3wycTr7ktnP1jXKvxhDcWFfR1jq8wcITXY8fO+EYHWgHOJ1hbI+EYiC5Ibh+5gBdOUPpd8uS4LPo9JGYsxluzM+DQklKIQ1dprMVzc/CI1eKsUWmA9OpGGh7Dm61VwXTp7ggDi5wM6YSQ9v7ou6/HROrQ/D5s13PHAo6k865lc7hJP+aXhEMisfcmu92n+6UCZ8zilDeNkSLcd9eUFX2TigAdXWa30oZnen2WDTFStY/VuzoYUHZPcD5rmbXnd70rTRNnAh07ch+rE2PoWnky2zMNN5BM1DETtoJszlomIpAoOsVPa03PouUiKlwcefhPEvV0pSskHm9AjrY0yNP1jWdq7eYmcpJOhXs/HA8DWwJ6B1oOAnnYys0tEf8eg63dxcaLyuJOqJg+Q7St9BWLCs5LYuNNDyI8/vrOeDPzd1uCPCpupTdYXiLs8/zXwdu4nWOnaCzxuIaoKENsyEPaR4XYFFM+cncWMzsWEw6GsP8iOVb7gs7wbVW+IK/UJ5e+Ve5hLpeyJSu7rZC3Tk+vYjwuLyIVQPGowjAzuu8y3dO5KuC16b4qmpAYKdrWY63+nresOvGvXLgr8QbbFCCx3KRcixKz8RoGEKV67mgc5TKlnDKZMKC0vdgykPJ3fRGMVOKQyFHyCFw6OKPycrcpMYqRzksbITftXncB6V5uOK7tOj2cAOz28vnYZYBgUVOnqWFDdnkHGH8M+I9S9Jo72DAjFUDPg6F41ZT6wwWUGadglxSGwcZNMN51woUOb9WcLW4XipAy7D7yWg670CMYs80moTjEc4QwsoWtLgpNuJklasuqJS1K+NVygvzRh/GlIXyLejIQItWr/ZIaQ13KumG6m5PbTFArsklA99VA02vsgYUlrdxsvR1vTQw+BbyM0X4Jf51SckrR5ULa+SpWFuXkEDPy/eQ378xgBHD03GHbI/lD0M3PJHqWEgqcdbK8ZRbCUzcU/aa9cDhkcstlwQrfdZrDUXQX/NVstm/iwcvHq85PlG1cw+r2l3WczNVljRdZwLeHUVaZF4n+FQxL7iIdRaDQRcoXLW0WNBULMCckjJkTlWWzX3X/OA/vuaqH/3SxYN1nFJAUjGFhzBpauQNlwD0uoJYLutzAIod/ZoVqyp/jRrRyBZyyahMWxT31nM56cOON1sFtW+CsW6xVHu1CFgwocZcRBq5P59H6hxx/IK2ZFGG+VBY2nfBW1C+9dM8oNm8SwuyzgV5RwdIv+FyVLFJuLkuvyqaaiEjyVMu2Q7HAcX8Ls1jnzGFx5S6TwmowymmrhktCMXYessTZa2pErFW1KWKRf2oXkpVqH5lb7zuGQ4AaIt4wiyQPJnw4Ckb+Qyy0JZybCrvtYLe05XgYFLd6+mtvI5cxezIYBdTaqMupo5USfouJ+iIBjwJ8Amk7VcyEeS8wD0OWJQ1RAlHYtITeHO526tMGEdy632qLi5bsEag29RU8FAk99wvQGOHZ0cdWFQfgUxT6BGTU7zprU1Goqiye1acXLQ4yZMakFsUpzeKkoscxzjZMkhFgChGUIJzysY1gezAKMDxjoD8CRZhlvjYd42TCIFDAbXyQA2KaGmi6m6vj9MM0CdGX2Kd8H2P0XbDz+d5Tx/lXTQWWeaqop9YBOU4r2IwHPUFXgEjJGLWFW1ejI+meIi64Hm61IFwxAhN7GYgkvpCQdtZCgrsNosOSmHSFvO3C5IUoDguA7Xo+Oveo4uWq+jFl9J900EUgaz+mdx9zsu/shlBi8xEoab2pzojZFsBgMTDFLAJPG5aJy4Z2p6VVob2/Y9Lr73/A//5Ly8e4KahonJL0Xt+mF7NW3rliF60DhkyqA4tCsXpYpTxgt3oAtDCOqYG4ohttEVlvGeUss3avXxdnLYtgFhWF4iXYEIBipgqAwGeUHjqAhpqwEUPPAT4SoOEhuhpZOQoQqQUAdMz7xj22IJhFm+z/Z14E5tRLczeeZ2UGja6MMCTyiyOwcRgFseVWdwqF3UVxkF7DcuQXZQPhXq3exFK9DPcbh13szT3KpkSrNzeC4sWiwYIP3x8NN0Phz9Y1qkJUMKBsgi1dLaBfs9DzAISC5lk3uXeQWKq5MjOItmaBiq5tBiPLjiZ1SJgNg8ozfcjAyVZn5ZlVmutmZ5+bTapw6PYIyJwhw2s2QB6S5InsHlsYC2weQJtvJxZoauyDHdUMjCrIoEFQaMs75qezxq8UByjBdLQlrGFTQnDFruuFdFgZGlTBIyHFzVr5pARCW8wR8qQvrS3nxvRFah2DdRoxpL2OTE2BtJXY4gwidtN+nIHXsi8rOElMy+H8FKzLwG/7LXZ8HK5LQAvV5ApGi9Xm+M9NTmlAJtNCXtuzD0WpTVXVNirOIRZgUlPgUgO5s15eROLIE0jrl8H5AHUPMOh7/4NcUmXb2XRZ7GNtg3y7dTaKIhokOeKHTPmzHlBkLKYFnNzs9V53q4sZGCVKrt3HauY5mS8tujEizAU29bXcn7vZ4q6PsZoSlfuKZpdFZEhg3tWfEPHKimNJ+kYYdz3/aZnnHHknt7vqTYhcUGIeyoNBx5NzueCqvZejKuaUtArdijD0y1ZHKCN429o+3qx8/AA3kMKpe9tQu+RVoiDxVgN4fNrgi2ERztoJxs+Gl31F3HhsFSWhv1OzOiYtnLfX/6iS5/7m6dc9KSBqLB7oJQDeBos1rTKHBW217S2CN7BE36BepAscWpdEIhPsSHnVm9v1wpHdoFUzPFdbRIpwvLXr1n7WzHzSmCG1DEB6KtKAfR0xYo15igDF2EodWR0Jfj2oBDKQxUlyN6EuHRCXGNCXAjjXViZNAapkd3//8q3o+qkKk5GEzUl74wCPnKvOH2sHq3Ieaw+EvKzv5Xz6RBGB8nLfls3kvouR+S/g5g8KuOCfY+Xf391cfa7SOJjIUgf7Ib9GJQoKa44pRTwbDAFFehtFPWKtnSdeVWBW3YnysKXa6Xtb+4ze835c3jWRBYWbGzY3d85e+U8Xze/v6efwt6aNtF8jA19JFwf0G5Sp1JpEiY+/OE8TgyD9D/SeqZaUP7ooZcf5ESCeGD7C87zn8UF3AMoUQjimP2+3XS3FDyn+1cBpKJ+epUVp0fWYPsu/7lFNYbrds1N7O2q/dkfHLTOm8A9cI6k1OyrqBckovHLP8vMkL8OmgNfwzj2v4Cbzn22hwKg9Y+2Liu8nioV6Ck7vurfhA/K2ExaALaTs26gJj18tx9kvFCgbFVV1rT+X76mWkS4wlUxAF0JAqHyi9AVAQBKYv/Ol7siEk1RjQcMq9V4+Md62BSruOFLnKm6ugFInUK1UhNQmH1MR0MN9ydQ+YVGAOQvedPcXxOz1/AtipnblpkLPSwocIXmHox+3iQdEJGlUROWhbJXoUpO4feepPBUg4oXTEHptcEW1kt1rICNnF14u/yK/DDrWLcGzDjjfvZwQ41VqgPCb0chtplcuV6AFKeEetqjDYPoDmKvgnWBUuXYW/3tP14kP0Ywc6MtzqjtWpwnRndTBxlnlklPCoP1GEIh/e0veoE1EJ6piYEpdbUxTc2NfKY8ssPZqV0jdT3FImOf+axcbOMTY2qviCXVuUmZqAlIQzGLLXzyAz4jejm/SgQT+kSuwVuXmGg0BuBSPUvcacoukP0+r6zgw/bJkaKMldCssKRzvJDMcu55gTMlNJP9PCwyo39oAKyPdqFn9mC7xmQ+jOK6faJ8zsHfIzVpNNNWe6pjn5zEpkq54SqwNC0FUI0QgdqInqZZFJKg0dZzyBR4lilqaEbdU46NPAS0kkGNJoSCzqulneM+ywrXPsW0MZ8xdsLwYFxXl6VdfsASBz/EhXVdzkAxKxJY24wo2YAeJgWrKxsDY0/xcibIM+vFTMUqdsXyYhl/aC+5IN+W8IsE5V3SI37yda4evwtOf1yvq4M+olXxeKuaZLL+oWZ1xuquDlTJXw1B/ZF1NajWKxCnPka97JhSctGXxE93jaJSdrymS84+0bvd+DzO29BnmELaGHFv/l88b9yoEG5NqcwslJOq/sG/YYjjTS9DqeU2sXWS/bHVF4Puw5+MWhN9Xxh6opMdTri34FFgLgJ9lFfPKPtT6VOsOlNdrD/gwEKhxagRoa71Pv4Ad0dvCagnrewTsoCop8j40iLpQcxAEDWIK1+tTpfgt0p1n9QPlLnRr3piLUTtSbbxRZx9Crmsk5QYj1DtX8cbVXE3aNi+3dFP3nPON88888oqP1/mGjLomQdDZtoDakCz2mUGu7YO9Wy+CuT4b0oryoyHi5ZrATXX1btg0bw1uxkB3Ernzw3b8tWLcQ/MtQCGIKGI7YQbz3Ft5r6sq/HSFjWPDLS8gWtbylbjA1UwicWuRSm2HpAH1KG6wE3X8zVj2waDiasenxaIegpRd59CsUj/LuutwMtraYjkaFjeqxA9e0/7au5rhsCDg/+bUdQcSnChCA0Q/Xcmeo28I4OKL4EDwjNCVmW8etwRmheCOM6+ZBDJ2RfsnQ6EKj6AlWKIpNAetEK6HcLGWKS1F8YiGjQuvSsnuDGItBjoRV6ah1a5LUSSlJbD9SjXl/v9ZLgO8ZxoyhZ38nqhnwP+cB2wxxSgDrSEy5FDOZQkLRVg/UjbM99wVm1Xjg8Z5m5YxCRUeosXBtc5+rSsO0cEW9b9NEoosUis3+BqEPmyJ1R/ZTrbahTzftve2iatGddv+t+AIalrNvIwFQd3fe8FG7pRDHFI7OO+8QZUNy0Z28cGUNN3TzcbvFVpmMMjn+lN4yXeSyuuSf0SfbgQcIMwjA9Ol9SmCWNhdhcwU6VRpGTuXH5ANgy9PRC83SvZnyGTrj0hHmIFAW4msZTtUrUsT9WyasyzwZ9fouoRjdXszwX3m+Y6/7DWauqCLRdsg9Y0GBA4XZE9Pj9CCCPqsI05jX4chBt+1KFK2XJIYvyx78vn1KbsvJ6DL1RKnlhfWtnDqRV8CJGMFT01USR3fnmLBpkZqDQqtXqb+WKlG1tccMl6Bu7hw2X5sGc/XKIlVvlLoaewdjhfxE1I3QY2kM4fC7hhAWk19wj35XIwjUPVc20ogAvaSt4Gf1LbyLcJnJeHpCuLgKerm9tLW/HVdn6wMIdolquYy6HZGSkLqYfWW3Q2Lw24kpq5HbFtsPbePXKjf2pF6qYtXMYRjQNv7VnrABFEjJFxk7p1Dbp4tH0th7VkWstbcKGB0wXd85tb3tZsegxt3Z5156djO2+Xjm/kW0oEiagOOWFX8WRqPKc6l5CSepMs2Be5iHtQ4y5VTJknOD0spkV2AhVVuZ424csdeY5TdHF8t5P/TgHDTcK4sTgu98w4cA+X0VGOmVDIKflOFCF6GbUiUKMJCsoHG3wb//Peg/d4XHRAUwDqTgo0vZK405rWnVUmcgd89uWnyXSboy6D9ZkTe36aeCs8jWqbVHoanUq1sdo4TptiKg20Up+bdsqDn/OKXfzVaQgU/MMS3Ss4aRcV/Cm/XK75+KXYiXwInKL59tokvOzWK8QTGr1TKBJ54p9PvuVvvuhRzj95biwRyFLgzJ725KU6wnZw9+SZjvE0xNq0E44foehGczqKYe5hdDjhFP471Y5oKCM6oXWncj7kD9F6gG/TET3VjugpE0b0lOER5apP478dMqLhcUaURx3+Jzcd0R0Y7bHaTttkROG2UkaUv9qBwOnVET3djSjyYSCRD4FT3YgiyY0o4AhMR9PXfrP6V5w6NK6nUY4yvsgz5olv23NZ9a/Ywc1GAS/73upfsQv13O8x0HcK/tkSCPnJpOIX8B3Bk4Iwd+cw5BW4FEawrvhjbWX4lMPLBD8Lfmbk65LduqaoveAMJj5nqOEYeXm/8mx0xvuhq4IDqkVW69piLo33Q3NgHULHVLeIsmrmHh5ZXjqVaULTKaR5bm+2JpsMnBuSrFU+o++ItMmvOHxGtUm/WSoO3s87o/ZA1oKNtX0/XP/I9a+P2eURtdylLVxn3ljHCuUEfYMBpaWCBXlDyUeRvLZWbi3X1o4UbhkkDSr/nn7B98IJF4f1jtBh6IIZ0WvFnbHMONs37+xaBCYEljqwWIUsU+AMVq9iOF1SAdaHUAEErB0YnFhDZp0TEdWyI/qqNkAiFdaoQSe1FJmwb1hSjijEcYSxaBXqJ76KoFjSRXKrW7IhLlTeMHT+8tWdsYfvMvFtn4nhyrvQPPKFwZTs4BaNzWkxrsL9rd4OTl8Z8T5UldkqWwq/tOnrLPoWQdUNxDo4zcO4tR44eyN5WKK/twJoyrYDcBapLd4GR5wDrwgJf2kTytJ1S6Bkxu5GfPLdbkRfdDeiL7obkRe3G/FlGxGrzxTbMNkpiKfXWJuHO7N4JLi64Kp20z7WYqiO3YhnFSA9aZXZjfiyG+HNwlAdysybsuWAWOSaxIFwpA5fdiN6t0aBKLsRX1oqMMRuRL+xu5EYuxEkVk7hsf/ff2YAoDKkla4cKUIHchdkEmNGy9eKbEPlxpQrszpIrkwFF4UoJR0eK/300CuA1WH5clXPbL4xLm4HJRvIw4NB+mmPp/ywnS6q6SG6n/2dnkv254x58lBjcGlNYSWRxlc0qgjwiJDWv67UGYlQqlaJqb2CCyPeinNTbp1Ge5UM/AdmNVCdC+cmJrSSOOJ4PYPlIVdJnIh/Cl6oAI0TOBR/26vHzRcd/4u3T/jiJXoL0N5H1B2n7/ZQT9zbScuJrO3d93dfPHrBjt+/cO++39h4fXzfwh4bOH+v3WOET+vhnOlpvTXxyxCWfhnKKX/B3rX0P/nYV45Zx7WeRxVrdVBRRvYOpZCwfeSrcezfF7M6QcWaLI5k1tJ3e0Egh1abnbMFOu65P6YXhWBcOVur23Oz+si5mZ6tTcyjh8t5pD4acN5p7JJQoJv17DPYs46ctP1nvtsKvMT89RWUbe1uxRuhXMDy8RW2zgc/b2ZX9qUbpcBSmw74D2qiRa943iTTy2LOhB9QN7UmlyFRkm26kESVEiKkUsI+ag0hHmRO4bOy8UY5VLEYUQ/qoshMtaowL/Btn4RwnkisF1TFetGQWC+CpGVIrBdiTcGoHCmcSjrVh8R6iWsLxVasF1uxXh2KLMNiveEli+pVf0XPQboT7IXrkKIkFE8Q69VZrBcBVyLZbwv+PFtZAzXsg9t61aLyRt8TbW2v8MYB+C0AHORATJQd4JIhwKUVONQt4OoWcAnuIhwXcMlAynaAa1AAcKVUnwCuxIELYCIIuppQXmqShZaPuzKc4KXGhnfRxJHOCBChyshEGHYwm/9ewQibCgLIwu+BtPM7BwAwe00TOCi8wIkoxFseRQrxzgDnF5vzjXlQZQU9J262bGGVKYRXsbVHk+kDKxZNYvpCw+iokxF1+DSJ6Qu1GIqU6dMLvZOYvmCU6ROrvabsK4sQTB9q4UAwkelT9jMPJjB9wTjTF+ZVBss6FhnnsoIhLis4EWbc/ihixo2BF4zbabWmdbO/Ojhhd+W2pm77FrntWzS+fXPpkoqJ8JCqANPXUd2Pe5Bd4cz9zj6nr+A1ImOvVFkmtZoPd4MrcgNgP353i9VHiTgLP3tW9vevvWbFkKhIy6nJrXrs68A3UiQNQlyk+7oI7ROI1ybs63xu9V+o/yyhYpIdlIGbV93XDZmJ/aTnh8dRUXLCcSxoRj0mj8Y1l+Kq1LvugslxNZfEx11iuKvjazeJS506NJfAXFnJ9oBidb42wl49g/HYOCszrsvUKYoq/rzp1cP+ySChlUTfeXKp+ihryWfQsIFSF3YgehBEPuDzOsCnBFTB9pMabNBVbcb6aKf6saIQeOMLSYMGit7MmnSgJt/WlHygu1oGqnwI5XTS7H+N+GL53/q+tWa1gRiL/wJxVcWZZe3rp4AdTE++9kl0Dpw5xwogkCiA+IrPRq4FBfR0IcBPyMc1QBDZWQVOpCIoTMGKROuaz6/TomrCfzqTcJWwwi9F4AA4pLuyPKjUJTOhLnWFUrScNdRNXSHyRahL+YsQk3JyXRSA8ILpiCnQKg3TEei3EZiOQJgOTG5lM4baEuInlrbUUbWiRqxt0Yvl4YpEp2gH1UHmJ7WGV4FCwEIcQK3jK/eiB15b15DKCXF60BNbOfaMKDSSJrXgrWIl8mVQss/jKxkRySvioL9WLNCPkVkP/EN5FV9AsPfMD4ijZFp0UnkpSpmRzrJU/DT1P1NThxiMDh/9B0Y9FAf1NpTEE9025QtWNYBCZ5A73WvmLuZidq/00SMpgh8VyZbu/fEIjYsPaVqSvhR7K2d4xxj91taqsZv9FR9x/n5ORlahHX2vk+p+Ua0HP41quouT5QwR12BccL8c2y6zNy30Y2BN+lwZCfLEYDkeUjHCKm8o1L25dFlbwPEIBxyFelBvIjQdnKIn2QQyw71MvxuQziygya/4bNKaUICE1OOOdfkSSFTfULcw/Voax6wqp7bjyuV/zRsSqGY3HSyrafGU9Ekav6wHzIVo5cgwrLKajkNE/lJ9tItp4n4mBt/BvFiwipeKOp9kIyYDII2iLiwqJrComPsQlht7nDsVjZYpVGWlcLKjel5jQ8LzIv3s6RTgcbmRBFnHINCCVBfqqkqsKnnGH6O0PDfgulwuTnMJ0EDSM3R1H4JLGj4ey7nQbg95QuQxRf494CYZCh/adef5u2ReOSXVvIkIVCWNvJYCdPGFYyL01OnGqo1I9TsnbShiZR1ghiMJFPjk2wPnuiiKoB8vztFVUCXQT/aC80MUYG49ix/cve/HG3oQ4DzegoWSvp/dp059MAsKX++7SoH4eaFcCk7AWJzFAJXl/F58l/0TFpWirT4c21KpE3b7OquVutmS1TCjVmya0c6+jMphtmG4SjFhupp9XU1nykArsZuTVQD3uCLc1XVXkgeUsv1SdxIBHU4H1rwDw8Op5R91WIRWPT2vqVXpQx4FbmR8GRmM9vOLOgykXhDczBm4Yv455K1kX1HRD3HCQU9LOOBpmqrXZ1/VHGdyyXmLAg5xEa4GNMFWUid/dX/BmtDZQC+fFs0BlJcD3Ei+lYO7jZrNHriZVnqC9sK2+i4I2SS0G4qkgYL2PP9mSVdbwjd5YnK0i6YltgdfQ/vG2lP4G+t5c9z4F9p4dU+cBnKGaVVvqW6fm4q61Fw/4uCut82n8pb1boFrGJnBck7FxJqm1uC9e9CfyLTsHxRyMjzGb+rTdTrMXapaoDrtYp0hM0KCYTJNl+kucFAbqBgpVu7VLSKmjd7dcsdUNR4DXTBXVC/dx4DrQAhe1KVdzpJrC+2fmOZLc6URRc2c1AH7Y3vnJxCtYBk9/e4fTV+TStw/mbi2TlgQG/VWagbXRb9Bo5mml/L0dB4Tr1yca9mfIz7dNikWy7na1duN7eG4CBc7JCibZn97cMRb6hvBl0zwHE8eBkKdtdnLFLpm7CmwSOmKdxEF7pBSk8+qJO+uJkuZyyvWm6iCApGyLUXjFAq+axyXU+nbB8HOjh0mOicukD7loXEp0AJ2KHdoiOzZNeV00f1rV7DX1w8DCvEeWtN1SC3quchq3HfqIzMU/bW+rz5Y9WBCdxoQNuNeZaRuAu3z0p5xY+cPu7Hz2p5zY2dLSZUitHSVUmrgJ+JTHNdCMa+yb+pOHVslBp36tYMdMNOHGrDU+mQZNh78yXDI+V1kwadbAG47AuruIFZmrA4S/j0moQ6nGAlHFI2nI0pWtkRdpsDzlvUtlDfVD5fxKtSk2LoCTsGOIUbv9sqnutuPgWcNNMLHaR6FUIRPV/br5puj0v2FMZAdqxej2BY/UjY/NKcWnHLBlquKYc3ds770EoEfuoB3QLBeqVg7gVFF1Zz2TO1kII3ROq06I6pGlksrnTH2anB3G3U2tc7QeIDwpOIYkeiL0c9NdcFk3LMuKQUF0YAYGNdEaVQvHVHGpSNKj/TbiofSug6j6Y9IsGPn1UP5Ytt+3GROufEoX7bjAEX2cmzBcUxq/EmqlzVLUJwjycNRIEYsxmem7jiy4/oQ9NFzPR4XY8fK/yk2gWCp/avAua5RN7e+TtVAP/T5nsOFtRCv5LtLEw1QyMB5XwVPqLMrpoY4DDbdDbL70RcdiEy2JOKL2Fdb1Aw4qHJmX3fSqBantFYZsoU0INZ+8FddeDBuqp/hUGxbsweQ0leMj1FpIBVX/Kb0vgIv59rfmLSAjlTaf/sn3/ZJdmyDbjVMSgvb4Aaajwb134Yc1Orz4wxGg47S1X9GM5VT4eqq9eiGBeAAv6dtToBdz32eqDA0rKuSBo5PSp+TYkKDBJptKbOIEUZnxOhwYLxRtihRiDcEynhL9AFfEv9isKhN+Fp33YCfgmkiGHVG4UxXdTDET3v2gOKdlXCp1jqgBxHgg0is0j1x+uksbl+X+7r3EYHrLUVYJvwoFgZ2dvOUb9p/tRts+J++WfvBkke6/zpVysBRoLLSFd/y4r/ugydTBrc2Fy/EUeVzx4dxeiT1oILhAq29sG/W/n/t2vDnFJbf4YRZIBBZLi3kqJ80UbdqlC/yU7VTAxtm6St9z7/Wwse/ZTJ0JjekZt8f+KYcGGuJHQWU+lUaamqwOZg2LwylHA8aQ2OB9V0PFPApyjD9DwxITMcNoAIDFcDhvfXEGrJk6Sv/lZrWd9ecKFyMNT7LmXA7cJTfLxd9f/JwhcVdxPPJt68UmvOP3Qjjdgv/7F67wL538bOH3/eU1/Ww1YKtNi0C6ZfkER57re3cS4YNye2dtPFGlVaIbr0YgXGKK4o/jb5a9EhBtOQaTwpvlawH0VY/Wyga/dOmVfqoLSy7iY6pyXnKp6RbeQePXXlWLcAfLcAVKbnlS4WFlCXlGlhl1DlyAXoOU+oc2mtcPgp5Uw8MSr30SktKodagNbeZsesZ9CAS11pYIXjZxd0Yaqk/SWrqqjRd0UegJhP/fMbF4BJdi4uTMr9bCpgm/joBqZ+Gib4WwEaRrh0zkKugArFm2AEaQhpCnUHRETExdcS2lFUfUNgI1AxsYrmNqF/nmQI5ttiUMSiIprg4C/Epi1iA1y5qYclpGSs4igc6zCulW5tA1euF2s8h3BKyWWZrFVaU2wLniyjmZL9L7YWB+qDe9+bzKc3iPIWLCKklTEqgPu1F4Zbq8jsPbfIUrUkVOd1QmBrtWDwNjXNjZRYInpN2x3Djo+zWmrU696iiSNWp9TdO4NR6c7vorzyRXfSzPW/405p+ag6VPOSu2dz/al68b3j18Tv8U8HJe+4HazXmuR9xofPcz/Orz4OOQ9PW1fy2cgI//p9iVsgzfvzBIzk//p9ECoXKKzk//je+2vnx36zOh+TVv//C53EBK4++b/9XvHqSb3/Upcg04t7/VYh7mM67f+rVo867u6vOeTdeRpx3753kvLvgz65mjF55GB68T69s52XCWP+L/41Htf/kH+t72SHpdHqT7zVOzpV7gf26c+UeVly5O0fu3qgjd4hoHtD9ldg9hhzjMKqAwiTOMWNLGshVFnFl+025wk2HuvGMKDTcNI5IVQTC5aOcqg6wMs4esCLRR4iHpGUfe5Xz2R6M+Wz/OFJr6WtidpjovcxdqK/s8nWq91+2MuXDCXZ53VO2Vlo/mtHyhclSIYrO3CExCBnyFbhTbluGnoNoGdU4m6nG+8+n0KvPx4vcHTLsrcwnljPgqddVtUGQt1inOCp9UwfN0qrzqqXY9kK0bhaqGGU1RlreKL9Sz+waodQ9pdhVgvajBFcLJIRMYVIjGvcIPqf4x7ZVm8iRwaXGGHwAX8xN4IEDKHpHTTV1X6SQNCVj4in+BL1Ac6S7LHwNUhjaV29WsfjbxKctMTeX8P59qAxtfWuFs0DkH4HssIgftkEiaquVAtnRyY7eSJRaJQjrgEuT0RjtVhHIWBNThZ8HyCTSH4aEgNVK1XyK0eDY3OxW6DRyACoYKgs944bWqg0lbWhiaEAMtR3bUPQIEvAWpZRkB2RhiuQWBRJ2lxKK9Bgkm5v4FO5s5lLYOsrVPad8qBcgR5wJhyPOhCPnqJg/1YIDjJEvX6sLYaEOviELiLBkQSe58x58/asneg8+Appn/dMGkAmFQh8REj/yzj9tbOZBRJhYahG67tzBxjDcnqhWFb94pp0NECi8NQ1WN3WC1BUgKlXUj4WoEQie+KANrQ9aSDr3A0FRp2pWmA4DVZ0P2nSo0vqEShNT6UrF8S0q3V9Ip4AwI35mg5X0rWCI9OpqYLY6GLWwNFjvW5gjKQ/t6Huaiswgz3gTnslQdX+/apOgGLDxfmVhj4A61YVdbmcrQY2MGQEp0tbkIy2AXKJ+cisY/A+HbgXzKiuYV1nDgtE1DCh4n5ERhiocOihLfIQaAoqdo3Fh+NDKCPW6ymMuWPseaN9jI0DVNU6k0ir+0VCCM1j9FqprCocIC0ALlSCfPEI8JC179avdwlYfW9he8wj4mdeN8TOtKj/TGuNndpf8TJi9Hh+fiH/5wUmHJxWWV3XbsdbDPlx50PGTKJsCK6bX+h0fN8wXPezuv3as++ELXffxMtL9J05i5/iAf//D4OQKAYPiKy+I2YGXS7Q0QjUiNIvy7tUsMkya5fjwTU4avop4Dr4PcZelDVWB7HBDu7ah747dZKaS7YIPEp6bcqh0uVw26l+BBVPckzf0ZoH9r/Q03pyK41gs1WBJ9Hh111njcR914qiHdJ1ZNb0wphpgXQmFHJqDZasVinSJ/2mGB/cwQrJ1+m2pliIATgaUYqm/bw0hrhUpSmUrUi/52Rt0RxKW8dzlMvFnkNgKhtOYFS0z3IQMymQ2+4t6umTZCt0j/6wrAq8/5z6I+xhRw2DgIRl+Xtvjp6RuYBhjlW1EDdcDtUik0mXTtWUBoNikpBpNiM7kOMdFN6EW4F6HYRiUMAwMDAMLQw0hTnnNWqUJqel10VQ10nKUa+Uo17h9GONJg6vjPj7GbbXAl8cgBgZ+NyNB+DXgk8bdgjiY69ufizasXrKJhClTCMec61bk0lMBAIXR10YKD5F7sB0QMODxxPkYhkm/BQupWzX5NhfqpE1wUoPn8Frd93QDzm2wR0EainjclIERo22dVNbks2uSR0PIg4ID5FIzUmpvzdfnpWDqg/T3Qr/O6lPWYl5Vfmu1gVQZTwzBKdcRQ9UmFMhjRXs6wojnw4xLEIZfOjlGa+hBT9Oco/5FRVz70ZoblZAaWnpTC/a13kiLjrVUj0uF643NypGTQ+BeLoxiuXr7lOKJ8rQStN51zrS/0vS+d/xKaqaSWkUi5KESReWT7szmIAG+uFrGuoIGoqbjNOTkW3H83taOB9JUDfkZdGmk9/m+D1RyXgujIa340BGJQCbtHglh0p6LEFQiIkEcrMtnSVixbRfCrD4nSvIXi/co/Ox07dTW5XVMLienozqemABaWaw1+VqTxyXigQoDrVC3Nqhws3o8rWcYHmU9gdYTaj2e1lPTejBdtBZMluPVUdM6Rga2rjCPnOfF9LOBg7gevsRViIPG6ppj3Axi2BFC9fsoRjvFG4GZ4BdJOJRJvQdh7obQtz+qreCCsPye6xoqoNYbQaFtKOYSntjjaHV1rSvQunyAJrajjCp1lCNUuXlNvtY0PLxlTaHWFGlNvtbkaU06vFqTDu/xa/K0puEBLmsKDAi1Jk9rqmlNGGCtBwN8/FpqWsvIECc6xHFFZv+JykZo97hej6qdhhrGOOY6pWSRqxNXoeae7Hl/ogfdEprDWiqhBOgoIbR7J0Jq3zTgTKKQRdVRp0a5xtex/bF6/YmYGrT9AX2T7XbS8kV1XOuIpQIAklCPrO3LEsLa3pXQ1bKOh/zMYW7rMSvSArSmXDRSqVKsTqaUqHkuhV4dkXVqMHQbChyr8OPs7P2670UnC9UamhEpcGMFbt0ANTRKFCVQayVQayVQayVQa8cFalgCNVJJEadLQyoIH2uRdQfDsqrlsqquVjWnLa9tDkBEOcAJp4SDU9hs2Qxwvxj4kaE4CrpwBHQVXj3q+6r09TLcMRf9IGEAKc7eiDZYZwDXaS1eHqtASoEuEg10CHMRH+u6RXgobBFS2JYOGFWfQtZxtEQuP+l5qoN0LFOvgWlqIQvu0zwDGHPU9qXK2cXkW/c42iPdofhoUcntksoxtYDsNnxe1EX5yx5oK3dQH6Iq4ekBnW9Du5RTrgs3iUFWMGa/oG3xpVI04XvyuhiUgsEnlTlBGhY68Z6fvjuahN8UlO1FODA0uCvh8AWgwXOKVhk/dHMFdNPN1U4JYWpqZxWtdLNAjplTlR0hCnEBZ4AQGuOwMiBT13A1GFP01mB2/1pUpZM4nljHU6XPKFkNMdZ0Ok4uvS5TU0ueM51QCKPaTYsXyS5ESdWSTw48hbdZyeMF181oZIg0e6W6229C37mLOAllHPdod/RR7h4ab5SXgcnIriTUrXIpeY7mVCgL1dPrh5C2ug8pkTbUFS5kbNUVDpMQvBEWn67QvtCsbHMSyjiUCeOr9KLErTq/hUJO0BVVIqh2RQpVH8v4QGUpIfkClq6EXmhq8dFPf6ye41XwVD0FEc+q0GV8VEsG+H0tuajzuyyo5uoKgGKRDjkU6TRUM6RIkU5DBulC2gy8RfKQmqc496j2Fo0H0plupuUigodDO8iytX8W+4Ci0Ix0lDP9WhgEvLw5w6M1Z3jUA6szLpKaiqNIBVLlrEnKWRPaWRMppwAHyHjo9kdCuv0J+juVJ9hd9kwXFz2FjCrC6BjPVriJ4Ck4juDJP5HgyRvKUERlsZK3qFfYTD2ixTGJakUpPdNe1qV7iYRCA4VIex6VPY+QhP3FpL5LKeWsb1SZTLNfopUqn9m/Qg8DI2U1fa0iEchSYKsGBp8loTnQNglloG0lq4kNGdqBNo2wmhyrt5Ed9VKFqn4i67wMxdNUaxF8Z96gOlZo4aRAbpSbAhqlovnvLjP8Sugl44QP/ITyG75yULCTitdA7nvyvTXo/1pPIP73iiAFDYHsWt1TK2uvjJGOhGSJbRYyWXSyWe4/BtMCHjWszLQejj5d+bGWH5flx5XyA80ygUvDYj9etp6dDBP5hhL5pg68FlnWnlamQ/0SJp910WsBSNQeDqzOKEhOor+uyYmla8pQI2QZ6tjSH8LPXAmVOK1UEWgVQVlFUFbR0AKbSvRCVFSHraW8PrFgZXJSR6zSKpn6C88hDJUUSvHEfx4sXum9QIcooCHSRGC8LGsOc4BTdb1zb2dJt5wlczqPMonYhRMSCe3UCS4TEXvLULAm6G8v2YLQ9KRowlMUlKY5kGAuJeXoJXJDXA9JA2ddIUnf7E9iBXRo0VwdMjMrLOhrJegThEqEtKxMWLIyoWNlxrARoB/nOWJFx7qq21NQuE5EEAqGpEZetUEnwIVYcaFewYUk9ybigTotm4wGclm5PEiCjNdqulBNrQL4TjHHc8f4KhwCmHDxOqhcvFbbHXrd157N536AdJUa6/1WdAbrdTZQhT39GDm0dF9eUSGfCcu9g+rFa7zg+tjwxeuLcR34S/biNV8Ftbe4AmQIxcKCtCl7s57/V47/x65dr7/6IV+7/j/v4vPh0Ie963EFRzfKff9FPJ56FeYa6TG/isXN7I9xRTT7E/xCAYUntJ7sflpikHP3UAyklhcNxXg6ds/a5Oj1EvX5Jh+oU0WV+lVj6vICXSK985C9w/kDDYvE6CWgqroqQ0SKlCEe+h04D9DVqoXANXc3s0jFXSqlh/H0qKH5TKrEYXpzAj9Qgdlg4BFaT4IYVeuaQ3GhISoEdT2X63+itiLwuZOfpW1Id/WygauXG9wUe9tSjpjtZUpKVd9e22mj1Sqqrcx7oTVDWxdUK903xeWFQY2pmqjRO5J3T7ojORaLmafnuVN6Qp7dridxn/Q8f9KdSe21KHAgt9buAQajsTqaF6luUE2Fs767+KjJuyvJ544n76wk76omS5XdSe1oucj7NbJ67QWFuT7/+hnpDKw8CecfviTgv9Z1wUtsx4tAWMMDfAF+7zXlYqvqLX3jFMLicpEY7ztIbSKqhUTuR792du3ed95wsCZKaH1xRHW3vE+cP+ExTYPxH/lMjQrkLUXRtt6/7icvgKFv3PetBVjR5SueY2qjkSNaYMS6xihBzObj0WJkLTJqvSCfJmnwDAzAyLfw7CJ67Rv5vNaRx7Dh37d+3dpIx3nG9Atwfy4Sk35HYdIPCReRRAxoHn5F+cOI0GHxU1gT/6IL6kxxjmmTeledpUzM8syCsw4PeHmXZtChLfzgDi/RHKSHPS5gOTBKd7gXHeHRLWrfPdH689Z8G22FUfecROwGCtPBMp4IJYYP12V+gDfKKVI1sTxC6vfnBR6X5DsmFEtcJHHRlG8VYCyJVx4qVFligfJVmrkaYJleMZ52YA2d9A0srsadIt1YUMXL7bSTPeSgrXQKAlvRYNJIom0auS01mplc6Rb0o2JRPoDpenbKU+yk7ZyXiMOwMs0JiPkyYu5DDGlWfilsgmbNJKt+rFlrFMDXHEfwk3o8mR5AsMdQu+7Hipjf78f7HCH4NQ6KOKamjmHhW1eVP8X1Y0RdisWU9U7uVeuGO3/vebv/6z0X2ycDxEJ6z3fZJ9p4Shn9W/YpTUf0Xtzn/7B9oghuqqRcsfQj7zn2Qft0KT92dXDOa7asv98+NaUg/cdvXPBXOKf+hy+u/eQf/ecL/+xzT7JPaegXbzvzNZ//3H/+kH0CXIh/6Tfe9YN/tfV3n2yfNv6TP/KRLWveGR+2Txv/S/dn09PT119snzb+0h/Av9/+sH1qvLYU/dOl68P2ibQxb1PSYxrtzif2HPzQF/759g/ap3z60Xe954Nv+rv8yfZpm/HO77vtwDNf9oYP2aeNPzT/B9yNf36yfdr4/+8/fGRh9SP/8cP2aeOfLt34xYvt03VnO0yfe2ZieeW8ffB7Jxm6f/BTXrHtwe8rTp2QyKb5gcpcmm+i7JOzfy/h2we/D5VC8gRc5ClMKIzoNCL5lLY++IcejeY22hmxUV7uZ0JFl7EyL1tHuh3k6FDW9zkjP2Is1I6YxiqJAz+8C4+sOF2s9GAe52dgoifQzj1T14uz8OFn5MOzlfai9B4FeLT5qyl8yb04Oz+DYs6zC2vLOUYHXLWEzgJdfQy2JFNseCvfTWfTFD1mFbtxprEdvPKkLGY5biXP+DXuHwg42OLp+1gu+HF0Rv54OhOu081K0YYD6kX+KdR7GIhDD3FgJssYPSpRa8DGpam4EejkBWX5DmoxPX8cE/PHg4r3X5bnVIiziIi25Au0lE/TstQGmZu6UdtJ02X4FFoow0RRGWbCQtMIMTrV5LkVuLWNInk5lRbkeRoiz7V+yPQ8lp0YIPYJ1CVC4LwymWbZBn2Z58vGPQMCIMVcKNapjAvl+cVUGwlAqS4HxtETX0j5XfnskMctxATQuma4dpTDFSAaJUi0a8IT6DxUoF+TfEzb6FzEbZO4NW5RtUROlUxdOnViiXAsoZ3C17u5T9INQhxJ3B1c3VCJRMjEH3Zdic6ziRwaLuCxQNN4TNt5k0PAkOucoEJ4iYJ2yHMHbZHnFlqS5xIty3PZ+hmYMvOLZmV+4ZFRC48WPQ6Px9HjafcK4+pinx+L9Fh891h6zHeraN0Iac/pv5SvdHg1Py1nhv/vdWZ8Z2Z8Z2YEKSZC8Pz8fDwuxTIBLOcSzuBQgps3eQthTIUOyjqbazp/FcXxjJDQYxl99/CEeAxPiN0Pf0LQ6IR4TJ7zZCh4IuzgCbGFHst9320mxQzleTxhYsyCDd9kYkSViTGrzDdjS2QmxXRlUtgBnTVoQKT4bOJ1ilnkBmYLQr/t6c+69yfe+8WL7bPYDi5yK38vbIrKGOyzOJcTBbukZMVDoKvGdsfnB5GgI6HUcoqRnSuILZsHRkbnCqIdHmpvtjqkpoK05lOkRJ0mw0gNLzw0jtSKuMfF7Vk8ZuExChNKcTsX3M0fJo4/Bnu2x1CLMmDl4/H2eMbxDHj5WLw9lnbjbTejOgHV9+DzPXS+WQToLMhjHwe+CMidZxXMXhLMftwq18rY12J8nmN8XmR83hLsNWhJWxhpk5zkWRMn+ztojvu4hP0jd2sxL4Ce6DwDZ4YhkzNYinwBrGYFLeMqvabYoGCkKOiwzFHfygBSSUp16CzprY4ZRyMV28aTHTOM0rQZpVmBPoYOz5nxUQNYd9hRmQPk52iJMhk5vDE/jLdFHtcMw9rCB0yO9IMz6Sw65/kF/2DL/bIV9bl7Jp1DU6v5FPaNDPmYdoHNZmdK+IjOKJnop+VGdlHA9Z1660Uo5FBLQjDP8jh+Ri+E614eX8aSJlb7HsIQPeAAs7VqCiwW87mqc1/4kuphtM+gHdxbToKDshlOLmhWdrAqNkCJTMiwo7XDSjXhEYqcI/by2CICH9TknXSkczk/QoyMOZ5bdZWqmbU4l6cspOfqjvxqCjDsulFScoSP1MtUQF27RGP5BT3RJJzBgqbIFn63LcLu8Dm329x3DRZhtm+6PINKiJOrAGujfkwyXjMqRMIJtoAjrDkGQjDNRdGCIiFhD3VA749aRFPv9tSzClYphmERw9AWyVqHhyLjfK085yWh4Pm2g5eHLSpqEB+7tMT186o3wZhfrffgHHdwB7IsC4RJJDsUy1qk6/syWqxLg0h/KBbLEfP8qSW8LJehNnGlXKItaZt8K2N5Ks3fyrlPM7kBfbt/jGgGBLhLqAoT2W7l4QtM+RV8pqCufpabVWizkXE5C+Q8FwSijJylaZnMePBcxiOnAo8h+nsdJqo1c6Umi2s6X5f6MrPn8GBazEQij/nhw2d4LBcazQHUIEnaLDiNrvNf4onANLDHEfd19w9JSgucaxnJPfksQ5KTsljNpOZ1Y+JX3UyqURK9b9tQqWoTQkq9XSwCQLUhUENmSkATYBRUbR9A4llTbtsilNTdogaE7atMJSA+TTHzQ/IhnJzCA8yUvyEODqcplek/gzYyYACcy3ocOqo0me3WzaJsmoaH7mJOvTLuzufx2Jk3VDEJcrAMVjxCSEmpIYfUPAoQDxqUW6CFyd68dZqqTuEkp+PqxnKezKKyMCkH+TJJFmmBEYMfNfE4zq8SwUtATbqnIkT42ydu5SLqxWvNvaLhUP6Yta7fuujcBEnMgqEVeF5unnvNc7eeC3cpU4NbYsUWkAvgiRyQGPc1zviJ+DEP5SDnsiD35EJIO59Hg6TNDUB7eaXYCvrDfZzPazoaqtZRB7EQckXcfyOONdAWLY/cKmA6D7qADJdYkxIXib+U3FtpQUYYiVJgD2Be0skJV3NKDyTvPGbSvBpMaygcwcB3GSFWNoptt+bb0RHbyAZN/Rh3Q0qtOmylvud6Y1pBFIjdcEaqF8AiTk4yznIwwQFoiqIXapLNTRfq4reA8HkbTVHjmh7RgGrWpo42VH3yQXjLSzAau5J3SVWu2v0DcggxI2SEKQ3ISsHz5lKLTl17SP37PGjHMdE/bos/qtrij12wrrb4j29nf3Nb/M4bEnlyEThWR0el659k78CEuuxSeK2Ixu3yfxZ98a6dcOkSpzv3D5/u+F9yJziaJBb9v6aHOTWcNATa+1B9Did9fGFP14PLYFtDD/feqebuyStXOXBHkjv7Zb2Ki8G70ysi58lFTsxwWQT9HeAm3K2Dkc+q5lG08vRvkyCDOe3rKtd4wmovD/7ycC8fcL3UJOnljQim+sXtw18Ea/I++dTrENKkNP0sNbfMyYMJFrSiHKPSkf2uvWsPBPAvoR7cwdiyzvk1MLgMCifecJt9T9aPluoTmWNktCajVr8FKRCqFubFx9okmoYKeJwzS2IeqarEvh+/6eKVv37M7xM88uB6n2dNWvK0o6asQ6nIYwOKqobHxEivAAz2AF+QfVUNdmNUDqACBCS5iMUcVJy9HbQSVWDix2U6iadnLJ0tEWq3xJ/Cuh38ozaghvx7ctDdAhFq2RPuhnHzpjTd44TU0o2UIkSWHkVILs4zaNuKUrSiy3KST+ExJ2eKGdXzaXDUkIVjwQOIQeQ0NEMZF8+AtqCcnWj8fE5WjJDw3G2eZJ640fnia5iMTqtLOz1TFIXqbL9GcVtniP+4rQl8HoAXmucTfCGGxgk5zs7gqYliLMQtXUDnZLjRe+Fr7RoxBzAJ1UyFamput2TYPZUesyrTQTVBQEqeofotqCWS77E/CigTBqRJEB8t4O/S3n5wwhRxU7VTOKhAeygtl4E5Rwe9vlc2VCGjNjfi6jLgib8YkV1ygPvcUn6oRmJ2rUGpXQ8W0YEZHv8FKdETX44UiVsO5xPI8Im6r5OONbVPUBIlj8mLrh3WVJlZO6ZxTWGaMsRl1NaFL3Q32GCSwnfKtkMmlnHUr07Y9W23vp1lDXhx1EWKhoGmZGK56yIoWSF0ur+TaaqG2Gp4t0zdU4aI4OFXnP4ooX0XqKJqMF2kVgeOlk19/aNpTgwCMQ572W+UxsNwapp7pVWx95cJuVexgkC2Ob/mhd7LPCbVpRtF4xDidPhZwoddNIURNsnVoVsR40fI87LoFKcwIiPq//wIYEpZKDopAJY1G5dHiPP1O+Mdv8a6gOpH/6jY8ZKd772im0TiIF4WdhOF+8l+9quy4hz1gzoa/bKTMu7B3z/PWvf4+X/6AuzvZe9WoxejRj40r+jGOkMfP8ffUND/g395T+jMfLwHBRQB6orExzAAoDv1hGLWeYcekAKC6SRWCJ7Nut1SGMhXBPSR0HIZt1PUZ5GJ9LGMByIjwCuuwCugSIEjdxqzX9PR1i4F2XsrZj/U/NXm5i/+28Mxf/Hro+YvuDFV8x94GzGA8TxGf8VbZeQM3gtqifmf/s0ve55+GGQbKN/Mh0kmYNRIF4WbmIAZtjbyvpOxNqJ2KBRLnBkK7ZixQ/EVL/QF9yZ47qrcGlDdWeAD1grgQ12NKAGVoO4K3DDm7Lvgv9UlQazXqvrLuIsiylUNVY+1ZrgTipDYsJZ8tJiG5g2AIFEVQYAeuUGTwjjB0usuXArgFlY0niSTp5mGPGT90EkbCXnPy6RU35Ua8IiuFMexFPJSYV5k8NCZlpmMEgGy20Kcrzl8kwNvc5I/6Gr+OYkAoemaOF5L1DOo5PVNXoalEMD+MTUd+CfQgj45MnKfIyNvGHxUEOQDw2TEVzlE3dETfKT0JAEBEHry0/wxg+XgTw+UntSzDw7ZDDLkPFIdGGP4J/uQm9x4/XBlcvvfisl9dGxy31ed3Hh76JP7EE9u+TDIPvJoTu7ffAiTW8euOrnvKyf35VxmdRKH5rppqGOiI5LzO55FaOcT2p/9FnJIaW4SpU/kmeMmCkoFfEtHyAyQlcI3n/pujqC76fd43iZ+I+ZWRlQ2EZmMzjz/JCdweNITeLIppWofQ9vH5IR9RDHpe0I2pxiVAr9a5ZopJuxz+YHX7PzgCo15Fik+FbiuL2HVqr5cwwmF2PTgasnTBebqNE494+yTIuBSQ4kBtD6Jp+sqPL6UG+SJVp13QT0+pAhMAbOjqzieTFafnzcspcDODSIP/F3Ww81g7P/q+IlWVzaEHQ+g/AxPStSkEP4WGsR/st28ThKuev4qHk8Xqzmr2TsU/pToxWy59iHeODPtdnNjXR3epOoCJ0W5qxtinFikAjo7pHfkV5y9MmOa/aNsG8XtTlK0KokQcrSPDIop1LS76FCHpq7soSJsONswNt7lxKnBYFC0kGdX0eboFvJwK6C8KzUwLOoGNnh0pXHg9jnQXO172Z2CESE1MJM0o5H8CKTQWxmXb2CiUuDMhBwPa76DNZAHfMuw5vde/W+NNQ++/OSwRolXFWsusct6P17FUz5fXsVOylo6wVjFVM9+H93spGPxf4D49FOB7zn7BQfYemHd3j8mFvjdHVJ9glgC3P+9oQAij8jXda4OZq3W34D9Y365019BjQyESJKyDfSi8GCxUrSjvex9iAH+9e9TS1UI3h1Cixu717qq89fFDEjXJoKkozzy0BnAGGvHMbuHIfXwJeJEuYLFmrq4jIX2PRDyPQ9kRHz/df6KpGn80ett/IGheHUzVFPJWA2XMLnnauqDPNXu34X26Chp7EWTIne7yI+UkTsnRXYnfd6aEFnGaCPrPH4WQV4XuWXyEHzx2Ktk+Op1Hj+ZZBzAM4aPugRwOojXkGWVeBq7fgEmJnCriHlqqvyLW/JiFACWBsmcwlEvRCH9YIVPhc/zr0ZF/YC9B65qTsZTuQL2XEr6n8H8oHhVL71YCrKszpZ2r1IksqFYLOblnvrhtcI3pKmBTmwbyJPGCYOpM8vaSIXhW7Te41qldJ1Y0q9u4elXXq/wYBVKtiffTwlo49Mpgfs0KZ4/bUilKB9UNfsCCJLmv0TyQ5tVfRuQV5mIRSCtCbK/0Q92+VfngGoDQ8aNABIn/OVdNbGQk2ghEMUkWj+kPAh+CcHdErwXwbMkeKMHoY4EH0AsSfAAYpcRVH9hXQnej+CcBF+HDJkEDyKYIAiqYljRVcw1XFT8GCaJa1Wosbp4aQPHYxtljOJnwnhnsfEr4WRsdGg3GSuHsTGuYGNksdFTbMSIKzZGDhsZD4E9Ol6ryOQQ0KNoIgLyuInqvudwLhSRZYlzgcE5BpniXKQ4FwDnAnNTaRznzHoU9IrguDjnKc6FKP/4OIdloopznrTGq+Jc8O2Nc0EF5z7+KOPcY71SEAgkMF4g1Sl0kP2hWfyVQugG5/hf/NGEL/7knGAbO34Jy/XTF/bNHQ5tjBwOvcMd52y4w6H3VA6H7hz54gPuizvdFx8tz4ISvd2sH9818vHH3Md3uY8/gaBaMcLZRVyGVO1AtQ1ILxgCsxBSDgYhqVW9fCCUIdQuL3ZNIbTTMF5nAZ87RkXJNxaSETf9/GKGplf342RkVt06zj0/nxdk1otDs/vzRbzuRqFdhHYhtEUkTljiRcUOmkyy2ctoC0U0+4KiRz2aez4/5lb3rxbLqJtj5vczN1n0+G0/tuLT1MUlnv3UgfIBXD0jtkdLtAipRr5E0/0QcnofD58ikZSoCF9xQny+51vxODffhgfl2/Xwh/oCdXX7sLSS/Z3kb9AsiEXeEx51BmGolLQ5SAnNr65QC05O8jla7IeXQgUPtr9F5wulFdMISsFwA40uRHJFa1pOZzBYPJXQiwhNjjhdvVIaBRbq4XR6iub4yBo10HIvb/UFt+Rjrlr8rqoMBR5iinz45HQ7cjF5xWA9n4vuQ/Cw77Yfrx286J7zX5YX/BnpKTMS0FopPZ9xfWi4PiyqGXIwh9gtYOjR+2WxbZpvGWc58x0MkY7RCOjzTBMus0Nb8CdeF/KMm9CgRUCnS5ma4pgTizKLNAdMW1rRnq4U7MnHz/KdhCerIOoBkliw6pG/gkja8eAXvXyHnhqxPicczQGs6oDRl2bkkTsaU20OHzXgElzDhxrbKQ9+3nvwHncyVkzTtGQ+lXZWk1QVSD3m6q0aq/c5r+M3g/7YJkZSOUFdEd1g3jgjblnFBMSyFkcoziiYdXCPvUPi6MgdnRXmFmNAO1TPBbzXNQyiF7C/ivcX0JIqKL+ylxdDc0BdCOUpEp8N5OD5+rS2R9swRRfVS2k+I6gicEtVu1BwqFgGFvnPz7covvSE5jBTqWt3Pm9uho5Qss84Snavo2T3IJg6ZPON4sHIx19yH2uSKh4oGdwiqk7mLP9XRs7y3YeapGf5CKZ9aRJOKY3L4r5UI72mjokzztqLJUBpCVgKi5xMBFYNfqLtUhA0t6EBRD1s4mY5MA+CgJFMcp/mzEz3jSMRH9aYfDfbl4BcPcNwIDKxKLSkJ9oPlERJKZJMdLyqwyr1lhuhOcipmOYDu6UDoNg9UGxuldx+rA3TRimpmJb6tWRh0vqgPygToAEd74A6eCCzGO5p7WHdAQEn0xleDwDGRaNsT5GMUIxZHrj/ARcSk1WvdhjVKzwvN0+L59jHZ/hTurFF6Ib4NmviLum8oRvzlIzSjUjoxqmEJ/RdlQqI//TFfLpCDaYtEdgxNNM1OaMddGoZm6nOXU/ISh1XInhAe44GWPWoLm0BoKGhvlfnvIR3mznf0QbSjKMDElb6kGH6Z9Qx3kYqQ+JgD/rZ6XfYr5IZJqhWubGYdWMxPzIWNR2LRIhtHX8KWfUcPytUbNIY5adCTJ/RHJbC+TxiIPrEyDg5L5d+KvkC1Z20RNEQMVdw8tDsIEPWTcwOO0cUX+UEvpg2EJ0DxE410NwhUKuLEecKpPK5iTDojcCgzjC4hpHnYeHjPM3hT6GWCMx6wMeMEgYN5ieKxTJO02LHZAgjGQVCuZiMF+KXu+1Lhnvz9qXGL0cx93ygpq6okdWxi+CXxBfc3QFrTB6i8Dq6hEVGEdA6hKtb7Ewsdl7BcNxNGr6cw0SbYe0cCpyjTtW/t1o2aNMyTSmTpMu40sZl0EbMSuWeusQflzSEp85c3jOdAgvHmcTHXVFAmIVs5aqWX9XDgZohXv4qf4uVn2mcbtrs3DP8UwrcSWkKkVPUsrjxjir/pBYGgCCIlulkeaK5fsifOEZoi2OE4hE0AqtiLvlfq6QoGWF6wC7i79KeCEOwdNEWioXt0V4K99jjz5YpJqBUBVt+mNHgv4KCMZrriyNjSvQdQ0OWoQHjrCriO0hvkI3zNJh4mrQpT9MD+Hr2pjBTo014moDRVpQMEDYWYGlpnKdJUDhjgxkOmtON27wD9OLmgAZYM5oXTFqmLocAuZ7uKGToFgnKYBVmCcRKoLJk9bKjSiqsjlIiM7UQ7R9glABe8Y61hwq3aEKJqEqLlomHXMUJBTBzCbBaMuzWPF6YPgjglNmq0VZVDFdmq+uYLbU+Z5it2DBb6WRma9YwWz8zwmzhXdkeTVJmC8FUEbzKbI18/CX3sSYpsyUfizJUvmiYrZtGmC33oSYps4Vg2pcmYYu3auaZVKPM1iLixpmtALspMFuNVZ1Jy2i7FJR3hKAsK7PV4YDszjAm87lPy7qWu3N3mjOjNs5szSNy3t6Ct8zWz5wss4WcmzNbsydktnTcIz0j+YCHZ8lbBTDuteFJ5RVWTGrc4mABuGHTKW2blcUOMC9myvYVc2PbtZTvEefZw1rsMprF36U9S71maE6NonaUdC0J6Zorpxnn0ytGhvUKHOvFjw94DJm+N8R++bINq1AtJU3jTJiNzWhamDAub0PKw2pSt4yYTkazGcOWs8KIBW5JU0K1qM2lriNeElaiNguaNUuLl5q7p4tPFT4rc2CfdWBfHgY7sJZrz9TMDPbMxI9eBQZLZq1Utmt5nHz5Y1SLiQZ1JlAtVRE/LtECy1KlWFCXrQCQpSn5nKrbG33HxSr7qfPQoWGmRFcYUMVHD71xgNniADM7xoACH8F8OVYK2LUsZW6h2RMwoMvgJmax1ToxAwqMcgxooAxokCkqOQbUqsVWGdBkmAEF4TEMaKAMKLBlDhgyV2II6NYEGIwzoHOUggmffThzEsiCP4XaPGBmGdD5CQzo8Kyssp9Blf0MquxnYNjPhKbNvDxZDlThuDkHOmevj8xXONCgwoEGRJtN12Vw+8sGMXU61oC6DuLzm09HgLpDSzodzWZnftKsy2SeDs+6iPFtGvgmM8/XmRcNz7zNMWeuyiXQ4iQGOqamLAFu6dMpN2uWvhhLHzdXeWnBgEX9YE6o3/JmvDTPadPGIqeciis3Y6VjaZZZGi0rrXblrO/tlmbBoauV2//DmXGX75R4YoCsbiXra96IZP3mEVHN6+Qd3IMmKfdwE4L22sXIF7e5L253X7wZQStZN0L8kQ/f4T7UJBXilx+GQmRL6XVsReF53QrH86SUaDdK0XmzFKynKodv6eLeLsXsU6VgvlOK47NSRK/OuRGaqQqpZ1VIPSffqox9jrXq0Ykqi0IZZMY08/yitlpeKvahlb+6vxDEyGcoJW7CKrVokdrIuCIy65RfGeNW9+ctFVnfIZtlX1hFCdb04pFaFWsrz4+LY05sbYx5tYfE1g0WiuddymgGVzOblIIWYdj0UyticzLr3rDMen6SzNqutlJOvuxE2Fu5FBRbbJN8YsC1aw8I8inXse2uYyl65K5E8rhsgwA7nmgqLRe+JqMYf+opmFn3aWn+dkq5z0R5wX87QDSWqKa2VhoTCivyHfAiTwwjFNMsd3gzRrKNp0q2awbcM1aynUOyneu1uLZKtgF5sbxBU9RUwVUposYlWSpl2fkOe2uvo2M0TYXs66dVfmIlTduGBc1bUYcsIbkRNNeqguYebeX/eixo3mou3lYFzb0UiSJojiDf92lO5wDGt5gqRzjfpuPXkOnDsEVK7fl566GLlB+GHHmbuFJ72HLkGrUmyJHjETnyDIAwg0kHSWlaEd6BqgMdQNUzDrRULlITBi/N2zLhnPS4iQWlnHQzK0WbGoZcI3LZetif2Ux67LYz7Zb6OR6VHaNP0mgmFTMgD9wmmqluZ3SodTvTtktwoncxqY5f3s2+zs133fkZrlHilWvUYY9l2rppuuymaXNkmrYoxjSd3oRXAo4e8gyyHrCBq83zCgJpnMYfy2Bq0swpWVKbIHNLJDMRg4NL03reVxHCgP7ZSanihNoK6B7KUYkMZgjooIIow2wwHE+DZkrmKbdTCs6RqOa4p9yUOso8DRc1A9jPUEtn8ZQxoyKMk74cwAuZl6s5nElYuauaPVCK7bDFyjk1HfynHPxbo2RShC9NAZ2eF0xJSyoEQ0lgUyA2M0JIqCWbFuD0VmqU91lpZlTgsrWKacB0cFBtY0p8K9gWw4fotT8lLx7Nyum2kpfUkZfFyeRl+qELUR6G5GQRPZh62JKTGk1PkJxMIW6MvOj90KHN2YKQl46SlwWgvjIJNcrKoahZeYkjL8k4eckQyRMIcO/QzMnIS9otzxEY5NyUwEwfl8A4eQkWoJbqlLZIWIS2EZd01XigkZbk045vrkiPtgFhRWKisw+yzqbbMmzXhk5C/IwWsVGNjSXZpYdJgGKaxp9u1xaEfWiB9myDbZGOuTvfwS336matJiKUgvDkzZe2PZcrOio+0FGsORFKoxSh5LSjQko0UwbuvyJCaYOjmIHKqgoA2tSEZRQhXMozZDrNlmkBw+IIS80RFg5PaWtpqZSgaDhDXqhmYNc3ZSUoUypBWXDwzzaFPyg+aleTE+DWiB8zDgJGeCpIkE0gSSpAqUYKLZo2tKhWoUJKk4aJUDJChDpKA5UUNQC+mgNfg6awJwD4FgC+BZpyh1Idh5gLDjFjpaUqQ5kyMpQqai450EyPgGZZUTNT0oy/UkLnyx5wsgwl1y1uTB1s66YNceZdy+S8uttVqRxIt8XNmYoMpSDGNpqpyFByy6roTrgCQhAj4Eph8CgXfGkCR5oljkzs/8xI/5vc///x8HmCaeUJFGaZQGwGUzImuD7BbEDBWMGpPTopdxuZDMKkchkJZ5DNSFjFJwT180eJAcBsBVlu2kMFpFW5gFqVC5g4WR0XYBHT2q5rTJyMnQmTcYEaZjI2zaTrjE+6WGZpJZI6eQ2TDrgmE8/XiVcbnnibY01Tp5whS1NuaSh8JSctnV/urKBFKdY+mPISvlTIqx5RYoJJW2bMiDSo7QQmW7ky2yhRT9uqAhNdmyAwaYNkgBlLtR3GWJhfsdypbSuXpSV3gL9Mwvd6lZWIOnZNA6K5XcLQcX7kjrKzkXFZoG2YCdvNIrX4MGfEdlrCnx5qY8mMKMOMqNM2Vd2DqYZpkFlsYRvKH+uM8M0y5VeWKdGy6AytUcxU6GYVqxO2p2Or06iWBUbIp9QtTSW0F+zStK2yNPkVbPdRcKwtpMVSy0LDmeRdwmxYotiR6bQyUG4YsGLHSqQxeEqk3dBMbz40Szo0gFyLmvhT8AJJBJjHJdILlAJzM+56h8GwdAIi3fAdkXbCBQWpJdJO06JKpMOR6bZMqRJphWiu3qIAraaD1lj/JxLpbdCyyB72xi3Fn8KsBYgpkV6g1iQiXfhDSFkh036FTPsVMu0rme6ojsVJ02gA8MQ0eplaVRrtV2m0T7QZ1qbqoz6uEjkl06kRGkwpZUuVsmG0KFbaoZQtPQ5lQ7ZShtO7ajPSpiTWShV860d1rVTX/h8VPy3hedqdC4KuGlyAxxvdX3QvkBUoMnPu3IovuJ3qbYM8wLq8zoVLSs8qAgoG2f+Ua0c1yJphaOJ6vXWc/j+eN8F3VECe9SHrPe3CWo9Dvjp7CuS6+ZyEcDqboeFiZSn7tN6sdUYp/sb3wkm3VfFfeWNVr/rqtb2IraRokl7lK0KOvczERZzlhXonOIBfHzXwhqZyM8TRmro+Yg+K0LYOMXcCtI147oiHFo9C9X5zac944M7+VC9Hi92QzWsJtRa0SS8c6A8ukxfefuifk3wRIZ/eh1BTJBjO6n1oDyNmfPsAniHgnOjD+f3JPqHe+7wUDZJrbUjTPVpYNdPUSbNP6s31Zz+cq+GfclfDyyrczXC8jFwMf6LUYq9H6RDuZzs8+znX8W9tj19m11vcOmTVa9xohLnF/QOeP+lOgjpflCv0Z9f4jeeT9UiVAzxyEKC3ve+acG/hj9sNn89XAj1neRn/vqS04rUWuEkgOH8w0MnwOjxxbCHtK0JhaNxZ8o8U8YW1V0kezDD4WT3qkUFuWPxH6EYfv/AcE7yIPLPn/qin5324bZ8IF7MBFHI3YCnQiyg1zUd84/6gmUa4rfncoiGtOHDjOX1IiW0ztYWNC4JDaFVMjX1/9tI//4djX/nQhVdy+Kf9XWed8Vp66lUveAFzBhfWPswDhoudDWqMOU668wODNa1E/j0b7BZnu/UW/PuziwfUoAogejCVdofp+05FldDYbVwtkrLf7/C0Y9R8J4XvNFQAXwh8mytM9zDbdpMEsz/DQOahvQALX8lFSunLENoloWt/4/AA/b1Cy2rKotNk+pe9CqQvB/UaGpb6CYflTgZ3fWhMqEWR6fn7Lh4MdEiyP0fj1tHxZ6mMau1dpYzqqBF5fxSkRE2e3Sypk28aH0SaSrOkEOsryBUoRWxsVkTR5kJut4Wc5x/TYNXu2J0aRZzT/4SrTqpQ4dlRqRnTHmNLvnYi+5/oJtiTj+J1Q/TXPOgPl9hwC8MEGST/RtHia8T7BGc+/vG+mEebKvEr2zsAMAdrlGwMTNzOvYMrc3E8yO35wb50g0IdcZ8iZ+ytz1GHkDrA+Cf4qb3sfSb9IhiDO/u7lr/4l+ctXSxZ1z51/UEeH4fa5IJX9cr4Q3vJBa/sPeDD/AN5l/TkKm/te3rZZ3SJI57s/5ECQO0HsEzI/fMqiC/R2btXH3v0sVudw90LBIQwFM+g/6pAfeYgvIeD92kQF2a/pMF3YOm5W8J6O+wzGr4D8XdJWK/ifkLDn0T4mIY/jfDHNHwINd2p4Q97BsdVhU6mBQhA3tDG6VJ/EF+cJcG75a6vq2tn2Uoqm77smthFUC/bKa/wOhSVufoS19RQgp9SGtcoqdz/AqzlhBhN4COPQO8icmJD+CwQB+TENXXEgB6ezURYFwSl1SuVIYcPqlQzfdjTTOJUTsml2aQCACy4V88qaE4N22nUpwIs5/5NOLigXIj7SfZ6LGx5TUFNjewvb1SG6Gdfy8uexma3Io9SPqS8CgviGyXOxGaf1RwMgZ/UhbKfacmWHF+UffLGkSx/5Xn+y7Bqi10DCvS6tn9+IGv3+YFyEOFTLn5VEb2CopdCV4Ffr3vFtTCDiej4FRS/VM0m/sfe+cEukvKrH3gUbP6BurxHjh9oM4Gi4KV50NKZ/NKCYyWl9xTv2jxItYG7sa+X7IQPwpdinjAclfd4acFpSJePJCm9xfM9vm84wf+c2MskT22nqGdL3oXpOgkWOMn9TTP971eXmYKqW7jArYOHTTDcO4CxUpdQ+MTvV/bSP/Qcp3uAWYjYFBIPsQPxpuzAj/O6UzTKlSeeyBDEWL7wSHCjtt4Hdtbxsvy0nn6qLnixE3BfRVoaPuO1kNBiMXvt2XOjMHu/2rXkllvO/WWeN24UCxAzTGv2F8pXwTTd3RrEYg2ze8ryhuf7sKKo3itxSiP4V9qp+qx+AyYYmObDZEXFTNUlnscmYi27x9X9pRo4IDAf6EL2V4hou7lBgU4KjK+dFBSkf/5tbG5WYkrTnBULHP0QRfRAh7CX3BisTzQ/++d+4F3XeNkEe0BUU8DXFPDe6UwgAzz2FGJN9v/Xe0p2HXYt1rjsDyDiKeErNdeuIsSDuIGMUD/QK+qYpBGn54ksadm18GkoBSQkmVBm0eTC+O//1+PsnA/V5k2pVo2tYjetNg85A15gePIHUTSXSM0fyNupJMeorkHNMin9gbyFpDb7KFTHVuAG1JxjoMTNz+4FRkjzc20+gI3Pi2hSG39QdWzyAJNIX3yHgOcx/lf3M3YHpDtT3daMATpNz65+Jmhg9kKG3uDbmn7LuT8ahj72IM5OOjmapviqhylYq50/0zxAFbr3URROgLkBQ0gTWnZTZBgoz7BvfyeTSIjOHH+BZxeLGwLLHMj+XnlsvGcUXlhD030s67Axl92HVFNkYHWxsi+72Owr8n1k3r4qb4F5+5q8xXKYeaZywMIoOmWpQ3cgGGJhuqy3UVrztVPke/eu4Uvhj2GTYuDIMF7tZmXtosFAImT7oT3XFd61+R+UmhzGvF1bw6xUJsPAgaMD7BWuLHzGfWUsfMMo7BYikTq9KQxG/TBFR4qoNAQs6lcxoZHrMkuggyaDApoQ6coYle0Xxli7YGK4uHUslF4pS0GLxjdmFw3W0l/1YawNw447CRb7AiCH3SjXqhvlmm6U4TnbS5WHFTqlWnZDyCEAyf4R0JJ3E0/8vAofA8Iw1YB4SKfIWy+8fQ+89ct/8owfvfxicsGrevueI/8+f/EAvNSJ24VmmKLddqvw+Nvhtu5C3Z7VMazsU1yBzNnZmnqX5OIs+UmePzxPfZ2nfvY5/RRxmmonPLzMHtF5eyIzaUdfCjNpn59oJm3gef4mtuBu90cMtqkf7tv8IpDWYbFc8ylw/m41w8FqhtdNyLBb04Ps1pe7yF1GTqORVeL3EKnYKx9NQ7gBefbYW40cBKUF3C84C7jKQo5YwH2779VP0v5j+OPW/CPyeKh41HxsEUAe6UzHQnwoRqj4WXfGY/9myN6ju/MgjcfKEKFeV3nMBe8X3JchwaoUqLwQ9cLwJL5o4UsJJeAc9Vuxaxyq1/GYoYpKpAaFBB5Iy77o7Ekqv+hVpYVfegTSwr8dkxaGVWlheJLSwqsfqbTQG5YWhlZaeKPHbGN1SQa5Amd/l4ffY9Ze/uV7S0rLBFRF6s6WfhnIvo7+olaxpe+P2NInT6zp+/jv1gEya8Of7fssVORmnAW7ZrKrJuleEYEPiyl+GXFoj4SuRZDKyF0m0jdCvOyfdEUFsDXifrUoml64KQV712snU7Bywv5qdcKOSDvnMAPl4AHK08oqGIYAt1smIYyyXzCshom1SkH2z5aG7tISMi1hDiWQmreFnkcpBJhbUQQOUYBw9/8yfJKAU4rAddfRXcFtMqGu3oeHDQ2SAU9k785qtZ6hz9b3VWCOYJDpW1l2kv5wAP7Ov7Zir91WZQhkzVjsBN8R4GsujcOHsfgxbwKOHJQdNQkdxHemgvRjQezZywJuY7x7fxFZ4qd4X8RO5qY2XIEyqxtrihpox2pRVykc/dc1/ylXVZUQEnWxo75G7JYM16EUubOS7bH2/hrPL5rvxMFV9tL3ySaH6jB0uLpfIrscmVI64A1Qi1rOeUKPpYXQ3F2nmH+yB4ACdi5eB90eimCqML2ljPyRdjUDkrOiNZRMqIi4GtaHiPUYJwb/gc0wti4M1cR691e3NhWI6JldxDIua69rSMgTwapiLDIevOxc6f/G65heIV6lPAokTfrp652cR+NVzAPqaLerfxmHAexR81i6wwg7lM5zxMGjTNgOBWBw1VjfmoewrC7HE2i/2SPmzCEIqMoUIopULngFB9Y4NUJq9ruv1fYfPOgrcYVFzRtRaYw4BhRORPilhtcHUhRUx2GJlqLibsSCCt/vU7SZGUVfrai/WHNebWyrozEebKMNO8w44Gk6jKVJ/sv5QZC2ymOvPvboYzc/PsJ5dpkn6SfP0h7KFW2DKv8DqMUgNYcfGsUsqwbXmO9s9D0V/apIfN/Hn3jdc9609o8X2z3I3r0DaFho55X91GoUBTRat1/evgtft/svf/J/PPXJeuDik1/GXOlucOhebIkirKW3Aay3BWYLpiW7vUIsezBEv84zikRgHa4oYjyuKuqiiAVipiEQM37k3nEJWmoJWqpGDiiQXDJ5hsghT/DK17F+7dmvPaobRR7MPS0AEzE2yrIRzJqSjEZ2j3aDIjWQZmI/W8beXYn9a40VwH5Yz7KR5cZAJ4QmCBeNcCnXemM7DplS1kE1X2btzhZJ3oAxN15/9l5TNDUrNfv3BeB6HpQlGEpT0b6Pfwz/vnTxgFM/ilSsVu87PBBK5nZnP/upU+9Nz5l+8mBN5azIARup0ZU9ftazbwgmTEGfLfumhCOAEelMnTYCanL5G+jKewJQXX67E5OK4YJJ1XzKbV+8/uidr/r6G7/BCH17QFNMrvBTgyQxT/Cxv8KZoQ07lWf9O+9n6gOFMyn4m9Lw6ezAa7SbcsgFH51yGAc6Mos1egaW8Io5ddcyh4TQ2alnFFNtad0+SGpRjUlRBc3SFKWEBr2Hsfd6VGiahyqlwo40vJgxnqgS7cwMevK0nvjeA5pk8BySUZ0RDlcNOXCzyNem+89dEcsXdZqnFjalqSl+TgBALY5HSk+38Vm/dVkbnb4jYJ06ufHdxkTQj1QmWnSAwYmwm21UIuKVmGbF1dYMYDWNi5wci3G7spjGKoIR5EBsTKiYK4mJSv7axH9X9qjDr0f2dc/e9/3/kjdQfneVCc8/8uisO0oi4oAOTi5vD2S2zKLXs+Th4MGj7DKUrWxuix9T2csBV+lcm9OAVVJECGn7AnqGvoJNHeSLqjNoupvpcYrtbjbU3bmH0F0eF+Oz0fY5ArpzQ4p6j/vvy8G0L+Ifqik3nPQ93Tzo7b0p8inW2ZB3aRqGEP1VXBbPGEicWaDEHwDXeFqgjXyzmddWg8E83W8AHHCX03cgTix8iyUL4t171yABvxnRG6V/yKo4qXfkgaAfvgib1Vl4LKbqt2uSJo1fpu5hI9j4Cq8SXdpCXeoyZ7MGJ5/Y5pVdNcLmmulX/9BLcKqdhym+WUdXKIRAcyEPnUfDaECL6298IEY2Sc/4wV8YichbmQ75uK6xkxeS7Eb0HusyUZPqiEbd2St0lp8O1QgzeZG2O69Lkf5Ztrq6Ew/IbB6KlFqgDG3KTeSGGl7OwnkfF9aR+Jq8JX1LbaaBsYl6/wwNS10vXxOsEQnV8ajzXCb4oF1T8ybqfLmp/i/wTtIIIp866O4r0S8mlgwASE6Qtoyf7n5sCMV0dqrT3aM5YPic3MPPM1gqkekIhGUaBzRHnw0dlAMadD0xXQfRAYZfax1UcyMUOFNUxzlo3clbuMdT/ZZiqa4+iBl+TfX1VTIuDV1sQKKenb4pdB4sjjpT6M6AOakB866+zelbS+17y2AfVEogL9xCvcFsbAQL3oFFRHExhlPEnFCIS9ANDpGc/sZwS9KEZdQAHTxXT613qxrMWeXe7SKE1ISzTnu9HpOI96m6LCTZq3VGBlwb51RxQgCTza9BgsQDt6WCZTTqHT5+b5cjMW3mWXkdxSPIahCZygpj0WKrU5i9FgWh2Lh/k4l6HaJS+UQL7T5NhRkinov0FDuUrvBYaXteL+0RoVDovttvtgCIjgSoiECzM/y0tJXCGimAag5ACjjUgApD8rWin0RFLkEjf6qM7LrIQxpZcTn1Ft+LLX7sdqdyIQWQYYQ4RUtKHTLghMfwxQ/t50u82advMLKEvjQTp3KcjPO/N7+2vAW1s4iNYAoNiauiRLmfX0leribrZrbeX5UJhDn9XAk1BEax4ofupUkNH3nUUCYSg4KV9xrrg8yDX+gXX7MycvAeq3FhIQ+YlcwtNLCJy37xtTp4u0tnWBCJOz3CWin2U1VCNJWMGFCw1YM1Ke6Xym9HBJBiUKYwPvCQnXUUS38oIrMQAwjeZh9frR8bqVgHATRIpWcmJvtVMwJeRSLpGm+kkQwlQGpcGpm9G5+XjXqoLcreg89PZDP41147rkn3NS+EdAN/RqfTz96p2xy1HK4Hq5x58qEqJi5nUra1Eg/C5c67/Ikf45JXCJ4Gq526TQHCUANslQTX1vI6xUgrEzKbECsieoDQAE4IBkdyHyeDHFrL4aopFLd9SgFqVMfcYhwEQ/aXUdDkM7v6ZNVW7bP1UsFdh31VY/NIbX3JShmq6gRrdav1L3Ouq9Qmj1BnlP20cMz1ycXWHmqxL0SxfllsYgttaKFyf7chnipSFqXkLTySoq2ONuWSb4rsETJ3GEncFrRNU4N1XAK5JZ9S42cZJcrXQYidz+DBnvK1sWqgR6y1FQFmPDcNnoe16+iUhjziz8U/4hzNkOTM501/58Q2bRGL1DkQrxVwNom9qVnlxN0nza84bU3IgUhkJO59TTZvcBBKfNK+Lj4LpbiE2kjWYdcVQODoAYiRvf+fAsSpqKi7kWiYkQgwKjISDWRraDaKhLHSFqL1IU/IPBZ4aXf7V4hnImiktPBQxXzsItDNNZnICBRt3Y0n2OYE/DCpXU1taaoUHmiZjpSRT0l52qS8iDsBonr6xrqXTHD6qifd2WZHBwCBxapYsQoyhxIysUJGXWgJZGJAJlYRg+C8uh+0U37f3vXsbyt+Xh+31/HpJSNeyGIET6SoYhX8358fBOOhS93Tdanbp2979W2PbWbkmslFLCvZDDmAI+l7Dr38oIrroLgqC2D2BsMqfLS2Ivmyn0GErp6ky2NsWEdEXcLco9pBCeV7NDUUIaG8kLzs1JedJMxHphwDMFUWauNVcDdXt8fUeZM0ImE+oYgs8JAgx7Qwx/izyJD9nEz0hsRi5R/yPqtORTk2+yWwpmqBZdk6wtVTnyIVJKVQveOUOaipautigj5UoX4o7TMnU/zFzztmNBPmqcQE9HmjHNH17O1mhHXEdc3nAg5LlTr3XClYLKzFHyV4RnTPslI5s+sHnIzRWmHcl6NpObCJeCDUZS9QUXP6z2h7agwhlg/yxGSjpPKt31LcREbcNPDkhUMphGO611CQ8EP5fICGoasxsNevMaGJud/kUYAt65jerIglqOVib9FY5ySVaumGJ4oj+EN/hi9SVBdbJaaBdYoEIUrdyLtVYyCoZLX+9MWHLo4l9GDfew7fCRRgC+dn4fJsxApBwmzGfGbpX8QxKD2wlcTmNowxMMAH7951/d1GpBz274VgSkCCORkqRuIA6LfRa70+AQxTJ3Lpe6O4wQtvYJT3rUuN0LrtAXrpdhLmQkPRt9ZLzRQ5f89Yx3Azi5r5VMtPdRNkLianWC06sjpklBlxRCZ0C3HTlFU3/Jlc4Muw4V+HfaB+55p8VgDYAKxm+52naTUYBQhKKKQZt3nXejsKT7eFb5HnNu51jNIUHhBS1gGmxLqXbiqZkTxFNQZ9Spk2kk8NAUd2q+yJJEyzZkkNZD216NNU9IFxTYMTVz+5VKkh7+zaTA8O9KkDv8VNYht0u5+Xd2kOy9O0HlA3sS5D6qfr0y0A4ZpKFLfwMVTHyA5YLzwzJROLYhYGA4YqcY67Ok6Hh2Z1PaNFMGzFkkmZY0H7EpdaEos1E9z7bPbSzmrfL3/Rpc/9zVMuehJctk+DkMzCUuKsXLdjNOhikLtARr1eTp7AqDU0LPNmTOayN8oYzJgh/7uLB6AkjMd6NY1ZGBhyzBMRC4hEwMkMDoXlsVH66w/pHtRR/3mjF6E0MnQ3obCZFz0TjzwOX42IlRPcjfr4Le+OzdUoMFzuatTHOIHjPv+xWwJ3Meq217iLUQ+lUndVCoTuF5R6ZW/Cc/xCE0QSqnIzcqnpMPLX0qdDgcATB1u6XodanSfhvnTOeFksdTl1V2NVtnw7IrX0XV6gdGPff/7RT3+6+9cv/H9zZBs+19/3tQc/8eIvnPr1iyEvVc6XOVtUIhsasFFgsHVXVmPTvjBrxjtJJZ1y85ijfXSx3oFUQv1lY5b4JTOmW45IMDsBJwYd4jUXJO/ZbWnyC6rKQsMn9XpFG/xJHiKGF32wKT55HMK9BQxt4fd3E/9d1lOGwAyLEGm9s7emUgan/PN80aFQOw8PB04Bma1tIRRTesqhZKCafdJTF3yIukY/Mdn75fhWf+fzeALBQ9lffXnPM9seUMRMNJJUxfGvC4572T/jSV72L4KlI6j4gKLiDfBUGIyfsVsl28kcMZZGiJr07DFRl4OhHgAr1xUbxFZuNCz9itbV+LVcm5ZRbpg9nh6UIHNTjtNISqMGZKUdONfD/ot/zkJFCXsU41VNZHG6f9e6X4MXFem01KFYqBNFEV14Vq0S3wJtJNRV7i4V39aZbnV2QRKJEOK6GjoX7EtdqxJWVas6q2ihqtQuA223DExYc3ysOYN8ilRmiXL3cpPah8WAkuoGyk71FhyurVED750BNWWtmRpeDLAUKE9ibTC2MFXVeX0Cap5UhwGr29j5fy39nOc1N9MxmxvWMdtZuhgGDnJZFpFUIyZW/kv1DfJEiVfD6Z/he/E23MQRqaig/S6XwzP1r768sewU0ASF8wgcGD5siAuCuJS9Qj6rumSK5M7tsOL6ZLfDF6neFkCBRvBBiBH8vABxRzusViCqXqFMI0wtbLpgTOlhf6yG3tIbH2VlQvW1DXpXVSV88DXHVyX8KT/AxdB4kjTM3S5d4cL5lgodfItuKwS2SAnfUsQqba+LMNSKrXVsUS1yxf2dq+J+VGTZUfYNI8nmgviL6eN+cZN88U3zhUbkjeGMeSxf500tcEYLbIphxwZ/feC1+nUl6npElSy8rmWYBA+RSm+um7Z+It20Z3BFw0r19mo16PMRdNis84iHoFMS/QrP45NlC9K/96vrhaPY1hdo9otui1orRcPDe3iwvhG2h1CUhnAj1hsIFh+G0yUVIHuIlYAsd1bMB7+ED0SgCa4we4u+glLHBAfPulHDLE/AoM0R/2T7CWZC9KhEM5u1hOeVGvRENomLZUzwCItQN/BKAfAdTtrloh70SnTjKse2yM4hfpIKf+G7nXsMClkSjtd+a6av9xQ3i71yFr/ZzWJP4D0yiw896o3JIPrikDV/Allbla7cfgK6cg1vA/qZSJi8wodA1kPdWGiAFsKV9x/Lr/3dudcPcGKlQvVnqo6gutnkHQeHkJlTjFkLXuZzjx/Bah6Cr9doP31LECZGQ3DCLSHddANymzIwkBDqFhwC8QBvrOBkjgV8kSA+5UYubbeUxEBA/bz1zD0j6vHlE4rAUEBQpzuY+Gp72pJ9RmeR0Y9+foFE7LJSI4Pvi5FGO22MimFiz9MVmFTXj/NI0V9ty1wHmuhtiBmPgN/9S9UNsxw9ge9KLVg3jMLAFt5eNteLVnbr67lR792DuaFdfqsOLbWyQxOTAHRGTqm1iNF86341MnwEJ9bRoTolOn8q8tYTnb28DVW4s5dHlSZ/9DUnoMl/GkDa9BJwv058t1JMsvJbFxNZMeGpXlCgYx/qAIJ7faCD3/s7RaISKZFMivZTxGdwkJqIDEhlkUQRmIMYVpzw2Y2Z3iETR0ttY3gcWlT86FBTJFgxJ0KEZ88EOvhJKVYrLZkygpHa+p/Cj41Sjy0xRii2BmhS0WYoDdE0EKka54Z/KyJ+q6N9Kp+M5CSrY3mEvK1j6YRs04KfHVCUFFq++XSq+jYz1AbbmmfYna0Usl0wOqbTcIC37/Hy76t8f2ag7c3gjCeTTpgY8UHEjbAxsdjkpVTV+QKMRmBGI70tqpeKw/wMrwW4unlim1408KrKhJ5lR/CGgbi7U6R43tMpKkYCj14ktirLG43i9G5q39998egFO37/wr37fmPj9fF9C3ts4HxznNTph0/rEbOFT+ut8WimGIFULbPSVFlY5XpX3ha544EOJWVkuX1AY7Newdw/g7IhuZqEN7gdse3/qGn/nUPtP/Tkie2f/+Xv/uxPzNHefT/0U7/5D7t+aN4Gph9G+9FCtH+zdvP3jf4hlouoM3suuUh7kEUJ4qQiaWGFJi/PuKEIHg3yLEU/CXYc8ZiF9g/22xApZiJXdCcmFKnGtsVHaB2WL1f2xu5H3PHkQZmsMsA13kutcRW8n4+FWfmCiimBc9TGMxtwFgS6XPoUzTBBLYV3azRLyToL6mha8I0zYpQQ2Pe83/7Gr77kK6xTy3fa/tvDuZ7yN68ZvZ4CHtzdT8HbyAWV5zGHoNuQqkq+AF+EKvtZ3PU8/TDIvojyDcuAIqp2fXxd7TlWLznLvclEHyEeaNXjy+swYfYlFDbxDozeNNvsGsznfC+YfDNb5OZ/N5HXjFB+NMTQRo6hjcYZWpcuqSAYJ1+Fgt+ws9nfl8wswJvdp69KO33HzGL3it0hU3vHyEaaMSgZWbA7KgYJEacKKXgIPyfq/WOMLDa7/4RmUaDHIciuh7j+MCNbuYDe56Eavm80sLt3xRcvWxd0k/HVHTQeVqsjeTj3l+44+RtswdANNn+TG2z+6A022LS5f/gG29tfU73BZhjuWBnuCCz3pGtsfOIS7xe5cCw0CWeUlWts4fGuscXkm6tqOlXkNluij1AfwKR3vOZ419jeqaPxy54f2kMwxSnFtFhOr9TpRIAHt0Nte0TKVKvlZOEQGj+KHgBmyaUaalFdN0xycTy7Q+e9VoDvdKxDeUWbWX4GCISlSLqTyksRWsva9n74JTj+2qPDzWP3wD+Y469IOXEs6tJQtEI7kP0qahf6EjlUS/eafTL2vdm7VIxJKKq8lSrwVs7ekjvBI2lhkn7w5HGtW0qy3v7Jt32yNgHXkEelVQ7d3oa8jD/8OMNh28YQtrl9FMW6uxKU626Gcv3nPg/qHd9axHvfcRHvN5D66Mup1DMBTD9U95MfOMF+8k9OaYIzX7rO51tDwUumrgteEl1XumM/5pzGSG+sQ5fbftWZkprAw0e4XyNZaoTwA+9y4S85a1FSinKVedxXlDDyLiBuF5p/MC4PcTVbU3wROwuBwg01+VSiyVQeRkhVj+2afIoS5GhSg/iPNwItZADn1tqvmTOXeZoSMOAtSpGQqhx1xt72Fh0jvZsijUULWqUXiWkgTYafph699vkVciN7gNcu01KktZGmihAsuRclnxvRb1tk/5C8zXDf8VPDRMg+qAukizUOYPp1bq5+IapRcAst5zaQZ4vhb6guSXfUtzyDaBr6xKtFUxiUOW6wXGgvvZXb0nAy3ZRvwyJDVq1TXKS0V7Gd4lgeDwYbqoKIHFtY63jGno62sHFSkbg6+6z2AX2zehcNmXxyw2TO+GCcl0MkYMOC+JjxxHJuhjGCFj2uGsCNTULZfsQtcYYeXDMFe3XA5HPCeE3GyRBmufFEownjoX4wDaCLmjZzq/rS24rW5tsctLeXBj8z2kqpghofQNddSRqmp7FNzZia4QCJH8BilmIDwMiR4XStLXmmCHbYe6oJvkgtydYieEiFK5ztlFqFVt7ELaNkdVKUUBM/bR1LuM8wm1pxaJ6TPGt5rgqb4lbCWf11Lmoiykcsp2J+SZ6IqJqEQbFWwY0z0ikUzR1gIKJVusF1Sm1ipnSbu9KRQZuBcUYN6W7hkLs3kXPWZRbqc2d1yqHA4r0PzoqDs6b2osXDPRWojpSQB/JXKVvB3l5Bg+bBEPakwddeFfTg5zwidt9DES0Y27FFjsicI7m38EZu43cifqdmnrORpyDyFM0s0OGxmdYBAubB9RpxOqd8XhMRkxPK0hgCLDDg0+rpXjx0qIVczVl+S2RLs9+CqWRwTImde5n7Mea5uoaVuERd12rcIsRXi9Z3oIoelIacCkti3grAehqgK6FdLvL0MvIMF3lmGXmWCMvys7k153B1j+FReQyP3S4l7obzrmNK7cYjKR4r1jnyBTlpAFl6HA4lhQ7mW9EnuF6EHfJ8gTiGxO3X46WYprHWczbI+xbWGKItEFHOSjcfl8c6+ek0hssuY9Y5xkhMAcMFeQGwcMW9qnCoJTgFTrwkzLA5j6p6tLTKREn9SyE8z1GzKwht4w+CFyC0nUO+hBY55EkIt8G6YpO9S9sFM/O2vCzqSyYvM/rSkZd5fUlpK79s0xdfXub0ZVnAo/TNR51A8aIl8zuiZe0qXohSvEwTXqnIqSVPwScg0zQRRRZlO4RCKKeIkas4RYwdUwEb4ETj80fQtzgXP0+QrGtecR7ntUW36Akk355CEv05rSQzlejnO9VrYHGKVKIV75C4O7jYodJ2kGTaSYi2pbV1fuXSCes+tMi1tHMRRxJ3lKuqlFbjVMkU0U5XmqAVk5RQiSNhxaIuJkrXuKDVK6qx9bm8xdmSB1Y+nj09TPlezU8VMc9nFT86H4i5hx+8SF7AxV7I+Lnd4OfpXMkZBj+3P0L8vFCx7sISP2c4ao/gZ49DF0hoC4fOl9BsibNJibONEmefyM3bJji7jRKLmXhpWMzEyxP1xceLReBl2sovPX3pyssWfYnlZVZf5vBiZ8B8BZvjMWyer2JzFy92HZvDS1tedirSZwbPTzF4vgMYcC4hDzGWTsvzPEReZFEhMzOgeBKjVo7Ak+188BVVT6EdMh+QjoBk2ulmR4m4EZ1HT+DA+FwRRMTP8WfKzqGZkmr159JF1ZkiGZ9ET5bJN2mm4Isd4zOlozPlFNMHM1N26iQgbb6ZKTQ0U3SKUE50gpmyDZNim50p2zFTttOFiGSkw0wJUkyMgB1k4wHvCrOYFbjVt4VnxZyZFWdygWeZWTH30GdFVp0VW5RSY3XQWcHoyBittHqL0G+l1b6EZjADdM4Ymf8CxRa1M7xY1O7IyzZHqGNL3H15WXTTIbb0vFvB8+4YnvtVPF+u4nkqeG5JN00bFJ+qoLgdLlyOzUlRbYSsK76eJ8nA0U+/+4cvrv5h2IEYO+lcQeCLq3/FRZwoaKjVCdY8gWzsBDMMZtpYrFH0P8Wi/44hhD1PSTvwdmShqJWTTtF/AsLe8bARNhYdf4uwc8CiOdqCSPVt3PKBsOC+txsf+PQ4kEWLXNsYEcM8x1NI0DwQZxl+5Q0J5pWcsQKhuCStcAPrC2L5djVvy0vXYtlWfoktluFl2WBZBX06Y+iTVtEnE/QZJ4bji75bQS0RU9KhozcMWY6OTg6y6m7UQnYbdoHbrL/97Rr5ODqbHv/8gn9wK+9lK+oZ4XH0eABpSYpayGu0G7uL3fRYfGQYzFREZHTqCj1GFxZdbdt8pXeVIdaW/TC1OU0cPoFX6hr98/YkPx4qvV0wW6kM6tzjmYqL5YQyoxbqLGoG0NjPF00zT3mq6RBQjvuPPmYwXhjrqaZDQMhLlmuSCc5TckqeQuafxD/Wy8YO5WCY8SGddkhTf9NkliqeOhchcB6S1I/GE+hJukPbq0XoC/EL59aXTEuQAcZYc4AuRjG5FnO1pmvm3aP7aN00CQ4IBXbvulmCI9Soupl27mDahosS/8huDxrYDTiHmhUPppVLmupR0Pgv7eq+JpR9TRf7GsyNx9A5dg90jsRBgmA8YTxMy2S//JqH6Mdgd+Uo5lfw8bfAeUG/YiYwEZNSQpL8/rXY+Q/b5CMfopeKsUAfQtrn2hJwAoKHCJURDhHmrXEpzrSKi2TOQUKkiPlQ2KtWS1voO0pB0pAwOP1uyKUzey2D/IozCq0JBUhIhZvWfl1AQUUPO0z/NPLaFbGoO53yDfQFU3i8eQ2+4hojJzV3PqAFWN5Rxk0saWH2T6olq5e3unpRJNO3lr6FRmptBIS6BBj1WUrG7hnlnj3ncjeO1Mi3aNBkYg9HNZqdvfk1EzxnL986K3ysNQ1z8cfnu4N5E468QM4S6L60qM5XQRABBQDe8avGKvbOvuKwM3vFzYU4zdPzXVX4SCF25Fjq9K/7MVi8hdHjobtbwP6QSS7EQS8wDfFQg3oo0SMiCrK3vwIpENdJvDoXFPU+COmwK1U1Cc+e0daO2gATUa4ZBmns1WHrSaxhpBKCq9bGRQCYIM0XCW6GKiO5V4NGtnh8V0RTwlc4BGXdWn6i5R/wkQNHd0WG0iE2og63Q5aIDvnCD6DYlkqNtHKfA/6lPeArzHjldaPSi1RIi42WFEDmblbZi1qhXNTSRBvZJ6eaM88/7qimlv25zO6tk2L7e4RiKH2ZYKcch6JiM/u9oDlVldvv39Qs6LKzCnq/swqaVWx+zjmTn8OGPFs10iY9bML6/jHC2q0eqXfHTtT3TjL5WPBnVzM5XXnYdh/16KlKaNESQ2jfevJnWf7QuWm4ybmpN3puCtMMDwyfm/7TDdWTLDm/0QPT8N/I7uf9Nxzv3OrzSGXN5uCh3ERqTbiI1Bq6hwSh7wv1QlDran470R2kT/GxoDfxEtInkUKhnhu6a0gfrl5D2rzOk/fW1H/h8yCWf/R9Nh2deMUJdWUfes34DaeP6EHis8ZtCft9kEnlFUpGAZqGOtLVuQ6GIQ/MFxRUDA0/vOn+m2PTvVWZ7ng5Dh/1Ww+fj1K8GJ7eLTu9f6RqzOORgKgIDZDEB0Hul3xWvzoID5FTU2i/xfeDIQucwbgl/mATHdsgUws+fvYHCkHLyqkNDWkNJO6fkGtAmC+h3o10Vq58flvnlTpR2wVk12zyZGnV8oPsYyifNCn7OF5UH25uxBZ0zfhYMvc4K1eCCtjC7ZRGc/FSxGrIsI6LJ3Du2RVTLNz+yPq52z28mLprv24xHYsFGA3aPGHyYiorqShbYW38vdEVdXON13tPoPGKddPV/n3lfZaksGo+G/t++qk/dVd+fVKaI7j7w+RhEJyuHYYDkCxjsj8FDWbIpX91onsJf/Qtv5eASh7qvYRjw/cS/njsXsKBDDvQiXcQjtYe5h2Ez026g4CqsNv8trmL8Ieb30X4t1Pt+pNvU9WuPz2uhs0ndGF8t9o48DZX7zozOLF619FOqd9VE717Ne1SR5zV7/r0o6ffhetL/aMZlp/DRsfrxq+P6Hhx4pCSF4eyPzuxktddD0PJ62HxAJ98JLKUTz1aspTvyFJ+0fcr13Zokr03LQncwNgi06WaJGT/W9VUIXo52kEv4LxJbSfeKe+YJNmn8BVuI4FPuYvjKx5k2W3asU7FgHmfRM7olSoga4YR+frFg4rN5EhvyuSBrQTqwYgZmNoiSeDa0PU1itbdx2sXINpzi2nuueuI1d25rwyFTrIKQ5FPitWZaXSrGb0zZKrG/YhMI7Zbru7TnCsKTMC7FWhdefmsvhCJwUs4qBKahlcPr39lXw+EeL3HvKa/5AXq8MfB0+97zgyLWikUWc4YUJ+7d90C8HOvsQAMNiblU9AXsXFCwyr1kLtUwBmaq0T9j8gswUisuc8Pp4/hPpdt0vGqRGj9FVYnfdAzlugDuVBiNk6VTupFGEt0pPahXnM6VlP0R6MOsWZRpK0ciourHzk5H6auN8Ga64fhXvJI0VjLPi8wa1JIIP02Ala5oHQIowtUZ19bgE2dUc3JkJSWWRGSbF3Z1I36WVHgpYf8WBerTa7a9WUa6FYAU0zpdT/qc3nZJ0SSEF4QXF7eIoZu/ATLeVVzefVKvFpRxOGKWBSjQGXzjHlingeaflg49X4aHDVYQCn/qiEG1C0wk0/1yjUziiv3VmJdEOI1birgMOytZvg+2xseHkSSflKFyAH/EYIkAEgiAUl9c5DUHzlI0NYTweTn/cjB5GQhkvazIYikDxMioYFICIjUAREVURuIwLChBUjYb24KkBgACYcBElbuZmEzyI0UiyngrgCY9ESA+cYkqniU4VGSGGm+D1i7m5rgBo9kf224t0hDaxMoHRaOQCYqGpcYg2EbRTjAe7ZeDPveslU0bMfpclRW9TgGurouUUeKaFDZ9B3m+AHW5IErZLS4Ghe3vobBVcK6nl7uedWu+3srqy95a9rc9YLDXJ835odG13ztC6QaPtTTxemhZ3rqO8I4EG/wAgiEuMDQeXbWAk27OmkFJtU+8hu34gfk3ycvJhe8UvzEG6gOHgWxyh2e7zNaUE3ujPp48g1SXzZJYicWf6xQzlXAiCsG2odZSLXjLsbJMBZVY6IxWsSKVPy9z3JMPdrwKulQbnLX9sTaj2cKYnRm7Od3+Ua0UVDMM/SCL8W8cJ6ivCxsLVVYWb2LVm4LMOAKGXUvYycnhdnfWqu/vlhRwxNMJKCijIHxK+ZJiqcpziWZ44/Bzp/IJZlyxp/3Pe9lurmk83xCiI+KM5w/a1itdSMs1l52SQjWXnZq6CwYuJHQblgpFBq2Sx879XEWHkjzdPeDX2PZGy5hDvh5oBvr1/lgqs/3D/ATXxz0teBD3NJDGuY8cHMmYU5HHi39kDyRpk/En+7fJGVP3AO9WSvjLFr5bfzEJ+/wz+c/CXOcjd/F+c/Tb3yYqD6P/4RQI6+v32vFb9Yn0j1wuBs+7JSnt8FHrNvLhrqXjTBWgdk9642lUFklCmQscStOTDxKMsUIRSSC/+zL1a1rUG5dA7zq5gVbV/6vunUNjG3SCVeTDky7rWvYX/v6iHU+HTy0Ag3OvlruWsPNdq1feRi71v/zTr19cTI72aUW2jAsMHz72/Dvb6yjsXsvhrTmUhy0Zih6s91cUNnNiaUnT817LvHnn5HXP5ETIN3DHczInyhsvr8D2IJXrKnQ/EbYbODn/WzZDzz0kIFmkA+3CvhUd8svk7siMSsYRJ0qUYLRTu05JbpNQFpYTatXVud6xcoMBWP7urUJ+7rxWIO2uod77HFOXoG/2T+NCorf7Hne5LNXwKbKt2gsIDUh9ksTY++uxN5fxh5zsWodVGI/Op7XtTKrkevowz7PfflrR4U7O6sHPDvHDnj2n/CG9A89Tz4Lshte+wjvR1cFSTe+9mEIkt76byFlPfzacSmrToZ/o4PgtdceT7x6RG29/+RFU3A2NsN7kZZcH4xekvK7x1cIfd2vSa/yGALLljhGqmsZeonw2PEvEcJJ11FziRDhOyrhNQ3jXEJKSeFBg7XX6QV5wwWbLogMxxKoDoutrLzNT2PfFYDp5lN4kNrdOCvPkC1aQRacB+MttG9oQ4YVtZimzn5BAJo2FxRn9hezNIuhlh1SPkeRvXM4T9PIEVGH+I/VW2aRYQH2P/dr5kWXuUvTuKA4SzNI2EIZmNd8yRrB7kv/2d8SzarFtP8/e98R3zbSZP/ZnylTNj/KQmIQQwEURVIUSTnH8YiePPNPx//9KHuTf3vZrM179HGPum3OOcfb5t25bc4557z1qquBhglZtD3ZmiB0NYAG0f1eh3oogLFQBxZq+OOh1aL9OZsalxgiO0j3NbAvwD4qQfsuaVziD6JUWyThE0Z2AfedvCzb4ILWUMbZ+eHqftxCpfC2bSt5P+7w74uoSmf2ky5iEondUjGef8VNJNSkCC9caezHPVqn6D5yN/mUPrRJuTEpiUp8Y4V4wGzSI2yzF8PIPNQ+z6LB/lsS2E9bEsA3wONTMheKaEsDJCXo39OoPTYCon1k+RQhZI83NmSvTh52R3gCN5BjQgTtmJC9kGLy5TCfQnmNa02Yhz8XqPsAjYBlcl+egKwLj1FemaQoOBXkZfQBHhJnR+GFeCjbT8UjqQrzkQsPLU4licoLydv/z3PwPtDoP//u1H/+jYTniWQF4MkxZRrmdhHGZA/zRG9OstgOkcf3IUyoUwAMB1R7w43aHGSRexHfahPayDbGgV4+cm/7PPVN5J6CkjG//Z9BPEaT6l14jAOf70JQTA25g3gH5lddsOaEAkAz2ZevDFD/YRLOV+BcSGqIyRmTh5tLhtSikvk4hdgjvk/cLTysOKpDumNKbZuc/eff6jF7htYUolzAzJRKkyK40ZDP4z//fIrKNEV6ymm+Hpsokv/IrhHSI9mF/5JyVvvSbwigbQOWaSfbjboFjuTON/ephuPGNKVZeld7hJwhLqI58vxriXzuOAU8PiF0OUS79ueVt3hXHwG5fSohK4YbMqYIjRrZ4Mwz6Ft2acOZRG1LzSjgzM+WJjvLgEtCjN3b2UuBwvkF2L61ffh8fCphA6gRoGZeEgQEnJWYwb6AQZKJJgG/TTobX+Q7usQXvswXvGzANDRdfFwCSn5jLb5iYkjlvUFXseX3Bl2TZUx8HajknL9Yi2/gGQfpxeKbXKanEaM34+t83E26ihHwlpTkaVThFfTJhKjCKrqjkDernx/HdJOqRA/mB/zIYdzmnzbgQjp0Pd6iG3Er7a8SYjC1pMMCiKXJ+8gD3TRH2Vma79qPP5mnSyvUiWsS8LgVN7jEL42ZgrFHUexTQ0qXz1dJdzAkL01jsPaQSkbky3YKtIAAogsK/20GhUwezQWEk5l8OuuXy8mY0USjRdwL6pMd/JmYY88mtwWylmQTknNnJNl/q9nulaSIoZz9O+VkJlcylx+bzLPJJFfkmOSgIU2OKnIqzJKz/6acDE2RO8gcmcyzyTRX5IhwkJyZFekBfR75vAFesSlRABdMMF+R7zLVJJq5RpFsI2rItmEfaq9qlAOFiHJoY9OmLYr3GRit+S5GxQGOHBDl4wVvZfGCArl1xAsK1u4I1tYfJEwfHg+ITUAxCThvX5BYEhhK+Pkaw7DHMGwyDAd5GA6eDYZbRHx7McOxG7eox7fTjDuAI24+9qgS+9SKQwZqnTpyNReKdQeiYZoeOdCdUsmMaclMYTtGq+0odicUyvY2Ml/KA3lIZeTepSmNkHg5g3Wwn9TsMcBVmSZ0W1CHAycW5LcNUMeCfMXgIuQFRfgztYAfO1Cq0VSQrri3UKplv+Euvcy5evbvKLV26CUhUhHga7xXDprSpLhI5VAe8DMZBYoBX1sG8CE2IdWxqVv4R4B/pPDP4I5thVqybVFbtm3qyLZDWwD5lqUDUQDgxtjE1MWmSz1setSkO/sM1wHIMaA1nLdG6zZE8ApCBPeweQtdMIDOJVznVBkDdNxFGmwglHWTiPaYCU2QQlJrjOA5c2KdOXHn2TlBj3NiPY6YDw3mQoU50aI1vvc7yosaRXGpgBsBBusjuOE73AioZLpt8pUXdYcXtkEDxcGIDKRtvrAsxTfALZj+5v/1///kC7//z1+2W/S66G7LMrfR2ZrdMtEEIknZFC1I3CGbOy0YFUYCSEKpKc1Gli6Sa38f3aaRocvMBaLezlgua5kiB05z40Ue1h6mPouwVug+Cd0a4lcDumuKbu3UnxHl60R4LUWXYuCyCatJPVg9WoO1Rndg3WGwE8A+x+lz2rPhhVewUugxxATecexguy3Y7j0wa6guI3qLET0wkw0FJrUYtuV4hC06VplDbCG8Oq4x/CIamHkEbj4uOXOJ0J1LYP7gdtoKxpmCceziTLtgtwVHaXeqTaf9b67NpqRjfnnZNkMr1bWVAqn9YMmheIsIg2+bYmk5WB0awBpQC6W3qIsTuEMyJ9ygK3TrsxP+o8GIsji7Qbeo+kBeo+JxzXPAK4IRr9I1nGTnoOL3Lsfm5XGYJh+xSv1OqL1IHNrEI5s4WJHxPx5gFkeXaffhA4aAafaWzBSuQHAmXELeRCP9ETfgddqSAyPzY4xQj+6yQSWgqUriQ6jokqvOp6HdI7PW8biXs61PVV4ravNzP8ZzHzb24hEbFeaKGFP4q5ASYGA7NqNZTUftQLYy5GKcw00zqwEO9AwzHbLlLNw+9mFMw3AuQ7X0O7LvAPt2yIz9PKxpKWL9Miw+wVg/CcuOjEeO5olMFXEQGiC9MKzfkTelr/AYIDd9hntjae+68arIWkV2+tiZqKMByxTBq2QOJXPqLA6nQgEqI41lIP8Xj4RkzmpIYyMDGsn52kmFDPm4xJvTYIEs2DCr3BK3gazuaml7nooj4yE5y8QxTgNZYtfFQeDL0CahUErV2AMw0tGNL4liyEff5OuaX2MsN6lmPBQoFpdYMYu/eup/8LlWqKTF662pT+HY4jPfzln17RgghoTUBXl4PaSydBJy7eKD/p8etMdbkVN8U0l5TxBFWBezhyCuiTPqfFyXerV9uSXW/aQlnQ2C9nE6f+L3vLCsVcyySo5lDbDLtswyLKu4LGu8cCyzSPpIsaylLCOMF6371BZ7ToYHkTYvIzlu5IhXU+IFSxJPvxytzKgBh7WUeJEQL0CxDvGC5YlXXPyzE89PD/IXiGcLqDsF1LUA3+5zzqvrefWMsIknLULeInMblrmRvCRkFc5zoShuqaW8FbL+79Q1WTL7BggM8OHV2qqc8PiF4jGoK9hQ9p4Mm8cMm94yw+a5uJ4j30AO8oRhUttx+zy1jfh5CizkD7G20Kumk9k2X1HmMmZ+XVGZo0IBeoGSTOSpdF9m3GihqnaFITU49WX7ePwUdg1+XOSJB9vm1rV2cBtnHoKz/j7V2RC/vlQ4vOuBqDRo4xr5Jhu3gXtln7U6u325f21T1UJaYsgNtudlMS7iJUeeXtdTauCC88/9PBEt8MseplAiQZLUkBZwyVRxOb7MhVyiz8QXTRWfEcezqJCsnHEVW9Ft9ycP43vZgxTbxjUv1xehqy7noD7oDP7qtSFoQsvCZlPkTPwh8xQR3aPtwyzoz5egPyqZrxTGG+axJArBa9pwPmqwndMKFMKKnRV9vOAvbi+vBx+cW9SDv+p7jtWD/8HRgP/ASb+b6cFSynm0D8QG0YNt8lyWTA/4xEjC774vkvBfLCsJ/05ZJGHpdduonPdMEj6wkvCJJHzwcZOE3y2ShA9ecEn4RBI+yCRh7YQTk2TyPkESfvdZJeG/+LhIwurKPVIS9go1hTJGDJWEvWeUhB89hST86Lkk4cMiSfjwuSTh7yyShL/zA5WEVQtWZfhEEv5ISsKPnlESfvRckvBhkSR8+FyS8HcWScLf+YJLwieS8KOPhiT86Fkl4cMiSfjwBZOETyThE0l45T2WhLHkCrOPE3xAkjDc08VObjirj3Zyw3WdObm/MysF1ZZzch88vZP7d7ILozkKJOGDL7O+RSxavurUvlmxwPQBOHV3x6ckAtxDFrH5KTW/Shzgj/S4oXMc7xjqcUv5xOHOcP3gWHSBGuIHF4bE9ZxqvOKoxgeZ+xvWE9zf+uJB67MEypmZ6p4+w6WAmoXe79NLeL+1dOt0QOnesaWn7l1b8+lnvkK5lJNFmR4st28GcHRoH6weXLc0sxRbXkc6odjHhGItpVgmGcMGfK1kfJBJxrAWJOOlWBeAFwF4UagYny5SjJdmXXHpxaxLvALeAcbKvDplB9TJyc8YmRd8LTXfN8H3hKgnRM00YaXnCzwoessMis+u9q4sqr2nH1N7V45Se0/n1V7YBWrv6UW193Sq9p5G2VKXi2qvZL9vau+J2vtvJvq3zP+f59d1VVjl5dcsftEab1f4/7zau7qo9v7g8WrvN+IQVXi/3kl/naRF7ZVSrKSgaq8mz2VJPeDp1N6CH7WOjhxvLkLid2zil23iJ23iO23i0CYe2cTBmVQr9lKt2FOtmGXfgALVileAk1T+jcjLa8VgFsRFCu6bg+vZwQ0hLwZ57GiqVryRasVSgZAHg/Szpg2QRwRjH9JTDXpwXbXiSIiV7mtiX7ioFR+iVFvk/FvFggYrCmz2WVNRg+OWEZPjNpefHmTeZNICRZqmAL6eDNrmky1xTdgQWcW2EgcirGo/UnmAjkHE29rjXzm1peF7P3LumYQrDBlyzYCaFD5Aj8u58pXTQC7l61dOZQSIS1bXCvCmoQCzEu2q3HtIv3JKbeXRAb/mq+No5TzudPWZJDLQBO9ivk90gAlfuYaG69GGPGKUNCGKeVS7j9w+H7LFh2aOzWxIFohdIGyPU8SHRhEfiiI+ymp7OxXHazR0xXHfFcdb+pVTiMTQx3mj+jgqWFoAvXMox0RoHaOPR5RQIIcFnA5YH6/TNlXtV057+zRAyXBhQBT38SdMv3Ia6VPtDfnK6Vi2kI2lAqSD9x1lPCLffOYUCis+WJMp46CZiq/j3C6SRsZ4zAOwjpUXXFeTftmonlPGR5kyXsP3I6GMt6FBbuaUcQyjAyNmKgXhKcZnTif46Xobgc5PhLRMNinMKONqTSnUyvKN7s11PjE3lIypa0XuHecrpDggTtVvIpvczb5LCkCeQZF4roEGMs6WsmcIpvw7CzXxMRfBf/5cRHCkZ/J1VJgonf/Irh2kd9IPpyZlrfdiTVyqJTsCFQv4yH339ykASJISPMq063wwFTlj2sl/MNXX+Y50IxW7ytiyA/RA3PuSl0AaT3RNlJPGL1LHGRPbUleKOJXGAxARfUsEabwtc7wfgRYOBCEjsBm6Asu6FALaMnF8RQaqS9mYdTnLvZLlXs1yr2W51zUJtG7RWda/T5lvUX4aiqMK6QK+uGTGofi2FdJ/di25gy2/kP0lI6THKqT/8lp8F0L6oZw4RKXy/30ucxjHfNyQ7qDveFlK8lVIv40BawNC+gaPbyLMbNLduKKz7UuxT5el2gKqoPGj9GN/aDHn2392LoxNYB/PtF/E7ONSm9THV/42BbNIE2et7SM1wrTtIVItzBgltY25mqQS/ik9/gkx9bLVPYxtY9TFSIxRE4OM0aQhGyNjVMXoGmOA6tGuuWpnqUkgfVXZCFCRGGNqkpAXJiU7FMh2Zr/C1qAxlY0BOQ+F0A6VGd3JrhVaJgx0Gi8SU6iY7OHP3By7ktxzvvAW0Jzk3F2653zhrW6vIqfPrACzK1cxl56YzJVknituQnLQjOZOcaGQGj9aKG9lyh1T3B4yxyZzJZk5xZXAYrbRpWTFCbJiZo8SDwMw9UDWHvUNWSuYt1doE5mbtJFX3F/OFHfB5itQ3F8BNl/lDY/5r3GxrzNEWwrRK3yRqwrR1nNC9HUDvNdTiCac9apAdJNTr0lqg1OvSGotha2XwvaNFLZv8s8bCWxH5Ck4xXhDwSnGmwpOMRIFJ+Qz2jRGT4wNY1TEWDNGVwwlATmAriwAmlxA92DYYbkLIxRjZnBfV6jvKtQnQMAehWLMqSHbe8h8y0KhriRI3qYZ7SDxjqVE1YB1lyZCCexHQg6a5Qii0C3TPZof+dXWMf48mSyzHFma5vp79FaOLHLk2/SOELCYLHs0WSRLzZBlV+/CkmVmeDCWG7BkGbtkUZbgEYJjyDICL0aWLC2QpUWvI5NxZxX421Dg17CBAr8GYmAlvMHE6CoxrnGB15UY3acnxgWXGBvSX8sYYYjBiGRQmx57Q3vxbcBOUglIYGgDuVNIULHorouh6K6JMcq664rt4qtiKLoHYpAywoF6bwHqVRfqAxfqAoXQduDUUJRHDsptc4WYDJEBW75zt5C9h/2FH25FuwMaM9or+HDrW7xTkGiuJ7CZk80tL6JeqaOwUQbsWgZMcpC9J/27Ijc3XJRS4ikDCiB7+MyQVW1XIdsFjrr2o9xrVke/jRVFyzyqQXQXfaOF10i+3LqDrfRDBOgMiBjWBm49IsYFUpW0f+3KIgjQqtpRPRSjZ3E2ZKOiOBNjoDhzAFRbAFDTBVBdALTYIy4O/tk4ajsy6T20+fI1y9nl5WpWFy9asyOsbEdEyCRqmcy7dJte/uyE/7hfbuWnm1BJfSkqjkt0BwumO/QSTrKTyrwy7lvPSEkThyUZg2PCIptu0UVVvVHzAxmtb0P1HhoZoCKqt52paRPgQurpx+dgUdtwHJB4Q6oQYbQd1FWIdb+2Q4matlHGbNRMo1C8Y/z/oRgz8fLnG0e6dBnSkjlFsr2HTIwAcA5B1EerCI90vJqYfb+MfSCFjGVzkmFubvb9JPbtEQY9VFJWin1QgE8w1gEsSy2dpy0S23QBY1P472QXlgcQ1F/g74tidVhCMgnF4b+jNRaJN0HdnoLfLMRL/P7SoUvmWDJn2TIQAES6jDQWfPwfKjYXbxTSjpwnGpCvuGwY72yXKpZnkeo1WBfzoeL/kR8lAlioo1HDSGCEO1HPugZU5fz2DTbihg5FupBXR/AW1YHsLCCwZBZ0DcMXKd1f8Nurn+C40m2danU6fvtILuVkEUXGbx+Y23/Mb1+zfvu66Bnn4SZx5sCWLPeTgYjZA6rQMBOzYxoUM6eaY04NvxfsWYY5VZc5tRPmfPjMGShz2CAa3KeKFcEE3DUlE+MzbubIVFcyhcuRKQTcQwv3OgBYt2RSESxEqQ6ZwuXJVFx6IZkSf5FOilAdR7MDGuTkZ0RLfDA3In+RcU1XKWvSqgae6iPdyjcaLmrUAyJo1AGcR1R5Qfh3wj9QzpWeX+AhzF9mCDsXN3KEIjnIF9YY6bmiS4BMeu6hn9PJoqwAYROZuelAJYIBhSo9Nzmt0jPqvqq9U0RNTmXSc108xU11/trcRgYrlZ6DfWosSM8ijgF6VKfASs920l12J932QR7VEXrOJ/NVOb6BVbldQviKc1xQpef8N/MVJTnt+aZ1bd/iUm6y9nzD0Z6jI7TnTqY9t/Fzl9eeg2LtuUNtR3sO8trzVLXnCBSmqaM9t10/u+htif+49vwttz9jI40/82VnWHf+NOvOp0R3XiLO+C+OV55/w1Gbf95J/2imPEspWRjxcXHGDz/QOOOV4+KMV5w445Wj4oxXiuKMpQokzhja6nsVZ/wuSpUinxhnrNKx6Jhto2N2IGA6vUNXfzEZySyONTg50eDkXhacvAlFSHWMCHe7pQHJ6DYGEpCM3KGRy85JqEZsk6qTPn+Ycps6ZnXb0JDkDjWKQ5JFdX22qOT+E6KSW2lUcnXpqOSxbEV7PS4qeefoqOTx80QlN2A1qFsQlTyBbDXIa68TODxU/xIMMx+GIjTTFnw4E45QnuIu9I4gcIXixPEQfVx9iGiEz5PqBe2mxIo81FdPJxPUI03umMBc+1jcJpXsI3FEONFXETaxJ+yiDrITzmQnCP0xqjwWnbxdgLJ8CPIY6XEanbwDc8fs2kV6d+no5NFidHKDtA7GCLh84s3O5HLFdyfqrEehVWdDWsVQJr4piVvmDfO9arL6EGf7RXHLF3Nxy5Nj45Ynubhl2E8Xt3wp6/UvZ7lXstyrWe61LPe6E+PcPEqa/dFlpdnuY9Ks9KBxS2OcER/Sirt8XMuVZj1Xml2HNIvhIyaJI70b91Jp1qPLUmm+UXTC1J/vydpMzcXw2ZzutYVLrdEWFK41mTEh3ZHQKKT6onEhNRSNC6k2unFJYSaXyOQuoaFZ1AZitI1Rg5Etd2F0jNGgFht9Y1TFUElgFdWzIM36urZazfSqMTWMXhWqNOvnpdm6653VNUdemi0n0ydKsyP82bYu/z3HhevTNsm5u7T3uDzkPybNlnPS7NQ64LdzxU2tNLvtFBcUSbNlK82OHGn27DLSrOcuh/QxywRUTWjLULWHeW0vi/d8ojQ7hzQ7BzZZsYMC9QoX+ypDdJhKsx5dVYgOnxOirxrgvZpCdMBZ9wSia5x6RVLrnJpLilLYxilsX0th+zpeXyKw7VOs4BTjNQWnGK8rOMUYKDipxYYKsIkY66pKiUHG2BRDSdBxAN1bAHTHBXQigFa9apNSVWJmcF9TqO8q1KdAwEjdB9tUl60o9m9YKNSsNPumdRi8lZNmfUbwtFiaVYK40uwebT9Zmn0yWWY5sgh7fQjiObLIkW8avXZUTJYRTRfJEhVJs+UiafbsMjpXEVn64EXfkmUIsgzpVWQy7nLSLFlplkCMmItYZ2JsWmkW0YpKjM2nJ8YFlxjr0l/LGGGIwYikWEgw5BRJqg3YSWoAEhjaqFjTpZ5Fd00MRXckRj/rrnu2i6+KoeheFaOjjHCgnixAvepCfdWFukAhsB041RXloYPyTOVMpdntfOduIbu3hDQ7KpBm33Cl2ZGBzTa98URpdnqUNIuAaBeye9K/A7nucFEkzRZB9vCZIauyg0J2EzjapHVkMjZy0uzQSLMduou+0cKrr9JsX6XZDqCzSh2RZpFOOGsogOql/eumSrNdqtpRPRAjsThrZTptJMaq4swBULQAoIYLoJoAqKBHXBz8g6Ok2WmhNLtczao0qzXbx2y0Tx1kcoUcI82ikrakqO4S0uyyQcsi1nYkRDkTa9EWq5lYqzFbPVnO2rmbNspjLu9I47EysbaeF8091+XdsM00ZiOSZsrE2mDB5W2bSzp5GeSSbXV97yETY4KGZEk7uS5vnJWFZI3N6LZNMvBhfNKQLIws6vLOSrEhWXyCurzPPr3LO71wFpJV3pfwObgCNTrLdXlrcJbzFHjm8taILP/5XN6BurzrQKqnSK2TZyKeepR8sJHHzY9l5HEFfhVnVmzJcj9ZFbF2FU+gZmJtl1aLmVPNMSdSsai+DHOqLnOiE+Z8+MxZVeaw0aHV+9T7wAOKm5/cgOJz9lH/VfykVeUbtRbF2lXqpAHFncoLwr8T/oFyrlj7Ag9h3vIvz8gI1cnihDtGrO3poiCTYxL0czpZlDUhbOqY2eqqagqrTpzw6kc3TjiBoaseK9bm44SB86PFWkXJ0mLt0YHCb2di7eQ9CRR+mybPEig8yfndiwOF/4e974CTo7jynuru6emZ2dCLdqVFC/brPh23IkhrAQoYtDtiAQWisAz2JWzwHb+VfD9wusBKK2xsZCP7hD/8HZY5MxrdGSecfg7CSeLOQT6DLQecLsnZ/pzgoswh3/f+71VN9+yOAkKOjGCnql+lV6+qXv3rVXVXApmb2t5vPrKUlWy8GXdVczCujdZ706uXGKO3tXtyW3sScFVw/3cQv1zug/Zr8yYSfmQHd6wjd4lh4ldIuEGA0YBq9Rx397ve2IwscXM1LsTnPL3a702knk3okZE0eu98VH2dKRzinv9Ir/KPl3gxLkeHY+BwfFzTT/o0qLGUDqFF9oZquY65S30k0RFvECk8zcZDNpE6XeqQhg1Wf++Ql4sP4v54jh3k7wvvYmKkF0vf+SpLbF4KfuttrZeCO3HpJdn48fSmbC/egqgaoKEi0ez27GotJ+lAJI21PWc+OYH4etF9vB0NXiUPr8xmAgdLQfV/POPlqlayVZPy0QFwTXW8NXePd7f1BGmE3COXuzmjUEyYN+zMFzlKhI0O8BO/G1+ubg2XULBxDAVhi6x3Ipfo1bYLwnpGhfg1eNSd6YiKuhJmNihCZwwx6vhneD0VJjAuwKlGDrWfciOOrEJ5iBaAFkGUAZwgDdHaoV7gbZAurk1xY8cw2sQ/AIMUJhEDGImeROxSUQSObso1r1Ipa/nbjPGd8Cnfr6TaPrqM3sQO0mJ0VTRaPzue9LFY+PcJ+9PsGNfxtUP7MFoY8ILOFt8mcsFASIxrfg4hx8y7fhn3rv9lu3vXwxWHv349WJ+G6xOfWQulgxM3Se769eBw16+H5Nkr1uUOe3QgxBMnEAdh8bbDXr9+u16/vt1g+KEJpAOVtA9GbhSWuGQod+YQ2QTwFeEL+Se+A3lIx5bU7JTi1+l4t9mJ8sJjSR7BX+mCbp9KIED+TOmtygOXHdlhDdmx50rWWLX9BdXvaan24Z/yFfvIroQIgfTCQzP3V2BE7vuXYgt6tf8Y50k4fAPF/3+l5QxJpk4BIbL0UamFJkX3EWaj6vMkg7bqvaBylNEaoM/qnMEFvVYKwogDMSCDKRVNhwcPD6nhzJsFVkekFOEo/j85hZIa0avwd2U6lBP0FmoHbmbxxD+7Wdo1RQqjfTs/YaJkFWiL4o0er+KVme4v0EDcH8EchG+eq6MoklkUtJh8SyMKVqlvXsIjVubzYi1hGh4wE7OJl7cI2PX/JA0Z8BA3JBPWD6XcrPopBG7NC5OQUUH1ese8L7O94s8A/kCXaMXmAGFxg8B0+H1VfJ6MMyg+DHUVu5FR1drc1YtQx1hFBtyAiAHiu5KQAXxW2zFTKjmQbA+vUlD9Zl9pFp808/jPn4puiqyaSsOkxNXcHMgJs6g5dfnL/NiKmR0j2Asjs9zESvEXMCclPhWA0CZqkzdCs5OmHWShenkJez5aViXsQcIBJOxRoBL2rIS1yHlcFlvMQ/I24OsXX5aCKkw8a0KaMv7vm0Hh2IzxLemxl4KE6uNRlAKvdHFQjd2CnlcAIO/lv9jOqIizlNNTHP+1Ha1VjN8YQFz1ZN9iD7H+w5/AbHRuegLOsIS2tFlWfXKWjHWA+KBG4zdKXr5+Z8SbgDzYxUzicZ1E6wfaj6Pa9zjjPjphg61kP5P+iUkn1Iqu3gNM2geSfZ7Nzx/LPc/BqMdiMEPTMmH1MadYJe5KTsyF4AA4/w1h9wDsDaE++L6VdlG8s1gLALej9CSwzSRY5s0L0pMVhqNi2NHCgGvEXxIWTqI5rqrk1znwxMbO1Nfba/qaFwHMRf1RjnxsKaCTBe172N+1WVvZ7NqJkk+WLYkaD0JMKauG1idFJ8Q+svIzXFxiaC4N4jCKfZ/uBISRsZWun9uQuVo4R0OhP3gTtrF6menckoT8hlQaxQTkIT+vuZl4Amoi95Y8ReoLAw6cIZGkHOOdK6fd56pMmd+nEjsn1zYloSuVhnQosLGkgpLkeNLJ8ON0EREd7HrZ3k89f+QPvzXqXA5w6n7p+c7FkaekSf5754JMII/xGuinu52rh59IQq6Z+5z37vuIc7OQF97gL3jViTs/5FwNSVNKhTNX1v7dzrV8qTZwrmRGxGFk/yHvLy7d8tHvP/rmjzhXkn7s3e/9yBt/nCx3LicV+r1r79p82abXftS5jr5t4NMn1s2jy53r6H96xf2zN9z/zN3OdfSL1+Hf3446F3StExv7KZ3B5ORDn332OV/99nnOlUx+cNdpr/rOt5/9Uee6zDf+7N1XffPkTy53rqM/9Jz7mblTdzvX0d90IO7r67t51LmOvkqY+/hu5ypdBc/ta+zAdW467+ClbSxYdPBLJv3tg2vTU9oE/g6dgrNyCc07+Bku0bN0L5clIYODa+1FHBiTE7aDpmznQMZ8RolSzaZN/FqMYRnACSjER4/DWo9sCAyJ4h2iuRhLc3VsVq1a0ME0TBXRuTI16z2ybDWUj/jo+Dqtpra2M/wx3I1QK3OMBXQqnSHnPBfWDIYebJeq6XHK2OOzuW7E4pYRPojKQ5C3zSWJU4CsMfguAiE9RdPCCioHxz35FJynh2TJEopMSAM7ZgnTk3xtOnfwEIJIPWc7OBlGERaKTA4nU3fCcAD0UGQStuirKi2gQVQ+9ZoTFvA4efKVwR77CCMtPRX5Ik9WL8jvdM6HjYZnwLB2BvWtsiKe01wHR5hU9/rkccZxHTM8wme3hn9xevhAa/j+6eH9reE/bAln2qzFnjaJW9Z3STtD3mSgkPFg8LdmCJahhtXD/WMNmWt31ZUw9ryxuqjlXvSvXoohNukupJihueCuDvBPBtML8deEl6e0owLYC3oF1p25ZiODBTJTJuI36GI4W3JOGK+9JQN1dVaLzJTBqKVpuDgAoi52hgXhKug7nfxMdHm7BkfIcfpO3zdT4aSZklVS4pM5TUafwZ8VYhKM3/XiwpZzv7VkU1Ic3/56/HvLKDCyP6bxw/g1uqBppNH4gw/gXzR2LY5RhvHbEJKUyadI5/b4jleDEmHFVG9iPwq3x3ciYMf4S1+y6vq/++1zz2vs1KgUUJnbb0edwp1u7XrtEHf90DLzyGgjDW1OB0avtaiv+JjPCBI92INw5qUV8qjCp/w9Qcu7cia66Cgr2EhLrdWLKGxQ4GrZIJ9K+UrucPU7f4yZp7D+uPjPDmlzTcyELqPWe8DbZLDxgpWg/P1JypA3Lax3lFWpN7TLmi1P5L5vdu1MAgF1Hvk81GVREW8Hi7Ks44dt+sBeCrZzJG/V0LEtDBuPd2H4dClFl2zGrlnX1/7sxvUc6+ewRjxnhnEOy5AjmUHFKrf1eBqGUCj7TfympgWoNpK3DN1zBMvQf3vMDfKTQlVOLDjvxWu6C44cpEWCXYaplwiVH3V1GeIwkc9zhoBW4z7nF2D3JFBlYMjHEtmXCYZ5yEzRRYt1TetXAPOp1e5sezJMIrnkgRrlZ5SqucxIHiA5e+J3WbOBLw2sUswqvx7WrxdzhX3iP2vcgnX8MTVuxW98pbXbBknQZKZ99dtyED94q/SmW41nbjKbyJM3PXzy5vsxErUbKHkLeLDEj9nxAXCmmbx9mLzVN7zEG9bQeVi25ize/qA6w0qcV/2sMdFR2gZHnu9sg19660OnYmi8Wa1l1kSo6yDWyJmtEGl89JIIZlQxFz7EaVn6b33orQNiLCzFb2mxFGpfhvi5K1tDX/xW7ccoBo9vy9nwvBYb3szhfEwK6O0zFNDIhkwB4WGaAlrP40iGo44hN5zJsAOVsL52+fMlmR/fi7zdIC/AtBvBbMcEtcv5UiG1YRo1dYgTqNNqBXvH0VjB7C4RWq1VoY0ceZdIWwNtkfAjO9N2id6JcGT1OHaJLod6fGfbXaIVygjmWrtZAvpwK8ZD8GAu+KR8cPVpyCIvEdtIxsVhim4IWYvqEdV5e35FnS8+VGHZfk67EmuaTGcZg0Z5rxtK2otM/H4Q1O5qO7mUDjMI5zSjm+8JqqzJN5kpw39wff4rbnKvbNa2GTbc28nGR35dtaDmND7eVPOQc1qc7xfSkNiJ0tIVQ0lEAUzU8ly+B7abyoobqbQxqbITbky6RGbout2EtEkPnDjphTOYxDhALVIMl/hbDLvVJf5muF1L/D9jp7TEv0Gd65V4jca5WpNcrk8rNWxMYy7VsBElDmsUUuKgRuFZcgV6bcxmLH29az6Q+mR6wsZ0Fofw3zp+VZN6iAn9K2LivyuH0v5ndRck3b7CBGmaeDId2JjOZupspKEyyWPMj5yC41M3DTCVd7UnN01CQhN2Zqqwhwsyk/gW8JXoNPb8rhr01eSKCvoysT9DegzsQXOY8hY0FOZ9X7jBxA+lqdQoowYEoDBHq+pjr/I+6adoNfxwKvahaWub34vXQG1zxR+043qbsYozj3tMq5oIHO45pZDlUkDmNjfkL9uaH7/tqKJ9QqK97ium76l8mXFlyoMB+Kai9N6ALzUu3xTys7fR21ScannleM/Cma8cb33vLe6VYxlem/Gs7xFrkIy9LfBWdagu1U8Fbz51IonY3cNuGc/zszeMjXh1Sy/pygK7s8AeDezNAuMssE8DT8gCZ2WB/Ro4kAXOzgLnaOBgFnhiFjhXA4eywJOywJM18Cmo0mlqWn4q/Geon+Cfr/7ExoFxIbVx4P8tBiT9CSMGfDj3t3mJl5wi7Y8XxvT1ILwOBwmzSG+Bo7ONtPLvTMA9PZ1Pw2xV5LnuVNYaxD8il/JE/CGdrJpZpKfBK9mkp0Pror9IA5HZIJ1lGL/JGS7/ZIF9pelU2cuAZlpYe9FEj++ZgqmCOpjMh3O6HMZeiOU8JSNUxLB6GgI2e8kiuLd4yZltz2afhcNb86lE8NSdZ5vzbJ5PBacQRcWlZ6+YevlkuhgPBfzE6RKhLKXFtPTKIQ45m5bgj/1nEz9dOZQsozNhYzqHFnCiFb2TydNpkVtLnrSnzk1wLo1kR0aetnMnk86jhdl6DITlzkLMBigssne05DC6QgBusnRFIVnsdhas+E4Dm2ffk45hIJy9AiC392XJEtAL96Uj44t+8tjr//ylXxttcD41UKPkbBrhhxU0QiOgnm8/klmi87lu8++dvO9g/3Rpitk1PYvOapqiNpezV7rLciptAS3gtrkbdpT8SzLaPWk+dPcCptIonYcXKjgHzSwdb3PP3gUcMNMmnV6I+Bfpi9Ays0Ey+PetD09NLvEjpRZaqQUdFbRggsbpopkm7XQlCnuEGaFx+GaYnNNVzvx2FtU4Iq1gQXQ5yTrXiqar/nc/+Nmale9d5lwQ/525pos4RsKV3ffB+/t/+vY3jDo3OasW2a8G7IMNSWyCNA5hg63kLCfPO9Xq91QSOZ5Ly+kijdSlfemro85VI6+2GURJIrhxqUN7EbUXJ0FoZzEvVkToAsiuKZD5MMXOpzExxS62bT2GqZPXilyMjpN1QwmHzff3nMbPS4n/eOQsldGdrpY3j8/EwzyZYwrpGiFdzB3skmYHu0TueF1km/IS9KZL1Xg6TmuSBbYPX6z9bKGYTVmum4sQrJUlLaCiBDDzItTNejqiV2+ioIVcVanUAujeBZxVD16uRhXxeWSJhDTMBZErHAXT6mQBLmD+ORd+CSDHJTRmRxU4Wc3FX8ZlqNwvU3wECLeAe4n6ipDsFo8zEV2Jc7TNj2bMx5vnYhGnIn6TNVbal4m0L+XcL/bH0A464TjLN62RG6cvlXaAIDajTojCzNorqYsikXPoYuZjA6zoSppvVcXBggynhVYq0z9+4I6mcmZFvSQETbyIygnzjPqfKfU/0wql1oPIzNDFYEjLz/GzkAteREVlFm3jdFcrM+AN3sMys9AxszBj5mJ9Df9iNBbXNztcuppzpHm2HGRtdSgtwBydI9gBiyJbz5auZg+3M12Gel5mG//ptOyqbjYk6Bv06JHSSgsUS0BiGA06n2MiEL1PZ0/SgvjDPHGDd+5arK1Tvm4Fzgg9jUauGyI+JT3kFDh6HzuoI8pe4G5sEYYW0dmAwzwXrtV3Lg8/+KFX9N9UshTsr+s2VQwd5R8NpLzLEJpIF0E0CXcPZmIMUIEwv3EkHjkIwnVH7NUdFeZvivkTWL7IjqKFGEULObdw2iiqAkqzQLRgPAR9W4BAwRzT+axgym9uS1XP4E3qZESb0rJXlF1kb2fK8iKWGhtuRyCtrMXwhe9lLO3F96Q8hido6T3pgku6PTpVzoYu0FUFRt56Dk0WoJBCMsIF6OcWsozTkawlXBVV1MUzCnGyyBvjWla4SBkfLJ7fDNDU/4RBU38HNHVAUwc0dUBTBzQdHjRVfsmgKeqAppmDvwOaKocFTZVjA03e2G8WTIo7MKkDkzowqQOTOjDp5w2Tog5M6sCkJw1Mwn9cxb94PFtxd1i4dOeh4NJFDhxddFzBUXhYcHTeTHC0fDo4Gm0PjmwOlx8ncLQiD47Od+Do3CY4OvcXAo4up+VHBkcXtgdHKxH/gicCji5oA45WHQkc1TJwtALg6PxjAEcXcNHHFRydxzDzgqMARxAlrXyC4GhVKziqHQ9wxB3oUu0+Omz55EUfZp7Vvnbt1ejSOcy0QGGUbc1L0aEuzkGUJwZPZCadAVFmKldFdI4VouPHQXI0peuEX8RMiAkfPYFD7EFRjkkTmq2lZLo1wPTmPvOXl2qxtt/IlC5vEV5ix/OlrNSmyXoNMsUpDtS1aCHHxfq9jvlg9xKaz7XzMuyBWn/H1drDp0Gl1jQhhaLSkJettEMdgdRuoYNABC4g8xmMEv0SOMrAwaVADJcqWuHgNU2IuuaQEPUuQFSdnxbaSWjEumTd2LpN4BoCuEpjrJamQf5he+BqEe/qJnD1GAuWPXpCuNUrTL+MGyigHW6NmriVI7TFrd5hcKvyemTc2p6ZGbg1ynBrOA23CiyCGIsZO5zKYPyCFb5cEKVn0BUdhh/IPugF1tpGKJBxGDoIF/iUhJsMJaxBzdccVyR7Kg/VK6gIZy1dQWv/YIjWMpLNjrkDOLRBsnR8gKxl1oFZN9jmK4htD2B/4AZXK36d3zq6UL+TOcZJnLlG8PPo1X/c6BWf75kJXwP0FZqBXiOHXv126DU6BvQaAL3qlyQWSSv8OiLXwvFCrkCsDr12kGsHuXaQawe5dpBrB7n+WiDX4EmDXAc7yPXYkOscjjH7Nwu5nlE44ckKWqMOaO2A1g5o7YDWDmjtgNYOaD0m0Br8wkDrQAe0Hhto7cdr5L8U0BoeFrSGxwpaWfDhr7Cl9crpoPUZLaAVKnU6agWtFbaCchjcimAA16UWuC5zwBVg1gHXJRa4ot+/N117/oOzvrj8Dk7YRKpr+eF87ulrQT0XnUW7brKgiVgX3jv53oOznOA2A7WN8f+4uCIbsW0R63wZVrfbMTQdsS7ENLJoIo9XJat0vM0FbRdyAMhja/J/6UrEB151GHRRE4OOfTr/p1cfflsxKLJCTfJ/ac3qPVuJBbYC+OYAy/dNN00snl4NgNVvW7AKweb/rFS6rlnR6M7/gfhdBavfEbD6yMM3nJf/YwV9ugWrDz8KsAqtrfMq+MeIVx4e0JM5KapsoSqidP1j76eW5/9UnWpjQYoEmVmo+ltIDPhppYP2RJSmLPYchTD2KSMWUy0EcaEFrKWzvD2nJYurtNQpRMxDtcmJs1jNPn1dchkto8VXJuvsWku66pJsjZWDJWdaWHLxTGh1iQ3CjL262f1W18Lm2Uo8eQBYLEtASdOcki/JgZlLjwHMLDo8vNLpgcVsi87jqDNzRV98/ItejWlqdVv45GXwKe3ApycPfDqhLXx6Bl35KwafwNLPHxP1cYy4iYkAxC7jNTMUEjFKW/aLQklLLUpadtxRkh3KixQE6SpvEJ1MclKg9LQMOhXl+KXPvB09SlqIrrAwh5LwwFI+WpS0SFHSfFzxP0anysC8LAeaznSg6cBuC5qK0wDScnpaBqNGdk4HTRfnQVPh6EHTul990DT6REFTBzQt/xUDTevag6Z1raDpmQqarrKgaV0raOKWOLPZnc7USYRZPrN5yVay1ra6Pl1RM01zF/PchCSXNSEJ1DkVWXGmC4fEFnRkiLJ5OkSpBdC6mANlBsYccCats9jk6iY2ufrnhE3cKyBXszzSZwGdmGT1IRHKmmkIJT4kQuGJ+wU/f4Ti/1IRymrQOHt5d2l1HqI86zjjk16HT65Gva+mdb/e+GSd4JN1x4pPejhGdws+eabDJ1f9ovFJcFh8EhwTPoF0A8z+vzC0cWSY8XAHZnRgRgdmdGDGEzOB5GHGmibMKLbCDA67RN+mtFuBl7LvqAAHYh1vzCH0Sxz9EtB+eZBjTR5yrPl5Qo6uDuTINUCVY1R+1SCHd7wgh1/9tXynNOqczO8ccuoccuoccuoccuoccnrS7tKFT5qT+UOdQ07Hhl7ncowTf7kn883xOpnvVX9DriIYfMKfixvsfC6u87m4zufiOp+L63wu7vCfi+v6JX8urtL5XNzMwd/5XFyXA0eFduCo63GDI/B/ilw5fwoNo1WG5bqnVRIQ2ovI7isXcZVdOBVuCtz1X4HcDLq5T67/shHlAjuDdirBidLoirQ8hJtTUWaFnc33s3zRTl3kJd0+8EZX2oNyu/QC1VDuk2MnWuKTOoMU8tV20ca0F1fMwV/amMa4Zy4kdmJ2OCRS50Cs1IdjTfy9WLPcb+lfsdH3WfreeAUXWtsTT1AXlF2AbkYFxkCTaR8XyaG9cjVdL4gFYlq8IqZYbqeL9Xa6kJqpBlsvtAMpSme13GnHacjH7XTUR73NG+oCmgVPMiBXlw6A0Ivx0Evxlfae7rJ++JgHabyiN+mjSlKmajIbQmR+ep7J+ZY5WV/SS7NdPtz+aPMA8udHGRoDnPMU53z5BciYs93CxDL1MZFznS2Psynm0lHVtRLJo55aldmcQz1nFB74H8YUevUwHj+Mxxr0Gc2hgJmkMP6IXkIJcKg9IilRmMzBlZ6IkQYAlyHiDyVzuDvM5tBB6k7KrHYOcN40iBrIPX7BhFaCuY/AfIDra/lHhsag1GiQyuKWmfuHzaokYDdGJQIwrw19wHaI/dZFRwB9T5x1L/Qa179s14ltV+HAvdbdZenvsjm92eZUt/Q7bbxtlr7FxtssdyDiVnfubD2Pt7Oh26A32c7a2uOyaNL3QGAnlrz6r+I+00u9G5OY+1z/xiTirkb996TBeuZB7vAOwMxsliOa82PanDeiAbRE6ad0wmRS4gaLqZcGhu7B5G67QCSdhLMpSVemwN5Bj8Yuo50HmyE0e4LKCKtSjO4WayfPqlviepRQD3T61v5TpW5ILummirgVqopbJb04s0SibdJAkGPRqq4HA1yF3ry1kLdw16c2jFlHAbzESkMKN1nF5R4nyWMeZEovbWKK/6xuQ0UwOpJyY46pf2lahroS/3BagVISP6VVKKsipy4/i38qV914TuF35DnCcxXPp5BHIa8H02gy/qjMohWtMpdGjpZyi4OnMrKiErdwmSIqM9wtU0gViC9C/+JJMbLzVxe7IywodviGPtauSS/z20VdepWojc4YfcVUEuoYtuO3TN0ah/PmEkKWOYUA873oEDFnuFSzH9bsT0H2Bdy1zzLnnIqQSAhnOI3WcYbsG0vLcEbSihBWTKmQKhThD3xATlIkqsWirU6rB1egB1pOmYtsPbh1IE9Zo4FJ5g5V28gS4TmjhvsMdbKLd0OOVepBHXpb68DM91CvwF8yut6+kgNLKwx6e5eoD+z7uys5/8n4epmr7U6bzfo0IIOrUwPycFmqOFcTiFDBPAy9jWkRl6rCbzamIW5WDeQuVXY4ZKU6S5U4ojkMaw6kxEGNEisx0ig4v1HyuAwIi3yMYT+nFRjNQURGxjC0R0DN4Lg1uHAlhlep+jnPlKdmXE+LcoJar2AWLwlRKjQDlWTiivi5TL7o3woVkyqHoW2rXB7jfjMETYEzFJVaoIN2CmO2jDm/XAvUVMsEP4k4ZZTAClBhn82TKlhzUBVl2XmgjHmgLPmlFWsSiGDS4kKRa7WZa4XCpKx5UYUDeF0Q8z3dMRPgL7C/YKcO5EfIz56CCGXFyPobd4KV2eEnHoAI8lCWx91iUm9HRwR7x7hGyN/hepYxm7iNeNYGVpjCjecfvPuxUO7EN5uosO7ejfBjGCvhqnsnq9uO55X0Pjo2cBJ8zVr7DEsTv3kt/Z7sWnq/Shw87Vr6j3imdJSXkg82LyV/G98sXgAL9jby7BLyQXsJeQkjWC4hfyviki+Xkcst5B5G7v0tF5FnzFNoq1REReRS8iJ4yBiR+/Gvf35tcANXk/kMMRH5GE06/XhWfkjXhfTii9LSYpsD8+vpzd9FufmbnRDxxAnEQVj8d7mbz0utN5/3VuO/v+3Yrzz/2IwrzwfzV54PzrjyfExK0SYxZOBhMXCyG8ish5AOfy35zJva9QJibcfWC4gH3T3lLzVyVTdEFiuq424ELQNtunFF8Ao8RZN4jDYq1HXnzgqJxz4DrYKuKUZijG9PpnW5WZtrqAZivf4bHYS4PakoHYwCvd38ZcePB6iYFhYisLCn0MIDP89k4kPG86f8SSdiDKXUtyxdaMcAchT5czEo3h1x5M6WeaHSfS4JEQu1KU6LUW71X8popMHKWuJ0tY8D+NLA3G1kdIX1u8mXiFTYsKtRT4uooQ+bgO+YX6cCLFwg3dB3FuGaAcSTUeUgggwcDI9AxhDqimEVf0oUCPshFF9z/Vp35E2ZSV46Tsot6Dc17z6v+9PuPt/ik49uvBUuZzpMRgEy6lNsCuc5aXhO4VbEgd1oAqN1j8ET6hfZe49v8fC72WN4+xJcW+xj/vkYR8MmJXYXIr5GeaK2S0Aq+SsKctU5B3+vgIlK45Ef37/FGsXJP82/Pi0LF5tvWVB7HrqYZVM5LC/zt3EOQDDjX934tf/c928fPeda9t/uDZ9+6m10wXUveAFWPdE5hd0G+w6DaZlDnTW4zr7Nhv/EaO8XCjcsp2gorTR2oFD773ndXANOtP31+PfV0QaVKSeYITTru6ws5qkOCHS+qG5II8jBgxzebrSiVL2Xgnubt83PU3lXBSDw8wiJN/7qKwFLA2R7GuAHkC0DyU3wDYtv8oN3N1D/azSvKmRL1dP8q+Nbb1FI61NLM5WO2Ex7WfylljYiRha25veNNhraRPHXwNxOVPxqvXj84fc1Lx7fZi8a/5gcDiygkb8noW21sP8VhOkV5ZJJVTPc9X6XoWaxBc/tski7OZMDLpPFXl0jOivVgVFeFiqJOKb3N+pHcSjC3oi+DV7oeoO2JU8rEf8Dhhbu5b4Dj7tkY9PAHqC9Af9YJoiwTSJwx0l7xqXPPPhg7Vp01p5mb4vHGhBmo07RroalzRtrXJsY3H/P/FxVk2pQoC3uNTvZ4FijxqT9CG2g/SP8FDbdZ8PPHWvUx884/6QffGPx3FGJWv/SzVu4fbKOTpn3uqEmfdsYZd5rhx7zUgNAs3KI2K0VVg/F//RKVRQ8+J9JPqS2jp2CXNafF/FKHc1j6ixVZ0Tv9f+eYZeTfAuuX7vV5972H+pfyt6H1TvC3h+q9+2G/fvVvwea4Z/U/y7Qv6L+vaB/Uf0Pwb9P/V+G/wH1b0NJe9W/26CPq38f4uxRdZCUlbkuCdmCFKeLdz8iDWdlzWtySU3WT8pYHBTvV+DtF+9WZBVn5UUZq4F4v6Q6r9zUep+WhWhZLo7HvLHVT8U8wIE8ygugjxBinsZLOlCgH89gpazTg+ruiVyT7+Q4VY2022ik6AIXM7BzFgQwzMopwYob7BSABhpyXqYAaM2JYLCMdDeaJ5AmxqpF8asBV5KCCpvK8TegefjpdbcxmFFqvB1xVPch5FbAnDcIzVLjr2sMlsFrFP7UYs2ZKvFDt0wL+4wxQXMR6K93FlAKW2am8JAz04tZ5aXlptIL285NITQnHM5gMC3VIJgSHk66cEiTBhQiVQG9w6Uqam5IxmoYwAZJVpKxsqYg/pBUK2TOHcBfaQxjFzfxk4kfEPTpEyYe5BE/CEJ3Tiq+lYoh46RCfvVrQYBJ3zAWylYwRkux0EiAQ82g4zX7iYD0ggIN7RwRuoXPPUcDuhwCsfrJWO34Y+iGVATbzyngDrLbgOck9sQ/0SkMzzEF5xTAsIdRY2onTcQPI1Sz1AmKmLf4M7c1qfG/Sfqiffp3efLt03/IU8iwHfpOJxinh1MP3v3ixUIjWDPktvGHx5zqvXSsjpQy/aRF1ssZKMBj3T7Wz200hCCzu9ZcB1DG82e1we4GRKzXAQB1DFs5MNnHVHxt6g2lJR23nh2HI4JHq+N3vbiw5dxvLdkkjVG6m4o7GHu9+I7Rie8u/Ae6Tk22YHJnUtRGOUsaBfCzqIvJYpN/mXe0CpbC2e3kBnWtnKAN3QITvB0WDxWGGvXqezxeF0tnSDzXL7jK6DIWq7rMm8ooQlfzVuK4jEwcdhUdM7mly4iY4n2QoTxbOrF7HRJD7tyMAegea2wyO1Mz/thbHvn8Jc+9fJQy73VD438k/77DkzKL+ch8gQ2bdYZxUsNpW3kdRtlGGpUpOXCQZcjq1JU0tBIQPai+J29LmIa6MUdwOVL5pYmOITtSkiL5bZGSLK5gjuJj4y/eQH78KMaA8Kc5xMgBGRV1TkNZbpEOX/+Erp8DZCCa5XNSBz+zNjzohwY6hP94XeL0yEiL5fY0f59JwxyqMVxv/PAipy4CEUlsSEuKc+gP696K67oL2UIrQifXFU/JKj41GJIR7NPs+VRSPF3+k7RyL9aS8cb7ZJEFwy6VN6wX4iATq1Rt1O8GLm4m5m23rgZVqWsnhfwTPwZxua4u9lfs0kVp9fVN4nO68xEQHKddLcGEgmDRbdQxzgNgI5ksofRhBeVdxMjZpEpYkpVyIlllzZojbvBFLbNokRuLQplE8TBvovbBrZhHQcc0aqWkQbffnJ9IQbfzKP/nZoVvhIE/ZW5CY2brP9eWVHQIbsuewhIso4o6hTKINvBjiIeHWzP8DUervRkTXm7uhOpR6HUNe+ocWkRo/NXblP8tWzy1YKRsx7kFhYagycS91eeHAh4fq4qNGetTzUVXFKACWh7wqNhmLRDxMPkeBwGh/pnGvIGzARnMGM6OWc4D181Gw72tRuNfzg4B0Iozps5SdUbYuZ/jDFuXNMnVWkP+JQe//hx9i0Wqq01LYgWl3jprGTbDKrrWVcf4g0+f+qM31v9r1M1DYzywvJrRyltlo8WgqS1Zp2Azfs7WkW+85s8vWC6QFtN8k3KtK7Ng5+O5VMRy/y6I9S5fp2HNOQcdw/gRS94K4zI0Pox016QhnOvSEiaekA0ZpD6YNNkRc06BdwnJQE1EYKfAA8KoAafKToyIVSqJWceXWMt8l4NLzSM8lzrU1MalNlSyJ7cx+DQDjMRQTUjY4QBIR2vE39Jq4EXHwkST+vUmdX+O+l1QrWB336yi4sdbfB0QGrANAfA38dvTjGlnweHGA1D7fBvrzJ6gik19scyI6/NfcZOZnLkBoLOFbrM5i0HMWQd8sKKoG0bsRGnpClE77gxkWr6HjQ5JRXZUkyo74cZExnEAC1I3IW3SAydOeuEMJjFz34cVHLY9thh2qzw84HZhk8WnEgaTONcr8RqNc7UmuVyfVmrYmMZcqmEjShzWKKTEQY2ie7M+OlOfHnqCJaS3dTs/nUU9LXv5ab+cANDVFWmaeDId2JjOZupspKEyyWPMj3Ybtxv72jgBgN1/mGX0rB5V2MMFmUkup192/akPDdZHke2ogSx5yRcr/zOaKHkOU96GhtIp3a71YixilRpl1IAARudoVX2eIeL70Dmk1fDDqdiHpq3tgT3CNVf8EKK17G2cUsiiYOJ3UZEYIDv+8m1HFe0rEu1fskMmxWmHTMpHecgk0EMme+jnfMYkUurDkT1jEtkzJpb+FRtvn6XvjfSMSfRLPGPiuTMm3nE/Y8IrdSAPizYGYImYecbkY4X8GRM8tj1jUnkcZ0y+9ATOmJw77YiJ1oGZD/SIyeREyj96xAQVwhETuIc/YmL7w37roh+AvifKHzGJ8kdMtMegp+gRE+vusvR32ZzebHOqW/qdNt42S99i422O3BGT6AkeMYmO0xET9LfZ0FzsSXl2PbHliEn5kEdMynzEJGx3xAQ9OeUmOljwRhgwjZD6if1k/TH7Y+uXLTZ0idnoDSfaDIhbf4JmP5GTKJE9iRLZkyjRkU6ivAWb69kplMQ/5La6l9tWR59rv60eHnlbnek+UrIPkq4ipWTJnmGkRVG263MipIyRknOLkVsFuVWauZV5AFWED58zsMJFLsokJ+Yc+MFtoHuH3ECPD7uBXr358W3oeYffVETtPDTQzD3F4JB7irccPxb0vT/lod2mYvAbuql4T1jE6r3Ef82F37vKOVNp7a5wgmBrvF1fPyFe5tVD/N4VpqX1tfIqsGBfa/npaIMHoO+qNFZHd6y9OYTVFCMERqEqnAiHeyy+hHh60Cz2DFSIJSHGGBVdvXx+6E1j9+g5e9V+Xh31oQV35AgnjH+/mnz34P/+hP3+Dub8teDc2mCpj/y6ozk+mx6p3TauF9wtflq8cAhmNkgTf6tYrSp27wef5C/z3xyyqxz3M1ZKS9wxmEUtjR9K/LDj9bzrh3gcEhFTIlB2hSqapGi1SgXxewkWmV6p5bVp71BSlA7KHpYB+mTJjn6UwrR+dMV+mgUaDoJ1MxmTJUWMLE6oc2VZCI1mk7xybOdjvpgadu2sP8YVrDEgk5NcXLfiSziEii+i0oZdqV9HZ3Hp9nHDYsDMQr3BNWPsPmCX0/yHMU806tTFJatYtZO8uZyWMCRLLJakCMYi5reK1u6Fw0LUrKTy3Vi+SA1RAZHa+A+v2PWUl//gc7yL2s/FDIhU6tl+WJ17tL8MEoWqQm+5gYUvcpgFSc2yGgRmshh17p3ed/0X2yPU2s0Xe2/WNnFrt5CHgsPRr/I8rMGAhZtHXDysiWSoDyYBGV7ge0QGC4BBdnxAUlMriBkbcUmCEf0k0DwYBIg8GwOpT9f4wxLfOx0EiT8MmqcxPImB/JZq2WOu7JVa9piWvVTzGteyV0owoo+DJmWv1LzGNfUzNP7lWvYzQJD4l4PmaQxPYlQ/b0x0lAeN9hfyJ40GcEDlX/W4jT1wpMfOWbllJ4+QSI8eRbC4uKNHA3ryqCInj0rx/pZjR/E/qtnDbsfpWaH460L0UBAev5E7BuS1HgOqHqgExUkjpyAyjYyxD72N4RjkdvkLhC1etW7XetfkDZY+U7xV3aapUpLMZp6EqjZYR+ct6cx/kfOsci3ueDXzkrfSQ6XVqagBDbbOj7/vo9ftfeSPf8QG+HXy732jzZzU7p/643M23D97w/1/NJpZ7Me279k5Prdu+P/Vo/XGjsYOKu6sJ35Vg/e/fIwCLQT7Gz9Z9ujPViz4Dpfs70g1D4103VB8JyJJVJVPQEEdtoVr3dZDuDP+gSwMS7Gsd112/8XZ8SjlkkvbNZft8VZE2MHJfcjl2qEWhtoVzBE8hMCQLLMiCw6tgC7GbY6VIxgCVrE8Mj4SYBYlprVhWxvUuAY1MxrU/Jo2aOXxNmVZWxEulV0rhjNbMZRWDJ94K5ZE8jDzYbRXyTWix/LipyRCtIj4ODjaoE3b+mgv8xIqTPwqtW6ndclQJO2bVodSOf1I7JF2NGsw58qITViIHc3b0bydsdnRvJ3W/YVr3hlHyf/4WE7Af3PGCfj9hfwReDxNOwP/fDkhwrjfWkzgBKmqFqwD19fqU8/XhH78LeTvXqWAaceLliAXrCA9fQuCqXr8Xw4NReoEcMDVSPPEfRB/G5kd6YR9dqJ+IH+gHhVzJ+ovl508lHChjKNArII+BboO0VVIws9wcbIIK1GJY+KfIj8yEmI0pFp9uvE0Q11CIVfIF5uEkAgLZCL1bFKPjCSiglS3+rsmmNL9RKz8uDgs1vR90lT2t6UhEBLO9xCEqQKB2OBBaOgS4EnMS6lfG5QyPuCZ6Am/U9JmiTeYX+G1f7mkFH+/dYn3HTwe9m2SUv5tkpJ7m6R0+LdJwubbJKUZb5OUEE+cAI6Exf8vt4wMZ7xN8gNd3q42PhrFk10ZjiItKpDGdnScJiIfRoj4w7egT2mDc5vC6M7CSZgZ7Mwc24spP3y8L6bkh8mPkPj4v4iCgZ/rTJ7KLOv2PguJDeEvkuHkoe3AMd6XchaZoPYibPr8HvomOnvterdVjuEnjZot6d9mjHHF7cleKSXTTpQwMMlxh0F2vGU4x4HXD3GcFz57nBc+Pc5r+EDgQOKBwkb2Qc4AHSVYhhMfMAyOoLOjhXc09MTNw9J7UXqBy4L9SOxujtmXecWiPUrlT6noSUVfwG5u4rH7cGUCOxJW2wQ80r7HOhLkWoG9cuQFIzDYhUHH3TlIIsKZx4G0jBlbpvTiet0+pArsXvUGdjCSKpWSLoqwE4tjS2pE7GKnsWOZD5CgOydwuqgbZXSTuQSNINknZRjRItCjXVLGrp2Yu0s4s5vIAaxGUqHIpvGFDLUGF1IyqgW/a3wzGbAY9AUJQxYd7Hmps1sW2DKJQ31Ns2Tz4Dusun8JUY4/+AD+/cdogy2cEzX+f/LG+NNybiqwpy8yIODvBB+wSxdVQYRwAqgCmWAyvKJ7BYHYJuUASYp51nDrghDtSKNGnQlRg+lR/Ijue2bYRQ6lTHEFpKJ/XYkCbe2bzJThv+pNuRMdYV7LkjOj+i9isFX7XsXuO9mPPZaovD4PqyqsBXJPFGnbCvOVhjRtXbai/oxbFI0Mprp0CIXc30nOO1MFzR7JLBbZDSsqSSzVODjrHHW3fcki6WEWlF9kOMFm2aRX8y6hsFLzgywxGUi+Dw4LmAL+LtUJ5PPvLNSwTeY90kP7hMm0qp/c6ac4GXD6nrfYgXhyX5dJZlOvygDxOPVsGuAQqoIFhA84YagorCG9nwY4XtfL9n7q+SN/+K1R5yLPGR+o4lzS2TO/MAXyHJDHsDWy27nKFknINXOf8959H3FuFvLCG/wFrzpx54ecixDkRvIfP6VShwH8p4xOPvTZZ5/z1W+f51xh9Ad3nfaq73z72R91Luch9I0/e/dV3zz5k8ud6+gPPef+E+vm1N3OdfQ3HYj7+vpuHnWuo68SYP3x3c4F3XIKniwu3+1chM34zBbHRg2mVeeLS7d89PuPvvkjzpWkH3v3ez/yxh8ny53r2Lh37V2bL9v02o8619G3DXyaq/Hocuc6+p9eAdT/zN3OdfSLpRp/O+rcrDqDxO1rbC90bnriwUtn9lFumS+ZdO7BtelQm8CTaAifEuPcPEtyLke/lJD24Frbcbuph7vhILc4cptDJ9EcSUsnHvyMoRnRe3hUeBinEXY18koA727XjCiBkHrka5kVPZPH5Bt5KL3AaoUu2e/n6OyBdhAFT0UojgK2YOrL+OdQGXdzxjKrPL5cD3Cu/ENh7tDSduOZqXBSVQ1GpZ9XcUHmLULVGFWNGMSYc716y6Zq5o2EzahBpR3YMtE3WiJW/EaTRpgxqVxPMW36WqyeeQmwoKQC6lN9RQ5VjDDkVJbb4zNsZclb3+wUcNirBGhB7DBuPJ2dUu10oAnxEfsG4cPpCElrFAQBecb/gQmFY404Gb09DN3OLdxD79129m47e7cDqPe0vdv+Y9i7LSS90zZtB1o3bVH9bbNTD+6W2els1lbetUP2lYlPjTYcXjvrcNu3/RBW/3Hdvr2QR+gHMjQW/5uuBGaSmLh+BrWxM7791cimZtf9NeRqsMr5b7ebqQYNEx8AIRUDhO4ywiHDksSitf2qyeaXXzUhgV01fRba0J/MrWQCO8IDqJMRdgwWLAE6Ne8Hozh5ESiQD0+wE+hCBj5dyMBnFzIFWcgU4e4fSEKENBc0Jt4uZqWS1mGHdHAv3gZiDkM3vc8ZajRw2I18fhWqIRaI+FH9sEuQW+t889cE5juEH05D+DKA4/85PMT/hO/7mMParEAtgFZ1FPry1MXd1YcOgm6IoDhALZAQeKiUtSnSCgXCQ6ORVJtFY9rSVmmkXTuoK+OpcXcSyTQaNGnP5Z7RXBbu4AzLUjfuMcw/dcknf6rxY6gdZleOKKo+S1PX1XGZ43U30go/jujjDln9Ij/2kSQps28Qc734YoRuTzVq1IwKMfTIl1CJlRMUrxzkK8kMrRoWilx0rCqb1H6ZiF/c6aZeJZTBAhMq6PuoCfhzNalCzXDOVqn04KEHD6JA0OVCaRPVKPmF+X5jmm24P2tDKmLQXc0OjzFSm8HluvRfyQ7eSx/A730D+KoAPolwkVgPPonTCWc1DQkj4tsL4uni3QfvsB2VxpoXhnk0xhL8lYKzSMz3CIedZUTuSL3M7D6WdYuQxyMaS0avtUMczN4PsTX8gMfDMZzyfqHDUUyB/TocYx2OXToc0fQyOMszBqdvB2dZBqQ2u2Flk3LzglTh7txglgAtjQzbhq7E0X30pVWXfLtLf6Sk1fwOROLnh/hizAZ5K5ka06w5q2ks4yQFMbXBzMrpnltA+OXk1covmhD0yifnQVq5AY+lG3FSUY5bFdT6S7AU20OSPsaI4Z/mczABrtBj00Jtc3DRMZsMX771cZoM1x/Rjq/m2NSPX7H1OFrxb916FObJc3IW9cBZ1KPMon49DOqv3DrNoI6aHYtl85JDbghsQRH2U04UsNO6HaAsIKvcbsA57XcDDs+7bga8sKDHuZBlwYpRrf7W+g6apzE8GwNPXRq/X2N1aTtgbGLZooMVoZKkS51Ynf7qRcbMNOuCM+ZZioPe+Znbu3AmXaXkDbb9BW1GtFOtEN+2FcTz7SAjI9ZhaynmM3TEP8MT+B3Ez7yJ9bU/u5G8icT2w4KTjFct4Z64PYXqM42ZuZkhFUd1gbmEX+cLhBN5iF8DZtT7l+rN+H4dAJrZpN3bA6sqZ9eTC9wAiQ96syV8dmQgIo1ojoJAxQQbsMK/EnSAcB3wGKBPaHwDOVon6K3qkAMJPtuNf4+Hpy0BY0S1kMrGNMer/VqZDljNsqCCRpZam/gjt0pLJQZ8iFCnt9Xtv0ptdUfWVq970rXVF47YVn/1q9RW27O2esOTrq2+MbOt/gtws40siUVtJkSe0J1/nU2BL0o9YQPF/Bl5DATiuohPg6/PBW/IB0ue/1TI8lR9DOq+ttRz2xFHMiLPmZZI7WL2z4jZbOlsuobkrBR1Xvfil6GqGqChrejqGMHOjhlgJ3hRBnbwMA3sPL3dh/tqN9y4/ti/2Xe4Rf+jxpib2n7FCnbFN9/+UvlOFfx35vxbcv4D2+C/V3oSxinK/ys8zdXvZH1F4+Zfcd8HkobuVS/69p7M++HMu0u87zhU9t7+LOr3xPvOdlHf1YYoWK/GQtzzX/xGamI0EzyI2LBsxgMG0N+IKqv+r2mHQDSyApEvmulbyaDuzVG/aLXPxwx05Jvs057cE1K8N0uRIZram9tS72pL3daWektb6oHCNCrTvmVsv8ojp5g/eQCROF6rp6G3OnSNLtz8lIwXfxwxWCJu/GzxMuntMznrEkYKpPxmJEhQtHZONUzXTPwWCfCytvJrXEDWVn7WVr5tKwqcFB8wXMIDxtUsEDm2p991CPq2Q9BvaU+HPGfSuc7NEwO9ocGW7KaIN2UrLECkSLlStb3/n7mrjG4kSdLKUpWqLLDLsmxJliEy2708Mwv9pn18Ndg+Zhz6sShre2novevZwWP2eo6ZmfmWmf4dMzMzeue+L6LKllru6eO77mdlJEdkJEdUpErXo+L8hxdv0q76XaSGwvxa7mN1hZKEp9ee7RtiERiECK1J43zt2XASeAVuDDdX3hTv/Yof/aH4luJPHj0pkdNKEd1S/PMjM2E0rFXEe8X7PmsmuH16cF48LHOBG0wbzQU/+/Rgs147KYDeZTG94tXjYmlvLtindAYsbr7ygc/oCGOfPRcrfsGMJt03Ln4rnYve8U06T2PmfC72ad6MKJ1e8bO8UnKu+KC5qHP6cWj9FYWbpTEqPudB3g596N4cr3dLXl/wibqf4pfEYl4Mrr4Y8BLcTym5faHk9q7U2OU9uM4u7pfhfg3cbqnbsQL3Mbi9YpeSbD0YrvKA/9qwVvBtp/QVdP4l/bCOk9Xib2u3+n71GXRft2JVMs6j/5pemCanqLFM2mr7GBVY34ExSd9t6rur9N01E/di8/nVlg0aP5DVmSZaLKJ7Vd9D0oksTMLqR083FcUC+fc8XDbz/fxYHPmxUclmkgEr3UD1ZSCZ6mgVzq8hlJnCKp1LpU6QrHK4GI2hX1Lp16Q/3S7xGJlMG4gl8jvmtVmsJdsPq0S9NYtvT1on+D7m2LrSIsKDyxEeGMJDGRwjjD/KmTSnYf05LrSeBO36KWi3FG2WO6aliMvRRvB+qBPzpmpjoM2hfDvX7ivT7f4lFLbWreFXL6djlXS0BIQqHeK4wVf/mHYrLb9Rc+j+s0yYbX1Uso9spKFI51DvTqP+NY7FIt3G5Aqor4mrUG9TnzWjX1En8izBkP8GF4gM+YTt338jDRl7fmeOjOVpMr7DyCAHrk7GNP7Mavh/z/8U/pj65pDPp5H/kSnkm5cj36yQbyryhjXzGNY/8d+KNasZS+uW4senwnBt3ainWKaTaTP/SXWe0HmLuNkart5x/nPM6hs23do+oQxLbSq2PUUZltk0bfuPMmzBpnDbq5RhTZvebV9ThrUQVnv/GkyTnraFbx+1aIW0JgTe6Oz4mRfubh4W+QeJbodhWVi8GJagSkvPRshN8Wp5IlXYs/nzLPTE0t/zlELn+KoTzvL1KjZZuj76QDNptatWqKLbJOEsv7sbXSD09OgDz0cfAaih+sCfIAlLkuujTyGkl4HPB7Rocou6LF40uUVEiGILtdeZlpQvWlV3mxLtJSsCCN1v0I6p0mZalYqAFGoTEUg6bqNZCENvshuJoffy89ga/Gy1+UygM6EPU+Y/rhV24LEzvVrU7NgOmIEGoQ0oubZ+iYnM8FNSSjqUCPvC1eyBsXglmnh8xG70MYbHTee1wZx+mqvGgBT324yyczBjNoslMDAU3QmKb2VHuRxF9hYaVF7Kf946N8qBD+YjeK2f/w0l88aBWCm3ras9J1f2+Ckjq8UTetb8YRSFYn/u4c9B12aaytTbs9gkkGBU6cVdOW3rs6ePVjPSL2MauXi8/w9OZUyFng9MgvlGF/B7IWjvvHsitQmB+yfBqY2Pulk8zb9HEajKkTj/XmuhkyPO9yW0VPAA1SXjSxQKViPMpp73Ov6+04UMLL6x9sSDt2IP8+CNEo2CGqr9FJUQNm8fUWvJPkuiPDEjNmQN03wC9YGK3vgKI7aGyJ2xVGCOVXiXEI9JTYOyMTsVoXgsEaG0OEftBocA78q3L2bx3S/OvdTEjiTfSUYX/ej72AIGB2dZQr3M1GKmoAKkaQ2nTmFaTh2aNxmr+lVHsQpZKRnSfaBfOMmyWGZZFFdlWZzNUr5TwR2NLJ7I8DrSOfZA6rr0zdqCP/2NsvDTIf8mlku5LUufwk9xc1fCrSMnpeTfJIvfHDrHQk3Yc4+sev33fHotlppDL6S3xcaejCWXzjfDmEePNyxs9cq4YnTrVCu38u9n+5ovZPkPqC/Lf/AkVPQFifyHLKRw7GxTo+zPH3vSUfZ1ZpzEeudbXXkLdw3KoK1yd1LOH3BlLX6cpVnS0ZULlcg6gCFvyUsSIKH5AScRx1qdzt0T/t4vdZzhbG0uxbv5j+iU86trC/0H3QM0+qhn3gdoEdiwzfnTnoQ6l+ftV+gvuV9Hf2OT0taKWa2LcSpuWaa7QqKhmmrsGwyb6AUkdXWie0KGo5ZX28jFv9pOQE3b2Ont+b6NcHdB+0S8Zy8W4c9MzbEVOyg8811JVZ68CF/TfDRwZcqZ0386SGOqFsXSpamoLnvYArK0EJJJ8xbwADE8hrEErgnMEFuGB5HBPpgq+z/qo805SS5iVvYrbWdohx7k3H4VVPWUmDXg29cPcfrsi2HAq+uhDJ4Rtf26wFfzIxbI//TGi1HNRS3psQMPZXniN1DCUKN7aIiwiYpHsgEsEZIC7I3h42rflbU90rB+tOK32BCy6rdJitlUki3pHt2Ghvhcd/Sd7uif3dFNRx81304IY0t1SXi3arBtNtg2iEeRQ6pCs7HgDvf9NpAYKqkxkBkCl7IBZV26ELH/8B361OIrZlqTjYxCH7RCWyT8WWFEkgE9m1QPQfUAFBq5wxlyhzPkzhNqZLbdZf+Ozhx9tjv6dvefonpgVNdJ9cCoHhxTPQBKFdVds658NaL5WCaZ7HgRfcLdDSU3l+GEiZ+Mk7GrXZ2H2RWoiSselpWxu99NEhAeG3WxUVdx8jp3OiejK3DSzXFy4/8XJ6P/Nk5GxsnaaZxcmuKknEYgf8OWyNGNsnXKNsPz0Xx/VICqJ6M1vzqfFRXlahjOcnpYsbnLR/GDXvUc6u+nG+1FTYKs3z6aaYP4Coyv/X9nvPtvYjyJ7iMk9O2QKtHUghBWxv6MrWMjNMMOyj0jO7oQbogDxLUA5XMBYzV++3gRiE8WgW3q5U7GagiRrbk5bSjsLNKOwFNYVQ5dQsRlVb09Nm4qm7gSKpdWoE9ucP/FqrROu7nqjkGt325VRG7zxmmgtKLYnlrDG/yEP9uSDRlya14ZVD+rSsWbMhr7TV0WVvk0MCc2Ip4r4mtXQ3wwi3i/Qpw0lbxZIy6AulRZniOAE5NiPzshoY95cJklD6SvRPT+I0RESsQSiTBdaRIyT0RPsd4mpD3BaDIihietH7rEbVXgdHVg+VD/UAPWp2l5RoSA1uwY49A78EG2WQGYo7SEnzZaevO0DEnLUPogv6+0gJId5t2p7lIaslISJW0/Oo2wNggLsTKB8CxpxgBNFY8RKN39sIEZj6Oc3iETxvvcBk2tI9KVDQSFTZA0P8/5LQ48W9uOvs/5rfnxu8X/R51sodlqdxaXMD7q/EPqUEbFSSNl0FTU0QjIop02ddinUvapurW5bI8ROzW4QS7bl7z/cTbw6mkNPJL22KPX0plpZ1liSUuSsw/mlRXgxMT4l5w79XFAp5a/1Ja/vgk4fRTUXTIS9EqtBDhRsaFGggkNALUV6lXaFIBpG5j7+emHAL88imIclU992uPQeWAxV22deDHANvMfyEDMe6aVaPbMKmUORaRHyJCzkz5FlD9NRI7vL2O632KXx/apc/ulHkQ9I9qhujmPK6bgCBr0KZnQ2C0F9g1J7tSvtzWUWTZUUKGg3Enm6ptC74P+xBufwMXNtI3GtiracdI2s6/upGH+PI0TNMwI5x4i8Frn3TG60TS6UYWu3alFdDKfVKO4YU4aGfboW7NiGkMdCZDuIVizaFF5Wc1LSkMd4hpJQieZR5k42bFUwJ3knrCgNjgKV37E66RZJOinvNYKbb3JL+4a+w6cF4/9Ihz0+iU4z2fHVJN7y0WkM+qKzqosZBn5ELgqHZZCQ8T42xv5NVnGdOD70iLlAzqZTurrnBnuDiOkG/FDs/Ki8qP1xLKJv6355tHNQK4V0MjstqzLitQnY3piCif4tzcSTBNSZpIt1qKFz9Tiy7Jl5IMS4FH0Eoe1KsAullAkQj5JwzrPmQPkSOWMRPAdHvi0UpitWMBGL1+I5/wQS+A4DrJWCWT6skV0Q32MchqPKxZiFN4RohHZOZD6WDltkRa4DuzRZpvFq3WtoW9Vtlj4lixb4SsMXKkWsfJzoLbFmVlXWVAfJWXgKUgEFVrJbTwNg9sIslENAKT8MCM/5BD1M88CidtSyyPEgtqjWz4yA4FhS7vQNnmzyCSA4hCTMUucWBirnzdxTRdt8JjJBMuc90zd8wFRkaz5ukYHtMIUekySIUgSumqrwev7dhKBwVgbmJiIVhyJGQGGlxIAWaLlZmGQyKIFboEgpNyyNtG7abslr+/b/YrOKuwxKpZo/bCLeGc4NyUlNiUlNsa1AW0ucspGzkY9/gwk0W4TGo8DU8Y9qL26cSIt5RhGGk19yE+RDh+n8eHIxnsd8VlJKMA2mrS6CrQOSOJnB39rQ8UX+c+rlRjIFPQWKFM7wq71s8656Weys+p1EN42XoCD9eMj4NQpAcjMHCRanxKAjB8d7sJJefudzS0BEW/DM53m4WSq2fUshc4BeppCu4B2FKIymBCyR802FHwrwYGC7yTYU/C9tWoN07vS/Kfsqg34nxjXdO7UbyyKiEVXdhkKxyKTGx5GZE6V5YQEZnaTH5cRb8RyoI99k8rEbGYmEikPhNDToxjyBLuRv6ApeJevQikz/kGKQiSJ8rZw+Y8RX6v9E5DeQVgyfc8fz93zf4op40zd8/9ijYlKn0QqM6DunV7kz36N8XPOJQ+WujNCvZlffLTSCynPm6YmLrGaP9KQiOvEJWqqtPcYQ29uEIXGZpWl3Js2OJml7HNO4KTS4P0v85TGok0xz7tqT5ax5Ey/W5TGLWohSpxPWX/LHm+Y/RQhhTN126q8abX+LHXZ1GezdaPWdDeffT56NqHKRLjBZiLcYEOMsG6cdlUbURx+SqlTbHE0Vmpl0uCphWUhYXsrHIcG2GNwLaRkaI1kTRj+fIXTCZ+jqalMq5H/4GeZrRfLkGj9oXGR8q2yQDTgRea+HwGNYntc3PUKGxKXTGWzgDCHykPwfQUF1TZvPSs0lL98qVBFGd8Cd0GLcKiX0n2i/ZDTatjVgdZjDm+TlP0usmAWlf9yKda0eSxhKdcDYre2Sg5RZpK/qxI1vVafAS+VHbScMWrlizcWaNtlTgr0XQgJbkKR4m68fqmvXgIZRtytv/dP8l/Rfp2WicuopIw1iTLK1NiGxVqq+7XhJyHV7Y3Z+I7h9NAU2rMSfW2R1OSoN80/m0NBDYZUcCpN3T/lv0oc7BnTZyHkWRxaFhLNhqiJFG1eaRhkKJTWserHs0sRW1OXNpQMnR4ddnDAGxY0ODWhTCV8mgXtXI4rCZ5Dl+TPBpp5jIRO7NNSVkh2S2r9Td9DcpzZVQ7Jtle54T9Vsvy7yUIhG0fWhz8mlB9Fn0T4RPfih9Gxjl8t/zUiSh40DPFfp58gZ7P30HOygULws0/Ued9r69T8F6ucbjckLn7/dz7rX4D2AGBE9saiFcWnqvHuIBXnc8u+K3E1W4vE5G/P4jPEMwI9443QZlV5os3EMbGnzGQmjJJKlVXq396IuEjd5CP6weq/7+Ge133B3MM9V8nx1lNyfFcUZTiXnJIJQWbgyoYXnLu1y0p9woiYcdlFGmixApsTyS6qPUYMMducsQMihxWcaUjMnZCk1CRqT8aS8fcZfIn4tXNnmZa0DiXmx5rVy9L5a0nBwZf6lhArn5R10csdWIJipW7bvUx/WyogJXpZiQxP3kqMb1Rk+Kx6HQElgIwGKbETetPXpVkpyf9so9nAvi5Bezn8ddStPyD1cn8X2+xi8xGmmKLN5nIgMyKYoYJnRBk3cW88uJEPaD0emrZ3N+eOEf3cCZpz+yi0LOJu3yYH932Hw2DiF6Wc7/TDeDi5pvPLaOeugSslA9p6LOStBF5HO4K0D6gRfkzhGhHrjSeeR6JcENXbn/g1Dmlrr/4Y3CaFkzAYk1l+aCNe+vsoaSyLiNr369KBqxdYIxn4DenzNg4+7UbS4/Gj8VHaDyhYSF5Z1C6Yj5oiZQRlAOXJYavgn55xZ3UMR95Ew/ZfC98oC2fBTjZxurDSebWmryii1WNaKKog1DMcB0EUj4+Cum/122Bz89B7hASmFCAgQEBPc6+dxSFsjXyYzaajRxT1GrszQ+WMnMHZr8mQmj8jQmeHN3pqwnSTiXvEb1l25Mxr7AwVzsrZQ+P/63ECOGv9gw77x4Ffboln5Ici0YH3zHlAsmqs8uA1SiYKx1lFs6D27ZtZBy/Xt0eBqGhypBRvuBqavqWkWOlvRNVNWcF/qi6sSAJu+0Q2ZMCb5aGsshtsSp9nTL3m7sm6rPHgWZcRTf6NxtL+CA4aFQ+FbvkBdOvGp9/2xR90KCuHsnzjF7/5ng86PGh93fe4lc1ySC1BLFypW2CgfcaKDTH8NR5Ij18ITKc2cjZDcamxc1xjwrCYwelFnwmCJwIoKW940uqRTZ/alfgCuc2AkMIr2YRWxWIeTyTiFMKSmjc8eJ4vQjdFJ8MIqbD0RfBHukP6nIgRg6AZe4FjndBHhAaPP1jkOqKFJxy5Nf3k2IYGUz0L/YAuPXYDxor39undnaC7M6+KpYsaRxvOnNSBwpqaS8c8OapYVnLgBX/HoSYA9kYqDGnq3NhUrb5oH0PecXDUKmF6zYTpapyjMw4rH617ojfG4yJ+pe8BzHmF0Cz+1uFkDPcn4Pbh/q4q6AIH9oVlOusIzXhrGWPvObYLGlnmBQ17pOLHwpvUj+Tvv7H3XeFtJEmaQMFUSWBL7BWvV7NUC3+mSJAiSAEgQIKiKIkQm6Q4mr7xftqs34U4Rlrvuvu8v5uhqPPee++99+79vFnzdv5pR99c/BFZqCIEavzMOukjymWlifgzMjIiMut3FnGZx99a/JTK7NTkXvaJmgacsEMNB4kZftWVH6HOuYHNKOzLKjGqqkbUEfPe5CU54TMz/LSMaQ5kDQ22jHs2DSrY8iLqFpFN9q1C0/yZOkz7FKa0076o9iSHy2b+OPIAjtQ6ccWcMXzrY9KhL0vgXHDGNAi06iEVSOG4X+Bhzi9iTgnAqx65eHVAROv1JaPRotxWKvmlIfV718Qci19Gg/rrihzEW38NDWJF4fgh14q2x/+jkfl9Ik7E2rln89Lwc1GxIM9aMuFK5LD7XIrUFid5PGkiQmso75KXbSyghatDrf3SEItYPtT6HZh0laTkFYNy9E1N10Y0PBkjUMuskzH5E5M/LRToCufxvov0/UJ4vzCkz39DeVbMeGZ+Ida6GuKL2qoH+A6NSmXrdbY95tMgQfTkUgE6jTnMVY+m/1XI/8leAX10qlcgSusXs37aqiY6Q0R/PqeXtMwVRHJ1Zcwsug7a6Ko3qqcVNur1wF3x9EZRyREjMUIIrOVW2MKzolRXgHd4Hcl1B1U+tuK7SsNYa9BlDbpoqX5Dwf+51CC6xoIymnOAWQcgf6/OOqTNWsM6k9PEuYYW29hiIWvm13WFqYrCTNvSPR1pFeVZOUWa9vbTwNNFxOwYmfDFI6eLAl9uFZ8JnlIAT5cS53u/SOiklfvK44ZIPh06ba1wm2jvEzgCozx4tOET8GPkIIRy8CGangWhfoqfNqvR/iriJzL8RCl+TsdQObAuL62wMJJJEGnqqNnPHyIa3lcTyfSpMKPs7corNAF9URDzMV+M2d5nAEwJSn4JfcvkitEM4SthidqGtNEGu7KWAMQjYh45jGdeQ8UsbuX9IGcUL2A9OnzSycOlp8X3FN+dtPiiSwLbOlaSq+TwAlTy5WciJ1YiKlmSFC9JHi+9rCY91qT3VURMscaKhZxr6Zi3rJyuAmhITNzrg+L3oMBwSFxCA5dRn/7bZszSIVucskw2jXlBy184duuWy/TfYZqgrX2IOkqRyWaUb4VMTYFE4axiXX43lDDJOLqESVhFheDCxpMfL0r0zWSQJQRZpMc8yOQpoPZPrD86noAz8tgqybm3VhKeN973Fx6TMn/nyIN3AT0sHh+RnCShSIW/8Nhd592L9nBOHm1aA6lCpTrACkf/a1hAfNrorxS4gTX53cKm/N7Edfm9hcaTM9Eld9vEaDHsRVkiBFYNSEavSo5eCRKl1g2hFrZwC6uU/czgdv7vyX9XWk6xifk/ue83cBMbuM3nTGW/SnfJbKosr+f/GB6wGhiSqYzsgKoyZpyIEBkfsIbrKPx5UwWPR1TeNCpeIomVVbEyy5tJAWKOrUyVf/ZA9hcg+wuQlcG29AuI/QXE/mwSsgrCpkDw7xJeAt4rabxabn5Pk28uoOKK6DKzDmqRoIm4HjRwhDgHCYFhTn3GN6CP2qEvCEsiXomRpjmydzQxhf59fT4EdU62S6L0gi0EzEbu3XcLgzd4WESTSJtHk3EHS+gzimIZfV7VTdNXs4GLeNgmaOw/L8v2JewFns94zrwkS1/FEpqI3z7LrO/OqkFB+F23ubH6GD/luljEPKpSmhzE0sry5VeezIH2pHZmo/A96GvWT9RMIWU0Ja2m8Q01UVT44B2+pRcdNQ4JKgWBOCvHKbdhVb6oYiOeKpH13aD56js0NM/lb1TVTNzRbhqxe6dKN4ErSAMDDewK1XCSIZEwtA8Mq6nHF7R0ugS0M4830shTSNvpYiUb9Ia17ZJLqBsbrVtCa9cw05mryvHfVqXV8rxXMu40oda3N2mQl8P3UFlloa27FB96S7+QUyV8hZRI0oYzCiMYu5vDLyCLQeQidCZmgx41dFr4/mxk1fy9cuRUsQduL6gEnlUCl6SpiMgxbrHNfmqUm2YV2uxaxt+usqan88kMAnN6tyH5MfMksNpcQS2UnogEcBtSygYaaBmhAxPdaiBiFIgYo8StnjknN5FenlbXFOwVxHaeZzYz0blINbQ0Ci2NWRlw59kqG9BjG1cVGS1ComWQSMz7k7DLCcms4+u82CbTHSE0b/F9dPinPs3sk9lRmH1RrlnS8CBOJ9mxGnoqgYpzAjwD0qWAM1dQELqKdfKq8r+vvVvHkHTatE4EVINxpILlUZfWG7HKGr02vrg59R44WCbrNU3Qt7eYikZXmaHmssznVsj6YstGX0BHoK5uJVGR42cLxJWxv0v2B2ZvCeW2SDuWlWTMVsRVXSRMiZXBMZMjUtZWJvA14sfBo7CBc+jJITa2hWSIG1g1UdDAqBjackYZ/biJAq7yJA54qKLDfDrK/gObqRs3qsaNxLjROyl5WWJHOfuj7G8K/I5k9aMZDsjXZ/JOEhmUxnlHgZqc4F3jad4lJ3iXQHWRLMt8bklOjga9Aao3tJR3BZjUjsxkRDFknBKurQqZfzQTsnL1g3qFwgnm8OENVHJkj8ZonopfHswkb8NHCIg2exJvwG70eaOPqZf1ynwqjOMrPnRt9edcpv3ymyQxuvSGFEajbiF4FpzeKvvO7pjroRCGKnRC9zQTggqoJqqqHKgBtpU6rwmop9LSjcBy5URcMhHmpPU+JxRYF/W9OAZ86W16ZsgP/kmSwpAbhMybXttBj3+SQG43uZ2ti9FHC+TifdU/MU/drT5UIR1YMGGhyp82igdSZ/ruPOoap943kKjNxRxp0uQTbpCixqMZI1QXoSVHRX2LSVqpFbJj0aJqfxQPbmAG2sOvND/aXwI/2qfyo/tMfvSfwY/uSX70yY+5MX58buzfqfzoY0750X2aH29+mfy4jLdJalNgK8Hb6HuMb44tiLQuyUPkmNOh79eb2bg5moeg9eR5tzFpGoESm8GmN0PLO0+ex6pMtv5ScRA9+RNFbXE5tPhZEwCSIjLNv6mk6InOOuBgrfwdvPWmeN7lUlqGJmVShNahRt0jMqrryoVMRUFywnZOpUaIQfnQUa+qH3zC38HgULPo2RSDSp3THHhGd6xgbR93NFbk4IHfCXj9bJF3fnXRnnxaXJc8/mgmW7dr6ODMOx1xc+7ANYmv+6oA7aAiWT4wDb2D6gGqIqCthzzMexiCPZZMoJNWUtoqhCEIX32q8xQDsmmksw41UDsFNk4FDXoP3UsKE7eLhEuKryDh1xauyqHyve4aeei2dDrkVqQye6V0brGHFVb7JT7rybz8oegIZQVMlUfqj2V2cBefnKhXiR/05PfGZBRlk/eKcjIWFMkQLijClgDkaTzZGHI6nrKZ5EU3N5rel4JFO7JCqLkdkvo2u8ijR2eOIglCDhyjhfkqpj6EvcElgd4ce9cc500hamrJ6IQClqjjk2GSUbwnD6tuOai+Rb4yxZ/k0LM2XIWBJa3WvGngWGJ13IJU0nzw3F1EHPRWXOLrUhzPprGgWhb51JRX+ywfzYBRmx/yaRn9oekOLVNnGqbOdE2daQdPV4ti8sRsByKH6S7LtI/QUUS8CeqFpTx5q+hupPpbWmV5x8dBibth8we/avoB2Ue9LUuwgfwjAapxAEPPhqtOVyVbqqlsa+7n9YK6XrHTWNkqPOcRsdahvjErWg4hACqLwuW0luOM7z6yL0+ix3CVnjIsTAvJVfNIlr9MTr7185WTb31tOTk9zkl+YJi5F0cMLAR2MXvlWFO5omw4DKyrkxMpu9oTvzq36jYoHviW7/KdvrG0bjPf1oRXNtyqcrg7gcOtwOGqcbh3YiIYoesqaKhuvsHRIPBXFZRCxtymGfOUuYiVaTfC3El4hESZjfTWajZSmF2UhzgXX9tAXxpTQ4t8EnQZ1+ZDMcJ3Y0CYRDdJ9GZOo1/C8tAvBVmptziSiFwMkTW+J3SwwawnRtH1EUl6oXlKCnROxMCo5oO9Q9cy3aaqNFSSV5S4GuXeRAMV0jSzJym+qi6Gc4XA3Uo+qsdC9SBH9TwmppLpYpyxQdVFOf0ieF7RU+Jo/UljjhV+QSYo2vjBG3tZHKx95lpDrZCkOGyyBg6LOmbNumYN8maShejwkit2QvxO2xzJUikDW0kTTGsqmkwPoQVzPZvoS0iGh3Q24yonvc284cytanUiVmdVio+zybk0zThrVemZMKRK0ZYpGQdRDnele8rPCL2R3tyQc1OWzUZnkeOmKT9M9Ryi+PSIrQDJCaoyJ6P6fsg7Dd8qZiqPsqXBDBoBuioU0bPJvVKvyPmm9HMSL9hV2+IQd3NYlJOKJOfbTcihp1R1fSWpqyqh3XywLUnBo1kzaRJnpPWrFIdK3irJSwI3MgLzYc2c6BpkEgxehSyGp6TWkz8bScq/Ww5X/7YqV/+2nApKtWxl1ilK3YtDlY/hKxlPPiaFfUBAw5+IPyWT31quvP7pKEz7MZMGfsyjj/4hqgRPOwPPNcKcdfi9kbLILj7Ni2mDSJUSk8XWCZAqWgYQno9xzcfKNw4jJznYOrEkr82b7dQ8V9VR2fhXQFtlrjqdFm1uyCGQCm3bGFYxhsXGsIaFGBjbOLpF5O44o2IyKsIq0X2SUcH2+XcL+xlr/jNZ8z9HrOHVf06v/m4UGJVn4tgYpxxHRF61+QNj3elcS4UQ6xKldWnY8ph4rK9fSdn1ViwcasMu/mdVLhAu/nNVeVcJyMr6ekOI0WZN+mRkg7PqyBjZICNjZWRko0DKvvaIkUjPUuamUrMa9sUy5jalASrNedSJrFoWq2R2FQ0bMILCEMRoNLS7uxhIHti26ZiIRZ2HeTMjuL4+4EKjvSHCvTm7R8l8mN7bD7J6QcDFVkdB1LZSUSsMqCESUaugVZC1TeG3VDYFwD7aacCMCpR5ygLOYZc1K7fAw7RbsdAlNq+BAgk77xKK/RUsi9qB+SEWDrFA7pEsdUYE2pux5kPoTNJDUgyuGvzs5N/aiUqOGDYioK3VOgyaRhI+BdZElUXaaIBEJVCmB0aZmrca7BuZqsf+8DQgE7lySfjGlYUkhc5XGSmXzDBIkZ5Qbqx7dZlDFw3JpaFDjmsgChRXc2A2hibkTBUrWCD16mhjOW1gHOjHnzAqVsdoED1NULNKmzU69TJE4SRVnMaqG8bJoOSmTUrj9HLqT50J6pjnk3nYTYuymlTZgr0biesXUah0+fNWOq3rhIpq2NYc+ir9fTRruLXK6xCglpgl9sMltEn4NtgzbNzUrlA8rSv8Qld4K/p8XWH652xXYOt/lnQFVvTL6wqRdYWCdQVCvalQH+8KTaNr6CophJXoDEXtDq2B8SFia00DXSm5rXpUl2X2UJBBN8V+YtiPv0Ts06Mek+/Nk9hHgzQysk2a/q9qrPk43PMgDW9G45DObAH51KnXredi9NjKxPWQjEE6NkjHpHDCvK2WRsEkbUKgYCEd0kMlnyaPVjvskuqSUK2gjeRhqax27RAcfxKWFARETETExLPG3nGgGkzVe25sJlCtYqfWahR2bT6aEABCyjQNczZ1ZpX21DzrV0imaJt60B52HnjzL5o2tJsuwyxk8SL/tuijsHJkW1WlEOvAZSKKYoOsFIdCtr02c7HVeRTNJ5Yp+cagDvk7mKUvootI3YhVROoC7thUN8St+542X98Vw9OZML2kD8dWYZtWSxOH+oI7wResSRHz3cyXeJrl4kdPWC7om+2F3pw5eeXQQaKI07b5Qt7zaNSzO3010Mh15PX46zk/1i0LCtN/T1fS3rn3XFF45nA2pNux9eyR+gy4L4o3Ry92whIhWz927S/4zce8IcFL6yGe+ZVZnjLW2fvPFt2+se8lq5AbkAHSs359NKRJHt+oGcn66bQkwg37o3Vfvv9Al3aqWaGtjHwhTLpoKUKfSGkrGpbJV7mzbtw5LnLP0DWU0de8p/8+m+quG4LcnL3ll61ivjPSu5sEk6+KqIxk3aeZ9eoZYHykkInNNVcX15ywFf1hurI4QUWdb713BnOQOWo4qxGzEBjObuYemiwb5ogxV5U51yXKgjNv1Pl3MDuUnquGCEHQ80/7HcxRIHBT9xVBBI2d69P7QZcXI+jUcWEz/NikGg0nCuoYN3WGuPXkrxX18FeKT/5cUexss6UQ9iGnUXZazE6VC5PmdjbJRIUuGAbfSVJsyM+n5FIuirwofurJpSKvIl5FchXxqsSrklyVcr4Sel7oMpl6Sxqc/wt+lBD/EOIoTnenZBtxdM09R+7ed1306deKjULml0uYn8l/OSWhEnQoT9AIxsnqKA6pAqgfhpZp4k+kSDC1WZjMm9aZlegmsS0srpk6aHqZI5TmG9qm5IKeLl4MKlmQk1bJ6tNzHcjTvJ1F7ppzTaVSGNdy1uQZjldBEpqzJw4WvM4km7BbZYda0lErKJG1seJWzZCNxMzbmtRXxjWq8Tow00qQZyFyQuuUzpFnVMnkoQppPknU5BCh7tR0XX4gQsUskGyN6dzGxIqOAkoIQt8GclYxWIeWMqvp6U0vpI0u0BmMKGvW6REgKonDGFcxl3YlrBHhM0ZahoiiRRNAusRywZA4p73frVjvtRk+K4orKpmCGWAhqDpXTU2zyQepYk8ttrDFBsyjILrzkLiiWalVU4H2FZRlKi+5xMdVTYzKA9ecINu6WsseVoY5yebbX4Bga1OwdTPB1nyGSOv+LBJpUtJXWqq10aVUOynOuqeLs2ZenPF3XKLNfeESrUusd8ckWpcp21i23BUIDZ0MBNnWOEW2NVwP8vTLkG1ooLuP1u5D18yJud7pfb3zVRBzFOPqiGihkndEdL5g6dcw6ddV6cc2jaRfVcmUaLOqtlohk37JCemXoG2k6D0lCEU0CSc7I2GYfH5hOC4K3aoRlrPqXBvlOi8kA4iNSGFfH5OV1cwy6hpaV14HkWbS1MaqAq5KRkuSy6LFV6iDi0oskqDbraNiUe/Jj29dthUPawCuY/34carAIt2A4tgD0JSvzHJ3unG/ocHbAJ0X62GSb9LZpnhY4K0FFfCpZ3BZOpJOg67JbAbugZrKfzW1XmmLswn5S7h26O6qFGVwKTVzdxBt8xXJFnfVHnmFYvTfF91VeWCq6tLuiDT6LXXJha98v1+konpNsk3uS4UOsXjfr1B87kksD67iGmEhnV4e8MwNZWaWC8HZfOzXbOsO5vZg1l/XmMprdH61sBj2P3ML8Nj/C4+clxwdTdFsheSnFqM+1iilOVdDiTMJt4yraiw4QFsUXwOmrwprPOCxDLnqkVF4lK0cURKQ2roQZBVdJ+NYkAGr+dizLOBqQa4WsaDyb1HXv1Afy4WhbW5M3hcBiU3brqKNKyYLnfm8Y7OqKNhiyW/TAVUUfGyNsGWdXn0rYW3Nkd+Udrj10ILyngGXF9lanw1GrJ4SQkRx2AoN3cANbOGmNPinw0Qx0z2+iEi0FiGIlkYOVfKRQ+oXvo41FP4CV5vkesC1gPp0Y+cG5J6Shg1g9bXyt2T3H/mDrKV5/XZWNxbTtIHLwo/SDl3HXYqvOj0TWDGCGH/3pNB5V3gWf7clyQr2JsQXbj4dJHY3dFT0aXuY42EOXR666fR4SWsl2DzAFddh9e6yVzFi0zVwgA4GAhJTtN4uTLyHu9jhTk/uHThwi7jrXpbSXx4U+Xdv1vVtPygp5wD3CJD5odPw309H/hdT3L7Tuu+xdF+5HJSGsq+g2SkkOpL7QmuIeY/zwPFAG7wTvUEc7BvydltFIs+21EbKs3eQ5nFYdt2monKYjWeaXX4gLQRTWBwGVOPehGEVJBNi6NqFEBtgDEXLcmUVzxYYLwELZujuuUIazcn2SVJ60oX0c3gHGSHkmLItsVnxRd/ioPP6nd//XP7PbUwMUtnSKYkEfxqlJqTZcjex5VZHARS9sGcXDXTsyKoMj1HI39AoEndL0gfjLjVeXRGziIY2/NDwFkzlfgMb2dCPhs4Acs5eVEiySg03cUMSsU64xZMtzUxtQzGkmOA85ItNnSfwlZvM+imSaNyLEhPdWfcuzOGebmP1brwdgrb3oI5V1Xf/O+uF1l+QfsoY9yc/aTLjnYNPDd2OHITB+0KSZbzTXQ0D/3ssZP+aSrXrOgq8/lzYsJVmnb/7pnuvHa4HDhT8Lkl5BbuCZV8QNLs63km3+vskD6b4kF/R7ZnWlOO4Zo6JPm10JtxXWBOlMu9j38VYcyCTmEOBL6cL51/xlVkHRihDTvoBpUGt4FJ6LqKvn/C2L8mSTAckVBPen3WoiB3qiq01GFC9cgcckqW7/willZxIb543bPb8XOhoGxYb16SgkVA4uUUNRW6pSGHbWtozFV3sx2kfdjEtgaOQtip5/lDKqdK4lULwTM5gHZs3Pwo9tPJsY3UmbOWahRl8zU2JLhZYv54Z3+dMKl4Hjt0HhAQOe7Py5kpoRzzYztz4UiozzMznES+1TjS96hlBJreLo9tReptPYsvCKv/j+ZqrWdh1SUBU6IUPyrbcjPhAB6eu8t8eycX8/TADkU28uuMhwaodmw7zgcdjr3hm4z94hBWbCX1IEf7hx5r8aATqgHSLZeviyp4e5u1QkQN7Ce9oyPmBj/hAzrUBxLNZAn7QlFxdNOPAJpTdJjuMRqZYeAuiWb4w+EE5SRfXfJDV2Jalw0+9bOVaJAdsuzSuHt200yN5QzN1hTT4haWlCTdHL2hCJsiCbKijryNiL2MV7G6cZlPTJ96nVUPMy4+kWT86SjNn1npeGByDz3nG5/6RnG4PHruPWlJ5jHD8yCPN9n/+veOjXLrr8ABwxMeb2Dx6dBQ2kvN2dB9Jd/coUacqbRPK8BQPloBqjN9Mt5YuAvgooIk+wkTH2pLHR0wmyq6k/O2/7W1/B3Z4ddaub8MOr8w+8tBludADE8AwZgcBIjh0G6AnVcVt1sbQtRka9LFs++sP2C281/K2g5T1ymMhtoi0v/AYH3zkXz1W1Xx6oLv4r+ED+HAo5zO6/eKx3t9BX6STf41MXsFrAlRKfFF2XQUDl6Dvqkq2RKR2xb2Oqt8mmXSK1jOR2lS2E4c8rOF1CrQKIs0IBR5EetI/kWDbhtI14rHJztojll43f6iZzb9ZTr75nnpVElyF1qzPqz1WhLH47EN13RLN7XGPnDhfPL1EktbCc6Mwf/RUkivy3LDL8q1QZS8+IgQ7wqsKsEKBB5vu+U0K6G/z3yID1sXDIVQQHPsP4/3grZn01iOy/28f7fyrf/kvbz3265YLD8yF12STHcTT8X45uXuHyPq922S5N1avUd01xSMyuR5i6rfV3oW9l6nHXkXEErFiRw52a5A/gdZaLZ05108sAF+Df53glxPi9LfdOoY/8h99hexngZpAjiSsri17KYxOnHSGWjirhQu1eB8cUVMIVdHjI2iWY6PmLpxOfQYVyJ8YC791UBv6bztw345vldHTLUjmkwfMazZgLlhY+akj5fzXbaScJ5Hmx0bKXXwbvp1DpCMMHVbwrWMj5Z+NvlIj5fLkgTJIDtLOVszYtRWtyjxND0SEJnlJRyNceScZqwJ8E+uQP4HUem20LsRJZgiIymMuwEsOZH9RL3l0JJVDXcmSVkHnLkD3Lxy561L4K3hFO1Lpe9O+pZdReomPWdexVOX0tozYnzn2oHSmjotX9fFU1kGhPfGYPkX90WSvzIYBXHrocRDINgH3InlFPHr4Y7H5fFSfUNAqgeohQjq/ajWcpT3VLqmEctT4IK7iZMd4ZDYSoVFwdh5P/7bfwL2r144cOJ7+BVx/9Ot0xEjHItiBIww2j7Gmo3ZgRdBjs09kSQM/+Q2/bBMA9ERa6jmOfRQQFn20BhFY0ucfO810W5dWvQ+DQfRUD/4gk0oiDI53vuM7/vBtDo7r2qtfUzEe3sdAYWT19mssWNEAvE6uK/9tnbJm7WIliauEwcAkccwSBWXagk189IiKC74Ze8TjwJr6mjV1j44OzsTGKQtWrjihImO0ygWrI+xAbKMqAP4IkUmrzxDw78YyseQLeO9GlFDh2YjKcrhOjecqs72KHR52sM/DvqRXn/C7VCosssRFvMzmv4x7FA73gnHhpD/dbr3Irvhi+o2SC3qTelWcboP9T6OSbblMNNpWrWUdJCoCRB4scIu2p7DLvc30E563UdZAJ85EYzV1M4fy4W4+Fp+vWfIEVX1Bkk//A1pH/RnQI04EMCKF+Z7JfbvuY0J7fvSW33L7nISEnCUzWEVX5rdUZIs4Bvij/AnVqsl1fya8GGkvc2c4fp/MshBy4BO+bU3WLFzFAHiGgvnMhhpLK2mEbNo2I6HFm6E88qo9qK3Y6tSLE6JQ7jx5L13ookEs2lraB7X/VypXdS/e8o8Y3cu+ZGQrm50gvwuz+Q6rNnPQOrIdFY3/L4lgRRFVqjMVRXEuUSmdlwSXSCkXH4wS33+uaOLlDC/t9KyEIgaTAM+Yt6BNqWsbPYc7kAJn5ba8m/BwVsOKbPoRK35wFmceoWz0i4finztrSe77mhnbmBV77GnutilUUKO9WJIJT8Q09xzOyu85JOJuOx8+dFHAcziH85iin+qnJxglpyYbJadynirh6X5WcdaRBEV5SEKwohVChJwhOHBWbZTZzkWZ7+lNy5A5SQdiPmWySZFSe1/YQ153OiaE9asPslCCxSCSk084ejbSwJNsI/uT3/GiAzWNR6n9sWK5aH34x6y7SV5Zcl/gC54VsE7BiDUWRlVLwcI7uUChCo3ME777VGS0lklX7e28Idm8M71XraVEKNM8d3SkJeVVxXJtW9rPWhVGseCF/J65Rd169ryehs0zw1WYa9f+xczzM28W3zjHvvMjZ6TVEf90X+uqnLE/ybVmW/Al/lDi8BK8qHzCqwxSX4RccBLLh5dYJRUGMzw7o9Xi2VmeTfHVWvh22jQvpvi5iyk6OGRX53Mosf+ex7n7fppgfV4/dTh46w2c5yrwC2GdtZ+5jxlqWv4XQT7ed3f2T/HFnn+BzJz5U2/4b/wj/uJ9fpHuDn71H5HVzNzyO79ZtpT+U0U/iwthWbm/hBcO/Yu6apvyPVJ3qa/jObvlgMv8YuYhv2XpMAs5eLwoChFmLekVyItzAdt5z8vUX3jsG2EiOKWulwXpdotyHnFB8ws8LOGSKdRT9Mcsy005rDDJgbvGt+65Fp5LnTRtEu+iLZp6g4FiEYO43KpKYN7ukgy9v+DW0JCi1nFJenhfMp0+cBvouuu6OUxQdRqohqgvletUbLAZ1B+eYk10mxufLfqt4P1lR3E3A+auY4s9r6YLj1HDlhnVb4nkvY1ZZ/PAFzgcrVpxt3CbFL1ACI6XtKpaVAebUlrY78APxBl1R3KbkXw2VKrPkPqsydsERPdQwEU5HhgM8E0POfJhINwMW3It0apdgOc7F+Tkwr1ZDvU7BzznnxRyQV55AQOCK5Eh9eCBChNJcgEVvbgjZHxpglNnFyvugorNXfQlAsDvhTADc6L6fbwU9nbbp/av0tTvP6nbrqvYS+MT5FZxdCtKb0WjW6X0Vmkjc7uGEILdyRJ5FxcokS9QgK64GWnfivpXzmAJg0PMGK5F3mZtL0tP5q1IbszcdxfAsMiZw1RUF4xld3Tugc1HY4sNy1on7rlfkaLftKLFt8MH27hN9NxGTcfLLXe9hmvo4uaeTAK5AR8h7qOH7hZu0gOkdkCBlOFK7tUMVzvK/8sTcLWDmS8JV7cNV4ZXvIiZIQv64tDliK1buMwDEV4wiF044Dn/pLxbEyHGJD9XIHZ7HGK3Pw/EbqcQu/0VgdhAXDzhM4EBZjddlxoIEUV8EVQtSUP0BfTQCytAuAsq1OcNYzPqqy+6HR5/q3h3iA2p3Sxu41LwcbtKkH+3mEnFan0Xl2kiGKRVdzf4Yf7dkZt4yhwjN4TRe/rVgHZw2O1N9oq2HbWxNkkqR/V6Xznh9b5xmte7Rh2ExV4IXm4aBi/I+zfcJqnsL2Re7jtS7wH0HHc4yb6BTekaoX1T5ypRsVjk4jIgwpSSiI5d3Hm2o1gInzY7cwbvK8p3J6B8D2J1wXIgyD52sYh17D3DO743GZN7OQIuU1/FshJw+4R3nBBbQONp7/jUCS1L5rGUXRf0Fmp2s+4qVJGp7pxTb/e0NdD4+rx5u5/F129wkWYyjefVcX8F0alMVR/IecleyyWaz4tIJKZ3BI5lnTHqy9ukNs6zfcq428EaYh6KmXSzarlOr/z/J+8qwOM2tvXOSLtae7VrmRo3dm5GuszMqHIDj5n55bOdG/gCBTd2Lpbbx/xemsd8mZmZmZmZoXT+82tWs95N3ea73MCONHjmzKE5I+lMy0Jyhy9TrN8er5+NGaQrL8IR+7PetyW0xj9njPWBT7I6pK7RcFwIzcsYuK+43Oc+L8h9ZT/3SXWuj+6F6G9B7qt8FF3wZhXWEkGu/l6dcI3smO7F+7F8hQmqYG+2DvZmfbA3o5Hs6s6f/QQ/5MOG4CizOn7XQ2Sy3jI2+NHOjXT8GnTMApbiGoFqs39UwG6i6Vs2anp3YwabNrQpoyHLBWo3+rX/zLC6kUpI4B7nWEDXrhBbLP6VoPg3hot3BMU/M1z8qKD4jLDYISyfB+q+FUzcptuzuqB5ckY/Zpp1xgdHNAiOeNd6o8Oshl9Nm70OLRCVrer/L2MTD5MhWl9tK2qQq5oarraghtcrNRC114ZEtWbXTRTbhrDC58xwhfeFFT40osKbwgpvG6hQNsjAKEPAypeZRd14oXoETnIxQ/DX6LXlAWBvF3CmpPs/Zh1Bc9Rj4aj/MgKsy8MKV4cV2O9a0O8bai48ELQ6b6jRuwLuemPdaEfdaIiYsN0Ois8Y6vN+dZffOuoZ9k5DmSHD/sJ6XkgDcs2GqbkRFMfrqHluY1Z+08lLgTdv1PTX2TRgISWBim4s2kToDArNRaCWaIBa9jK+8x9A20WDrPZ97fshQ33joJxxl9Hod4SKs7eOlADbjKmZOgwXz1jv0rhNMc3MNkPB17Lb9knhFsrQ3xSYXQNRFRuUHYxPCvhJJRGmwYDohRHfUBiO1pLgtNQZfVVNq4KNYrnsXBKZeHhe0N41niKCGi+V99td4FkIFgFM5sXbq7ym3C6XOxYLIyi43165k0vKjYYM39HRI46eWhDyy//hyXf86S4cYzGCiksZymXv8jIpkLyPvOFdsjmGvQj8vlPdzDE8vtHNHTDmgABWJqMz4nwUXTt2SwdqShNPzQBPOowAHN/Zth9YtcqNk0oq/0B8qSRG+0YSa4Ky7F2AdDPdq031SqEMYwHxATVMdLJ3o26j84eqY0Z/34XLQYcyOgUppIvOZJfo0RAEciccItUbi5tC4SMVu0blsqOf3FQrvFQAecLfQJOnTKCD5WnN+dLBRKMU4XZxI7v+qIL9vHbTHDlFgtBFq/ZCjKNe846dq67bcq3j3xk0pFQMzN2NkvVOuINLD3ExNaaulN2LXKBnlFZjCUtxhA9KovR+mNu/8/nGMlksv6UOKcTP1s8rgNSXs/dcLMDBgkRsa3Wc4udevgDnwglVgx+pKmmTyZbJcn8gdx9jnbYQZ8TKC8sFdDZ47eM0G9XLSMzdCwcbDY1AN45j784SonPSPwjECuAFQj4XKazarvgJ438vekv5hIu9nzBzLazAJB2+1o1rTEVpN8WtTySYQFj6MUnzGbXc81nX0MDHuD5FskBcdl++yaXqsYv25XOUGqe6cdfFS7YMQie6syueuXnp9EONc/MF6TTZrucx+3DI0QQgWxwajcErgZOCcx0CGrbc1DLzxJHgWtWA5ZZD+/fjWzkSQj+fcqdWz0iOcQdqGW7RNYWvtuTWzeAwCgvmgwcxhF7kt/4tWGX68ekZuRtzM9XW3i7lLQEBE0ftpusKCUkDivHBYNfWddnVKruCdk1rcBZ4JVNKqlOZyE0IirdLTz1Jz+XauQxul0nJ3OykTksuWuphORdX+C9SalqdKJu6jRGby6265ZrzE3bzbiscKc47PSInl7a+NP7yxO8Mha8/bB29E90aoHBOt5ZzisKUKGy6jiIuclMVMi3B8yh0Ha5GPIhCNwX/x5Tfpm1BPMst/vXwcdWbWHTpkboaDmHqtYiyVZkL4ujyW6R/0hH6Jx3UP+IdOEB1kO6Vu430zzv+6+3/ZUYqoLejRDIleXujVkEfHFBBG4+5sQo6sLtMvx8q6EOjVVA6SgV9mCrocmMivxoutHK4DhiMx63IQmhoi8FEAsHSkW4zy0C6MYYDujCV7CM0qESR4AlukxoOnn20n58bb2dJifN20pfbpjcckB4qEJXLGRXLGX7SZfwy3Dt+VNTN4FDHMLRoE9yafVXXTuX775AEf8Xp3QrvDvBuF9VPhsDgy7y+n48+j36VzB9g90rtr6luwPPyVSQyl8ioyrpN6gZ2ebHhCGuSlpcbbRTXoehxezcdR+TpYqWkNivw0GHragOWv1ciCOeayC2Oa+fRBUD/a4x1TMaS6fsuuTXT/vqB8xGlFKuwgp+LTVD1ZYMFoGe+Sj9f13lTVafOeZ8hMaMuzyGtXOHnvGWdLHvLY5zLx3W7TxGw+62b7XIZ1SABh9cClwwyO9paehw22dciWj+hSLnPXmNMfVFzi3mHuj/Hbu1uEGGGJ+oG0rQryYMW816fvO627Ncd+jef4LG+ivIIJXdyMWwu3mRCBWDHyLcBVasI+w1Qzd1w9Tt5Jlkp4853q1D04KdItRYC0eMKm4gFXClzzejV3fpslrgMbNaRC1RwTW3hutpF9jUGghfgEew0AdNFYLqv9/M1UL0TkH6D4D3OVPBheRTAcULWIxRtAtg8ISSJWgsU9j35yb6hEmgEEN8cAkJGd7Eo3jz2Tj3Tf9VtjBSD36vNslLbMiPnc0P450YFbjnn4+Jn30L/eUznSuGD89Nv0aRd26THZV1Q/Ku+lwJQx4XIlZoNZGpSxqEM/NgGMvCkNgWfuHz9piANNwXpzd4UpCe7KdhvzBFnxeLPI2fAtCn0Kox/xYYwGkpT5lsZFnmWFa3WYLM51p9h/TlkaP0ZRTprWK3ReYMx7WG3m38KykIzWOrcsnmwiBn/Uaq8CI9BZJ+kAuSuuaW7+TxxSQUdttaycAf5ujqELCzyR8JmljQR6yB2SfYpRXuTW4UW1Z5ypaOHQGju01xuDILbz5BBgFpshkKHUecZ1iQ3cz42nM8alS/nEYJvDtY6ghsKAe1aDz8dGF9Qxmli/4Gla5F0MSWYvHotmbHOpwkQajiEYFpLecQvyiq5uxatGFtxDFqkxAR6hLRhWyC86h1MkmIQ1NMk1gRl2RcDdCUBumjDfIlL+HZjmqtgQnrvouwfL+m7Q+LKrLT69Z88Eq7RHCvEDDs5YijUGLcZr7BVU9wSVYylXSQwi42TJOFDS2jjNzHUIsbFSOLgoaQmomhbtcjyBON3VIMkAxsW/8a29e6nCOZap8DSV/YqCHbtMSRY8Dbl3hATnpTs+OyQ7GgeqGUHbgZkB0aJVmnrqYTwolK1uDqlBK3Z59BrJTrRNDRnLecoubr4dHi2mcRIAMu9+hIqzj6PzjaSSMQXGTzEF+ZT4WunPwhQR6DJY1kNJVyyrjJuLreSFDHXQ2uYykVoUGCqhRrwLba9bzHdyLeIqZ7cQn15aKFsuFB2aKFCFH4FjW+pUCdKKWMGUWo9SsOzlfaGZyuc/Sts04j7CP/DrWCLjE22yhM1rfI2TcDbsa3DXKGFlYBmRqGwGBMkwteEVHxAsGIySRLgVtLQrJauFugwqs3SprhrMGp5PxqPd6LtKBFM0tKqFRjxAU99nSBWqqeu7bgWvL/vVWfsuEuz9+GKC3A7+cFYMB0jnK6IRu6q1VfGJLlVSA6+Dos++REA+rfg66D541rh+cKjsb5WOYpac446NHMRpXmMhEYazBI6mZpkuZgsl5DlIi9cnYWwhhhcXi7okjDc13S+bkx6Iv00N6ifFnZ7/fSaf/nTVys7frvWt+IEQpLlCZI0b1NOjFFkj1MXd1ynVmboMMJuHZoiVX32anQs6JPkdqrOOtl3AnUM95V+0K+lhjHV8kJfLX93UC1fexNqeVujEslkrMrz/ugCpIzrcmKxjA/hNtVTd+wsDoigEAzin633Mp2PGTN2IgxmG2Lw6BWKQeKsRZwlxFl7BKrG8JzrSFRR8z/mCmr+pupmGvEJflp9Sz5A2GOvGEDY4644McIuMkbdwuLKFExw9gWtur5pKHSNM5x/QoNCStKRrGz55opDmlWpq9J7OUP2KNixkyRz5nujE68bErULoT29MGRPL92UToycXSr/YLc2i7Lrv5ea8YabrxlJSINifMFbEpebCOI4GlKPsQpjMM+M7NF4KBW5pnfd9r9T3nIxarTvbLVK4mIUgpRQ2mZDWpdgRMq8hb6a7TgeRK6Brjp/YKJQqZz8iWAR12eCLoZytn0tdFpoDKBjpWHfN9xNw30DZbUF8L2htcdf8f2jtSdc8T2ktSde8ZNFaxf/WNFaDsTy+HQQr/fzeL1bo3w56BBPrq+BKv8K2ZvLV4zI7NxRpi2kaGjfwtlvoG6iXAaUZ/gxh0hsks4jFPLq2RVUlkJn5Ec2mF3rn9cySEzw2BbMJOmh89q8Nb5qV+JVs9JdjVYq3fck2To2vXNXN98X6dd0X1zO7ZZFnlteenE5cUg2Wy/Gkjv5v22+aJe7RJvSxxeLYSIPl1wnEyrGFdCioxYnQr22XWcpTyuQnRSjxOzLu/oRKxfJz1L5LLTFZs6WR/blPQWjWb6poQt/hmfcfKK+zKTHFEdBk+Xqjq5Gd8MKPjPPhAxc9uAICyRlACHRggkpAJtOSJlL6GCoTm96GjyiaGFt8bSm0a7ztEMgpDQCDSrm07LxU91GAAjER6oYeBJmEUAgrrNyF85pxnEYCbTJrCNMfloyIpnqUj7pIumc4yyCfDH5NJg0ZqoDd3hSxocqEzx36OgDzVzrrlFDJyfp8WOuxStn9TbPyBfWf1l2UmZ/xL+2NC2zxaIugT9Uq2OuaM2pp66zCCHGTPQGpFwdSQnydJ6uB2z2pG4XH/pJQX6prnfntDX++dYjyzk3tiTvZZx2vydc9ML+7Hx5282Uf3sealg34+w58wWo938vPs2snGYuFqDuf9b/nrb6+Me+UFD68cPnzEvyN+dtm6/6+dKqm0LH9WgrqPhX7W2oOHfOfD4Lj0uEH+Om5HB1Pj+FK7GpvKeMms+V90Jyar0ujM3GI9rFfJ7h/Z5EOm0TOfgaxIJrArlbiBRc3saNg95lYWo8FRbYy7P67DMhMfFDyKkuK+7AF6nygLuN64c6aeo6t1zmsmrGex9x/Fr7zGLC35bHr7kWKkK9Q54U3MSxYqhJNtTEomo2QCdt0EnPJeCKJOQK0kmT39K7CXhefPwYOycOQFRAF4ECDWVuKrtSdW3dyYseefzvq0v3ouMK+7W22PrMa4A4/sVybiscz+lSAKGbW9UMSNypBwv5OSD7V+qmuYN57iyiXG1Vb5ObGmgqzcpNUoVclfdB+dAj/whxNLaClLeWVkrSrvHU9kiXCUjIxSFmLmHKu6aqqrwp/3t+eaHBdF0Lrut0taAWlSKqNEZMrt7ZBI0meUJgW8gAe2hGaTRxFhupJZkf+uJL30U36Ac9hR2hG1N1IyvZb20U1FYlUeS2pSISJDDtelj7nq59Ic2x6JJ1gJo9tyMhdjYcCMHBLcHkIBhA2oxePXfKPqkKdELFhqgGHbjZa1xrnkhHH1lfgvxet6GqYBxaQBIN/bKPM3MpFwL7f3EwblfDYQU8toXD55bV+kuhyGTartJU09Z++ZO3PIv0BHDh0S7g7wJHieJos+uxW99di21W1gXhag2ggPVTKc5TN0WVgdZ1U9RPY2k4LzeEtgd6642o13E4LUoXVWd1pWYlyKF5p5Hp2iqiCx0dqlGVZahjBrVbcKfE2/3eaJ5NG2ie6Q3VTldGg7yU2KXosJenAq1Sh5uhcAmk3R8R5Tpzi5kPyi7Ki2pJMLFnDokyK6szlk/JGHU9LaETe0rtHb24IdlZk/CqINF2hhWU4lYQMCUIqDo4ep6QqKSvPyyvIYeLYANF6ix1qLav9actH3Oe9FXAl986sf4URKpgIqx6afYBNany6CCSOU8SyXFgXGm0FWKu6g89tECRiRpL7EYVJBbfSgboXInGhs2LCdfyvdM8y1SF+byagM7DwBPhwCQmMlQAtqjuFAzlGd/ZYnqpgOnZAFpGmW+W8U4gNtAKlPjTozgBMrvU6GBiIXQH+QIsDHr/1p8evbihZDzpYFOSMWy59mc+n0zC3IuD3Kyfe3WQO7dY85IDKroQPl40J2SinjIRGGg0HEEf7aF4gF/C+801V00C1ZN4t0oVgZitqNfXLHEvNo2GNZ0TWsMsEGyW0dkDZZ7GwIOKbA5eLZsdqEmLpyI3lScE/7xB8NH23EHaY6eLEKMVLohDIDbzF21e1P3+zkD4Pjg7s7+Vtvk8UNK8a/QlQ6VvckumEf7RSULpKl8QkNS/oDtJOEpXh6nHOLs8BHv9xXnrQUELFZUxRSX1t9wbKfALhrX2E6ybtsPnxAZn0U7trWjJBtTWbesVq6Ena+YTfSEopRPSL21xXxFQA9W6IZb6xawa1SAKkUZuVojimNwoguissJi+DSa1l5OyCnlxO51JoX3dXqzuQrqbpaDLIPxu7ya0R5dI97dzs7yppOBsDul4BLLKgisDAxOjhpNLKrTrtqMeflaHDITtrB+P66QoIAGVdjuHYN+jl/22+u16romk7CNs3yHz6NYnVyeVIA/JbR8cZc6g9FsG1Gm4gFXh3walct3Ggjwp9octW8sbubsKwLaNLizpTrZjBcfww/nGzLzUseOOmZmZ3fHmNimMeSklI1ndn4yZ18RpO2ZmZmZeEv/vu7MlOfOYV7XJ6eDdu/fePbh306JZ5yHLYmOs0pdWBPxAYfRKK10s/zHG+0azaGwH5uh3/Gkbn2Aph2rM4yU/umd/wdMrnSh5j+CbzK9vT2kLicJQg7D33yBk0IXR3QCrZwtlNqAgkVW7/HjBJhR0S6kyZdLQy48v4xQdLyIw3hN0R2HiRVg5KuNyF66E0rw0ZL06U029AZVpswpGPXxTnzYU/PmFFcCdgO0Egu1HiQxBYNaZH0wwAw/gGAKXzF6+qXYDaAkJnBASEsQv7VA4r8yOTCDRlOfM4OJf+FIoHlCZ4aq05KmizsnbqW8e620vXQNFbTKb+nbWgghtjcz4u+4+cNmdX0t6Jfqt2uqWS7NcGRmwElxxMEK1LVt8m/i64LkySq/L7b7bfLte91CzJ2N5WZOZZ6kMtb5d2B2+RilDFynzpODK0IBEbBg8ik64I3wYyT1G1jGCYVbASP4oDKZ5O3DNKeXFsnTb1vro1e/pSqMMpZcgKoEGqHxQSwJNhoTX2k54ZDI0srnqyGY1so1GcgdTb1lnhgDUtAQAXqoK4CUNYAwBwFL8B4uafurHKq0sbGLdaydxXMr9Scz7eawzfwHrbMfHsvfbJ0NYtvO1/zpYRhwlGve201fBuRINY3NfNJZtyz09Wz/4c8/Ejp6z6t+uFI2gFvxhxJ+4Ex7ZEhrZXHWk5uxoGlkzTND5LxB07gxfABrn7Q8E7KOqsv2RXgAnNGJOeGRLaGRz1ZF6ATkaGf3tdirdPqHrVXoRwshLg+agMv3SmZ8I1B/z1ahvMK6aYUwoSANHWhEMsRSqwcmZ39T4nabV2DzKfUlwIkOcUQgCSYoLDksMxXUUlhL4WLvCyCpjDM+PcJ7jiNQ7R+5Hw8zG01RSmMO+ikRJ3WypV6MNJVoW7QLhCPL+akFoDNqoibbPT9XCP08P1xmVfDJ/AZ9M5+fvNCwxKmKKm4ayRyE777PwxCRMPnpi9C6lFRi0Aqo49BC29MnzTlvDo+aaPElGXlaD107wfH9izW2wYI2zKWo0whoKwGKeGeuKhbrGH7uaR83RCrAKZ6ogtMES/g9YAxu+BoiujGPqFem/oyo2ZOkS3wa/EP9KMMtv9NuhbTlhk9kfMpm9VU2m1mgW0sR/ywVDufg3rLnTHYnAxzNzJry8Y6tcf9HSI05Ma5UorfS3sy4ssq1KDnT/J2yLOpBIPZ5knmD68aiUyT3+4HarP/16s5d599wlTn7j9e36XNUhM3ro6q1f/fedI7zM47vOmNc1Fy+4Xqb7q8ampqaxSZfK626JP7dTtZswVEyqHNxCMYqpce3vjJI6NBHJYEIJDBI2KmKhw29OkWo9N0wLtKB+QDNahp/0wF7/mB/MMIRNldVRpxl+FPW8R/Li5glr7gQH10Ywh4wSc4KWWF5xTBiDc6h7QbY3KMFlI3PmnPcS/G9opiM3nTHXATO2KriDc1D9Y6ue2Pf2Nxf1epnbrr6u9/wPEiNcGjL4iTlYu4Fa1v+Sl292bvvGY87uG/wI9XTvjowN/TAV+SNe3gVV2R9Jjy6a0PorEwQI6rsfxDun8msBl5qWRbtEhzsm7cx0sQF74ZoYSaMSzUHIZciQe4j80L9TliuX9Y3ssrNc+B/MJ8EeSqYZMUX4lYU9YUSNwHqW8WNuYBxV2NaF/UDu2fzqzXmDRWlLU1YfP7Gtg0jN9MPGbYMItlgqfNUWdkSkNT8uTxAKAI1fUAG07JC/skmrB92QMFP3HpmwoEwNGmOWDcyXRQNECQbSkTYuM9AQhUl/kW0WPtlmgqcNqiGxRDjck3qlbyHcslMR5Pkzuopsv8vT4njBJxQCCmDXh4XJkyyvzd0h4wsSoiz2XHvOLyFlSkXT8eeNMubKGihv0ryu0u+C5UNgjBZ3GsFlqMK4qCchjHERhSTGqd8Fdxz1UE3XrKQH+aP3zGYjXpzt45nkUL3A7p28x1p3Jl0PIlh75VGn//v27H3JbTvkxAXXfSSp5I/q+TdTOjs7n052KPl8vVQv45DLOOTS9WhpAfbAkvjufbj0gP1ms+e6rlMM89n+B/BZMwc82+WCTWbPPKp49qvYHwMB5zz23mcJVI1LDATX44rnsZ/Gc0fz3Pkdee6A547P8wBlUsQrL/Fx06dD2zZ7wNjNPH551z2rTrxV8d91CrZtjgHjIQBWSxX2n9SS00y6YKapWBQkjsIcARd8L7O9LVcun9netl2dBZjhBKsvT1BxIZBF4qkhCJgvZwnLF6oqDi3Km1JboB893099KZdLmErQvofVLoVdliusPBLGnq8zif2u5GVvxPZkhEbcOwgSPFggs6Eo/3jSFXam9vlJxI27k0hUwtYIWzFv2Rcy0xZcd2byuIeu/HLc2BuTinM9I/dW3kiZCgS0uM9Vre923kxA73li8UUnZKcnYXOIpcImWBEFa8/m9IXksxTuH/nw4bNvdn2BYFEHGQXDI4J+mZ5LjxI6rqTSUj/ywXrAaZXNCfPotJacjKWXgn9oZPFZg5olWD+yRCKmvMY5DkvNcfiN0soYq34zlF76DVqjtAV1ukl1MkWsDOmo8aMLqmEaNeQF4KgSCb+L5GFm2b3v7Nj606WVANow5K4iLcE2yygqlD2Y55Hvlui8/bKbluhsYePcFXn9cKKel2kyP17wWqI5Vk0CPMuytQbDPxVuIgD2xafBCQRaYLH6fNFKFV8sTOAqf4+Y/jW2caWhxDgleOhBo6hzOAOrmi3/NMAXMGFMa/AF7r4z+/dU1/9UjB3eKeWXm9KuZL096lOvFq6Vf/TfrOREymuJgERuG6a63HemmxfU1o+2vDRATS3Nh+1wAmt/aktE4vzLEy+9ZnwS3pPLn4ztfxmKh98+rthbeADFD1dTzKSiSoAcrpPazmOWxdrY6FK8rr/CPV2aqf8egeRU+BFmmYQs9eBTt0xSJGSpqa/d/jmjDxZT8exLJw5Q0VIniri6MRBdvy7iH4DrzpPUkZv6mFzbRIhlqm29OoZX/bXj614tTCbQOHbRQO4CdNw61H2IMPrM0sJ3Pq39E0xtdP2F/waU1rjkpuREgbz84tZNjxLJzh6g0cr3uUbyVmPUcoWJZ0vaM62n9xVWmijtjgRHK9fPRJLcSOucm61068TWMy5ZfMTZEztkZCImp4xUxyRhd5ytJwO6cLLoV+MUEBOzAxR3PMvkbcNoapXIpwmzsZY/bKIsLCju9fPUPEeQIYsJvvf++D9X8WG5A5oKuQPMTkZ4qpJEjryB7ecNDhNsVJ9uKNWlMOowzM2yZA7nPmyU7iJMKpPF1EVavZ8o2JfKKlFATcCQo1UnCTSYUSrBIG2VJeAqS2D7WYIjkN0zyRbvI0iKsmvRl0eyfYSt8i5D0zrnMYbty3IVORcznTyx57uiF8SQ1OOSO6ZO4NogzXzuqSG2jTIR19w+s0hFJX3Kb0CwFwHwkuwf37LHyIqNTC2bLrvU443rntBP57RsuEHr/xiQKzP3bLj0wZ8Z5mYzVAyNW0K7Xip/R3sXgugOWKWrwzdKTmNewo4kFQhhzByx5tErfbjaO83wQSoE0oM60E/moQv7Ru27yl4Uw3y8/yO3p3pv7aOtveQLC12531ZN2OUdvX0U2exVoOIIHZNRbZ5Mme+nCDs/TbC8G0ZZlD+PppUCKOPEqaJxMl6dt3Scz0jRWj83zvengZCnyQ9TIb9fW4r7Q9EcJ2yDZjtPpk0w/VSL4LxMOUbTZwMEQHBVqhbXeZlyJKcsp6+Z25WhZD9wUhAZflLA9UmB7ctoJDgp+AWBKrD+vQNV28urVfLvidztYZE7/7WRu43InSZkf2WCAEHrj6RIgvknBazipIA5b/EINCL+MdprwU6zS10syF8EapdQddXl4Vjp4xhoiQsLLU5e1oraXdWN+Rj9QnOnr/h2lXXCCr/Wj5INgWY0CJFuveF2o+DO50/QXE+WoDthVWmpm1+Y3QkTzNs1DJB3K7vYmSh9VKFTNvnzA83GircGZYginRWV0crXeOWrE7zuVsec6ksJaq1uYeGhWiuoNbuFiYdqS0swK5dAfKveuwopQkuaXw2u0qcp3Id1JxhwChNO0dlRXFc8d/0BSGaA5Yrh+VB1rbATSNuJGM6fDfxC2qMWb7Yva44z/QnT0veBnYf+z5lVQ91OBOHFraU/g7tXuLtLg+bMzc4me95KmN3c3OB0tNT0VPQF0hd00OL9OdBg3dvJ5rn+cm1Hvm/06o/nvPgNXtB99fODh36C+eKfT3+4LP25nv9/8A+67cqPb3rvvoveuvyua7/89L7vvv/rvc8uGtbz5/ep3BNk3DhKQEFDjhEI2c0KBrsjlwAnnMWKCbBcQwTD6Iv5TFnl6IgxtCLP4IukgB04jJh7zOK1wDrkju6BIi+gG2LGbGOAyICQPLqCBJMNOk4LRjosjIGSeoM42IKciG05bqnNkVUNRSgOWxfOAJLVxo0FOujlYKzLxGtEh3OunqYA7SUuQxOxlCQdAxNNYYtSKdgWqgXDgIvek7sHEm5JiD1ghzaoexewwwS12Dcv8RZLxk4SiO2BJCDitxKuPVh5hcAWYE1D7tUGdYPMODeBpsZR6BZhsm2TMtvQqWtuvavcmKO73hc6QUw98gDWF+Z0Tz3d/xqPpN4dUTPmkelQuf2YMvTR6ULe9flmCYN2Q0zFZi2xtsYQw2audV2agmBQuibmd9ZUZWo2BGZ0DqikPU8yaKU4T1L0lNm2N8PU27YvMCXOtOAytrVDY6HuMRWUQDV5V0oGEwohxymADXCLCfEW2rU0iFMCHzUdnX8XoWChycvskGXZA9VK7ZuOcraern/0uRcffbZ5/sUXXnztxReefvQGMGgdaXXcIGmU6mkFjBqEkurwOettlqzvuH35E72C5x9RtUUNMUc+i7BhsrkHTynJeFx5TbpSlRo00TSMoaP9IaQ5ZfJ7jKFaX2OlicfCFV9Q2bq8qFoKWaZ7rEuHO5sAM6zPJzYtA0Ahjp1E5SPPso2gtjAOkCOoNrrRB1BgOPojGFaCYapzdUyJFUwkQ5luPrVFiJpOp2fU1gLWpTy13bqnCeL28AYviqHHRPXhkScUKaxN9Vmw7j6uT2aV1KHfaLzxhapTmTEkWSEzhmXc64h5PMioXYBFsUYNAMYk7G7CQkEaFGHgYDehIA2LQVzC7lpJ6SUMGqUbi3KWWboRWDABlzJhBjCwuPzr3eG539/sU8y8E+cc5nyTR/4ZaUaHQ351nU/RxTpy1O7kUf6qfB/9mx40kCjoXf9P4sBvA3qkEzTxyaM2h/lL/dn2WUktSSH+b/TR0ugDotEnVgzBw01ismAadI1M+Y/ZPsDF+LX/zP+wbWeE+a5BogRW+8oK9YPgad43EBr9VeYPuq57RjAPbliz8tFPTHB1j7iICcFubCEkh3gvRBKWsv+Zx0DcZNuCc2dbCGf9nJb4QysEroP4dzmvjMUtRItddnS3+1tccJZG/Py5m9aFzQRPe22Iw5KJbMFMxBlLi31tmola9707FV7MEeTN+/qvJ3t6Kk5sJjSmuPZ93twqiJ+D+E4Ho72JXIIRauBZfl9SsH4s4sw74W07uEQws6x5n+kqgTMRl+wo6HzfRLyQzQ0Tv7Ra4AzEb7TPMfNuIiD7ac7c6nljcx3Ezz/9tWltE3H21YE1K83mC/KXRPyOQ9GdykZiouE7ezxLgq4Pmn9amoVdI9Gf7KpSLiFB1+cLkn/mD99JjYSt2aTh0uTVgvU5iLNOda6MayCmT/hylXScKvBYxBseha7SaSCuyX2Jzlvfj4/JmYjrWDkvzH9KeGFhaTLG0+j6IM5orcnorydWZnlG5q6WpeuDeL+Mi7B0PTFzBAz1FBbQ9UGco+coZVFHLLGvfhJUIEX3BeKx4RVDgbWEqnuMvd4F6bE57zNSH7nTnsU1RGCur1K27iKBcxDnMHWrPlcTtqw6OKxbgAm2iXh2pwS+opr4WLS99YjfKvaYnIm4/pdIs/1VRFdz0cSXjTJ0/yHeIHk09lolIfrz9TWCPVo/xHkzx3unVRAmuw+cZL0eo0ui21/0bsazcsK280HcX90z6eMPrU/SccWRMmKj/syYLdHiY3PeIJL/3a6e1WVEoLkwy7ddUuAcxJk1TrL7SgnsvJpN0dQFWmPyWMRZ4pK/T5QQGobS+zzPD9DjG+L9Et/33ywmREpPLFD0X0nXF3GGQotMbhFxK27Wwnim/NhcB91/w+WrzznEF/P3N245iGmNySUR571WCuoliEGVOAvDM6vo+iIuJMvvj0IC4zfKOlUZrTE5bwA5fs0DDa1wYnKhtYnx1GV0/RHn7dZwDi4gKlPN36ttXKU1Jo9FPFbp2baSPML+oMK+tZfnjM2ZiDN6fJr6c4hXp1SqNtxeTdcfccnJILzkMWFsVW5jPl5Ca0yug8a/5NbzTQ+JN3N+1L6yWjc2l0ScGUeuP3qfEI0LPGt1eS5df9RncRTFsoiggPVu0aZyY3NeP+KLTrRtTiP2Hn/Wc9F16dicgzhH+ZvJ6SSCvDuouv33OvaYPBb1v/O9ouOI1L9Xf80d/xUbkzMRFzo/PcI1hugWvXp5NXMte0zOQPNrEV6Sf5vYmPgzxNB/Dd1f6Pq/s5M5gURkIvfbZfE3+JhcEvWZjjK8a0S3zqtp0LmIPSYXov1/+I3JORTi3mfmzWTCe9moMMeKmXR9EGeGmByUZEHTUOdk89bR6yt0/ao1q3bdAdWpZsoFsTJ0fIjrvPO23BQLB54PWHBmjaOPDxJZX7450zYe1gyzz5yav47eP+KcmLmpoclwZbVZw80LdP46qLfVnapJB+E1L3YM2i+m64f6ZI7Sx0y4pFmlpz1rusB5fUh/b2/UvH0fIqKnHbRUHj0/Is5rTPrKfgjPdV8nWFXS/cdAPPb2PrMPj0F8mSU22YGOXwdxzkcxrlAuKPdFpfiL92KCmYjrmFpaqeTDqx1sDYtZK+j69CLxZfhX/vUEeuyHZJmsOXR8iOvg40xu4MBNNytv3D56fYi4pJjbxopC4G17m2XPkaPjQ5z3emPQewKGxe7qPVMdHd9Rl3YNWFAEg8Jy9ecpKbr/PyHnrxVXZVOLQDVMfWtAEl2fWMSZnlNtGovh7qPrNU5REwTORJw1L/v30RLwPrlnRbJCOSaID/FsFTetoFI4nzNseMGNHt8lUb/b3SNdBhVXHHreq9D58z7+6zP9CnWNy+G8PLbO9+no9RPix8/4zu4vhw6pyB7/WaP/f8T1t3r4e1fApC1Bx2fajt5/IC608VNWYSU0rvuQaqglTNcX9aFWM7MqODYSa7JmUJgefxHn+WB9IdXgIHVQf8tJenzhfUCuf8yNXyjVQGpHuq6/2lSBcxDnaap7NdRAzmxD09I9cnT8iM/sL/91rBaaZG+VnewdwAXxI85qzta6Xwdq2fOGZEZk6PjR9d+NTD9QD4pfNjGkZxdjgvojLtTWnfG1HmYFPDk6T6oaF8xDPPuh09Kwp6D4Zmp1b80Suv7v/3WTfQz1Ew0QpNs3/3Xkd3p8R5xhYydX2gAfPmLzfRdK08cP4u//HJ+NsLQ/4fB0Kbr/GIh/T6+xcGyE6/MThurCR68/Ebc3OxxGNEIue4dBX+Lo+RXxvOnO2+Y2wceC7QXtXmIC571D6td6ub+wCb5M1N/9M1KGzg9xBrdjYC4X8jAp7sVO+v8bi/jMwrN2jlyoPDeQXecyi84PcUWVc/uLuWDBnpxjqLmQ7m/E37eseLSoGaJ4rN713SJ0fohXnij2P9EMZ57ZidZLK9DjI7r9BdG8qmaIfyG2xFtSnu5/xGPVhTOXt4BpxZHrxwvl6fzfIsdn5YGhSy1A6ViSfRkSdP6IM0zfsFtaoPVovIjMFDG24DWrnY4A1fmvxv88VzhLaGhG4+FDU9nsfz7eeQOYoeClTpDsgqd/XgstaIi3+/NWhk5q8+jXEStLBR9MPP4y9Z9vKGr1tzf9+azCXUM3gvfcCP7redGFuLFYTzMCU1P5laL1jQLL1heRcxgncBvmOe3wXgoabb1mXrRi4R7XXN7P66Jgzjc7tf1Nfthpj3nc7JcU/Az4sYJZ74u3f2tb69hAgU3lWxvdIQZWGXFm4bYKCsK4KubdcSzM7XN5tXYhBc6X3CwTw29jM7x/OJk8puA3NRy8+HEANrTjpGxwOn9/kQrHtQq1sXuNXOXeOAqmuLC8VSf8hS/h/p1lG0HBdLaCzP6DN3ED89kN40IoMPqo60cx9fFaJScO24eC+V9a8ldUBeE8uZTMcFcKsowsPnRxmZhBQELlnYsU7AxJ+DhvCRO/ZHAFyztJgZZyu1G/RCD+0d9P/cdfFBAH5oCfty92pubYJ/PDFKz+NOts5MtbeLPFRHeeOQUMBQ3tod5wLDXfXsnLkIIodc8a13eB+LKXv5fr76PAvyRx66ZjPtgzv0M3NLdTcGVid/aki0zsVuuVoF1AQWhyctdwwC1M/dAZl4vqfN95enChlRcGiQ/06pUoGHwncUd2BxNru9x5dJssBVYiJ+BS3i38+uGvHW9WUqCUJurcMeSKdbRLfI0S59efOLY4QkoLZ7181XBtIQWPxKaedN3gi02Z0J3oMZuCwJp67+C5LthBBe2UrKkU5KRl7zuzzw2bl6sk9vdkCvaeTu8ct9kTU3qx9/fxcRTs/s613NgWiI3MP/JA5DcJE80DNJlxnvhATLB12TcS7PX31PbtDsZrUjQ2JA2QECBnsOS7cBhu+2KSc2YvCU3rQ7XfN57Ah2J6VF+/I2HekvqHixaF4T3Jc0rkukhw3iuTtDPGA1uuOntvYjsJPg5rLjJmh+BLmekTt70iwdx7wc7AJBNcRn5ISuwZCUvCd9lFrLuM307Wf/m1kYRZ6cWMvsNbMDlvG4ZIPQnUkcmaora3MGOhZX2bqkm4MOHuq45aF6wBK3p8r5wExdkzIGAkBGvnPu+XKSEhO+vik3rWWUxaZn3LK4KEczzDT+xlIdi0tuGwBzg/n7gTQqqhgXjSuqizD/JJ2BUX0lrb7oVvtn1671UOCdbqM9jl7edxV72og7KPSPhmcal3+2xPfEawZXX8ff76z4cXTlILwV5JP16/I4uESRE+Crl3LmHDFbebZ2eQIGq4tLPjMAtba7izTTiNhI/li/Q9KlSx3O2mPqtTSFDjHJF9qxyK7ZTKmHcsiYSYs2E2u7v9cNHWs/kdCSQk76M0y1T8cA8jjeyr8SRkfpD1Pn/AHZcsqVXdHkeCicnB8231Ifiq5Uau6vdIOLLoKjN1pjF2KmVvs9FdEtYstyKohyF4neY12+hYElzzVb0yZv+FE6+mnJnNnyZTnPMou8O4wuKj2IMYEgxu8Ay1Wpm4e6jBjyv86afaZlePSJzHT1v3vj/Dn86+4svZTXrip68n7AznT/u8NRJXXuSJV9ltPviJP81tFrWqiWRhYNmu58Df/rKEffmtypdwr3GfTs3lx+PIsTMc7g3FlIsUx/Xxp42cnqV1fDqKHdJ9uv4zP/7NTx8qlN29gc9erG0ozc9XdYPmQI5DCD6nfm+YN78e4iOLNNytmHhGxYrti/n1cjE++UK/ORTvC94a8TKZBCGf6eZ2GSwszNbnZUUqCY8+9hcp5Ppjr2NlNvekkzDyriySkXMU99v6eL5yFglbrT+bun27hK0/Ny8s8z4JblriSRKiIXj5SNAU80ckrBV38s1LscR7yuqyN+SSYJrPuvxjhRM+Y39lzdYCElJ/fFm+ZUswrq/bHuPKJmFPgO1zp2oPvEC4+vgAhwTp+iDZ31knMFZ/nGtQKQlPTol1qDU5YytWdC06XEnC4eWHlk8s88KP9lhesq0loUWps8tzqS+mIre7N6KBhHlPcG7jkyDccpX2gwktJDQpkZFKtSzM5KHinOiXJDw0O+Xi7uCOEcMXjBzb+flGBdyue+OKX/zMJRz5/eelUhN8brEflsE1C4t5T8LPl427Ay+xcNsc/7XCJAkFma0HX5YY4b/m6eXd+0yCzrdErenxLFzDtMf/5A9+/UMy1L88s8d3WP0aPDtCgpqPiWMnGYTvnnxXMXsSBXVt1mLPR05jTUV7WOJTKUi/E/zzFzsIFxV/bl48m4KHU7MUM11OYZH7PdoiFlEQOhxjodwVgF1sGLFOk+QvbyraGMhzx/Y0GssPSFNgt1hXPavuMPb43eRQZwUK7BcFO61ztMMcWFSr5AYKmh7Xui30YeI/SyyNpgAFx36OgGVGIH7ZW3i33A4KdqWcUc+cxsIHvaeJeOlRkCSslegRdxrziv/VutCEghnLdSSjg1zxO25V87sY/P0HF7XomwVgHsqvJ7x1oGCP47h0Uw13jPFo3GepUxRIaD8Slmpxxa0jLqncvkxB1bQdmvky3vjau1/nbvekgHtDgzEx5zT2DXzfybMoOHEyyqC3zA1z21vxyyCcgv4gbuDsoUD8FSv+XlY8BVdOr+i8k+mPD9gFyO3MokBEMnUTXhKASZvZkEsKKFD+lFISKuuO3S5w3CBbRgHp0aiUcsQH09nmYn62gYK+Ls3ugg0B+NzCyIzh1xRE1QXt0/Q+h71gRV8vekeBdy1jU9GkA9jAfxBvFeBt7Mw2pTRlZmb88xaMr/WuQm1TZm4dTlxmZmZmDFOZ2d6kzMzMzMwdOxpfW9eXSZ+PJztnduaMFPeTvE3P6dVSX/90DuU4jucETuRUnJrTcFpOx+l5jud5gRd5Fa/mNbyW1/F6gRN4QRBEQSWoBY2gFXSCXuREXhREUVSJalEjakWdqFdxKl4lqESVSqVWaVRalU6lV3NqXi2oRbVKrVZr1Fq1Tq3XcBpeI2hEjUqj1mg0Wo1Oo9dyWl4raEWtSqvWarRarU6r13E6XifoRJ1Kp9ZpdFqdTqfXg0Q9lNdDaj3cpgdXsz76PgN7hBpN3cK6uzXkOaMxeMCAwCBTP57XGI29I0xdjXbejwnQws9dAnv3/sUIgYMUpp8HQVH700Drhf2RK1wInKunz0DwfJfu4abgtAeM1muNqVu/wC4ma3B4367wgNDqFBwfhdocjk82rQ6xV99u1oexNIQO/H8P1FpOlRHhb6XTE2oVN+cxIi0uC6FWSYcMM459+Q5jl3xs+HD10kFVyYw4z9AzykByRIiLGeq3mlwdVWn3oEdmsrJL6DS/qe1Jo0oN5l0Zu5IM37F3/rhst8iOQtPXVz/znvwv2yBTngLXCOYdeujmpXD3VQYft5Rb1vy3CwR3y6gpRp6mr+i3LV874n+u6YmC/xtBtmQftmPr2BHEELwm8VFMA5Iu3L2Y5vM08nmzeyvfhxtJgR1xW9fGmkmTjt0zcCPm2/NfXbYqocyXKtLgk2XavYX8k1Z1fLCzXy5S5WT80jrTvYi2cPUGY3e3JHelxGnTa9chS9xVUf6hXsSY8DKzmL0vKXdW23hIuxnkIe8ZM/TcZNLsqeeQrq/a2PO/8W3x7szDIdLoHP3M3pBfWT3945ZX6UlIUs/h2iGVya1pwwslruPJt5Q+cf718pMrT85O2tVdTc5W/5h/dlMjuXg5+uwFj64kaUzhS4M6dyCzmjR8s257acLO/2vr/l/ebnk/MDx6ph+n9Nt0p9mJneOVAn0+kPvl9yudlpwIPRF/X7l7tN21+OohpMiYCyeCZprJgo5b1i5q5eZVZMm4Xs3eVfBqv6pI/1OtynsVTo7LafqYJ2VBZFRRn0+bdz0f3uawNX+9VRkO3SteWlm7LaFL17dhSqPevGlfn7nK0oSvE25HxCrr87T9vr5Jc6L/MPg+X2o5qXIsJEepXCfJ/JPbk7u2ekDqaYYcz1jvMskY+f2LZ/f1SqMD008nHVebmz9d3eQx5P9+Mb2Y2iOvcqlgh9SeT+orxrOFa58e30V5V6y9cVtYZ+VO+Okj5c7WJtIzXnmccyxZNGSab8OIZBLfvET89hWbSL3rZ3IM2rmUlOKzVulxL0A5VXGfb8WX482519aZOU3abrnUcIdpTEZ3ZfiMiJRbSaKSXDf3tZgqfkrTbsf1GqNa+R6yesCkCQayvfioyxHLu5P3kf7HMq0cT6ooZ+pUKDaenLkg1ew4LJh0flDs/rhz+RQ8HzlbN0I/bdTqqO1I6Hc7hJ7xqb2dZisW9LLRa+rZbKLHaJv9MmWn1SpThPdWW7lGfZU3RPXtn7k3tRvAXnjyTPsGbO9DT8waH7cZEdy29IN93Np6mTfcVHxK79v0sEZld98uL9oENu3f0NeNDh4gAESACqAGsJzGATi0zDXG6gB6wP+74GoAagIMLjgJIAOIC84L4A3wccH5AvwAtVxwtQF1AP4uuLqAeoD6LrgGgIaARi64xoAmgKYuuGaA5oAWLriWgFaA1i64NoC2gHYuuPaADoCOLjgjIAAQ6IILAgQDQn7je+7fusYRCggDhAMiACYntjIRbaMcXb7SZNFC6yhCjh6xjvzU5qb+LATvzA3oBMgLwNEZ0AXQldbq5sB1B/QA9KRcLweuN6APoC/l+jlw/QEDAAMpN8hJ/w35L9jIqReeW22A1/JnNv8G3RPb9YidD6y29Ov6d6yWdKh2zWbd55yyxSUU2ma1yvyg57a4sMWPbHyN/Tdt/NYPB9BaqN9C4yz0PgvWxTo0L9azUD0WqtNCdVmoDluezjOe2nTcGnoBLfrtFv0YR/3YL9bFvlGXvQ7qozpQH/aNfWJf2C9anCeMw/uwH8xnr4t6sB7VgXpRjy1+WeQ9mVoLY+Xf4rEvzIv9Yl2qw64L+0bdTH8Wpj+0FmZ+8D7Mh31iX/Z+sS7Wo3pQL7ue7O8D8ujHOPRjHewH+8b8qA/r4nzhfNjXk/n9ts8H8/mwMJ8PXGfUgfWwDvaNehzq4nz9taH3elG9ykRJ6vnJt15s76bmfaPaLRvzrb35/QnTSM+qLaWkEgGt+5f3la4cHJ+v0h3ZrK3b6lNA1SbmfRMzv531trG5w4QWAdueGaUpQ91r+ZRoKnlGN7jWvpa/+WiFdplOqzpK1JqpH+PwPjPWxTqYl9aTqB6J6kRdqENaYGwypWhoR+lKG8+lLZu0MVOLfjNa9FOLfsyP/WB+1CVhHdSH84XzgX1jn9gX9kst+jEO5wHrYT4J66IerEd14PqgHrOlurfw/Iu/RK2ZsdJv8dgXzYt1sE/UgbpQJ+pm+zMz/aFFP8bhffZ8uL6oB/vFulgP5wX1MuuJFv12i36Mw/uwDq479o35UR/WpfpQF/aF/dj7pn2ynw8z8/nAvKgD62Ed1GXXg3Vxvpj9zn82/lsdLyyMg/w3OjwU5+vc5L+Z99IKc/0v6cjP1FExOjjy76y/wNSpw+gg/5CO4kyd+kyd9gzfmPwz60+YOiFMnR4MH/A36SjL5OnI1BnM8KMYvgf5e9bfn8kz0LnOiJkMPwd5DPiTOioydTo75yGzmTrxhLlm+Bnkz61/U+c8ZBKTZyVTZwfDb2X4yN+po6pznNJPcb5m+h2xm9F5gqlziNGxlvyu9R/RmqmzwDlPQCqzLpcYHbeZOlcYHcov6PBk1n+kc1zkFme+9BVnnnvJ3P+OqfOM0XGCsOuP5xfcx+D5A/cheH7AfQSei3B/hOdh3BfjeQb3NXgewX0JniNxP4nnN9zH4XkH9z14vsF9Dp7DcD+G5zHcl+H5CvdZeF7CfZPbL4x8gMGAAoz/Y1K/sF1Nt8pDRO97hzKdknsl+Cyq0PiqvPXB2bDYvbflzr1ir/pVfyCPvpNfTTY8ltd+LBj2Vv9MHjagQcXqSc/lLw1yPngkH5BzKTf6TzHul7/0bbvjcfxe2VLzULF3FXbLnXSrqq25b5Fbpy6537D9Vrl9xZToddfXyLlSt2y8dHSxjDqGAIYChgEiAMMdlx0wEjCKcqMduDGAsYBxlBvvwE0ATARMotxkB24KYCpgGuWmO3AzADMBsyg324GbA5gLmEe5+Q7cAsBCwCLKLXbglgCWApZRbrkDFwmIAkRTLsaBiwXEAeIpl+DAJQKSAMmUW/ETRXLCmxXpnB/wkOzwBmD8HiQrvAPY+F/1e7jI40H9bkw8+h0H+t1/5v4g/5o/owu/+2/4URD6rb4Mv+BPz/phrASsAqymc73GgVsLWAdYT7kNDtxGwCbAZsptceC2ArYBtlNuB+DE9pT8H1culkuc8YLXUtmj1JAXKZmXy2Nye3uUGRMpzxtcNHBbQpQc8X9Ru8a8i5YH519d++agWDmkTLY2B7zj5cLjAuGVKFdeE7Vz3KtkuaRtrJbz2MY6OX+NdflqrNsg1yrUoc9Jvy1y8f094bVTnlXeH16pctr3uQflFrZxVmb/PT0YfrVmVM5HNXNLH2p6lMloOGzIYai4sZAh6/lyBp+CgoHP7mPQzGllePmih2HihAmGixOXGqZ4bjfop902VPDPKx09Ul9akZwswadaTmed47Q3G9BYR5qObXKYbZyj9p7cEyrF9Hhqabq15NjHTS6gRb8MealWxjLfp+8E7AKYXXAWgAJIccGlAnYD9jhw6SjwZ8R3GBl+sEyWAUEY2h7/WbQtZTchjZKTtocNWIh0CcYUNklFUawpYbd0mHS3k7Slwa4p3SDPd+89/en0Hxj5PxUAAnpvYbLanQE5cZ5ayFC/sBOb2lx+uxiG4RljbNf9JKMhjhTrInTc5/LM1IgVAk0If1ViavBTvk37idz9qXzWi6Jz0SFMMpS48uUwifN3Y+hrxauz2mwI0OZKhzYnrA4j25tFzwxdGobOM/bCKMYrNyOy5QRuM9yo9NVAuFSGpWtSuOagj+JXK9Jl9vPh2yMWe7XSrS1I8Prj9Lt+ZcZ9K4QsT6EywhyvgaW0xLkyM7MSjY5LvIuZxnbrswhN+ciRi/bcmGTFKQMn/KuGkPnDFAEBVUrMxXkc/Qdeb3fgejIX6cJllDsWIPy5js0B8pzwKCRy6jlM7tYjbfGUCL1RjBIcQt1Xn3y1z1xY00CGjxrzFxcw3bWZ6z3bWTRDB7+2ElqPTsP7zCxc5nrz0r0PFUVPxHWNSZpUTIH0VRIK81EwNUQMSwJ9lvJujyKXiy+hbgOJz7xJjDqPptlLXut1cXucFKYeA9hdlWf36zhsvXs4cM8CSfFP5K4wR/dVNVGHtZg7p5RXxz3ZsnEOzEijVWQK0hWNXFcdwmG6CxctrInvX4avXxWz7VNQ+xzEx5wdNBeWs1NDGEv9F0g0vGaTbgMNl4N5NlsW2cDPvN1kSnGJGkLvJGjyKUUydy3t06KQatqK0sSFBEywIWD5MDpPbyXhnh/Tv7SxfKUx4xyfE1tfxR0rI1ysKxCRDef5xUQEItvY5unH7fwArH87xvE//uTuyS3sep2FYqQtHTmlnDrYzPw8R8xKllBSrYFs9DPyrU8x4bEnI+dPYsLSyxRuLuSfIhNMH5wFyXZeGCcgt+IDgy/HQfYA00PL2F3xg4l6nfzb6s/DTwU86pElZFQoeXv0UBJ+iOiSdo5NuELcTC+Ukq6zLDgfLzVlxMzc2Bt1BtdPM1AtPcdfEisx/OstHY1BfA49z9uPh7moep5j312xstIgY3AMyy8l4hi+kz17jThlqcZ18VQyPwhzSnUe3fu0URk1ldFiw1gl5ITCj00siz3Dvk/DyXo1l26fSNyX7+W6RDOnQyNJPNvF0w3rqBRpY+YFdTpX+fLA1ol6PSsMLEdwJMgPs/VyaNrl4lY1DrXlamz9fT+r97xgyUZ3RIXzkO90ZpLDS2QEr2I5ci2JurV89SjiaK8kK1x9mCaTzjlnOYrL4kmYtJEzb104Vh2Ewt61jAzPxlMwlHaV3TAgw9c90Tjkr8CuaTHn6wO4rX8e49BBRgeeRNWwgWDtq9TvPolkyieEGnUR11zANv8bbPEPYdz4YMZ+rmKn/11qh1ahdWYsm6U8sIkQx7o0g0dBaYwzyOJZ20hW7JfhW3IXtbMzEJkUS9B8ZewCPBDWVWdM6GTW6cQy7XY+d7/fYdv8Cbjlm6J44Aq55ucZoR+AcEsXCwxO4qZ6Ee1EQcRmilNVsJXO4EKKE1axuiSCKM1yPsZoEBccSr2RE9K2DXicbMbpxHoGajW5czOORnFVfgWI9ddgZ+rA91EpyNmrYGGew7IhHVx609if3Y5sSCNx/io4nOxiZKk4fbMFqH4/jcUPw7GY8jca5cKsNvrCxOxw1Ock0RI7mTX20TzLi0BUfyxb/yxnTq8HXidGEiS5l+LIDexyf0vzN7i8chOFNSnEOqTjUVnJ0+HTuN+qyMmLeRQkeBK4vIZuyxsU+3cQ36JM/b+X0N+WyZMGN848moF8bTK35+nA3UskbAgh2WIkcoqJrPL3pUYwCo/YMXhtvonEBHnqUhTp+zBIUO1PgrIHee+xE4GYAfT8d3PEXZzBo0PI6gli7aiOvFQgpllff+HpLn+7uRPmqI1qzlYOv16OSqMEjxSNmWe9iMe7K1ApTSVn5yDh3GLUzvdsqb/BrF3LsJnwjLRth9ltvQJX8yYurh/GWjNNpr9MQb21kInuVliqvOeIUgzTHhRwU00DoZRwvt5/gUT3LP52fo/MkCdiI/w5ZaDImvIbzIy4yMNbz1G2FCGx14jxNaX4ZD/hcm0ecZJZlNw6iJDLNpTMJJHBDL9JLbwRDGSSqB3nDE9xNLuBmkF5XOcl4xW0kFHtP0nLuYaTyxpWykezpnALij2ZvN5ygY5HYYw2PcVMnUjCLayYpH8ff60wymYOY099II8bksnZ0Ymp/XiGCbpy8l48D3KfsM5sOdP7xxC2t4DbArrkGixCoM6LpiVlrJbr41XJP3xuN8TbroHLdlVUZ6sSfr4Az00vcH5XREvNRNJ1fmOp1FLM9lvxLKsT9+Bi4pUsGWPynal6RlgXHkVu8AufXrUz27uEXWcXIdRUxNDrU7i7vOXeYDEhQnl4W+7DNeEB5e5X0dvrRfF4F7orY5D7o5Gkx+mksI63D0azL30uH3x2sK/qOKPFFTgoJYavQyjD5CS4fsCDwcFszJc0U+2rwb/VEzmRnkbh+QFUo2VodS8gtEiDqmhzEqOTqCwbw4QgRXZZLETBPIiLFe94NTMN1+2x6MlfYbxVGYOiK3nT0c9pXTfeBirw5cVhBhJjaP7xFKVFj1HWtkZrlglTqv/h4IAI/StdUJ5axYbEw6y+eJKNs8uQN6sjt/gVotLnmLw7FecwO+Zv2YH++h/4jR9LR9J4Bko7WZip+Et/8NmyjPrtO3A8fZlg9WYeS6ZivekybywyWRdQTJXeOOr3LEdxaj13pW4yS2Epm9tfU33gAtc25rImsA9zgQE+/HWHoNkaaCXMxjGkDrPPsRyar0XJp8usGx3ORfX7xLweg/Oo5dg/aMHvWBTHfj9P71MNZgU/xOvQSi5UzsLgeh11y8x4s08Hx29G/LzayPYXVng5hpMefwCzrlssODYHw3QzNrsLMUs+EO1lAQS9+8iHay9Y0W/AkPkXpo4toWjzcUL7FvA8r4ixRZXUbrnDsqJAjhjbMCtQF4W/QhlnfRT5373wV5iMcc4Ejs0/w5+/BRFd+J4PtV4U6uQzv+Mr3Y6/fiA4B/vbC1gccp8sb1HC19UhU2+L85t6LoVKEy0XhlOFLMLfEzG5PpPVF0rYfcgWX+85jE1TI6rzNJPMPzGrVYikq/Ls8jUlQnodSb1xHGp8xbl6ayQ0hv+qeZ2AWzfZ+90N7VMHOJQag6vaNpbKbIWF33mGJwMdZgzbbErTHn+A/+PgLuCaWvs4gD8DxCIm6LUVu7iCjdcj/2GCNbEDFQNRMUanbIRBuSENInYrYMeBZ3TDwAYELl5ptjEYDed99n7qnO/n9z/dyVH9X0nV8vc6J9P/31Xa0E2RprVlodsqlf0myleq6gxmeZioPN3393JV/eT208sSqmoy5Eu7AInq3PmF3/HURsMzbvrESDtdeuE7vvWmd5i1ohNQjaX+b/3v+GKw/tQHpcRuc00Ovv+GS19njbRIVlkg2n3oG/6oZbRkYygxGuciUfuGZ6yZPi7Bnlgkupz/6Cv+OeV+DHcH8Xb1PWu5X3HmTOGTPUuIOXYZKzq/4NGV8XavRqvyRwMP47/gLVbZO050KgE9Clh5ff0XzDUMfWP7g/h90sqO1s+4SnSwgP5IzBOuK478jN0m/FQcjSe+lTJ2CuczvrJng94eAbFgg6y2sQx/tqsvjjpOXGNsMjG8DIfxH9bO2kh8tTw4y7QM+63XXMPMJxbNmfdvYymuTnlZMV2XuNt8wbmIUvy9aulGYXsH8YdYW7NSzJlbVbL2B3G0LFzSKsG5d93EpinE7Ipx92MlOHBWTQb/DvH74zvqNkrwUv8vM4dcJZZfXj+9uQSP/Hv8xOJzxEljnTdtLMG7xq38/HMnsTF79bp7xfiA/+t1c/5R5Y3rtNWKcV/3GLM3BsRy13l3rItwcodpue9QYlGEBktciIWDew8Jpe1k+AF75hkU4sYtI2/9/KqyT8hYnwK8II0ttk4hlnwuzKvNx+/LnRfMvE8s0lvIWZ+P1SQJRdNDiOWTT7k+ysOTPPyzDjoTG5ufPqeVh2uXP7coPkQsXv/AwD4Xc75sjXbfoMpHvxZ+y8EzC5hiKyNi3jHqPZWDLbRvO7uOI7ZeERd7NxuLVpquyGUR33q3a9HIbGzWHfFpW7OCdD/T5aJjFi59PF5txFeV04WelZl4/sC7Rz2pxKjM0nBDJn46Uctj0mOV/ejApAxs/Ga0tUOYyhZ2MRMzsPL23r29F4k590S7rqRjvGpy3KtTxLfcuz+0p+EUpdAvfqfKhrNyrdPwqmF5T96ZEht07eUXi/FbzuMFrPmqfNCikhLjxWaFke5jiAWb6ZS9GMf1l002YBFzOJHDVqTikeZbLTpa2oh7TKPHpuDTNsIdyh/Et35ss+35hL28946akUVsbWTgXvkRN84ucPJKJhbMrc8Qf8BvJxhqsW4Six1ebXjwHqfw3nomBRKjZ69YIe/wW1o2K9BVZZP1bU5vcfmiLctCThALrpzTOfwG/zoyR/TBkrjmdpWV+Wu8pWzxPR0gvnVm688lr3B5D9shyJDYOqvb3eAlXvSmZa7xBGKDY9EbdJJx4lL/8r6hxKjszNneRPzKbpuuVCkHxHHdFFL+HBcnzD+k+R8xuvRfC/0UT7tveHxdGbFYjxNw+zGeEF3r9VCsstqSfVcf4tLl2X5GicSCb7aH7e/jlfq3oiviVbaxCLS6i6vrdyQ+DSbmjDnx2+I27pu7zSjBU5U3+4odbuLxwmXBb86ovGNH2+5YbNjTcl+6X2WfkmOrI7HIsLTIwoIYPQnum3sdP34uz842UbnHwHNRMH682F3fZu7/80PLxvtjc8emOTPHqdySrq7nhiOSR2tqDFN5pvtwDWs8oXd219QaGbHIv112AZyajqZPuq3y6mVmlVdgYYxPEvs4sSA9825xGBQ9l1Kds1R5wOi0hDio1w9Vz22UEo8q/pF0G54mF7gJXhCLWZKDgfchTiv+zgQnYsEPjp/VY3gTM8Iv9B+V98rOzHkOe2Kth9ewiMXRf6KdkyD6k+sfVn4rIAPt38qdL0E91Guk4joxMgn6tfA1FFv1nXxmRSzee2W/5luIrzr8xHCOKj+zzKX8HRQZ2pmeV7QAsp60be3TD6Dm/vDOuVSVtT/luH2Cc8NWnJsdRGxQv1h/bQpo7DuUEr5PlVfZLxqBITjh05I3s4k5oQvG2IoB6lukfspmQEnXfS9tTIO0yArngUxi4/yi87PTYe6my1pTIoi3Zz34rp4BhqayrFobYvYSKqM6A4Ku5tmaryAWeNgt/5gJm4wnT9s8nFheOndlWBZ4yxSXGiqaiMfNLDqTDXdWWy+anEgsOtnSzcmBh/s+Q52vKp+gFI/JhSDH4TLOXmJB5655jbkwZ/NT0XxDYk632vJPeVCqCNO/xSJGhpNag/JhIlUxM+F7IyAJy8ryYAGIknOGzHpBLKYLbecVglFxlGLhJWJr86/LOgvBefM96UcrVb5haUpaEZiY18dnLyWuKXnPCi6Guh22RlxtYtFY8fDdJRD/nbm2o64B0Pupemd1JOCFChOKMbEkTOe9vQR0MlLLxTHEvMs37b5IoG/sjCdznFT55iVXlpfCsNhXzxCX2HyGrXZ0Kew2tWmwmE8sKKxhukvBWq0jgqVJfOr49yP7y2De3Zrjs2rrAT0aPdz4Qxk8f1Pp+iqV2Hot22HcZ0ifFWX7JI54XMu52a6fYa/mWMVQd2LjxD7u18+gpf+tIn8PcY3Rb+niL2D3lstC7DqgDq4JPavmTUW83qqOjOvA7BAyb8IhlNuXcG20vQ7e3f92+SH/GvX8wrahiFcHW2btsmvqP0q90K0eZIR1MKCzf8scby+azjo+FCXVAau80vxUWiDdmWY1BUnqYFSYRfwk8KNMO4c0M7I62Pl37QQNgTctiLqsg9j1sMN9uP1JxpPSa7TtZ4zqYeaVlNm1KJg6M8qnmuHWQxmr7Xyo2nladMNWF/HqwenGriL7flt6Wa53LyOsBz8N5c20VB+qLt1gkEmsB5sThfPGevNolAetTEk9TAryHOYgENAuE2Y3MrJ6eNETf26uOIRquHtDA7EbYMmWP5Zl/ABKaBg2Fhk3gE+78dvGwUD6huMSTbS9AehlNnYYB1DZAWsMEK8BnD1HtdvgIFrDXdnMCBtgb8HqO+dRAF2tQU9HSQ0wYnONSTW6SAdO1PrDlDTAkARmgz26Sq+9FtrPyBrAhOch8fTxo3KO9E5B7EZQf13tEmoaQH3w3KCPjBvBRS168zYBn7owVFrHcBth4THmp9xbSJfqUVXMhUb4aDI78okvj9YOXN/BCBtB9uhE6ETBFdp0YfQvJrERVoQdCKzhXKFP9lmQ6Vetv3Fpw4qBsrzRZoDkjTDi4NU5TyCQ1kxaPwqxm2BP+b4Yc8aJ6u38NBQZN8G4cwsCn6YGU+6To9hoexMYu7v9yh+8SpkvVE5GvCaoePpjtYuZkN6xZP8kJGoCPZd0fzV8jd5syp2PkprgCDCUxsBpunTKi+9MSRO85on06k19aTcNSykja4K7VTo1pppnqIPaNhWMbjN8GDHVJFfzALU3/8kgY9QMk6kZTlNY7nTlx4ifDLcZEuZfPsVm3OkbNjdnIl4zmHIvS9YzgRTnrys9jLAZejLSI10HvShugUYZk9gMmQsU0jnMcXq9lVkZU9IM05pWSd8xZ+nq4ce7GVkzWI1cGKVu5kPvdHnzL6PbAuPPvAs/kRZE/d7b28YYtUBrtnGIbPAEPfM/XMlwW8B5Ywt9Cvzprg+7WpkLLdBSs1N+19uf+iqMIcu/Bdqu94Ro+jlSsdNmTUNJLaChM+7EtYFT9I0N4b+YkhZwaMqZlOp9jXLJHGhiZC0weDXh+crUa9SC7ti/ELsV7A98eBR60Zma3KWrjYxboTyHd1qUFkBl6ro3MdxW0Brcl7VCZx/950rlQsRrhXW6aVu/Cfj0E9/KaUjUClZWA+FCLyfaT83uB5PYCt5Hp2VN5gdTKzeenYckrbAzmXl5k3WVUorW/WFkrRBQuCO7DJ2nwjufFjG6Uig7/bcBx49P/8rdUcEYSeHEsIn5aciTkv21RsFwpWD5NDzpEeNAjToc2MBckML+VFmyY+deWpu5OQqJpMDKHXk4ROBPrxt7v5pJlMIbg7VfNZEbdZuvNwFJpHDdao91t9p2OpN8iYnkUhhVt+zQOs4lWi3EQ8noymBIqGzloj4unRP4ZwoylsHuUY6KZz6BVPhSXyXDlcHanO9fzCCQstvyuJ+5IANnt+hJHWrHaLPMnn8ZoQw217t2lF50pbx/15DlL4NFd71ix7Mu0Df/c52EJDJIfla8WepjTy3KqOliZDI4cIXHWjHkPH3e2qaD0ZVD+YhJFs+9A+l9HpfbGSM51LzszzjNj6LHavcPMFw5HAwvWDqIoyjfrUXqiCeHgj3/if2QL9VQoCDrnxwmOK9IrWbO0TblWiyUJIfm2XUv+BBKm3y+x0ISOXQlmLv3XhRQAwPlvYxMDmK7b7whGq505MDHkYjdBsdGnvP/IrhGHer408sYtYFs+cCJXhxP/Yz9Sva/bfBiux7PFcVSsbunkf1fG0irftf2DIRQs3fN6WeEbeDosKrSGIVS+6nVeiipDa6y1AXu/Bjq3c153UxJG9gGJzxd3GNDoy+BHYysDZoPPozH/DDq3uUgLcRWwPSDA6F2ggRKfe0lsv9XwBKc0JzOhFH+nTTDcBXgsHChdz3Lhfo5bZ6SuaCAo1p8l0/9fIr6J2w0EilggZkala/mQOsf3z0aJSlAbapiia/gOr1qx2AzU6IARSXXxJu5Skc+fz8SyRWQZWa83ZK5RCfWevQxuu0QP/fwVXvkQ/OPPCPbfzuMefcODjGh9B7bB1poezuk+AZN9+VHUNO6+kYhXjsUftXO/IgE1Aej/WT+t4Plw5d/x0M4vabslwZKaod/TVx4dvxL1N68l0qmpB0W6WH2P2oe1LjXSWT7a4ekHcknz/GjqY7ExWMQuwNmXhp/ZEW3LTUvaCPZ/3fAWstKhzqWH3X8dUQ9w+2AAwEv359mAqgaZw2y/nfALkV6XLI4gq5PuyBjhB3gMP8fxXBOHKXxMPUPk9gB6y9q43dMOF01hz0WSTpg9ZlK+xPiGLrWVK6L5B0waeelkQH8KKp0c6UeYith+b2T9jYa1pTHnCF/IWMlDF88o7gYR9JbeBUtDFcJ328PGeKgFkA/3nVExlxQgt6JPJ06HEfpsevGIpESRLJEnyzvq9R10zx1lKQEsRYeMcwsgabHW0xGEiXM2zirb75PNB3g8b8u7gIqqvT/4/gdcpCuYemhuw3iPstgd2+vyvp3AWsd3CKMsbGx87isXf9d20Huo8Oxe+zBYkzCVmR1dOX3PPCZczirwL2v8508Hc/3ra1pevE202rkM83BSUulIYTvoaOPUZJGOnv9ahq4CxYM4qcqtpeugwsi6ZHfrt65fRHWBZAovqdeDQsG6UH6NysXvzBbkmYuYXvrTbAhgW6Ia8j5xbkG7xdLj/I99kBY506sL9bPnJoAJ6bSgXyvPdM8F+jHczfa0X5wSQJ5xffch8FGS9J97I7doWpYH0FT+d67BhbuSIL/ztTyUrMfiAXNe/BmP5Oy9b/ZFe+GVUqSwvfiK2GhTGw/s2n4qMtwaTjN4Hvy92GjBa09umj6rDfw16G0ry/bm7eqxfNTiI/tpf+/7GG2M5l0nu3Rh8G6IKrvWB7Quz2sjyL7z7C9+m6wSzciffeHV8NXcHYw+XsR27PPg48l02UbkqrOFMJCCNX+yPbu58CaaCp8XbBRv4YZ3zdkPd/DhyNTiMn7+iHrw/C+jmRaJ7aXfxHWx9PeOfKho4xwfyW1LWB7+q/gyEjiFBup/2SB3s4uP7qc7+17wEZr+j5h+6CjYbDqrdjzBNvj7wArvchfK4fFaLvDgh09y/f6v4XzwkjQuN9W3xkN69vTaL7nPxEWZHRDSNHDlIVmxxErG7b3XwZvTKWzmwb1qdgDf9+OfPeKdwBgbTg5ru3l/ct1WHgqLeBdgFpY70Us3tjOH2qCVQrSh3cCHMz9pLdSo3bBs6IA2GhHIuJZNyARNkSTIW26ak53hF/60DW8I/AFnG1P3Ic3zOmZC5ekki28K1AIK13J/PjKQZ/mwjobcvkj6wysg7VRVDuuXdCjXbA6hkzh3YGjsFAlaiLE9KZrZj8UN1zmHQK4NJbmvgl+3PsD3F9BSg+yLoET+lZXE8i22avHXFDCajfSy4d1ClLgbn1ITbeDntO7wqmptLlb8A0srBRHHX8V9dMYWN+G9Ocdg8mw5q64p0fE63mLYZ0VteRdg02w2pHmjFt90KiFSx1JE+8cnIPLLMi4P98cHVkNFwRSrT/rHrw2z11o3Z6sHyJt0BNTuVJjcwcBNtqT5yNMVX5xsMqOJvAuggrWO1HPf00F3QbDOWnkrJ51EnJhFx96oLJk9tbiFmu6fE1TeDdhIebdfWj1sQFfqTbAwllxKe8oHIRVMjJbMTbe+SysfCm6HWNdhWo4+42YseO77zzfwKU2VOKdBdtn+H52xHRKHjPIFzZ60hlzWHchAY70J5brz9Sf6gSXycii5g4DLFSLfz4eXvvbGPPckvblXQYNbHCgpdlN+UOWwboG8S/eadgGlzaJYdPSr084DGvqxC6823AFVr6Vjlj7jbhWA6v96dPVrOPwEfZQ0KETvUfnuqKX192e1GxgXYdw+IKKfP9ckZGSAec5kH2889AfTrSjeWNzQ9N+hIVHUmfefSiC39nS8IPnfy9cCKvfSLXNHQhY/0h8eGbCzIZy2EdBHPNYF+Ii3P+t6DHjs/XbH8KqE6I770SYYM1zySbrgN9aZ3QeSkzS/5WzbkQYXBpLfx1/p/vpdFjYLobyjkR/+GWD9G/nksLkHFhzRkzlXYliWDKJU8VQC8MiOPuqtIB3JrbADvbU9dri9ocobNRJS3l34kqLNXdd6POQ6NFVdZh3ei7+91zRYelbk489rNorWfIulQL2cqNTLTI88oJg1SFxDO9UxcIrX4hnKlzjr3aAVSel2bxb1QlONIi5gxvHD+sLZ/rQb3nH6ht4ugVdFig6tfkRzn4l+vzDulZqONSTxG0dH3O1GC6rk/S8czULVj0WT9nmNNLFcIFAm7tX62BhpZSYFrjm5Da4rEn8WMI7WPApkzRnzMMur3SwrkpUdGddrHOw0poYhqSFZBhgvUl6wztZD+CdvmTztuphm17AtVb05WXWzfoAJzrSXiE3IhNt0Tvt/0r8jne03GHhqfg+euiOWwGwpCDXeFcrGlbVihOtXntsbQ/rnWgd72x1hI21YmpSvyXL+sKqJ2I+7259Cydak+qj+YM35sCplsR1IO9wwVcjyR8Vy2ZenQTrrekS3uWaA5f40ZwhHb4OXwG/dCVbeKdrA9zdhTyY5f5u1d9wWjc6eAjrdlXAD0NJJ7/IZQmnYGUbuod3vK7Cmgdikmrf0BojrKsXU3nX6xlcKiP/nE+dXvkeLvClC+ezzpcN+r5L40jA1oJ2h91gwSBm3WHdr0C4bQwJcS9cfycGfudNan7gHTD4lDeN8Jj6IbALnGhBLHgXbADc3Z3uuhCQP2MorHYjiomsEzYa1rsSZ6N/W6cC+HkS+Zx3w6bDOg+aWLHo10OLYIM7tatmHbF18C45WeN0KWfODnhCME2/ybpiWpj1it/7/J426TiscaFVFqwzdhnWO9FCzxGBy6thZYN0MZ51x57CK0NpcAntefk9nKigYQd4hwx96vbJ1H7T82fJHi3WVKup9gbrkgVh3j2Yrq/bmqGNh1eG0Rwv1ikTYX0AiTA9yBneAxZuS868W/YlbEik5SV31yeNgE8Fk7TtrGOWD2cryadfAkLCJ5utoKm8azYPNrahRz/P91Wthsd3psoy1jnbAivlZNlPT49M3g9rPieveffsqNkvxOB7zzo/0sNlXrSiuYMGJ4aTc339qtVP4c3d6bxJrItmgm+LtKIs92iwHL10bRhZxjtpClgXQLp2tYv4EAJnu1PlNtZNS4JXhpAn5dMzTZmwYBK9eUetL6xrlGSXt3RUfm+2PVXwrtooWONGw1Pm5owtgI2JROCdtZmwKo5a/b343r2lsNKBjOfdtQ1w/wAq046tn7gb1tiSe1G8w2a2O02u9NJmXTBbILd4l+02rI4ly3cYpsQ9gY1+1CKOddrew0pvUpnUZXKW/C0+v5xG826bAhZMUv2AzNqJYbC8J7nZl3Xc2sKGcOqzs7Hhfke4czK9tZR13QbAYncy2rXujjob3hVK7kaxzts4+Nss4nTs/q2ISbAxio7j3bf5sDyE9rZvipCvhZ/2IRHNHThYOCY1FG394HoIlicSe96FOw2fCqeZC1aVdjHAq7uSe0rWiauBVb70zJPbyg2NsNqLaHk3zrqxxe/Ciec/5x9He8KCjCTxjlworPek+6O8/e+kmO1G3XlXrhOsqZdMC6RP5QPh7Ei6IoV15obDn/LJgmT5ycp8WNmBTuLduSmw5rGYv3Td7oZSuCCKIg9y5D/9hSNClv7KFLm9weLdSEH2LlCQKUcJMmulINMz8/twdm9g9/zhD9lVhgPb5oO21jhoa9vqwLlqVMvj7Fo/Dgfb7XEgnr92d/baD/HavzA74hC9M/vln2essuUzFLFr9qiW+1nsPm9Uy3O2sisPYLi2CmB4jBZk7vyK5Qv+nDI8n89P4TkK/hzMd7H5VsxrMfdqNT/eai4f3TL/rNX8Oub8vqbVe7E0iep/dpWJfA==";
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
