// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 9833c153f215c0c2a1e4474406adafaec3ffb3946bc16426ee4d5cd4a5ba3342
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
const wasmText = "eNq0dnVgG0f2/9BqVxpJq4vVi3O+y622vl6Z4lLIlqtQKXx85/gSp7HDtsuy5cSufz5smzJLcumgTEepw2Vm5mCZyfHvM7PrtVz48zsr7b558Jn33rw3u6S+ZSklhNB/W110HiHzRA6DzAuphyIM/0n1n+bmEfxZLkez87gS4N6u2DwLnpKAxbJanM1mPS1fgDtVHNwwV0JwNUOp03aN0t4O2sr5w/dH22cJ1m4HAyt58HhoR7OeH0ojjAmmpTFAyfSUwAMFMqv1tb0yA7yhuSD0PKvc02tnIfSAtNTS1tpe+AZE4wdLCV/TKGVo9WAhGJLABI4E8jbiiZXvpcsoO9PzW3NAKDPN5x7PX8zwk+FnxQ8M6t7Tl/iWnqNMueUt42ceGQxSBdpfJMi1UvNlOd8NX5QNcu3rB7kOvMPQqwVWflpo1isbyDxcQ60UPMEHgeEpBAEpkLAHkg3SFgTi59LSRJtCjeSCAb5vBjLsk0rdDLghj+dtgh8r5D4azQZmauLDDUaqEfynXzgYwxV1aQVrgfJt2zG0LEAB5VuiQXTdBQUUgHvp1+nz05j1FggqAcC6VvDAHA3X7q2howoK2/A5Xk21IWr9YPoeChalbYrZBiabyr9/Sn1LY13LsvoVLYuWt9ataG44ubHhlEPi85csn7+4rrVxaUPdiQ2tJBxasnzp0oYlJrSaWxuWkYjPEAvrG5cQyS+JnRsjJBqL23bie4kRCTUMYdvxcIgYtpC2tBJlyeSIPb4PASHCiNsj4/FyYctRhiEw4uWUcs4YZv4PTBtjBGAsWm55N1v+IIoFEhU/HJEgUCEGUb/SIcuJYQl/YGXL+pGkUoIe/eO4k3LBs/Y0K3+yl/jp3mL0PsLed7/9JKD2d+QB8kApy4yDDjjYgrt8r73KykaYZYeMKrOltA8VbMzBI2xRJcaUH2ZhgEkRGsWawiZGSAppxA0hBSghyg1iq79UwSiRDssnRaAbPEpF36b2HXeMw+2RAuscIY5E9iuPGjlSrz16LETjqBBjh3yxQQkkhAlJyHiLwk+p+PQQ5ERaVFBEY4MFgWGXTaAI3DhI4p/wQIhdRSlCB8saK8snuuWGUS2qRc3YtKwG3iFltdI62jYyhmFZlMo4LYf78DMu1RB2OVDwk8RWQwhule/NLTrJKuPmoZZJJ09JJqnFOTemTjsmmaETjj3u+LGjTuB0+oxRcqY9i8Z/ZFtls0fHK63pqAaiE0DLvRpKmkmbwp7KwWXHV4pyOUdHROZqHVsmxysibomJ0lZuUAo3OEwO1CZR2yz7GafctCqPlceOHl1WNtqaKxlj0Pi5F0v8F6a0qugv7biIH23b3PnVr63fxG1Lj6m/nfpr9TOsqb+rS1K1lkTCbFpug0b6qayqlHKE2hBVnmLe9Kp4vN76/fQyE3XKsTVDtWNbHK786jfMtLQDM7QD/Fgx314Qj1sSP2E12JYEk1lWeZzGKaVxDWAZgiWTC39TN92iJ/4qhHodXTaicsIEroMt10iGlVSb6fmG7RETjYOSBrGMUq4wDvr6dAKKgC9K8t/UNdJfOV5ymvxQhZXki+USq8amwj5eShUK+NonZnE2kjI6Bo7LmZWTypYKsaxs7NhRo+TeY0y597ikaZlIYjIpZSaeMc0MlbY5F/0VH1ZNM1BPunpV+VpiBo2rmCXRRY44eLzcz4e6VP4H0w8ys0DCHVIuDZsOERijR490R460MKotqVNoLU+uOHiqOjySGYGHFHqFvUVVMplcObHZGmshzgOPpS3SPtKaKeQMLABMeCCBCoK3Ap5QZEEVGfKgAODNSYbw0YCreVLFBia0oOmrnax4Nk5OFGpZWZk0lcslBa7ABcdQfMCPkWLMGM/4FFp+ipct08OnQ7EKXMRCfBPpqadZp3uOUJWoFVOTmaqVEy0MqhY6wkK9B7nykGtE1Rl7ZY8wEdQvq2raqgSFHBNo+MfVsLsGJ2pJGp8h+RhVIwKVjZ2x2pEPy851UEtXjwSOfmAP1VpxZEU9YUBt3wvtwio6RpQHezj4tIkRnxGdk9BjNe2kuCXahElX0LtxGYKS1Sx0uJmj6Y6ODkvmSLrjuVX6SdTtvSe8SdeT3vOmDZ7SpqcwN89ie4SWNixd3nwaI7KucVlja2P9ksbTG4gQzcuXLyUX03BLQ2vdksYTF7WSy7zJyfXLGlrIVZSvaFlIrqZy/kmtdS0N85cvW9BCbqBSqcxvbJ6/BEq30ahH1jU0Ny9vJhtofPmyOhgEGhtpbFlDfXMdzFub61tayQM0rOTNDfXzF5FHaUTp+7qP03Bz/YLGk1rqli8kz9C4b6Ne8Y3zG8iz1ApQ3qDi90tOaiZv0Yj2p35pQ3M9uTpqLGhY0bqI/C2q2Qsbl7Q2NJNboiGfuj0a/pxRkqZyCx03cfyEmimTaqsnZ46eegzO7BOmz5g5a/ack/5O/0HvFA8ZjxhPiZfFc6EtocvND8zPzSetp6znrdvlHfJR+Zg8i55Lz6cX0i52JutmPewP7M/0bHYpu4xdzgqsl13FrmbXsuvYP9n17AZ2C7uN3c7+zf7L/sfWsQ1sI7ub3cPuZQ+yh9jD7HH2BHuSPcueZy+wV9ir7DW2lW1j29lb7G32DvuAfcg+YpeIS8Vl4jdXiE/FgOgwVhmdxjnGGuNc43yj17jKuNq41vincb1xg3GjsdbYZGw2thj3GFuNbcZ2Y6dxVejq0DWh60LbQttDO0K7Qjebt5i3mreb68z15gZzk/mU+bT5jPmc+aa51dxm7jA7rS7rTKvb2m7tsHZab1m94avCV4evDd8cuSVya+T2yKbI5siWyD2RZyLPRp6LPB/5IPJh5KPIJ5EL5IXyInmJ7In+Mfqn6F+jZ0fPiZ4XvSB6YbQQ7Y1GrnzDPTdWTRItiVMSpyVOT2QTbYn2RC7RQROrdN2j+rto4kya6KaJ/0cTPTTxB5r4kia+ool+mshHE10xuSdhNWmyN1v31KoeMilGiExjQw/35olONAmRN1AosRoHPWNNjRGHZIger+SKKaL5A/Z08Gl61alNKRplcrgKBP0j9W1aRXr1CqVCpdY+pgRtHh9E+9eK4zXavaavWqqiBO8t0rdjK9JrbKhAQflgNl1fW9XdV5RPWyZtZznazvWftwOVrHV5bVXPta6AsytdozSMo4u+0BOl003pjoRjVKQMqfxZ64a0panFlnKt1DIUWIZ9y3BFylKWbK0b0ZbSE8OSlVpGvs0yLHWujfRuW2XHgnxqzAux6LC8LZ1w+oFTmlJRKIW1EKiDUieavt+cXAElAbiVqZhj6qfpSP0UTqSWdtfuHtDD7qzt8EaiKxVxQhAhGqenFjKiZbTLjTtc8bkygoVrt0PRp0OQfU2dt2fdBJhO3AHpgIStE3Js8KE+5/psKq4DjDqGYzWlL1re5BqLXStNEQjYVrr6WEQUcazru1PciaTXIQeLr+9JRaJMhf5nhG5ovZomldFakuKQaM4AOR4MmgqBGfcF6uHE0x1Uobh2N1wJX+8merqUT921ZNb1XakQnE30pOIoNc+xKfAgmjKcSIrDPqL5wE9PV/ABD875vnHlLzxtgs+2kjrcsT1sDlPvckwn1uKGHQF06MezUAoFSeEKEHRbylbK8CjS5mhZG3Kf+zls7BR8TwmliH2dnBK14LUh2pwisFyFMufS4TNQMEDnp7mRa9O5JhcRxxF57XoCVB163A+dO4byO2UAVa8bmoGVQqe5HPIYhQ3tUbdOqKZzqXCUlVYi/PPxsVdINdbHsqLi3ymmStgJL0Y3bTwFdaymoKYoarAFNga9ABMXVVyPpXktCmtGjCkwLKtuPV1emWKsI6gwfw2XqYInBZf5OO+ZRaCQogNBQXeDkTgTRgSeQgcKAwM/rire8d8hfRtO4+qw1Lpm54wKPDtO7QwWQSCwHcSRR1GaS6OgVG9PUqFwHCx7MyRkMnJF0qIphTBURiBmUSKRLL0h8lNGWU4lOJ3Tesp5h0xD2Gnq0FaXqqweW+FSGJ/okhjBMkTvSdpxyGKoDQzwlek2GKZj01QZgk/TnR2iKZ04WRlB5/paKHV2X5uicNC3YK0u25vd9DROc5fAZ7inJ02wTrQ6pCmdbUIEhyMI5CkNL2qgqEXpnDpJaqkTAHuRK0xE/dVTCpMCE6p60oSc0RJAakuI7tEi7ROs9MwPx4tSZ4UM+qjyCi8Y8Af44ZqJmc5FWrnG0liBTYshf3AyRaSjUseb/AC+NiOylQpsma5HvU1EEQcQ4sJV9VDdmKYpAzvJ0wN0JfbNMdSNOkYTzkuCh+4SiiZxuGcptCXApNKFZznsItjTKnS9yG0hg+ZolrbTHM/u2YGBjC52aaUmdZ/BP5S7X4mf5VIMAQ7WZV8KtTE4GYCasggu/13mqFcHhrnSFenPH/nLaqHOTZHe8MIzu/nxMQryls0bBvh0xKIPEK4xX9lde+DWvnyKZU4ef9ph7x61c0IKseFUUe862KDHBkz1+iVwyZQwJbNjIZi+e9QXMO2uWYCAB31TboekZ/UGx6Z4AgyAEoAKCcvdq/drmLLHp9XFwX6vdsg1+a+YK+50h9woIr3Y6cDFInxUp03gdHWJ02uBnwM+1U4jD9WDLnNdAnccyaIo8KjeQQ+H4TIKLingnjKk2oDAn6IbKqIjgytzwMbwsjv7/3hXMXPUrK3d9z38yMR8MXPn83+/YtRDyT6QZ87dPSpPf1UN8qPE9zAKiutnpTrvmj5t4UB1zGLBDRV8Trna+lCx0FtMhZTvym3NwZlV0FWgZvCxiL/DwAq2XaAG45wwqrIC0ZD7g5TaV2QgiOyRvvkxqnXVwZgPHPRTK4JvppSh8Y9ECYHniMUeN6S5ZeAGpk6ooAFxuBb9xZCxUL4QaPiS4U6CXeoCPgsdAj1VOtbkiqDw814GWMneBMhkHWClOraavD5Co0WBmfjTXzD5ismdwqQ51XMsq7vvjG/pvNIeYrWKmX84/3b1L7EN3hTjs76cevWRoJh7UwSVDIUBb3w6QH4W417xlVrN8TazMMyQe1poV5enaavq2XtN1arc67WVMT68YjlMhvpI+Cs88syNO/pyv4qRkhbTxVKSYAMx6XPhtbt+0oTVkifrD/JQCVrg8SvnXte7kQBP7UPp5mE6tB0FP+iXz72ucx35WYVj9KaQCa46bmX6ivWXDHAUkNPtq9mdXX0le4lCvlO1mhG0sNp1gXnQ9Gq9IKSafK9rDG/Moms6BgrFFY4oukZ/0rUc0e9SxwLKlVtOfSR8ycbqYn9SKWUysya+POL9DeiHl/j9FyyYfDf6E7r90RtP/euPNq98oPqX57rnVU57rLr/Pdr/AfjiiwsvvvjiZ6vPnavGmz7ftfrhOm40n4eDZiGPUIYVHpEvcsZRZSUHoaqpi10ecNTHDL3YFQFj+HGvwvy9UnGoegiHq/8C16iATNFGhTu01woMJtgOUGoPMw+Myy28Ir+1DscxCaZbflh0qaqmYO59ESW6ldtXAjm4ii6/RLMhvwTOcOUJ0lzwmHk1dYSvUlAW+d5CANtrq6oO/HPmD/eiN/DCn//feFG0pYYpBadOcH0THMql4JiWgMMC4N4L/DHKWMn2Vqeod2iUbgi229v1taXvYp5e/8JFAzxo8A/wWqQOS/xRLaLTAJThZ2Lv0BwBcbzBL+oS2irzpxd/sMdC54J1+cQadcj5iutyxSEqRVGaKhGeiltyVJPe/FAnyb8wTtsZDkfv9KOlXjPvLJrmHWBwwz8lNZ+AnT73/f4nWIqXHjkzji5+HQbfBkrzfmhCD+Z8meOfEBTHjj9yOCZ0QzsCPqKtdYsX0cFPv/3GE+Qm1cHPztx21/2Z7X15sCHY8NS0Y+a9/zkETuV7a17ZezcEmTVb6+2tfHd1Pg+stRo/26kfVrbPVZiq8IyCQsirRIMDSjUzkfcIod4W7Lu/0HCalgantzMvdI4y5Qdk5nyZ+rx6kOjDCZibW6G7usL/cgcGh/G7u1U16AmwVT2QKPPP0GNj7OuHP0QoLO2Cb/PAgLLR5F87xPSSV9NnffkhurrkAwQvnjRLiSiX2uwiIARmUAjMAmUKZSYDuUMUk4NJpa6Ib7EkNdqSpIRW0duIDynHvzIHLWnaP3Nbsa+YuaT/pVkHvHS92rKll7Te+MFNtypy5ff33L1l5f8UuWnXRTiH7wWZUsf9EMb3nnNfH3v92QhtV+zkymPP+Fs1tGdOeCS/MHazIpc5x21+cNKdihzoJGsqp21QZGyuGk+CTIWGNuF4/XnMW129Dz2kaT+uqt3Ex0sROvlBXgHnrP5eukTvqbebTqBa+Ma74G0hvC99esZ3tpbawcF+6sg2OfTa5tI6CvZuxZFoPp8m3teEPmt92w4FVNrhF5d8BcLn4MqEP+2PvTqBAbjnFnrSK+9OU4kZd9ai2/defZVK+dxMT3zu+nsVt235Lj7iqSc0V4/N4AZAq9ccePPmf90KoF/Sv1QsCW1Vevf88ZeXvbkvqQF57AF//OFPx/J1+WHlxx2cxUJ7fcvW/w2o5AexOgIXL/ofhOZvkmP2uuac/+WRc3VK01oyu8KWvvYOaHudvaJTt3S+MGgxHsqq5AqOALtXoyla5AFeyAcA+f9PzVdAR5Ic21ZCUWe3VAPHf/6Xv39WfTKzF7+9W3POjo8+Mz80twzLqDcz69GumZlnte+9heMxM+NjZmZGM+v4xY2ozK5Sd2s1Zu9sq6syIyMjbkRC3Sypp1diCSQvnsbRGFzlTcbOYUlhKFoEIvYaNoIi24sAawAobC8CxgGtUB4AD9CF8oB+wJHKm4z2Ituefqpbt0/zE+1zsxTphg2u2jy7hIuJ1YFTEruJFF+ScoOkY8mJilHszyD9HHxdY7yBFkLSAkVcL0My+RYiaRlJy0jOsg5pxytedKw25PWNJ0/+MebMfrIhReBcdIyulzlmvk2OYfKKnsCr2VQxnCkoTmkcWPCKmqbeYI38Tg8ejW+ZO4Rau4BIOea7qmlrq6eTRx0rxcRVevNRu3WuKXjKBsHVPvAc/TGQUG3iPqQ0dgBoLTSWos+103sZ0nAbEWcbciBxNH36bV6DerNTXj00tnfCwenWgHvTgSID/eV14N7aT6AnatkxYtrja9V1jc2QwItKiNkSPXMcXlAid869JXiAf+SvV2eOy7YFG3I8cvZRAVWV1LYHAh/EeDPECayJASCWWTvT0qySdPcGBzTJBQnBC0qMACPbQVg6R4LFujzLEA9qAFxyLgsWUxCcj2Qh6/4HU6HA+vHtPyPNrfX0IfIzIT+9mvqks5dtMIw8RcUrWEk+kpnk2+5Yvk4pc0KYxM8wk2gmREviqjZtd3WOVLlAOX6BBW3rj6GjjgRvt3SrqpewBemE3FvtQPNp1x4DhQJBxczJnMN6UGopVFPSt6XIWoTKUsYgWjDwEGYQPArIbhORdS755zfSHZmCl5b++VO55os3YSfSJtUzqS5J3DoleJebRBHLowjQrV4EccJeVa+QK/CWyQHWzz+EgV511StPsqZLhpo0AMMkHzUl0CQ6Qc1y4zmNI5AuL8adXL6GL5800M1smmotPojslLKkJeGNyxqFGvTe+ZFQ/y+V/IyeKGZgd3uioid9G8YJqzg9u0l4Tr/VyeP1KzERrG0D/7gAXlrdCvFBWdWVPb/MMKTkU27i/E/Hgzp6OqMDKDsjkVJUNVl746VTOtpcZ0o7B7N2/N9NhCDC6Vlx9MRmYI+e8t97O7i69GlkkC76L+R1QYcfrDxFw1h56f/EYeDRG7u7/94dCWJLEGU+8dWENAR/2PntQe1/95p2QVfQet/pH5olS1xdohKLfeLLV/qSsL2N81Idw+mk16jS0QNf0m4BTsdWcFqaNDl0Vtu4JiE6Z6QcyFlR7jMAWmcEYjABx4hy5ir47QWTaT+QrwMpdqlf+z+PIQjVD0undPUjcuWz3pnvA+nZtd9taP4Hm5tigUbJxbQ0jnzaaX/Tr/7Wsy/ebHSQvfbUD3XxKTbjSlpSy/shWZLL2vTKxt7H3P4cGs6N2549QiE72+Q+5hPPRs14u5lsNyuekuxp725WUfEHqNj21PhdaHy6qSgyFOgP+vKW7ebA6YaKytON8ysUHkdc7AE/8WNsT8a0c2cVfxFVfIhVkIKKWp+m/xBlT72W29S6FFNOQ2gbVy9n8W0pfn4sfjoXh/KTsfwL6Ac8WTMhs94fUCvJFBkcMm5s+85rp+1Fsim17U+AAY2AzHIpl6PrZxTrdYZJFzGbZWMeQ5mH8HrlR7d48kQRAo5GPnkHN7dxFJ4Q+GeCoW/CFQPH8wOKPsSV4tG75HpM+CA8zKN1VX8QdfzGGcFGScUvxIqf6CpK8vm21tK6Tz5nBOYbqNwTPkyG3suc5vvU52c2j97v5s1axyMAHDLeHg4rP4jlkro5jfFWuv+hMRW1iZyhRUx1C8YGD/rK6/atBUEKmaOKrr3eOIND+xObnpI7+a8Q4zOqhA45mTJyP6WU3Yx8cCFSXsWBdDFxKAZmmLC/T05s88wRZT5xEQ0HkWos78peEWMplGCf9PmgXxDyHqf2qLUmPd1knjRJIEEFIGP53KZPvtFznIv3VbLtfi01eCaCP+HfwiejL+GcjDAT9jVlX5L/00tFQn941NV/kwWhaT+K8zU5f3wzzteE21E4JksGJ2ymVf1TNjs8zEL9if6BFqiWvQ7L9Dsb0zsssyA0+4dl2AuDOMYRF/0UfTqczGE517sPvVI8zsR/X/ehV9Y79MJzeZMODr1SPvQC5hpIcYk3t9wCyH1KJm/ThwpqE549B+ddZuF5F/Kxf9wlO8bFp0fckdl9FMZBjedgQlmcLyli9jq9An2ph6dXpIs0YeixrlS8GJ6fgY6E5tOBVjLMacR+kNnQzd/untTrfkhg9zomrI/3kyZw1q9oNM6LMQZe9xPP+igd42BgVndgsuEJyMRzrYtQZcKYvf0R/53pSbDu+EH+9iieW4AnVw6KT0uxohbVneii8+RuYXf7gi3sbqt34Ga++A1S/GDaTM6xsl5hKx0a/P3T0MCrsEv+l+Fkv8UhfoJ3DQr8SNrjl1WvRRNmfbXKZdOrSIgvINMYkmosHmXSdhTUrKHOehrIV2M9xwXN6mtNvuEV3nfLvZo2RXvNf5oYrqvL9lpfeGggKZz2NRndZ/Se2rWXtcWUhD6NmYg2xFn1KsbfsJ08KnJYjR9ICeyip75c8/lXRuQcVZeoSb2NvuAZpAAreY7GZJC16nJCB0kFlayAzKgNmykvpCnRnk+xBf+Kg95doPmCtEliFmT/BdQ3NSim/MgnzxKvlxD9pFL2RIBPE3wEXg+6xgh4OoCnAZ6lKZ7Aq27iowoNEOVcxmz4dIqdVpvAtuot6ATdda/a9Hyy5FMoNWilvGaQqLme1nreJx190jOfdPTJvVirFK5oxFMhngkFUs1ca4pdzpWI7QibjxjbMsa27GLLCorGidns/2iN39uzsMsKRzH2NoQ4Q0kmxXYKuplr4CXdU9rBOcQPj6s6ymVTKJkCCgGCijMU6GljxUtqNoK888Usf5Tkj5X8KSV/ZgH+MB6o4/iYD7BdNDpSCvyG7wJrcb624c0Uy8tdB5aOPm0oJb29wJr9B9b2A3s3CPEcJRlXvZ19f6mOqWtZYWPJCW87B6xXNP8Hz7PoOVWl7I94l4qRlM/UoOU0Hnhnht5lAA0DHeIIYIphmcn9RpNz7KEw68a81wIaB399jS+z/7RGQETtUAExkWfexcyjZCJKJqCUetMf0mf2Peue2TXrvrtgMocA+ODWw7utUPu8n0vC5R/Hq5I5M7p44OXUL2OCBbnTe/oDopcMnD5AJReyhIaEYqaEhuGfJE+uDav681x0maBrqASil0ZF2Kub+a4aoNvrDMnpDbV84gZ3GOs0yCkx5Pk/F0143XOyvWxojIhf2ijY3eieOXLKrRd0ZairdL+mknpS0Ag83MlMSO/hD8i2jDqR97Y//OsPgB+q/dDWw9k3FL7+j2x0brrYOcjDOUCy0LuhdQMhswcEWPjy/UIAI9AJOhu4vx+M7B4YZWRFITE/+ZFff0AE5kV//TvmLsOOFoAGiC6EZmD1PCx7YpfugV1OVpf7xg5moheYMw/eHuja/aCb7YEuJsTR1L1eKdObbnQ4eiffUsww78Qt32zIohx+CWEkIcBcEWYSeTEBZddiG1dMZQluui2SkiXOEjzgbeNOqOsqLDJK5kSvw+lubzX8caPSYK0P1kKUJscj4KDONRU3bEdEOb0Jlf8Eb7Ee9vp+SdVglfSGlwArYupyvHQKkM437BlJk6ZUpJhY7sJ465ZMa9WzMOeSqkRelTfe4kzb8KMlazC9HuOShk1XBkF0SyLZRjSQ+e6wH9FYKA6zFcyEo4AhrobrBUsIrvpepjpXJ9F9AQP9VG/sEGh9hBLWXAm/rUOfi9BpTN9W27eVJTnO4qqYbKPJqEGBmOxTeSC2YnZonDhnE9/Rx++BXqf5/4OxoJUd0qBo3BV9VRFlHt8r/FCy0ZiQtWE7oeiHvFKMNZc5LCVxbNL2J36Z35JO21/hC/Ltw1wj2Ugg6vO82Rknu/6jQ2Cn70ne4Lvovo8AsAuSC/F1jn6oN5LlxCqcoyu6o1CMeQDaKQAii2Ab2Xj3AzdGWh1AUgmNL/VISQGKCYYIRtcxftWP3Owi6K17dqrTIQC2q0vgPny8dorvbFrnwmK3m1xQABzdgZPwPkgS2ectHl7I/w2ihVN5NeY43qe3C5AoyfPD3np8/wtvkXD/xttAi59U5xISBAIgIOABgQUSBdIN8Gg5ksnBQrcJA0MeH3hqQETMsYQJWGoeBzNLYWOT+hzXS4yDUb4zcm/jtBiXinEFjCuGxhXzxsEwMP8WJ2sPOQsjJFX2QkY6H3R95MCp2DVihoDChHuu6ASkjCURQetfAC259LPL+/YwDJhi5uK6SyQPeOoK7WIRvjq9j2R/CYc6pe9eNqbuJpX0hl3ByYUSRQ1xmIX0x4Sk4GGFlD6HoFGoP4/mDdkDkWYuoKb4rrzmK7hGV6rTgb0AMDyHvrToxLpD+py7A2Z8sw3Rd2kI1fDzJnrTmADmRrtzn8CvobCNiGb8JyQ07G8yn9IXhl8m8wVuzDhlku7YUKp6BrQiPlrmPVgpYQ723h1WsaKGWw8ayqoljSvUakaBI2448gKVh9PQ5oET8spCmhL1QvXQvtO6VcjquXGDZvdLHgaVaEaa7ouChxK/O9YA1FKJk/Aclrjck0G9Jy6RhL1IJF0A3C7A0fPcsHGfV0oNER/inUS8kz7edoi3/VrxHjY8G7wFC4F9AAlpWA5KBNM9VUfHs87ptHPHZ+IysKeUOBaL+6aKwodh9hVnQx8PhS52QYZWGEy2N8IsrGPvHtgq6UnzSXMcl0eahO0ODS3TlPPNvBJvZawvD326IO3cb6lvCAbfiQjIPuofz56A3vcrvKUpSAo1OIhvA1m5GoS+cgpbWfefMAuFsk8MGiLbVbvJvyAn9NsJVPBjQfJv2dsrp90rBz6pfoIv/tc3Vl/cAuaiYGjv1q9+I+2Fvm+0vd80PL7b9F4penk6FoU8GPnVJa8CkdmRg9TNJD43YttUxD01vvDMP2Z+jZs34QkyPD4Kz0aZ/wPznUbCe0EPWnrQgx40ehCGGwN62ENwa+vb4dbWN8+tlxg6xE3pxVbY4tUP8O9IXkbC8p4LSrtX8hsTXmvVtzX2cohUz+8eMk17j6tbTUSuvMB/0dNvu1wmXz94mz+nptywLrgyW7HGJMq4+Grsarz8kPC5oanx6LL3IuyPoh4S8lsUmFPzcKl81por6V2PD9PMJ3KhEnM+mpz0U5/Ta/1ugcr0kv5vfBVoyvJmvXsB6NZXiOd8wBM8sYnS1vnilaszd3zRvct6C71qver6t9FPQrkz9/kfIXNJpy9kon+gvGTJi54CbN1yVx3YisudbD14fKJVm7h/ncRfu8UX9qobrb7qceABHnFFq6rfk23pzqoaRSooPlMSO4KRX6c8xusM7A4/VprezjXobIqVLMvIb2MdN2tKfuyUx9LRf5qkcriV+NKP6GucBjGZYwpfsqAvcKYDuQSX+KzTraVmQeFyOam1pJPUodZ2QHkugaKEt3aipBQ8C9RCuvAsiA+L7m1g0GIG/dNd6BgVJqiSvpZpgclRy1KD7NgMbbczUbvc9vFdgTsegFssA3cUlI2ky7HYUogIFBV+L7DQ2ATrDQLUuIHXLuoNcI0ghw/VG0ixKgjisw4FVIwPzv2orAywFZ5vGbbw9yn+EdYrDAf5EwAlXV2O6ceb7qymmBg8+WJSouQva24Gf8hGxgcnT2ldYgjAyCmp4aTWJA3d8gcaRr4U8MFIox1ey3VMBdWlkwFA9ynuU+9qcibYM7HgyMgQHQ1IxIAkGuDqEpXdaMKYLKRDU5dAs9ej9EQtkl4XBl2E10BQoLvJwbar0+r3hZnU4Qi63byMrPYpaa1HGPFUeqNaBxAhaXphLvt5BZF02aBFiSjYlQTrzUhUcS3K+TYXHwtRlOMLSDvRBw18K/3mIsCo2SgXR5tgNJ61IcnxeuN4HBVci3JukflSApDt6rLsd2lJLotdFnNdFqJlrsuxjJoABIQ8VayRpPNjSuqJ7zyeCHS2c5XrSYtoYz0wyUHOT4AltBRsAIdu1/SrQConc/FLlsRvOJxjcJI94ie1IX7OY+dY6260NTxchJvskmO9O2AYcZ90x6OUR2KBxMUfUihRgt7QO40FSlOHUWfQDJVNV0HFioc2N0xwwzJFyKF1yHB9gXoU1YbV1s6g2EhaOfoaam8c9A+1NQb6oCzoTbp0laUXMgxCwei33FeNKDih/bCZ+4NAMVq23N4vKfghH+2rP0QlBqAvYAi5J0U8bdUKrxcYnntQ4Ei1DGBPmMkqz+1q7lq6jYcs7o9zNT4Rdwrdmt5YrOppq+Wwg1+uv5oihzfJm6xVVOzpbH7a5HR4wDsj/aQ6J1hyzI9UBV286rIHpZw9NLlPIHolBx7F5ko8ayAi02bUVTQOVeFmDA1lPelm3QnKvetGfUNssKI+J6xX+kCuB1UoXtbHmBMlGOTHHKESaYrJBk83XJuSl+RjAylqL215eZ2EOZlNG9Wln4hhOd5cLDujTsy3ljTp5nCk6gqjrgGZdAdIAX49JuCLY3UGIYPxsdIt//jKkbsrPpfxVuJrzIcfOUIgL51C0uIHrZd1Ht0VQxCdNlmMbd6MgO2IUG0c4cpKXauRfel/RJr5XdF03aV0NIL/g84Y7xAcNtf5FaTzCngRGTiScYYumnGHhJYpbLXFNMbjU4yawCjMedCHyNpw6jGBlRM/5vMNtJ34Uv5mFF1wSZNSq4IyWVbLxq6R7owcoovcp57Qx26knjjMqRzTGnOt/vdkpzxFSA5ghNL1qkyqKA1/fYfLANEGGYbBNGLX2H/JKLHbwYRJZ1VIJleTndLxSJIp54Yn5humIZlSBnSMBE7pS0sCr8iv1H9uJcPRkT5ubrAn9PFAYWH/qmUexjBTwNBS/5YA0phyUy7xxqe9Kbf7gz1c2UiFRI8bIXqitdGiN9Y1lJSyl7C4F6jkHDGRrlISlX+igYKx0ej2iwbQmZ0DdXGUJnz6jAxkRvza9Pw5TO1mZSqUjY9+CCmU1tqQ9p3vQZrvXLzzk2pnrHbJ7vzHZrLzT2k40Y+bdw56ulG4UTfv3EN5t/Ofa6xoBa1oVDrWXSsdWv+cqsdk2/HNRgxEFjmSnBTlyOGPNPOTUprlO/+ZOqhHvBRBEgNmk7SejUdl8AYdQCmUhw95eMHX4eG1e3pYwsNyPx6W8HD0nzGT/2cZ3n50/W2cxlrSQWOLx0UbzUqXGCuSGCO8Rz86RaErcVWeakiJ8h20Dk/lx1toblbWOGPak7pNqDu64+z5gsFY8JpGIblDarbQXrftlGYVQrDCjwOkEL/AMzZBEpnW0rzrOuYExU9qVjfqSqaA1VbRPBj+HN3qmfogXR9CfqFMBORVs4P8J/vyU80hOAhMkcqT/UaZVFp/CCnvLQd6sjxti35QiwVBtUhb+w1JW3/IH/wvE4UZGVH05j+d8Ydu9qMtqtKthZ8H/aGjarM5JJFaJZSrenU2xlewXyGYsNJEAHOBPgIoY8L6fBeOG2eN4yEeLHbpYJlgsHytuGKw2G/IYJnDdZ1xLbeoCrPibly/iWPrAAYSBhbjvyrD7MCaoI/wqfCLlyRwAM+tUOTL6yiFLrqJfsPtplMcSRgxYqPaLdo1riCsMKVOYUlnk+3WMMuLDvVE2TE2Myt07xXV2OtYO1gmFrlQjhUKzvnRdbe1F13R2DNiywjtg1BjYYaFGWREbz1agRkB6hHMwB2MYh7UW17c0FiFVvxqjrQ2sh/LLkis+3iu8hP4VRS9gDWjNTntcWbCFmCzJlsBupIgGcalVaudnIaIxdItDYy33fMbLvGRh1ItAsYny+Wk1pJOUjcgzbgEiqRnKZW+i8agWtgWlsSHZe/SQvFuYADdhZ5RkQZV0tcyLbA5allqkJ0z3s5k7XLjx3cF73gAb7EMXivKuGBAm3GJ0GZ7oYXGabA+RYiabOB2FvUGvCzk8KH6FFKsCoL4rEMBFeNDyjSV6YCb8Xy7CzfbWFHMrWCA2CN9x6ZWtJJ+Ma5Ju47trGufCup0JEFahJnmbRR+hbUt6sIwhy4wCLr8fF7r8MvKTLphhAUKq/tjet2GE6RbGh/JZU+pXdhi5ljHqR9s2jOqIgvAxQutkNUahSDSYK8iIdcqbr2YSjc9Kv2PhUr/u1WTnUg39RI6/Vqh0x8vdPqlS+h0M6TT0awp72OYXcKXe9QlzKePzjdM+tDXOA1yfiYJHsr50aOaYg2SCW48rpmoFTGWHopJ03En3YzASD2qKdFOKhM/9rgFmS4llXQYNaG2kg5Fct/G7VIk1kqlCPZ1VHvpKJYZUzCPLiLzZhd7m31kGaZHBNNqOaZH5jCVdoIgYVqwoWcDUlBLimF9MwH3N9PrxKIV1JNDJLgCMVFFpShzaAKdQYugBV5R0FpEnxfL6XMd6fMUzcSHgj2S30nt8eekB0k85M/RL6OOodw1xFAuSBr8uSR8fPxKmSkp5vlzsSCgmMwsSDsCXYYPRmEhPSbMJvS6TKQrapGgj30R6H8yIND1le21QqCT1jkCfVGqlL1cT8MoTRdnVCLte2k1jmq4KmgCIy6a2NGip26V6wtWIdd5GBr5nJiMGoFoLE2kV9SjgquCJpDicZYphprETWmVhYGTLe6wkvaxQycdymApZj14J7UCiqTzahwUVTfxjUVM8r5a6wmOBQlkPrRz30Kdc41kjFDnVDgfkkHkyiWRC5FJlkVOqoKmhcQ5xTCqQKZyWklfj+L6Yo44R0mXbxgEQ+YcqS01e1HnSBwI7aLOgZFgXo8Nip3ACMyG6psxdzBQh9VsAXd+beTOIcM4FIB/CXf+p3tx53+GSpmNmPLzSooCd5523HmKgmzAncuyjnZLuPNfy02Ov+m4iD83u/hz8w3jz82VHH8U2yunZA3CAgZUKoQ/x42APuTPUS4x2pM/j33ky/qQaLpgEQd8bwLdgKaVxrywTkJS9Bh0mLaEQY/N0beQnuh0GYNeCoNeIF4DBp17jVspptDRaRjnxTyFjskFE9GjAoXeR0Eo9Hl4y0ihR7Y6j+S0UOgTPwyoNAfSfQp9EeSjHuQrbbGMQ9cdFpnMZY4spR6ZScqjVSnlQekFX071UZ9Fhy6f1jlPfNQaEjC2oJxoUpk1IDDyE9hceoRI1pEssuUjCTjGJOZXmUdR2skqlKEq2SD1GDp5YMvzQfpMBIjRMHMm8GGWObBmLnMmg8xJO+y00OV6F13+2ZVSbRr8lb850hxqDFOj3XSr2mKONC+ENBd45ljzIgI3T5sDJo3KOdocAcxxL5iB1cEX1A1pc0yeQpt/Mhfa/LBQ5vRxBjJuGW0+XkCbTUAyO6HN56kxop4TJPvO+s5/alZAkk06koxuFG6EJBsTSTYm4yps2iaLSTIa/CDJxDrnsTJPlpFkwnqxpC+Yp96/OzIAxPAFHcCZRRzgfty7dE/3hFvdh3tyJOBA6o0CqeeIwUMia0kEjfmbi2ix6VLCSko4UHnuVO0CvdeQEuU7XLGVPrkpjNrqGudKe9LSvYuE+SfyjjA3IMxJTSTMO64cPw56FwlzkUSO0dS5OiTMq436gMwCVSDMHUZ/daY+RNeHO8LciYAQ5ocC0XsYDgJTJPHKfkPMhPnh2i1MWMtxX+GELfsRLRdE1CJh7TckYf1hfyiwuphAzaNadcUZf/hm77Zmx0mH/GEQu4clUhWhfKCuZqN7FZNtJYR5BLAQ6GcAFsJFF7tw3DhrHA/LocPSkbKyeKTsA1eMFPsNGSnzuALUcApx7Ryo38SBdRCjCKOKwa9kjB1c66BfDWy5Ybb84ERHjrpxkS0fdWy5Y6PapxOrlR7rz/9Dm+KBzkjY8mDFPFtuAlsOy9giJ+XClsM574ZsuUN7EYpsuZhhdy1DLkDtAlte9NjyayNbLq0GbDndBrb8PbnRRJ+ZJYy5GTDm0GpIHdhJfKW0njJlDoXGp/QllDl373UULZoUPj2qMfLAhRuPa2ZiRYylh2LSNOukGwte81GN7vNimcctdytFlfQYVaG6kh5FdN/W7VIk5kqlCPZ1VHvpKJYZU8zsLhbYXext95FlqB4RVKvlqB6ZQ9X0mbEMauj7bFAKakkxrG9yn4u06E3FogL15BAJFhATVVSKshRNoDNqEbisT4dwDWCHbaGFif0GVg3dmaC6jKolmqK6c6g90tFNRCJjN8sbpzZs4EpxUvDgDfioT5EXUx4FQ4o85SEqFLmRhvJeatFR5Ck6dli5nVDkJVUJRT6C0MiXtUahvGu6iyI/pbSiTfL8nxQIf+XpqOJZoXp5+Gup/8DevwBKdlV1wnidZ52qU3Xr3Hf1rdvd65zuJJ0nDYSkEwLpwgYTA5LxryMznzMTTGD4bl+YBJGPkUA6JEADQVqMmoRIquuihpcGQbzII42iRgVtFTAqMwYNGAU1PMSgCfzXb629zz51q25354EyI53cOvvsvc9+rL322muvvfZaNZgktSZkr8lremMbqKW3p3HBPSnYINaNbPjhQBHC8Kw4etKYV77iqX6SVswFkLoIG2sB+Xrjwq+aUnnPQb3Wb02pXLWh9TXb+h2v1rKzv1ahgSkgr+14jdqOxWD99mtQWnYfYkDcTg3EANHZPi/NMnauJabxV6uxVC+T4hl6RsX/w9bAICw7qKWVEdOV6sMCRg1vG2Q34FtjTOSmRDJXvQWQZi/f+ZO1QfbjbzS3BTSk9vZgEy99jeeLAx9nv69q7bAjdxbbntjba72m8EDp+2KKs5Oyq5vcVzt8WNWwrcI7jKjCcrmuTHqFQz8hz9o9g+M3sIzwlqOo9F4vUPdd8MXgaWNGzcDenIi60sYeiL9KvQqiGchztubIc9DAewUa8h1/9bm6foV8gHUlrwuuCdzxUarmbX3Ytk+/4QVosndsBx+uNahDHbn4ApEQVfvcY3iBw8WZ7B/stY48sLmOWIv5pe3AfX+a/u4z/vkdK08d7nvBTy/82m/95v0fYbOAzz3ju2+6rf2DF5YWAu+AKw9nbPDuV37gD/7gtHc+ZbjvjG++4ncOvutJMDZ40/UXPvGBO9+L4BVf+8QH/uN/24Xv/3+vvHwm/dmfRNCBQB2MBM7Q3zB9feSHvHLDOBFAWoS3yFpRhBxzo8REh/MYwAFUviGojfHRRGuvgEJUo//gXAeE8hZYoIzW8lg17OK1PEq1lDthKUf5gxE3MAkCB8JLigZQ9IjcpuGrbXg6f5Kv/193HYAJj/7gNzT9qDyR3j/wMQ7278Ev5/zi+9+Cwpo9znSHpBz6TaRwRDOt4pc3XOP+6n+yIuwa4pcG8ujqI9NHoo/agNwXTc47pCayyiPTR6KP2sgQuKCBnfYVDUNf8ZzU198yfZWn9vW3pa/43dhXSTl0V9lXQF88wtzCI0uPvKfaV3zTxDcPs8t3s58sGKLP45TiW4Q92PfCtzzt0j9p/yW7uPJuW0tv8bzg6so0GQ4ZV6/+1B/85/P/9HOM81+49fTXf/5z/5knikyGV3zjPT/4V1t/m2fQp577UbaxeRoMa/78AzCyeS17t1Fjn852ZkQBsPRitZPPecWBgVoGckYyBZUPc3MOU2TzXjgcHE7fjLaNkoHCd98VweEidMlik7N0jHdo/ve4ff/MLf3//sNHF1Y/+h/R0mdK4T/HcxB5pMcS2vfJPQc/8jf/fPuH2cPLe9734bf+fY6Z/e7vu/XAs1/5Zu47Gs4YyyZe07c3xYdKBB8qx3ZPVPrTGhjSxZPwXlhlqvRIqRpnvrUI2LtW1cyr+t8CtMzLuXufJ2bSHvR5i9Ffv8t4gSnp4q3XhWoNTleRkjbYwIEKEeL+uPCtz8WiMmo+1ngIO/CBp29Z2HtF7pN7GxShDR8ZMMhhAIMfLk5vMZa10d7LK62hYI2dDr71bR/9rv/wt/NPG/ArO2io4wHPDD/4zH/80Ssf3PE05Lw9ua7PHhXEjUXy0Fc4den9r7/2CYcJqQf+3w/fKqkm5eT7il+5I0PKHT//0OFKyn2Hf+69H73ma33YUr+qe3Ml5cKv/PE/dl/yKaQcev/fv7qSctp/+8DLW+98N1Luueqq/7eSctPH/8vXX/rAK5BSe/n2fZWUZ371wKV/86WnS8qHjs5XUr7w2tduf9r7Y0k58Nd/sdelhHc/J3nXa+/cK4CZe2sl5fue/KGXX/afVzTlwKWVlOiUr23/yXaoKepzIk9kSd5nk4b77OcDcfBhCuG3wkLzy5vWjpTJLUbK5F4iZTJkkDIZmkiZPAJImTxqSJk80kiZjB1ImYRVmmLx0GKnQDM1Wx3otlQcVmJ5VcO2VPrdM3aCHXqrXd9RBya3qiXfCpeU7R0+qP5hX8jmkl3uw+Ul2GHufEAqjzgVQPUydXXBdvz9yl+3gmp89iUT63PsLZOye+PZb8lr7hqxEO7acMjsA9VvgQn8W7CChFR3bc1+Xjcnav3azP7u3qE4y2TrusN0r3hsP7N205exa/HEiy5sMuj7wT/j3+yrogPQhzMFpPKDI39GItP0NwI/uSa+ui8bBOx0DnapBgteB7rEed9mbNMWLB5BDPmI4x0XMvKLZHkwNZYlr5dv5iD/4SdvESM8+b53jCfv2ep4Qr2phAwOfUH4xRfXikbvvY3ZBzOlnr13TaGw78G3f+mPnvXDl/F4N/W4ULMrlW+uIa7OcdS8pUgVh/QIPZZIajJzjXIQFUmUMwat2ZWPRnqI9FStIt8CnpwfiG9qxryNw9ey8rzpgiL2k6+pWfWxM7XvvEt2nDnz+gd+lFzw8p4USq0hjqsoHebioQ06XwArtrNWDtuo8FcNczmfpd6SpZaeM9lWZ/8gsOAc404u+5rGuuPiMz2vtOnq4admPOWoKqIn5kr3G/MJ6X+FcU9BtsEGZNP3OcWU7AHFWeBShuH+3QNog9ld34qspEoBhYemqenZNH2O50/oQy279lWmuPPFHuStprjsVYjHpo6kh7728TrEjnpkc+2+fbTdeN+83XeNtPttm7b7dDMDDxx61Ujh+n4Hvsv+xUy2Nwa8k4TXRYf+YovdCEqKwOG/Z/D/uybgP4QpQJRohUJFao044iPinZWI+kpJUIvIfNVcqdofd9iN/C3OT6GZKeJhTdMrTE3opo2bILqfMhV0Vvbt9n5x/mtPvQ8VUKjZNJfk8SrIrFKYwufGA5kdYELMMQFMgOS7FrlpjnSbfM/Zu1aY/RwK5lKmxR6tjQgrNYWQLWFqHYzNtHmZj/NUHb6Do8On7zzDRpADhFFM+N5rkIMmnFoyj5UCgwhPMs/dikbXo9TqVDo0Wq2+bzqVfq+Kkjcg60SUdMXfNFo83jcv/taR4m88geIHG4ofHKv49ZHibz2B4m8fLR7vmxf/yZHi33YCxd8xWjzeNy/+/pHi33UCxa9vKH79WMXf8PFq8e87geKPjBaP982Lv32k+A+dQPF3jRaP982L/9hI8R87geKPjhaP982Lv2ek+I+fQPF3jxaP982Lf3Ck+E+eQPH3jBaP982Lv+kT1eI/cwLF3zdaPN43L/59I8XfewLF3z9aPN43L/7oSPFf3LT4gAXN/3mEDQkrNnzfCqu12etUZG3Mk7NpZxjoBfmXBVxVjrzsWvVFQWHVt3tg3Hypc7L0NGd0JpkWkbVkzCXamHcXuTgT+U14o7f9xKsqvNGhazX2ppHYnzCx10/M+8ChauybEfvIuatvZe7N2MP1kW7duLED53v+aCW+VuJnD4DL0gRN1Tsk3nFrvGekxp8+8Ro/du1xasxq/S+icN6B3YS86encBPkg9xVJa/b02c9uuQEtu8GzH/+h55jP3e6gpiabkl3+/ShYN4vEr1/Fq6qjqts5cD3Ig5Ms54lP2AOcsauFLbDyuy1CwxdZkr3xWsVZn4FBHnvoz9YV3fm0rf/zr+MpI0nZLddq7M4VTXo77O5nb5FYjc/+RIvFKYoeIO3WJEyo90l7gBPGAPapPrMxEOvrQ6x0pWdZj4Tv0f1emd032X3N7mv2W/wRfj3eqcGaeFLUifEgHgI0BbsolMZU0/J0+lCc/az2A/scVZKDo7hU5xx5aJIoF/rZW5Gx5W2aRPHT/PGCY2xma/hGIm8T5OjXcNB/CHHaZDPvb8XDWNpCY1XX5KE0YDJuChigAKuIE6G5kShbxA6Nr/e8YJJ5cHOvCvgvjl7MGWBXTwTn+IHhZrqrmEYhUCyw4wX2VW2bq1Htw4oVfCMrD0rDac7Edvp+jBDKcd5vihBaC8YBubSGQjZizHHPattuwyAwRWqNDTmgtYGYlcIotIbClgdWWdIqfGjrrH9P1f40DkVUfArHFoGtINAKdKuNLBzOjl5nrFDLCZT6DXGNt0ZAyNzQE3kw1Dke4Gf94l72z5YqcQtL/dtqUzdrYyANyL6J7x/70avW7UZveJzRe81j3ArFY2lHVm3H2nHa8Xb4SJrgE19qB5WwF+PkolgIwUTkhk8GI8ZQyB1DRgAMIdSG+K8cwsAOIYV6Jn/rQdlQ6m3L2KB/JCAETYpQq6s65mL3C5oa9IoteqFWrt7HFy292iiF1qWTamXHmnugmGGKSqQGhQMeSMt+Fg1a0ouo/HF10YIbUqT+G4HqF66rgkpx7d8UVLdftymo3Bx754mDKhwBlbcJqIKNoJI1eQNW3VAFlZkQCqzs3wqvbjgWsN6KVDgzU2aVZIWWFc/TFQ9G688L7kBiel3SkON+lmh4r+Bf+TMgvoNJb8NaSi9FIuLTE9/iAuDwsF4a9Hmb7VEDjigGeDJtuclDzau5as0mgEUDiyo/YIEdN+Syn0dzxJ1VWnouS/ut1aImr9g9qIsxLLZYZd2qW/hq6h1/CTQgzQIOzSCu4SYPHq1iqme/gDrQStE+woWVLiTLCbAjmVQukMde42nJiOIRFmYZw9pQkznz/j2+GvhCqXorxywODev/7sFvQiYOiLTE5JjuAkBGG/0D3oq2WZsLqisNvh1ZOMMEGVH7oTS8kgvD8zLzvNQ89Twirdr69L5LHlOqk1SvJLBYPe9wZzKTg/ukpew2TzLPzDxrmhGWL3wxHFSHZL6YoZRmYC9tlm+e9a9kpQW5A8C1xSLSjldwDHEaA3FOCiB9/NdeMQfgNVwGmnszYhQ3JHZOP5yiKZr7Lz0kysXm2AqwfWTNfW5JBoMpiZovO83fm0/hwY0VtQFqybhRh1L8XQyzD/29V61IC2OKN23cHJmq8ynUDKSZ5lbm0wZ3qGWNFk3t8QG/af4KPVdQzXHxc9JDruHN+dyG1ncAPx6DrH+AVvKMPJr7IOSaM3mdZlGuXr87wDPKQCVnVEOjHYx8uQHrSw/+C1RltdG+trhaW4SZmfEDIP2g3CHk6W1X6+f6PtMAOcgB1yQcuzq40b21Y5GKQM9cvJVcFSHtdZAKn6SXZFCr8nH8TH8zTny5iBJcHcnTs1pqRxbtNgDjexCu24X5cYdjXvYecVpTZ/WKPFFC2UCeBLrReICN3iUOCeVGTXYH8sOy2UUCiGX4w+A31mkmvkDznD6L1qVHYL6pQ53VIsseREw+DfVzdHsatXAONo2fe3rWBMgxws8MxcJU+TZA180+xMPDowz8fWaQo7GKy3DwHoOCS3Mx1MGtHg/temZR27/KUDVUuiZ6zR51+MkIMoUH8CoLRIfMtq6YJW79LAFi1mVfR2qnGhBqCo2YQiMEF6hhushVMp8mRfQ9XbJquvmXG3rZQ8hl+z9dMQUmj+lT/TCfQzwHzvVD4C0eMfjIDy1yVR9aVFmH8ziZwlP0DDUZWENKjDT+1L18hjkjFvK4sQGqm9VaoSA6RVHeYbDP0pSiG7dxRp0rYoxVFQeQt9sPxOaJaF52ZMA8DBg+Chkc8kkyfL+QGIYQwCTCKNZQVYrdwQQHsLkGJh8aKRg3QzzvsfwCitozioFVYJcFhbJvKDYxYEOOXEaiy1nvf6wGnwfA0WrsHhf55jKSXOR7NZIniN3+z6RHGylLcOROV8hPTKkAa/bVjuWva2aZGEXCna6odnF3JOpwZQyAnMYdA36oaO7vZ3rr1IOtOArMbTh8iUAyHA5xOmMWMp2PTSP+vfG6UkYIKvIheRe68jEJ3jLhNNlIipGe4sQVLIOKYzeU9nFX2icl+JbNStNP077UT+yAy8Cy9t2U8s9VeWvfG//uVwb/9FuHngrlqfKFbyy2hQGRFbEOdiXpo1oxFAhu8N0oCYwBkA4zGaXSlHIpBo5Fx0ASYOxQEwxFnoHDkKLyabcQz7hg4oKzumDP4RPpQj5fSZz4yQzayw2UQZvDbdcCg9e2g7dAC+XgzevgVRoEeJuqinkEj0hw8RlFF9Qmb9K8TMemFEYdED/MPqtSjdnDvV7EtCm9kEbcju7qSr6lpF0obAtl5iro+/MliimjdBVmjKp1cPFSBy3diBnLtYRjtVCGqcpllVM1KxYqXuCB/j32dL9MwNtlHtlE5jNHMNWWiBmapR4tDAdMeeZQ2lx1GsgeItMlfjrvcPOnAZmjApnuM4p5gUyHYxPAuvsMvIMKLSBaOtKhBYV+7/JisZd3UBtxgGPNRwZgPihdxnHrpgeDC4bUwZfcumKWv5o9zA/0ZPby3hqmojuiRChgbZynctaEgufhSm6J0c9tgwYGcEOOgZkX0UaIhir7qlaqtBPTpj3En6im/4Jq9Cc81FBZaVcOdANKuB0O4C54eW9YJG5+ueAVPLtaMlhOUPAr9Rj7D/xV3KIdCBwhq/e/6q+YSzfZr8pEDnhw5X2Yc4fFligvpuugQs4mpPq3KdJn6PVaMX3F8W17dEyc4ktzAl6a1XVNHbRl4OnMv4mf6PohPBusuYKnxwot/BzjzbEpvB0ZpLl8ZCth8PgUlgOUffk66RHYfWEK6rzp8Aofz1s9NFXFh5F2TgZIOc+yzQ7b8yYeEOXUZe3TRnLpZo/hp9oNNLd/n7/S97Q9uukSw5t5S9vwgLTgq7qjkvW3jatUxHlCaoncoaUMgg8QQjeqQS0YKs++Ij1CYUVLr+sz96elFQ3OrqIFq4/SxixrmyobKFjnVx0M5FF/ElyLKYbs3eDyPYWqLGNmVFo6GpWGYpgUwLwQrMNBtYzDPRiTVQkexdUSdlP8Aqpjk30ZP7gK/0pNRL4rdNwvpTqsNVykDwaUopoPZ2h14scefgB3zq89R0ErRexBzV72VQFMKFC/p7aS/aMO/encF6VE9/h5iKajC/q5Dpyj6VBslqYoKja103geNCh5vT4VCJ7insU6yBCyr6HWiegi9+91lifl5aMh5rvB4Y3tQjjQabu56hCWEHdS8w2nVnPsz7AMjZ2Uuc/+1vfCSW4+dbLbjYkVVUPaq4Jpc9wTqgz4EhMXcZaXGCcl/Zo6MVfFZ4iU1ZkXKmAZqK/eIH8U2x5kMFKigCMfNFKiSBjJ7J9EoBZCwhNsXkuotaBNatAYPyqxKrz9eWQ3XRHyWWE6isRW6lQ/OdfkB/sq5vRQovrhw3mqPkI8JC174DrjohMNsg61PSy3erRUFRt9Hnlr6Yf9IBSC7OCnLXRnAMaamsQUEYomDwbZ0HJz/TRQ0y164TRRwy2xWA3BfJeiMUYUCqTA4nOW2HwtK1S9ckigdlZ0RxkbsT/pTnTsFMDb5BQgAV6gOv4r5aLJhFOAItEtbugaNNaVEA0KXYOciPJ7HIZT6dqTAgjIuvzALlwdayZG9hMAe37pWt2ZBeXCSF76Jj80ojnL3g8WFflHqESgI0Jq324n7tlWUwFMMBKxXJqJme0J5BiKs0e6mPj99QUssIHum3OVewLC43tw8ah4KUp8TvbLiBGRZaRbnFsX+ctb7fZP4vdUo99cRlM1Wjc66lUTSIzabRHcZQuQIL3XY/+56hQYnOy+i37pQ7d8+U9+7Kn7PvFx/Lv/wuz666y+FbbsIoTLzg32kMTsplp5DEISBr3AfksRxSI0HKEJZgraM9Ku4hiLh/kiTDq4mVWP9asryPtMdQyYFXWwECK5xfnej6xYk5BqkKY8JrnUdYDC9QrD2mNd1OdQLf1YGGB/Vz1Zjuz5r1n7asKn5jEelNcRuydPIL+R3kxkTrog9I5/A6GXLSfY3HWRDfW7wma5+wBhz/Bb3AgkRXAujI139ucGUSL5SiTVJeEGdLLPIGQ8LRYCyt2FMZRIKnnTK+DEF0V8q3hHYHysWl6XYik8uxZjKpQABSnKRphBy5zOjzmKsDlsySPYhTbJUVYXoVP9LiTOiNsF5CpD5NSsneq3Cezcu++L/2F926u/8IcXUpS9SgmLCO3VaWVWNLQrXTXlk/vW4OOhoAhF6M8bMOhmY8GFPblQ9XtxMgwN3C7YIixweB4elvqJawOIM830RE+xAZeL5nH/poBx0AgmXB8VRNcJiKKKokD6eh9XQS3hOFoboUXkgV0eFlz2Lgzo/fNi6EXcvAaTsUeTd1MAIF9EAbyXcwP2SeguzP69CAo27EHooZq/hz9MEBaIn12BOIWMZ4Dwf1j/Gt8nGoe7ksW732C4fcp9PLq53lDOcfhy1Hlx5cLOv2H3X/74//zRp0LT9PT/922nnt67jMPeOl8QephqLwMP0tBXjut1+Eqx8UX2K0r7VBcme785VQlEViZxFEBQBkIhtJ57zNIQJCgEJTc8Xwd36ekDABZ0GWBH8a72d8/gKs+wGjZODST9+UbTLgyZ7puuroz1kXrFozLqyqqC3cBEKv5XBUOMU3Kao7OWilhlGepizBEOWf3eF/H+hZ9H+Nnk58f5mfLz/nCF8VIsY3yRtzhtHLPzc4qfN/osX+PngJ8ZPw/yc5qfRz3Y5cpnOHg3lzIr2I9Vdo5Dt3PMvGZC1AIHD0VSxSLy8xLdxfrWv6MO+hS7HSKCuP2kXdtyXnB7HSvXHfV8CWUEbneAEvHxUt+jLZqWrcta18s+gKd2i3rZr+Gt8v3H5Puugrg7cdoA0ZfO8Y96FKL6W6NimWVXHi246pGeafLtES0zVeS2Flvc/dEeSNyc+wC1K0gEVNxon0cOCg4o4262sIHl+oPa9PLAEk3Qb4EJMyTZMcc+hIzcKUC7voK6EOyIcHNas0HE+WHNVtOas4+Y4jMW+oJgfajuqH9nQtzUhLj2WJyaSnB2GMSU4hbuYazmuobDYusQAvdMwZRvQZfvCXIGG4hvvg3x94X5dlno++vXYLu6bq5Hk5ZPtFV9YwyHRPuuu+t3Xrj7v917YeWGJm2nbbSMv0t66+VNOZvhe/cOiJtUyY8WDpzcZsgRcr2U8+F+IjeXDF7daWHdOodbayKPGHAsVeLebOJmyzgHtnRCXLMS91ET15gQNz/h28UJcb3xtugs4/hIp4zmhfwb61Jd1iVQhLpbg55apbv2LEmVACdp442eP6XphbLX0C3h/5YZ6b4Ki5oKSzxz6sMMjR6/IF0ak/6+J4r6Y9pm0oyfPFjqq85pjS0x6Ey+cYyMH7HWQsFqYY/Pb8RXE7X36w+l4DMJz13m2VUtMu4RVkgKgMYqftGZJPweCP33Q1tZnPqvy66PatlPHTTQdeD8l8hPR5f0igIEM+QlyXiubnTBlFPN9NQY+fZl6yagU63EGsw3RhQgHqca21kj4keYK7zIQDcWP9cUKZvs4WDip1WrJdrky+8F8M2lCQqNQBGKQjEeWLs9ZdTAP2GSC5BRsgrXVbNwj+baTZ49Sn/gzmvwFTLKJszfW1W6ENEVboXp5zvlc38ZbJmIpYqmmtQ2bsdBXsoWF6n0VrvZ0k4n/FCE0v6KW2ScJIJ7y/4cDJeavoylAcTFB+PlAhZ6thWnWm5XJ8T3q+v6mP8i1Iy4rpMHMEheStEq2q00GQCk+gpXIyZK9dClLgDIAxn9vA2MBYfkSRvFSbw0GX1CaA6kX+BHoThZa1FAdUBf+/kz6GfeQl0X4XS5DoNV1GYyWdfDNvRYtumRaNZIP1R+ZytKtKQHZBwbyNWoDhLqsh8kYODxVXYngKk+p3V4leRwJsfjpcPAa4yLgCpTOYB8cBm8NgU6qwOZ1X29LFVTdOdE69dcXcrGfd3fB0hYLiDLqKs4Qh2lCZ8I8/DL6v2Oe4rx9X6EyVbe1EJbHBvYbUFgBdBChuSoWPCDhc3oUQYC1bDnJBKEjuw1uCDkU9NZeIH5nuw2dE3KhqUxT1EpQjmtvnh3WsEyV7uot0J1Zxq+2lELcilES2jl/KpKuwOUv6ETIKxmy6JEsO9fDCGMabsSVwrU4XfFbk2QfiZm4xnNa5S0HfUq51RV1h/nbT/16ZPvS8+a5vO2ghVq75KpBoll5eojXEfVsl8TnGwqz3opuatZ63xAElNzMCjYYObdnu4+hkU8ancDjDS2DFzFkKREoJQpNRR+gD/GtmxoCkq5ES+f+8Xv/uyP3ci8btNIu3T5asoNyvW1XFB/n06VPXkbjzPyKTwo76jELsNjLp/uj57xsYWg2WCviwhxrEQzEBXOrRTz4g9NVZ+uwXjPYkTFcmBGc8wSj3woA9TBATx/tqK0AgwTAEFT5F4Gt1G78kqtkbQB+etrA36Jrmh7NK+iQ5hcxZ4L4w6xHf+UlDyEzZhZhkSOE6lwwMM7A7ybIc+oTRkaByWQDdLsURDe6CkMD3oKxKsViFcqEJ+jQLxiIxCbjzkQ48cCjMOHC8fvr8CxCTg2R+GoTmKB44KYv9gMW7zTiys7vdrITk9ZGMiBJ4uAsIxUjXuU4bP3rr3lwaAQqh6vy5XoEHKHPZg7WP/B/EGSt5vL9zl8xooKyLM/xwa9qKNKxIqjPKNmghhakcmgMbJhnNOYfrBiIpvCBuTcWdk4Wme16jJUPOw479MYRkYdnGpPga6NaLTxQE6BdRu6e51TWK2mRu+NuqsCKlrH3lSZtBZ/H69SWJ7yb0iHiWJ/ZTSLOerWnJ2yNTjsV6x1fjGow/laouaCiTCjYsF11XbpJ3lddeaEbKs1No98HiMBhGLacJB9UCiXp55Lp1bIk/vr2EDXbXdjGUZVie0AkaRW6tAM+AkgW6ct6gUduAVDW+B2iCdghxuDgsUYJx7znGlBrbVVAE1zXMkC19eR9gLV69S+0pp/npKG5p5tTp1SNK4U/hOfZiOvLXGvE0Ms9Hj4yF9TC24+sGIBnVmgDiYNACWD1kUMpxdztk/zAjG4ORJey0K8/wq1ZQ5NKgjr6lZfoy6nMVMMB/LLoRjmUF96GRrtV+QdXRUmeMooqJ1qMDCLNCtdVUzLcK4J68yVb6vC3aHJXXiqtCRNmRJoUdeVBIKQYIxSbkXHrOejN5wXXbCLLl7SliEUccsCNBRXhT+uV7IJivl5tRA5z/TLFtoU7l9P+surqxVPUrq+Js2mRTUVpkpSrJjTGzDIuuQNACRlDc241aUJmKhK7uYpo8XDWso00qa5nO4gzyCKeEY+hUGAEGhKrEnrjjbRiXbI7WfnQEHKGLCQBCpTxjBFdNul30qjlkjHAv77tqGYn/kOxXy0FHOuSjE1uyWYcxsJZuHtO/O7lr/wl+csXSj2X7yyb0fuHA4r3ZxHFV7293qLjXwY58rnjU6XMNSowR+ecIGeK1C0r6RAjrKUe558oe9DnhX8+y2h44uAhc7/LeN0fJEr2VKh492HS8e3bELHt4zT8S3ozJYxOr5F6fii7VP3saHj85Po+NwmdHz+MaPjcw+Ljs+74NxGOr6FpmlxjI7PjdPx+UdEx+fH6fg8zYGOzx2Hjncpo/mNdHzuW0rH3/hYXmmDrgaHvexP32AvsEHylnvlzbY/KxNyT7bJG262/Y7vhZN0WAgC+hWrw6IiEN0HvcvTC8liLPoOT+4tZAMpTDMMqhneNpJBzbz41tBL/0YP0gQ9ZAyg5aTXhUL3BX8NK+D9SzFg0qx7axuaJbF3b4zt7x6taq5aU3fTimwtc5MqScYinbzgW3vVfb7Wx95eDtew/0dgLX06l4FVw1zOkovl/KpPaHdKQK+Np+5CEXlGneo3JeGFXjAuiqpoIokUqP+S8tQ3VEsFlRNyQC7s/5AZooB96RUBXhzCOeWn1zeS6Bpf9n2e/Ln930KpJakdkodIr54uPpbgDyEREom3yL6pmuP6gq6couyqqiPQLnRGqVqOzLRlMWNL/6CpFBg1vxyEbReO8+pyP2Wanx/n58zkMsxS7Yk/c66+7Sl9gSJa9cIHGWWTfFbi8znbykRb6aRsxnNTAeI1R/Os2zKXqkuXxMjYtKY8sV2GKJOUaVIJAVRfkuy3ZFyhcYtdz5EAWH6bYOkszYOrmMp+W5rU0II+tOAKpgYKnlgiMn1IMulHNsuHqpXWaQZpGm1V7Wi6EvdmE5e5OFWaKVWtAUZtUXaXHstIVPY7MrFbooxV11zJylhtCdCRf9z6JBrulUsCWBeA2gvw+jgrwJ8Vp/N4hGZEKKE5GY+h1ZRywzDLyA89Zn1rUUv1ojFsRiudd18GibHrrCx6XDCy5F3tIPmyfyy2qDsuLWd+WCxlvysjhHubnGacuPVonv/rcvHmssgCwLUkzrns10PWEy+6+54v/z5/4fDBoB+tZL+H0iAD7uKLboWRWOrrTZNZueDVo67ydInhOOdRPMT1GjE0zZ7X9g2xxqoWGWQ/AArqUIFP5FpuAUOtNbTcboQNlWjT4gD+JYDqTaMUbKAns1MGPFQNm/bamCbdpJkxeUpgZi9Yit1Kn+l5kykfvvRh8iRQWlfV/tTpdFiIWZWwvcUTWxtP+6c/+fQ/Xfelt998xOgqiAEJt4kxgS17qTS2D9RyhvSyP76uvOGJi3FB9tnXywmV4+EeuHDtwQDsYQq6672UdVsDqqG1IO1lJgrMxbBa+nv1uMO7R1Be/+W+vRF7j1f22hxTbrJxTLAeHQigHYe90GUkumy45Nl/uTQBnCr54D2MPnaUfV45DxxCZYCTTk/YiYtwWzmmEM4rpZg+gSvz8Dk04OHiuQFI82tTz4pCtYyYp3pLmEMtbVJR64fYJdS0DfmUK7GDHNcHELuuMzGP5VIJNl663YhlLiK3Opv6DNc23/fyBZrTS7G/WgJy6OBO0wPm7xdvLRZ5kvGW39lxf/9Ds7It4ZbIUplgryyN9qjJLX6oFtZksqHwLbT00OfFZa3EP3Svly+JMlmBUdE7jvwN50pDUbu+ijn9MJeTDPKQPE+LjAOvYPzEbEI6+eCCVMxFde7TTF7TvNpJfIxdsgwTrp4FeiNV7qIGfSiFuBvAcvLlrCtmYCGfQ1OreP7QioAwMOV1VAX3oYav+zLtXyBd82vczXzJzqklQYRqp1MbY7paAw2o2WoDasuuIbDGHhOJ9vnzTH4vk+L7GSodLV27qS9ohNQ2WrxebO2ZMfP0dRkQMo1ZJh/XF6/i7r1Ybr0uUw9RjGjV2B5ad5XCo+/nDEx1kDMHMBVczAeBMkPq6RMIZO/70awK3vRFb+3oImOE5/qSojfl/dYbviVbiHvdFqJb3UF87jg7iJ+sZ/bKS2IYOt+8ey/n0ERyo6zTvu8Tpbm7ywmW7B2o7CPAshUzaalYqM4jbZOZ3rFqGeR1pZM4lROCAP+LcIthCELlC4AFBKFN4TouVa/nHdzlcotz9SZbSRtmDW2Yo4BshqMw7D21VkSq65nPU2RM5kegIHr4XqUanQGO0m9l85BAgQ1Uo2swcAvYGqUaS6CACS0p1eiZWdWlHqhGozKBehuoxix/Qz3B3i1AyoahGluogeQ5ikapRs1QjTmhGjH3dh6HWaNUo1FSjcZKsaRUYxm0YglUY7lCNdSvqJ2+baUaaZVqLGl5uG9TUo1u2b+lCtXo2Qu3vY1Uo+eoRm8C1ViiplCNJXNmP5lq9AzV6B2PavQmUY1lM2YNfd0KCJnGbN1INbbS8gSqsYzWXaXwEKqxhEZOV2Ru0zRDWz8omoy0rE+2fD9jrgpSqGSC8TCPRggERelvbLqtZ+qg11Fv/cmKAbwb8cLaUHjo7VTEqGk8zYlLrJKs+993XGfVcDC2aIoqGrUKUByn5nL/hdDRRO8JGkfvxGeSL1fTW0jk8sbTyZbdyt5VRqrpJF8/R4Y8LDlDx9KWoYFhsEZS3f320mgThICBKnJUze1tUytaZl8N0qf73+wTwkz+fdI03ihLghdeE5SXG86t3PmDtOHWc/kZsSGRc6u723B8d8vxI/tb3QOHVkgYIk74gHr/0CI0Nw8SR1UOlPWKVkUjtmqZW/eiKUgNlAdgotkks1Hdvp/9PtK1aApXsMG8VG7GVvCyadTX+wcIKKi0XDZOeskA0801p6W3f9uVmEB3wNSWi70sbByRnTfBu3Nad7XIjJZTqFpOo3dBmthKydC7JtlLIB1qDvNptwOb0TuTwvwVs7zIqifoKTw6LPmWi2jlIjSkzprclCuVtRiLdxuA1XF7oA4VuOwPVFE6j/j91nN5CQJBCNylTcqgBNda5YZJ8ylEZ+b1XsW8nGDMV/rjgh1x7CoOAyuRVIdi1IKMSb5oiyiYYI8CpVN0wW405S5wR7dNTcR0OeawAutlo4bb+h46gZIvuoXmRZ0edwTldh7xowPVen4QBotv8eorapD0KpwSEfybPTxWZgWThRutSHp2FJF6uDEjaBCi9t0UWmZI3vfgPeH3RKlliMuQAmk5TgIBjGkWH+M7aZ3B3TnzXrMeSg7sHRZNPuVSv3mRjDxFxnFu5zBQaf2wKrjWLPOl+1MZyzzBI8wb4OymB3nL3v5sULK/332hvfmZ6uWhSxVbdM8j0XsqsW8uY6kS+16NZdJhaJCT1LcO35y+OwhgNXvi6Z/HwC0ikKfsb1UyyVaNFvIYz4M43ZY7dMsgMri6EILCn+EO+XB2x2QbIblikpQnflkZIiF/MbAE965KTeKSJZIpaO+XwGEiLsskeOwuGiMkwXdB+A+qvLmgCm8TuYTSBO0TQVhATSCLesBUhUsRLwTyo4OZfVE41hgoQUhOijoc05CPmC7hhQFlitMRTnAhxcl3KhBxF1JQJPTvnf3tor6mF498QmhE1J++22efMlX3xPC7QsGH4TMFjPSITaVk9F2drVjXeqFqwAalnxcUBK206mcPmM9Mgj60mPBm9+Wkkia2xBV5/Lbq/cVQmeFh4cgR9MafK370NMONmiEYUZ9Dhlr6Bqg3x3b1zNwFH9wtK90UDhWYMV51WBPRieWEkOp8+NigBkMLpgXwkCtK0IHMfuqN9qZ9ngi2YCJzPm1bQ+z9OFlOVrOXY7I/krX+K0Hs1vnQtvL+M74FFxid9ftgDbdWgHWcy9OLjRPvMebR2B1Ht9TXpRnSJLkcB4ncoLxsOMwbWBr1ii4UDidImMo4vSMJBoPGIlOy317MbnjQ6gbFQ6xCPLvWBgNzq/GLFyLR2/dE+fcFlj96LdnfWsMyX8Q1oS+eYSkn4vdUo99cRlM1Wmmn3t0cu3apNzc1cuO9TY203/OQuhurt3oeD7mKLgI9lM8jZ8rVXJfqZxRln1SrbDUTtUcya6xuW6uZPzUps8aCkw+r5qc2sKqqdSf3Aa4WK1fSHL3RbC4yVyit1l1504FWMil3t8mXyTDMPm2kuUi+p1bquld1WNE29eG5lq6OuXAIbDtCPJRXA65rZTnQPZQKFf3rw+xPdLnDkgKBNuYBqnZMXIDKsjUeBx91lUrlGX7EPIKxlPgiQGXU05c6AF0boUWVS0jMB9RQ/sU9fvo4tPdX1YquHI7V7Nn7YeIyvMrVsopZkOx+rDPpT7vWtQpf2+c/do17xO16o+dDElOKGmDorkRCT3GTapePECc+NA3VVuygMu6o2y8/9ctPi0jIEuylKRW7Rm+Rj30P/5F/EQXQXSoNXh5dKGlnabUwD0q7hXkIzMarWH1E4HYERohp5IKxeGgORpJjS2uBY4xlTEVjS2uVs+u/IE/UmrQxlzxOWhuYM2Dy+vf8i3GElv1ZxbBFgmuukZ4PNbm0JpfrepG4vsF+UUOpU/X0VGL3uMg3l5EkkRE1KQHhJm91HTdTBsO8rlnfa2xWaddH5n2do6VjIBupXLx0h5eqMYIiTLdDd9PQAUNFgcY6pr0j3SiFiB9f4MDH7aGb2liB5o4OmpSg9igflGDT2q1JrN0ae6TWNHZr+n4+ha60aUq9brbGAJVugJKOJUY9gJ2LhuHMvu42vNTuucvbINrCx4N91KPWyCzG2AJKg/QIFKfja9n/wodwx9UEZmNgU2H61ewPoHq0PEyqs8VkvaI8dqlDr5v3a8qZmwN4wHUBNBv8ufinDCby1Ow0S+Wvouyj9gGD6j0FR1n+097hIH1VEOCWWDnNaMPt2YTE6PfkW18R3/LKVIWQoFfAwZ0rkA7Nq3MrpB+ZN4GjNnCPDdzPgf61/pO99XknE6gbmYBeMZ+DXFOWtKb1m6xmNVvVI3Ph4BCL7WG//ex2gEmQ/YXew6FWdo9SIOWzTA34AM8WDOngigvphq2eOiUguFHm5MTd3An7NMkcfSwLV7+ltuhFv6d/1xt4/iPe2qKPJT77rHmJrdX5t/uhqjd48CgG2dcuQPGuJqDoICQrhi4SgbukUiN4TZmnAGorkU4WbB5wTSf+EYr55Iw3wk+/6nzOBN0vMIh89z1R3hpSY2XDsZnB1aGL4DY0BQG7hTjE3B4q+MA8zDvIXoBr9pReNG7et/Af//qtvxT80QWXA2yM1edzTowutukMQLkFomaQimSIQocVVr6X/aViuFpHCgHusNpLB/Za9lfCV/+D50VXy42W+dzH88i8XABj7AK3k70Z4M8jwy7+i9Ndc0I9XTPLhI2BWtnfq3oKWpeXvMPgsOGg0wfAMQdFW7Lw991yM/79zoWlFuR5ewdDisqZOaS4qlg6vE3V28NhIaZ1pCi40h1Uvx+m/4XN0duzVr0gaieKr2gMVJAdJWzoMLyqBt19dzbtDOqANVD7N/9aNvffevBY1tL/tWzH//x1x27FFr1O9ym8MCQP/IFxVuWlX/aj+jWBMdKmNvJh/792UVsNovAMO+qtcln31VZxFsDTV5ZcT8z+4IFlUJwqGjKGMlI2e/qrDiGyLx8w9w+F6qzrO7QcaFK+KYo5vuiMp2TQFNXGtW4hlMeYjFVySBmrskxB05jqqmlMvmQUu6EzotHRoensK2+QlgDaJtymWTl1xLLjCqQW30g3dfhX9YZ6QNkfXKNXo6Qj5r7cTP/IK6EYOY246VI7qX8Hx/L6iZtKDdDbl1D0TCSlfxw1fWPaIeK/mMPh1aFOBSwlE5YjWWxGJ3zhHc59pfoBRgeDs5v3Rf1RXhAS/Wfk9YmWJRsjslKVadkpeoSNd1TVUVvGdFyrVNqwOfewy7UpJbQws6rEF8yP0aF1ZUy5YOaCHRecBkan1GF5NT+mhtW7YaxSA8MROS8H+cLkOxMuuMUFl4SJXyh6+/Nlms+30ly+bWLlmdOhlubTNrA6C7SMqbcVGLJtfQj95mlGNtoKdRvEQkN2mptMUxAwL+TbaEF0EgRX5uUcm9vdAxosMKrN4NQ7X6QtHOpyqMvP2SEORTuMWUv8toVPxadypC8xWg/yJeqhwMWbS2NIAE/XvtbYbWmGST8N+5o0zbS2eZ5yJBlsFFPGMQ2+iomYKepkb8RUcmUVU2J8copzJeeBpWmVeOYku2pLl2KXVN4V7ivCfzkKm4LSzqTVQnkvf9P9i7LX7jiJouxzjpMHfccDJ0P1pxcJSKBRDUcy3kP7rpa9gG8UuTzO9nvD7j6U/6a43BDEsiGAdUZ+t2bby10A0F4za0rM1HpkJ6AECx/D8tUCB25dKPV7ZB/Qqe4D6m4fkNh9QN3uAziUiMFztw+A1FJ2Ap2LDcsegdGBRk/bgwvaqeNz+iBtHJfX8T2+NZ2lKXD+2ts18rPP4xtS40aITIrM3RDXtjHuI5njp2283SroFYcOJk2nuj/wUiwKKC7PKvU5IP61AHFGz1yAtTPD0YKTDQXH2A8l6IKzupxKjJNpNbAfahiZ9jEGoAJ+vwS/fGTxzsCvrjxGzHhtl9WfCSPgvC8MrlXsWKjaN/3kApwR3YcWoScUYbOoZ6B34ZmIWaGjC+RDU6MhAr68qWcg0NGHtoUlvTho4+LaUBXAIcyUFb418DPV54AivS4KHRW5ZtzHSRjS957Ry6el1C6kpR2Afhqlf7fZ7c/Y8r08pCnIVWUVDVW7s4PHvB4XApVmoKa7RoEemqpdyjmKEEiQOWFNTooszkQA9AI+GdKCRpZyvQiIFNEsxntW11Idb9TjDpFMjDtAakqME2B2gAEdynQwDR0L8KaHKdjxJs5oBsXSPHsMpmSyahkBxUXG7AWGDtwagJf9jTaAh94ixqv8QEnhyIVkFZeWUc/DcWPlgsfzYch3/JwaAiXf0MNdqn3YGpFvhGonxc4j5CWvevw1iZ3ABtXLvqAZYCZsxGSU3JOqOsYu4rXcr1bpYfegxtkfmCdODd1pixo2uyv04kr//VHxqPrmLvclz69cbcOmxwGporaOj4blW0VxSEpbK4LDFLjkYRE6GIaV7dFtEJNkf6qbWYKdOn1BMeHwcB7IFKpuaLh1iKrulW5+nsyMyVJHQM/BbihDslkvyMNZQ3TY9ME/TP6J9QFwlpbrFp18DUNcM7Rd8avuc7VX5Gl3NKz9QKja3lBRSFoWSnsHFJoWoqkeRYOqQQaKR5oWY5dsm1anEDNL3/RkCq2LuXUhpKPYYh6mcFCBJHlV1FtLnwVl4k09WHz1DdU9oRJtSfSdBVi3L3yYV1OwR70a34vlSNzJvm8eT92mD4tA9+nAKAph8oICXOkv8xzlPGKXVFIB/PNERpT9ncil3wYJVVgxCOnUk/S2XJXl56oZxYvQSZNvy35CZQLqNq26Ay8AWf67vKd5cProYJz9E6q3lyv9EcsaWhOmuMrIPBTDw+6a4oJaurqSJnQSOV07KKjkVPmFms6kCJ7Ou/jCZRaSU0ZkR4Zrg5tRnl/JMl6eDxuBWl4mirqwM4Ofx61kf4kc5vJ9TRNh/OZ0w8zgCQAoNIyfH+s1wnNG+R7w/cCxtVm5vveTPBGMmwFrBsOLeQNxXBtYF35XG7RXkd6XEHGPZYW/qFwpAI47BlhXJBRSZEIJ2EAvhVfKtxhiFVGS/Z1lJjAhWurjkqNvMotQa6V0eDmiRoRptar11dBESBHF1n/OASgsJrJVLRpoZNlAgK3qU//92d+jaHshIaIQFv7l5mWiyozuUwgGeDH+B3xQjY0Re7+qvJCHigNVTix3zlmpN+B53stVniHripmiEF0IwAFjEaHwJ4QzWqD9SvaTuCSQ3YhfbJGZv1fJWzCaFCg1uXSi/DdkVX/Y8MLzBeb5MqVCBz1SjTu1GxtI6JnEWnCBNzPu7xZ1P1OtolwESm0IGVg8UMZVbrZKUr+koJX8/UQE/wBuvc8BiGKS/XlDuioXxe8TDjEpuUMUr7WcIaaPprSmFqWohWJxhBZyVTgz+LKAv61uaPBJkREXP43wC/IZavF2Wy7oYMcItie7mMuYfvZVenMXiAgbz7HxPeCL4HRO7nLjZrjYbfCoLq4POFtv/+pKaRFrnhrSWE7gYi7urVC00o/5XC8Qj003OtP4KJN8s89U5FCjKvZ+a2K4uTmIgfXq+aUO0jVqZl+R2TIvUVxJMado26Z4FXXiCpjy9S0egXK7q0MQvNQaa6mBD8++qgctDj3viL3Fa8a1NGqwrC761Z7oYXvQiYKFW+kHhRiJ7B9RmDMLtqoMouYnD941ilht4vEDHKrwdCFsCrwGAhZAHoakTCT8/H8NRSq2hQoDTw1m1RTbQG4F24IS1YKyBUkhpnSyf0JKoXyxcsmeCOSpvl+tbsIKu1pjo0ilmE1MvPB/UMiN+B8FDu1TWEmGOuVFPdTuYTQ9Gcc8qpCZKq4rYrcMYreBwBapQ0Vq0xlYLjNLqiJ04BBamt3RZmdoKO7jEP9dwnsddbc0oyv/LLc5n5OOc0gPrOchoZEJsCgd09v1kCVCWgP5/QJEQSGDAgYJ/gfNrfBvHuLS9Yp796hD2HVhZGiOQoFFSLMX9agLamlEppzkSZJXTWoSTHlNM5gWjT6vKpJyYpHCMxVmhxiTaJK+O/hC42qDD9pFpCyaO/o6XWSSOASpUUsnCdQ5ymmS6q53ijydJhGlOk104m2cHzGGQKdHQAnGKCgvBqccdgQ9Djvs1cjjP0X1PNDBDRVFpQFSOhBVnftoBtu6IjboAqlNXc0xYwXBlAFkFX9UFC1f/JDa1GnlODiLlBYK4mRf10mg9K+FHgdQ0MFAFPFKDjTjx5RaLJDrEaX7uw4YiQDD0EZI/FFNIRSBgpHHKUWIyAihaUT+pFwtIskqEaQZEHxzxQUeqQ85jCXEqfKcorY821bfvWWvFNd18JQsS09E5B2porFxb4YlIPtnFZRIObG5Q6Rdj3QY9UjQAtkMrvXA6cEze12XUW+FpwHr+h+4ELBcfe9P5TM6e2fJ4+/AXbjBipUbl3klqEeJob3u1GZWO6E1NZEmd9awp9+fZzo529SU4cVYQM7fkkpaVH9xEVMTGBFTA9OT33QhAwXD+glAYCkJZI/fXuVuT7Po69ltD8oC6rEt7kfsmA3kNKWMO7gq88kYcJzRdWmjK0EdMwWnzsBRJeKYAr2rBk7Dq7oiwyDmPIgAeMvMygRxiZVAKa9oPDa8YpLHBn/MY4M/7rGBm1312IAWg9c7tscGXz026NfGY4PzJ8QFXD3ZY4PvPDY8qNsL521jzGODt9FjQ0CJdbyR3X1d1WMDGhS6Bo11JUSDQtcg5/Di/1Tw/eKjA9+tr3uU4Pv4awV8v7CcnHaN/3Im1uZvqnTi5FVVOr5aW1FCEsik181whcTKAqZs2UvyWFfYutOKSPBIhPunutgSREQmqjpgCdQbKIJtjZlyMR2NyVzMNM+8Gf5DWQHFIrKczZsU4NxOLKAppTQcY9T3X1rMQ4o53w9Wef2fB2Ow2IcFrhSLv5wfYvFom/V4C9X44hfuaskNp0AufrlXtCGw3uCrjgi50hm5b04zqzmv9xiXGsLLuIuwgtBWDi1KaBuH5iW0HfenXowQcciXUI7mS6jg5u2QzdwOIuGi853ykuvLSfJS6MvJ8rKsL6fQLL9s1Zdd8rJNX06Vl+36cpq89PTldFBRcz/tVL2cBx1FXFLLz6DTFTB4OZN24eUseXkcnYaX3fLyeDoFL08gZKTiiRTK82y+XFY8iXbLyzl0ljzPReQe/uGtF9ET6Ew6AzHn0ePpcQicr0k1OpnQDHoinf3Q5zwuk9MRkEyPl1tul3INn/dQAhLOoHPpHA6Mb/vwxZn4OUc+y4pz+TPbgpDOIRTD5SMaBaD2k7T2J9EelK31Xab1nUfnI+5JEscdqxSGD0xhiLaF7URhNe6K9kA+vLJ4PDKeQWdq4xG3m5vpCqtxouR5HOdxhcn6E5pbj4FeEdmBRWcHzSgDsQX3W7dQF5GMcRzZ8lVGIbuqV6xM+V7NT8tp4h9zmkxxJZ3vTJPvTJN/B9MkSDErghfl2/G4uO3RdkwJ4iK2UZqfZqZExgVOmylx2sOfEll1SmwDKp9O23gG6pRgXCQS9N/Coe0S6gHhJLQM9NcJw005VdD/VIvXT8CLxeud8rLDzoVZftli5wJeenYu4OV0MxcqSL5rDMlPriL5KRUkVzTYrfjMWIBo4PdSBb/tcO2mMzBSgmcaZwY+NMh6riQDQf/kvf/lwuofhh148Xh6kmDvhdW/Yg8nChJKdYo055CNPWMc382csVijuP9Eg/tnj6DrufREFAisdRj2BEVXO+EU9yegKz1SdD0VmHmqRdfT+hlI0jZEMl4Yqq76XFv0EujplIIiWtTawWgY8ujgCepzOtDmFGJKZqjvLo7aIsh0aklVT+NyTha0OplOU6zYLS+7LI7N8supFsfwcorBsQry7BxDnpMqyKOgO2ucDiqIzlJqp4DZrVB+XEm/lG7o2I1ClqPPODHIngwgnmwhuwNSwh10OiIZIBqZwh/uiwr+YXCxVWiV5KQ0ByDNCBlo5gH47fJanWGJDYsbOPY17L8AUBFVtFsfhJJ9SSBAFG5C1LFpht4DxYXUOp/wz/p7dfHGMEP9qF8HrKFehIW8x9n4bRnroxLMXNH6yvxseVL+JMXW3JD6/FydfPkeMW2yAxv8mg5vDcRjGY+TtdhT3KqIPLp8zshrgAVUMp3Gj2B00Tx5BCUoP0NJyJK8nKl0VAgHY+zpdtEkRtuT3KJZ4wUwlCfWv+LJtFteLqCz5PkURD7VYI5bNC+0i+ZeiyqnKsHRJYrLZJqy6ZJoVtI9I2voBfSUkmScP7IihnS+5tWF0tZoSNyT6an4Ttc9upD24u18etJoAZoKMucK2KXz4DxLbc4eoTNPdAWAwmjq4zRaCziBBdGHiNtsAGfTv/a8+BryVHoYvFQ3gz4OYoNVleGpWE4TVPSogvAxQdxFTronrnFjOf9wbthqSr5Cc5YgHsJUthSuZA9h3+zEoCpuR50Xu6vLIba5FYmn0e/xKZBpS5FV9PHxuW/7pPKYX3wY3koh9B/zVoq4sOKttLsKA4Ei8L+S31aO47v0nZ96x6dqpe/Sl1R8l74DKRzJj9Oc69JvvMG5Lj3RKp0jUy4v+6aCNDtwwyR3o5C5ZtciaYPH0Vchrpa+3/d8CF+CivAldMIXiQ7hxDXiOAVVJOOBWnQYkCMPtfFotv8MpIswT4WpFdlKgAfH8gM5rYw0FKmG3K5guUVgKwhMBejxmOQq2ET0Ii5j5QSbAucydoLkSgCuza02dbM2BlXB1XE0Hr75mg0aD/5jqfHwWd+rnyiO68AV8bF88sYn7pP3eB55UVC9NOBYJBTxqFcqiWVoceAolVS98GLg1QuvHlyPjn+MpqjfXR1tiKkgJ8M8ACjLR6gPwDeWG1jZ773WzYz4WI54nWDth/WkktMaEIPD9PHeq4TSrOK1fpUwEL6uhqBvQJWgPOyhFfEmO4JQavipYNGcKqj9V5l4sG3zxTdXbNt455v3OdUpyB4QSAqq4bbT4EG9GcAw5Md9yGqt8nly0C6gqBb/1dHi8b558R8aKf7+Eyj+wdHi8b558XePFP/ApsVvrdnLTVTLvilPhMyVpWWdZZ82lyU+9qlrD6IIvS+xFWZmQ/04+50DGz692PPHLQ3BfPDvasOyG8TOuy+TD9ijBoTeiNhRA7rf63kGAjcY20RY+OBQhV9xO6ulICiqVEI7rlkEXPrxt+AyDFQeFPeq11B+/FXHvobi19JpR8n6tfNrUZrOyWRoYZiguvJalCHWKFVHTemnL80TP1yM/Lyiy+8e+a3hZ5cEz17Zn5s+8aeGVUnrNRCY3el/3MRFec260VInxTakDLW8ZK9HqzT4ho2ez39KnNG9UgHoG4KqBfkyNKf6omtirxCB9AhFN2drusQAnKq8Ke2XCIQ4LtVBEUqn+T2Mjj6wbCA6NFGAB2LTH+IRNzUA3IonChtkUtbGDj8WfV+LVO97UqT2JrtZh1XuN+udlwp6Xj+KngeOj54HHHpe/6+Knm86Dnq+HSvfGILYE1Dn7EwPi0JhLytsAgAmN+jU4XQRYC2rU0T8V65lQeldXn1xZz+FRhWRYDfF2nAwFwYZI9Tqqo5lGQMmGDYmtsuYr6uWjy9aulxJofVz9Ft15x1q6Vi6UInUoHDAA2nZT6NBS4Ic6nnMq65gP4PUfyNQ/cS3G6jefExQ/SRSheg9D+zcZGuyxvqjbmpk8sP5hziklN6iFWmVpWjJi4+XQtgSne48iZ4stZjjesOp7e9ffdV+zlX11alJrdI5J1jEDt/EuZbXqOwbupAVleNH3vpkB7Qv0gid2Y+sUzd9m3dqh9A1ta/nC0ud3YJcyJSZks8tmxTC6RdWCu2tRqKp09cjp1nLsz9XxvppTOOgk4FmS/nG2nHp7RR9RKkrutcAvUUdfml6y6xk3qNZyd7qVrLb/t2tZIPxlexERryJURxK7Fs9JnwCTlHsYLqErSgKcJgIb5MhHl31RhmS+GrMY9XI6asuvu4W8EKR82uH7tdl9MOUIlQTYWbgDrlV2im3jII94jvSWvv000Qw5Egt/ZgX4dAe/s49ZyXNIYtod++ZdDmk8MXRrUd4ds0z6au9JtibRr0hUAFNE61qOLA3KBFThIc2rr8HzeqfrTAyeZ3zidCCOui/DLmvVtFoxXDYUzx/0pzRkZUZk/28YvGKmy41O11+UPDuXiEN6n7pHgkvr4CEVHyyitNH/OyV4Bni/REfwDWusJWs/rRi/wyQ76k9mnn4djcP3/Hvbh6+8xHNw8eOgiaPZuR+yY3cHf/uRu49j2jkNm7y3ivpz950k0eym1veL1s9Knd9u2S7p5Nx030ePZqxfb8b21/9dze264/J2P6apH/f6Ni67bsMIQZWfRM/Uwb2AvxcVFJZ8icP76Oeuh92w/uRf3fDe+cjGN4TW4I/uvkSfLb0/gJZUPeX1hd3C4EmWWvdqKMjsGhqRjp7NCP9MTfSv/nvbqR/61u7vC7L6HUnLq+PngT/rhu53/t3N3Iff2Qjd+kJjtx9uJcE9wOOL37Oyubj2H0043jUjeMf/rsbxz96ZON40THH0Y5iwqfipCMZ4gT2WzMPP+3G70/+3Y3f3Y8JK/Rnx2FzLxLmZ59wQ7uFD1opOd492KMeg80NH83Y/i83tv/7393Y/sUjG9snHYsPglgxm8D/6GAdeVSSgr9yg3Xvv7vB+ty3lpU5Q4U8E5fAR39q+Ddu5P72393IfeFbO3LqPD37Fsl4/sGN3P3/7kbuS49s5J563I3iLv9IR3mXzSjlAf/RjNo/ulH72r+7UfunRzZqT+ZRc4pdUFcTgBoFOx9WDAs/+7oWbpkQ0/iXTvIZilz9oxNMe7MqzcTYXZMil8ci3VD2Tbf6ePVxkvdNc5KnbWdgHFCXXIIeCjItNsBpY5L+5jMS2Kd+/DWtlwfXxC+vGC08yqfRkdajdrFg+Qu9vdGnCINzAz+hzHC9PoOBRxGnXO9zwYd8hE/lJwznIHrgcXTmgjdxIypmkwTCcDBU1PeJ+7/1r7HZTZNh5959X/wPiP3DCymy7mRgf5jrzhM8D/p5A3V7K1o+4JW9WrrezF6DZ45DpAdqSKmvsBpr0VIfPTcFLyzaq9C9fa1kmxL4+HLpXmM6FIlrcAqyg4iA7VV8CwSpUwxT4FH/UKB3LhH0JQh191lqiw+9+UAsc+Dvkl7BI3OxHHylOPRPxefw/mKx78Ga6yKwc6HPAVUP7CcU9vKuGD6cf0axxdhxnZWbNJ7CAPYmMm4LJm2avU6AE3LPoAnarVholbryBXnWiiVM1h7xo5Uv+3sRgA0BPZBa7tf5VhstqNNT4uaURoIGzleas+4vZWb5Vpj91LKyYjsecwUxoBBaznO5jbqcF/zcwTlD2prvxMWHfBuF+U7ajhadNHIrtYDG/sm4lbqDVQTzU2gnB1hxfxedzNu9U/HKIYAUd8/4lWlnsAoletyf2JmfSdvysyjPHyenjejMDBwEPo5Epb4Z6O2BacTB8ozGON+Bu82tox2qbL2bTmXd+tNy1pLn2wGn52fTWfmTuORX5ufQ47k7T2CQPTE/l87O99CTpLZFHOE9VAtq+Xl0bhlmbfcy/GQKyzBLB+lchIqn0CKerJh/P3TxQ3nZS3vk2Ufk0/jnoRRDgc/pfDoPsd9FF9CTEdhXJvMllOLpZZ4vQXV/L/UROB8Z91LEtxgGPpf6ZY+eQk9FylPoyXQBB8bPRPGJVHCBfhcUT+XvbGVP5+qlnL2EaJQg0a4N30X7UIF+fYePr6HT/zREXqiRQbF3pMgLpSwuee/EInEjQbuFr4/43C3pyJMR+WSNDIoLqkVy75CJv7zAFWkvjyzisUjn4nEu7cFjD/AB+H4OnIKc04+hBE+Ph+o/48MT5PkEeqI8+ZKNPM+mJ8mTLyliAu6mHbpinEq7gLin4XEanYnHmXQ6HqfTWXwtiNH1cTBf/Dg6A9/xDbLRu6gnubuodnL4/44nx3cmx3cmB26gFriB+gw8LsZiAUTHxT+dEKfie4QTuX51JqYCPWMVxe3kOhE6gzH4u3k+nMzz4pRHPido45w4i7H/ZIbDGQyD07n/p3DfzzTz4ul0Tl6bMDd2BYzMlblRq8yNxercMCh/AS2aeVGrzAs7oKHigQwrUNrE64wr8RvILTj9jmc+574fe/8XLrTP4imMBcVTiScGEF4NLtpn8TROFPySohUTgbAae8H4FEEzOIlQajnNnmynC2LL9lGfnqzTRTNr9C7TnadKtXamPFmrPl+K1MhRtN5F52tpo2itqHtM7N6Fxy56OrD76Qa7zxHsPecRYvlZdCpQD3dFGd/OwBtuw58GLD0Fb6fQmXg7k5GdgOzfjc+/m55h768WuL96JvgjoPQInp8tGH3mKtfarwHrGQd3chF5/sRgr0FMeiKjbZI/GU8QVs74BKAd7WaUfBx36+z88UBQdD5nipCHjKiLjKjnghmsIOZiBTHDCUjo8E9JcBXxnlySUx06S3+rGMDRSOW8553omGGU9phR2iXQx9Dh+fTxUQNYn2BH5Ul0qgwVIL+bHoc3vjGIt7N5XDMMq7nteqZ+kFNBJ72o4B972xWurHM6iXbwjXRQD4Z+SNtxwWk7kX7Ug3HMxynXHSqFUWrCKpqfwJXWkqLMaOz9iJ289hKz2zz0C3y79RxYcAI7cBrG9xw6zZC6x3M6P57Aj9NAExH3RKQDXUJ0jVlvdPscZEOjd5tFIX+KBvz8qWY+5WYJ8nOzLAZ5XwN+/jS5WA+cCWk3OqXXlasrPBpSVJf5JyKiutY/CRG73IKPRvGcM6v+dymCyeJdXES75OViQwK/B5GXlGtYddV/pl31n2WTz5am2dX2u05kOQdFcyzCxfQ9Je3aR/0KbkqHaZ/m1+Xe1vp4rfUiugTf6oJNz6Rn4W0fXTihEEtPK4XssE3XBVwWf7fGP2W0EKWTOoEcZXUTCHMlNHNlt8yJ3fb+/GnGWrxuFWv4ebouaef2+WL5fiYNU7twQV6tLD6BE3apfcA2LhGfy1l4Cp27H6FLepgY6u/v8TRPbTqXN+CruP1Mu/SO14uFfyC+fY0PWNF9zwojqOxf80UQHXXcWhu+X93K0woi0EMbaW2mq9t/dP8aBhQ6wTTBUzouxOBcdPBcerq1onlkC8y1zcH38RzNQ07HLbQW32ALD5Yw8ceWE/mJe7jfSz4MKGaT9/3UAWAWFD5zRkqxTD5MOcIl/MjGf35/UdONP64icv0cwMZf4I5tv8oauLHUxeb96Xi08i2QuyFUbJH44ulMVvb3Zc3Zsp4/m2t6Is3le6Q2DBwFtMxU7KZgVSBmXZccgTPR+NbD9OyhBIr4cFGnesWi+ENz+fmoYm+h1PNcvCTF4xm8GHWMjvadIR7o5XaZtjrp/b1MbCGYonNzxgsRWpwvxFxWCcww8DcoeVSasIszgdwpWeeyfaD90wVV53kCxw8GK7TlSkGScxX5TDN2lcjG0dZ/1rkUcjSKWOQkimkPNxFGf4fG3r6nuBM6j/5ctfYXeFPssggDegVseiJin2jFgA5FlqgrchXAvZSmbFFpyvyJS1OWICPqqFBlluZFqNJVoUq3FKp0nVBlixGqwFz17P/NQpXv7Bu/s2/8jlDlO5PjO5PjO0KV7whVviNU+Y5Q5TtCFXDL1OnxwBjpSvcxka4w3804MP8d6cp3pCv/+tIVFauQT1t5AjyDMW3BCFgef2wByzm0ZaMQpcZr5CLtMrY3Y6pVZCbhCiIqghS3GcUjnCRHoWxcjrKAInL4sfteyFHaEKe0aSvybLU2+iOaUs0Q7NOzb0BTRUGQqR2mFFpDc9KabCD6LZocVpKTajLc4Pc/XltxpVpvk/BUsFc/a+KzfWOfLY99JdFZNfoBjVallkr8dap+wioyqohzHDNVY86a+8GxzVRdhK9VvX21vJu7vCoGI5x/UNg2zF6PpnTSsfg3IP7h2bs6lpUAf9RKQGCtBLzmMTZXAmqDSaT2HJ3BkhuO49b5z+MYvifr/BewE2d7y7tR+l2FM9J4RUbjJ1CW2tAbxPi9NS7q+/sNcTNUOogcwpdG6ZVvkDe4hNtjcZTapAh9SvGAB2UkqFV2xITilCHqW+eihwJUW6fIzNEi4JdOkdlXf+DcmBXTGMTDlYiZfX+T5n/90Df/gcPBYfg+R+vVZyk45mBg42xby4D08BD3Dc+DQRHxQhaIx6I6/ti2/6zSnDm0k4LzgttjfmqL58Tj50oBR5BaW139hR2++bzgDuTjlER8WiJmPVYocL/Vsn4T+Tvi4awjvby84AU6EhzlQGDcO6hZX0ItHDcHcjFHs0ouGhRSQjM0M+Becu+H5Xi8bu/ag0Exj9z19SJYG/Bb1Pf7jPw8y7lj0Us5jaKXZL9XtW7oHCtSsJYHGKyu2FScdf7BFmSHMmc+4CDSZSBpmtsiH/FoYuRoYTC06HLnoPDV8fNwUCwCksjY0ox5l7/21Ru0lNEdDocCRbjXXqSU85hxNciU/STenL9XD7BEc4u5i5XcVtwPL4BReUbeobm8br1CdZ4u2TKGeKZfj2C7c7kf68Q4x79dR7B0I8uTB5Pr4VORP5xLjZ+EqyOejj4/Z/m9NAd2v+f8gQmpDCd6HYvYekpLSeoyKuEhewsPc9z3KBYtuvgcWcAeFG9O8foa8Lz/1JUiWd/32R+b+8Xv/qzPDhz5E97ZFo3sQTE31uQP7ucP7HvK7/dW3luQtkvn3BTM2yVNoMY6u1ZX0XxsnOFQo+rB2xOPOFOV7wdDHXhxiFhMs7S3HDqZjW2a5mlflvBcrnxaMImfjKQYoaDie7WDR4e8yvh7lGGNzmQ8w/4djPlp9r/VFw6FCsAQgJ7jt7kVDDl843nZh42iIK1oQrJv+m/PvPbmn7nqKdlHkJTPUIgUxo6BRyH0KrM79RuKXZxijNaUaU0wSCNavDPwkj/Lj2VwBTNo/Dw/zmZWQc8OLMDrtMguxQNqbYRtoAK6xXYFbh7WBSUsFroeeQwJQMsbh1YVPiBlreyIdGOGDVrkMR578g4n3eghTUHXRXQt1w4Fd3jUpQzucfaz96jWC4ulFQV19lGUBOP72T34Tr4qepiFy3oSsNUXJ0mQ14NNQ4u20RxSttMCHjCUntPW0jQ/8baztbqCpJ1Yz3ljco9nAkdt4IgN3OEJfJb7CS+h4/MoPwmmqQGvnZSv5Fkf9p6K/BRQtPxk9eFkkCYGmejwhgOOp2PZJNApJmDZW06LsUWK7SFJJnxfRqfI8xQ6WVxH0vKzkBhiP+PJ4wi+l9BRfdyDCBz/nMT56CQueuChOaNzSVEMbRP/8p51TWmtwZ9MywCs9K1DJ+NULpbPOvoJFfoc4ttt5mvLfC8rGdtOO8xavJZ7WtQpaAktg/BLCUVGGUrzABAp77DDsqo/7hwxORV4FNZS8JJUeCJDSVtpCczhzhUZm1OOP7QFD62M6cl5JmNaHG9Mi5PopOMOZ/FohnHyEJ5ih/AUlH1KOYQFLdu5QQU6H+/XWXsyN9iMZqx8U4BhdFB/mYV6SB67eb2FAjqZM1Y88BZMOg96SEeajhvm8pyZvLfJlJ3lt4P8phMYk5Z2oveoFafOBz0Z7QXqZr9ueMcZbFpyPOaKJTQfpIS2rOi3+Q68LyNEShBiEATgnxKA7dyrXCndiWBFTAYhCkGIbcdCiGWLEDvyjE42E335sZ/oy4oh2x5DDCkMhij2FSWGLNM2gHg7LQM9OnCEtoM6K0B6PDolilDHTnUl/BZVMqCK0H9AT2c96XxnMHEnpIyTBUO0KJ3goGYM+InzvLVS5G5md8/x0X+At9yCLgrHBN+3/gr2Fgp8vhaQ/YasGSZGl6Q0+5iurBq5cXXFnj0j/3l970cQ7BoAPnAhYl7c51NonxZBbRYpYVE9bAm7V20iqrGtdAs5FuPJ0btWNvRJo5cnR2eTCmlNyJpOiGuOxzGb6EzAvi0M4HY4mORhdNQVbj/twyfWFFtIbvCzcUkPO3I1uQcz4fAuQPhhv6N/iFZmf4TfPLRm7Li0XSh0fd9PPP1Nd+fXJnuth/L7LmSefTeudVGNgVNxA539sZQRK7d6kXC1qrNyXsCCHEgoSlTgHiqrWadAxQUBGCZ0JNItf0ZB9kkUeF7wHHPSFuj9p0B9hCXkg3/PPqW0SCx2FQkee/XWksmQS1ySN4Axz8ljbRL5jN03UwOXw14Kr5vrph/aUw0NbHBwAe9nYrTExxzwKamaXtPKLxUzbVyxWIHTKR2Rt251TPYOKeQM62vZpxVOkp9b7K+UIKR4DfNNKzFVaNmJ26sEFJQONRVNgqqh4HNrDg3CFbnrxZvY/gGfr+2j4iWOz8p4G3c82Y3aMT9xE+MPeD4kEQZT75mxqKr27fQ6fP9u6PhwZQf03wMXnhvYSh1pjEolHHXwjRGENfYZJhkVyHnkYzde2XCY4K69a8ocu72My3TbUEdDwB5VdhMRCAUEl/co3Q+yP0U+rbjvYS5lfyag4zTun4P/X061o2s8XCO7Gs+6bPrgNK/x8ri0u+eXPsMBXfE/ztBYye5TZMboHAqKRGg01p8GnIXAG6zmg1gRy81c3hKBivh7DqgBWUQD0olhEZZ3xRjvRgQGU7ITXi+ytfJe2fEkBwmmy3OkoUVIIQQ00wPi0GEHssOIPDzIQ2RL8hlpSD4rjcrn+kfVP8M0fw3zqrrGcX1Yk/hH1zjZsBOLPg5TtlbwFolzD0txxRqXpt5qiwUsgRHOZgQexMEuJaISpk79lmieodPDS1fW/a0lRkHQY9leuFKmtvAkmIzboUpGxI+wyK0qWQGf0EPpDtTAdhCty622nbScnxTshUMTWqKdsihXmAdeMLtyBHYKLeYRLYhr+AWuVNbYUzgTRUhH1lMEDpwrwdqaqL/Qvk8nsdJYL9+FNRkHpafSqZxb3vQkQUFvn8VpnMopyMcP8rn456B4dkxD2rT8DDMQ8NuEJmAotBXIVh0NOoUb2brurt954e7/du+F9om+mYr3fJd94oTi1DL6N+wT0Wcieq/IhuxTwUOSctnSc9939MP26VJ+5MrgrNdvWfugfSIFpXEaw+GU8rD4TvtEX9B9tJrDeOA/dOGTew5+5G/++fYP26d04WPved+H3/r3+VPtE5BD/Lu/79YDz37lmz9inzb+0PzvbRl4//xU+7Tx/99/+OjC6kf/4532aeOf+QP493MX2ifitQ9QPThzrJFXf+oP/vP5f/q5p9inFPKFW09//ec/958/Yp+28Fd84z0/+Fdbf/up9mnjP/Xcj3LjTrvTPm38zz+QTU9PX3uhfdr4i6Vxv3mnfbpGnkU8np6ZMPbJg/m94+w2j8an4enm+4rdExIfT7uBiqfywP0+1+ibePvkb76XUMBD38cn0mfRaYSCTiPW9dHPKumnUUumgWwBnsAoXOfXNMTzDHDq/Dydnxk/T+Pnbn6eyU/iaZeLbEWYiCfI3uOqInoxz2en/wmyxvqfM0MJFKFQs1H9z1OpzkI0kg85mNngLNU1NBwW2TCf5jSyafye0XawJHp6fzZekuJJUBs9R0WqaBfT2o6haOwujCKZq9j30pNUbfTsPOJj8gTz1pKOmiMdKLlKO+hczgSInN3PUGcHZ3AdyuUMbhsVFEJtlFRtNNIG5Anl0pyIImk5JULtVTM0AuyKs5V8n231NRPwKUnZALcxsKffu0BImIq9Eo6gdqIVTDSVi5mrLLZztJWmnpFHclCWb6VIxbYNXfmawmShlb4VxV4bOb8Kh1iQmmg82DK+kO3xM2Kz8vyEgO5qSsAxHcQrG5q+Hk9jPjrgFiO8XMQv0iOmImIO5mUoAPsxJHMKR70EhfSDFT79Pse/Uvi/YPUcf1Vz8gHVCo55XsAg+Qw4VYpXDYPbUO5wWZfy3at6AJLH4itHfUFjOdLKkaaqsg0xCIDGqUlzOf+nUO2VixtytN7jWpFFYar96oJllK97MJ39HErA030/JeDpnkkJ+HApnj9tSKUoX1jpvwH3ofkvkvyQX8qs8cirnMAVgbQmyP5WP9jlX5kDqo1z/DP4AQEoPxKszOf4FyCox5N7JPhFBM+W4H0I7kYQd9ax50DwQcTulOABxJIEv4rYZQk+gGBXgjcgw5wEDyLYQhDCbWPJYZXqgqbZF7Sp2h8kIlZPX7WBE2IbZYzy2Qkjm0XBvw4no6DDtcmoOIqCcQUFI4uCnqIghllRMHIoyMgHlNFBWkUmh3UeRZOxDuJA7EgcooVCbUpECwyiheQpokWKaAEQLTAbkXFEC/SrgAVMx0Q0TxEtRPnHQbSAgiqiedIar4powbchogUVRPviY4xo7zxxzwrhiGcFbxPPCsFGzwrY1dw/6lnhjddVPSuUx9ERtpr/Rr4Vfvy6Y/lWeBNSH6EPgkPXbfRBEFZ9EIQn6IPgykfrg8Ab1S4IrXbBz3Qavpzoh3KM6F0T8J81T1Ib2VmrNOWZKk3Zp2979W0PsPQWlt3geV6wS3bRu7CJxj6NwVzdhmc44j0vwJr3McxK4MSNujfVXWDsxMt6rSY+b/OPUt3RUlHHY2eRqK0aOfuWXWKTAhQLelhH6ektw6J1XkAol9JhkZrCqUnxsGiKLKarEYeLpla5x9T4U7pPJ/MNUvHQgtvUHgz025QaiGlSEzE0oYSWlhBrCbZplNoSWlpCTPHkEsAjcpcTKyTyR443Vb4A6a6Xpjx2U2PCFxgEFHuAArB+V9izhKYEI9GYHM2rA25oI4BMGfmHuY1x9tNoguKgT9mgGlPTRkLOrzT+FgBbv0+pNfZpa7NPO3mdRJowJQvOlLS4mDZtBj16NgbaR6vr6OzLgGuUHS5aI6CIqYWlTsB7GCM+GFJrraoQ0kJ0a8CYUH74fMW79LYiLTvPWYomIBBROtqN5kBjJkMgrUAg2giB5jEggJ7mifQ7n05lxBkmDcCkQdMkMLCX6GDDkWNh1bEInyHdjof5DI+pzAHBpixvqsAkxqM7Pi3d653XwKZQizKMd5Nah4vZIcUgooeLueHgFpoljpgjDhetNeD5kFKeTFLtgGYOM4h5IG6zuiq45jcK3CZF0llV34AEdDQ9Lln45+FVetGmgOa4AunFAEMDxxFtbkyMAnhsNo5MPDYyuyx4R7VjGn0CVEO8bAR8B4CHxsE4zC9QwCcqme3094gZooQ/iXgaTam6YEAcSBwSSENbYw3dfCaITE3Hdlor5HZEjP8eSu5K8YfzFp4ZodLDeUrzeUPd40PBD2yATmvu9pUrQpsYkXkmUF0nDj9fIPFtjPXhIr651FQQIhxBkQbpc4eL9pBB3tReZSiGJxAjwYYBHh3AFrWBIpr3OIMdYLIxSg0c6ZmjVCIwATcSoOYxCBCgpUN5QT6tw8xwEUYm1PGMmGPRK49Im6cOyavIApXF0QL/EsugBF2K4tPPmLUrENYDCTIDhZMIuQmg3eBrtJybdAGQdczF3qyxvORa1ux3/QCqduViPGg4nR7RA7kJ/YAemWgl3pLdgiI0Sl1Pjq0ImlMzQtsaKmvKS2gqaD+OS1Wljd/yRFLyBiN3UzCpXk7GQGmJrzVii5ZHpd8VXcx84r/Le0VLl3UBBaUckV6hld4Ur1BTVpw2YXpQGysr4w626k0xHIeSI0bZIjJnbE303G7fVc9AS4KDawgTDgpziJM9aFd9S1Qo+zdpHQEHqiqUb99chfJfVZXzLcdpx5sf+3Zk3I5sQ5uo2qZbj9Om3xxtU6DRyk9KJYwfpTMjP3sjUgt/3245W1PCgdZC8PZTnz75vvSs6Y8MQFzEDUAe4UHgYbVDAeqfw6OfaIegCsDY1PeEgff3BnsFqhRmPycsfI2pbQisQz4lEHwunGOCl52gMP2kF0ItD38CJHXKK5MCe2R998iDSD4kT9ljpBYxMJ1CkO99H/zwn/zpX1z950+5HMIqihn/VSFLfPi6E1k8eIOCarRlWhcKlUVX2Z6I6pUSkUE5aW0TRXlddbbwvfbMnfgKdB6ueuLDy/2mOPJ49xFWid2RoCR2ADMLOQKgTLlMYBXwyzdm3SJn5zCqKKfcVsSDQjor24jDWFBA+vyblSTVAWDwuVIg1QfD24pkkNcNfieHi4TiK2RxB7Xdw1Sp5QFad9U4SKEeP4cQxODv8t55wV7GoAaGpM7vyulIA5ocEYPRR6aasHGcj0Lsz9fROxTfvx6Exe1pUt3TtMywJkX7lnxKrhikMrIoCWHl0okwYSOGBrUPgzkKaYoiDnXR0luQPTNZuEWlDnNeBo84UY5MCE+3UAzdt5x++DVvuT5WXqChFJ6itSJCn9DxPAZgTAoASOVHHxYw1DW7QIqzJ8he38AG5EmqmOyVd3QBf06zllEPBIWnw6G7bF2zsMXDsGGMB3mCZDJ6L6ZBEYrSMUd5Cm1qyNrTqQ5fArU2N0B2IMc+iTTrxDHVLqhsebMRphSZUmqZTIzy/6ZCmZ/99hPKvPWYQpnbVCjz/hMHVlQF1pHaJsAKNwDrQhzBj8Lq8GRYaVgXQsCNJsEt3M+gE63kWEgPIFeBW3gsuAGoChuAr6XgS/QR4qFwGx4TbmuPQpg1+LYWZj3CTr1trFNRtVPRCXbqskfVKSDkaKci26kf9rE8QvHHysdUNK4naLosRNIIxPBO2PI/T7XSsyGF2HjdLE3m7I5BulwsST8cB7vBCMXxN5lE/kaKgwOlB0Zn0S+MzCJuO0ioCgX+bejN7cecN7D6/EjnzYExFAuqKBacIIq97IRQ7FdOfDBhmNmM5uGPviqaMJiaJ4BenxvQAefFXnXwUd8N5wdGhtPukCLdI20yoP37rn6h2Ev61g7srx1zYD+oBPH7NjMvjqLQQxnOe3GXGaRuBeO2kr0bH2tLK1bDkXNuJf2wH4TYC1iT5xjhchpd0q6VB2akEwvHwvzHKlKyNvjCSVGAo3kIOSun4jFOw2OVQ+GjZwFyCOzH2Zto0urX4BX1S71rygW8TA/yqSbLRgeBQDHSvGa/aIXxlTnums/HkZjfqI7/yvmd2Pmd/RI+154lUnARugaNdSVEg8Jqg7I7dES+FDZkG3VNiGMJ/RvfIW7U4AsBVcVp76UKyNp6UXfaFjnX75T08kb5RqxFWcf/eZNnsBMG5y2BYqtUUh0MqbFWtJ0IWS8T5VPUVm3AvJ29R2EIthOSr+YaTeG/Acuwpm6mqXI/NgRr6VjxNlTL5/KO7j+h5NrVR0aBYcVaEurKnJoyBDP7ZVTHrwGLAIs2Hl1qu+3S1OEiGx5G76bKujiSde3WihnuyoDbrhoWsFjVHmtg6r6awSW94XCNMsoG6Nr0WmUjhg48jMzY0aaq3EZTboiAHh4MrUN5FsmzK9W+INmn2RVqa6hjQi1Xdt6iFEiQGhGRs8yFglnBFG4AAddadf+evsvzQkcF3MVWFZ5BxTZ7LyDd1y1ODJW+BFO6wVR/tyzYHO6Lo4aG5BfH8RlJ3BnUmLhwLFND7455KDGBsDZ7n1TjYW/OROv8WsiPBoqNnWuCx1f32eiaWT+88h726LFPOu7MwM41fApA+/j0NumGV1X6xoIAjBtjYE6VEvvchsFPvuqgbvVR65m1t/E7YJ6to4o0/bwXgBZGV1e0cHVEWV4dKEEPjaMO2bK5Cejkw3ndxSYyLSPFASUpFQRo6JaxnKRmExpTMuSHHJcPKrg4PIw5HQ/MxpSCsQzyKXKBgOQxZ4JeFE5kOMLD5PHED8b/YN0NcQuSB8oQCIkHJyYyHO2oHyDJJ3G8kRUiSPOgDSF7BLldgFSIirSoshj1xl2ODW6yG/12uzvgvI5NQHm+4oaP3EZunf2KEmnVh/dkaH/c9wJuufj7KPzzay20UB1/yKp+Zq3V9owxr0Cl3bql4RmGrNJAWcORE3tMjwuB0JALRCiUiJavi1agGu3clvejLVogfsCT2m/7NXlkv2ru4HP5npbvbVZ+6tySAIyuMkjOApR0vMrerwj7XzGQtap7FHW44htRI2Bm1nUkJYpw5JuqfBkeGXF1YKIDluATTnDFY/aiDozPY1M8Xlc975WKfyiP52OXZ/vfYGY/7cj1T7kGvl5ODZL/X9tDmU97wtU48ENbpl+DPEJg5EPApptKAbgDw+/ZG681uJP9uBKB9L8/Eq74Q2NcMVhBxxbjbQNf3J/EFxf48ErmgVce+QYM7O/I/gu1Kz3XLIE5W8p+20wcPUu5S1Hlr7zAx4Vst3aM3r+ek4mdR0qPM3X8EyK+hhSJ8/SitoccUpWKLcE246cGFhEpk25yxwzoMzgznstayQUKiUx1q+aKunWNjHbojdtE+E1fr0eZW7Yebl15VDdiqerlj/M9f1Ss6yuM/ez38KkmaKqMkIN7evAxPnDQC8RLcpzAGXKvPGb4TXfMoALCjUcfgQ+efOyWEypwnolC7UwkbHnM3LXj4CN22SPsu3LcsXDc3jE4bg8MrucYXJD2krP2oWgyiZ2Oyu1yTLUN2+WHW6+VE6nqm/7IBizcLw60Qh3H2KiA6lBwtfAulJxr8ue64FQ3W6GUikeoD7eL1sOKWLcOUbm9AK0d31O/4zHFDl0L7c0vTDSNcD64NIdncgB/3DHVHxznmOqN2F1bowpYu8m3N8m5cWbuomVI3IOfs/fjMrvVav0td6MsNP62VGEDOTExsewr2oGlqKvB3yIASy+ZduEemtykxljX9c5HXDQ4t3iPqtvmeBTm4CB9tYcrn+Mn0KuXziSuOQdqkA+OWY6AgEoTqh+pWZidj4R+y13FIkf2DL3zRJygtg8Cc+2/TppcJLgmh9OJmGSmYS+Gz5pm3+TJ8GOxq6OYFIOEEHRSdMPcx0SBSWBsihIpo60M1pQqwEtJneqVrwylJNTBeKD+AluTPMNYZ3LvEwpYojPRxLCYnLlP2CEZ0EbUhB0FvS2moInw45egDQDTgCI8IrddL5U52kpfZdSiSuNgVolSJdVNad409k40zUcmGTVxSsfp9pQO+4qgvF14xwVD6QBLAD/x5Gue/9YBu/fa9zOffMYz/nHqv1/AvcoM1de7exFsv3kvVtr/bgwMzi/4D+D0dfxUXVa1yotIuhtLd4tMhXX60E6aLsdMdkCU0GXfoBLmWeg0UEM3ne44cWFVq5RVffodn3rHhLMO5BmTVX0Keblt/PhUzUmrPo5pyI3m//BprKjZb20qqXrJC/utb7Wc6hPHlFP9ju7UnlnlRqpmr4LytBlYKXPdYaIeMcvxsdtBuP2gghQMkNZScW73u5Od2wEa4FCfLlws6g+r9Yd2jQZJA4UN8UnZAookDtVg9diEK3OtcmxZy3JlP+j54/I6t4JbL9bcf8bdYIN/v2DUt6CT3D1CAe/vjrGyrSon2xpjZHeXjGyY/T4+PjbfepzuJifeXSBetbt/8285AY24WFfNQNfUADIQRCCkK7aGQjNXzCSN9Ss87Fs46bDNzNxv7ZHbCc3cczYT1zhueZLM5ioWSfUzPc0ufAau7m6hpIbSAO2g/3h+7e/Omc9SlT8MybMVJXRHf7EQdWTmFGOvgG8M5R4/gtUcrQg02k9vD8LE6LCMc2VolhMMTZ4oQD4GV6bW/gPlrP5cOau+Lxzc066Hv+NzkUfNoeKuvFxZitBo+YSiFcAKJFMVJ69U2qao/RmUp6jX4itWBdL1bleEWpnCAOctq1VXhIampoyAwlP4Df5Y9AMYj8HVY7HOG+StQwwsC5p/cZ6iXjBJeQzeQCE7egG/uVa0VPwrS612Wq2f+NTKXj8xxSPRnXMMgr14FelgRJxY74dO1dvxotiSvd7zVJ6GhZ+nqxNJD8Gz7dvxtDe3Dt/6208eXmGVJW2Wo5xlmIcVg08UCKvoVQ1fFdEQTCUwDrNmbVj4AP+gqBatzU5/K4p9sSDBLXIs4YFQeEIlKhAL3v6T14lYkPH1dkgIs/8lc6cPQYMmpsqnHJCqyFulUAwMgEdRCuyb3Rmm68W9Nit8XfE/P3vNQz/3FFFCUYNycqy2H5fLRTaHm0d5o5Jx47FBE7cT1x38qL5+2L7dORg5DVAclVYBRakiyRRl6XEzAYMLhxvNBAzkuoB0ZH0N4eFhtXGBkczWxsXZ4LJw6irrp4JOm9D3dLVV16pW4BOAFDXAl4WwZZZn6B91lCmwtlsi4kdUtd3F/6Gzt/5o7eAF9577yrztjiZaso9IK83aoEc/bbrDJwqu5TRN6WGqxgy1n/m09DSfKQu88Ej284LX0y5/xgbmNIOeDKwV09Qm/mN+uF0mfJVrt+H/tPdyVehOMItjmsKtDBjEEFOGG3DHEsIDoZ1TcfoGX+UcQeXELnQndoYnDlUMoKKBSDlCz1xtc/yYj7gVrEM6KMikWfDi6Ymb5mMm05YSaBa8BGOHcsEmh3IhpAiwBcl/pRQhHDuUcw3jT7RNnM21KVypnsHBYfPVhraYwQ2GiqGgJUM0tkpzEHc4+wt8Ozy20Q9t0IkbbB09ugjBFH5+I6v615uwqr76Yf6wHwVmWdOGsbmNMRshBxqj7/c1+hAni8Se3VPjQq0jBbIb4FgsKj6PVX+9uWLMWAzA3SKO0WSQrhB2Ufc0kFruD4sAiOqzFRBnkEUXrQ3EybzuYSMVMagblUZg+swPUL23nodUzwO7eIIo4fLn7ivXDd2hsGKxxOjT2v1pEakdkmpTfCxKOmOkRRiAW/0QkjPQdlRkra/UwGPhCVCC6Io5z8QBqYEjXyb4SGqSl/vjh6stEJaVcgcNcudTHU1J0cBUG+g+otbNYMiYp2lj9qngJ+I6ZAWLqcnfiIYkSua3/gGBvF43hwFiboiPG+M+js7VEGobR8EJVHoZWwUQUmSVkdDDDTkmM5o15OvMaaTXP8YSTssD98OqdOqeY0un/pVa8dnjtOLXxyfaAW98pu0dfT/4tMpMO/DKCTONY8uZ9sBv1CZNtQO/VdO5duDXaxMn2wG/Mtlo88l26MLhw5ts36xdNTbbsPCPzTZdwrUt47ONzGx7j862Kifll87iYWqOS0Pct3LWaUNHZl1czrpYkSS2sy6aMOuO1DabdvHkaQeISJmwikebTbvITjvA0i7cjfS9nueDGWahmbfv5TBP+2PX67FvrTRGtFaGL6iEL9lb5U8mBku7XWu8Gnu35R4qGr2n6mXvREswpNmPW+2htcNUk090A8AR5CmWcMItaw9H9c4fUb0LN1G98zaq3kFb5MFR1bu/dJtvt92OMM3/jVTv/uqY++d7daE/YVB9B1SPSIj1uTEhll/VUvRPUEvx6ker3RuOSvx8VYR9RJ+8IgjtIrQOEow+939ECbdxVxhjr+lmsijcMZxFuwToUh+qD8GiLkcmkG7XQLCMFl0grAJou5ip0ZuFfRXvP6sqqlUrd5uKauEWAli1uaz2sS3N6g5xeWomRjXWeJxR+t9p6UYYgS+P98WXJnzxi71o6Zrg5SOSpHuw0anKA9adPEA2Ce/Cu0oDNEl2EO9DMNUv7trwxYfcF3e5Lz4mXxh2B4u1fnz3ho8/7j6+2338SfkYLLRciEQZIkAiTNQEoWWEGgh1EWoiNIeQVJkh1BKsR6iN0E4O4XkGP+VIaQpsV6mk03lRkVFndT+MH06jyuVi5kX5rAwx0udoen8+j9dd6vs0yH1j5AlnUwsU0fSL4XyTZl7Ej5nV/WJthd9n91N9tViEPAT0YpE6NA+Sl3fIB4r4ls+V289mVGs4juziQfkW6Vy+1BdgoW0hdVayvzfm9DOYJ5ldXaEUNYr5Ol9Vwo4if9FBUD4tIvBvHYpAoY1BqCWAxV8V4obWRJzuDiJTatPMSt7rC1pIZszuf0DVKFai8zZomiQWs33QAlf5squ8jlrdmSGM+qO9i/y4ekXEOjVz6Q+clTKs1MLfxT1kVDu5dbGkTOkKjhjlhv0Ud38G5NEMbAH7WRlMTYmlrW1SJG7CK5+E6FAuNuIDmsEnsJJXbKdtFdPAUT9zNoS309aRJAKcMHiFby6wzwBkM7RggZZWa0QDCGa6KvdTOpU7PotaHKG4A56Up35aafZi47nL+LFIHWQXNoUs4IgmGKtjUwwufsxYa/QwVSgKJo7oklqbXzRQrB6JEtVznxTRSY9ZZ8g3oFa+lRweJxtshU0B/3UiEOi3WuxVTLcaorNWQ5SnGAa3SQ3K9JuEpq1zrPl+iD/mfptqdL6m5KEtc1Xm4lxflRK3ABFxfk7+i/KG4uWMUBEGh9pcyqeVHN23gRx9xpGj+xw5uhfB1OG7rx8/sOHjL7qPH3Aff1U+1stpC/rhwRtHP3zQfahJ8uH1CKZ9aRKoy6qZdlKN9JoWTJy/V7u3iOUJlIYJl8/jNMcHL2J/BG2XgmAgQcx5zIApm+eAgXBEKQ7ZlSrIjsSo+VYHlhYxJ2ZUbJciMjVGQmhRRrH/YEmilD4B3eRVLTSofDhCc5BTJ4iPSSkdABWeARXmVtEMrr6Okkgpqeho/TLukd4ovtXDkyKMbkc6xNfUPVTOcaBkqFEAl/ccLJYxFQzByqcRfwAwL7KyfcXshqmFgXzFiuzfggmKYNvFaGFAeO42TzJPGFWYxp+Ss3muPKNZYPwyzSs5WxRyNkuLxydn/LjVY8jACY8jazIz+fPJNE0zZSPkLKMOtpAzuCiC8jBKFHP5M5iiOl+txkOP2wkZJxdCSsYknBkytqDNpbYjbRJWkjcNijZNCxer402YS8VxU8uBfdqBfWoU7MBarr1lKFpKy0LRKjBYhI8bQ92maWqcuvljdG0q92n+EdI1ploVogYARhUALtICT8AIAGwBgC3pNei4Q8N5h4Ytpcn9Do6/BB899MYBpucAM70BMMuCjzgfQ5vwp9g1JWX2aJohMQlP860ASoumYGd3Oo8gZoE3iMl5ufSt5AtGbaNFiixqzmB0FZUYQRnZCDE1E7PdchRq87oCPxAeYMpWg0XbBVtmgSGzJYaAbk2EwcwGGMwyDP4nO6h/JHMSyII/x2L0aAZzsoUlfNFweAHYOupsnJW71ZtBQHgh9WigL5l6NdCXmjgEIBz7mHmZbzfiq0CPWSG4V0YD8mwPUXjdyI5E6qnAajFh5VRgpnZa7mVA7iYN7+Yw0WbTdQrbkqkSMcV6MVDXQTzdfDoC1PO0aKbjrOBaOmnWtWSejs66iPGtQ0r6iXydedHozNscc2arjASar7wDFgOVT+Uw1qdrmqCQm3LTZumrY+nj5iIPsB/su34wi/HmJs6Y4VnUIaMQ13qIZp2Hs4L4Xa+dm6XJX807ICFgA9WEjV0aDSc9h77Mmb0rNZFF9q+lNcC/9Uduv/iTNGMDcyCmAzKiGRvqIdQlGidMvjnSCdyRjshCnRasSmd87MYhjuFEZCjFMWEpjomo5sQxsiELNq8l1FrQplGdVxb7ePvlsF++iJCvovMql/SrOq+YNJE4wVK7+KGq2MsjxEPSVCZjdF71FqUTn0A2PUFC81kIs04Q1nrUWMTj0LaHkqoPfALQVp1jDJOF9fhZIQqqu3tACaZQWKkkVnlsjWKppApfbO4VvoHCd+QwM0ZTDESdkjHMt6lAzCsfoT5q5KsszM/uH1Mr1nu0YyB2Z5fnnPAl2orfylr6hqV4Ebr8uLfJv84M66jc4qYNPPQNeFce+ibHQ9+IYGo0HzZ8cav74nb3xdsQtHILIyLZ8OG73IeapCKS8sNQWA0ra8hjK33I66X4ICllE41SctFUQYdhbFulHKNdSj6mSnlHp5SBZAJIhKarooMZ+UjlF3O8M0Kbq3w5NalNPk2/qJhfpZRD88xy7y8WqPWioraq+hrToKS0gB24kWZwD2KkxCpfuEPWCV82RhKs6flQDdRJdvSq/DznZAw10HUucETG0KBpMfcPi7TTfYykfmPlDHkTVUh8nsoMRWrR7cPzi2vIFteQWOhjDc4cZMFKqCvuWjdhEZZ4jT2A6YjAleZ5mXleSimghT+dnLUVMYm4RT2eLRK/18HJonB0glpVRqFmGAUkIkyGDakZNoFMuGbYkVbJJCypSETNklHNcQlLyjfUqkyCc+0sTIJjPRMDY6z93ElhEPTlSg6TCV8mDIKGLwWDYJWdu5ZB6BpnkQ7eTQfvxgZ4A9Ap1Q205O4U9vUjDEIP1ESgF1ci0Wdq5D61AVBwsGQZA4o3MOg9w6CjUsEqsAktY8UYa7PVOukaEQM2KerKSmberGjB80cy5V6ULyteqcSRG46U2ovy7sOXFTwCAcGyGF17xAKCGnUnCAiaGwQE06C30/a8su32IOo3o620fY4DXZ3wNUrLsahVxAJ1BXuik3kaiBaPiAXagHybpk9ELNBSsUBto1gAvZJmM1GaBhHiVtF0VSxQQy1acNGqiAWw8jb0rjYTWIxjS/pT3uMzQoG869jDyEFjBuiKjZhY6sH8dmzxrLZyItbTMjZji+ajLY+M2ixSF39Ca8RNK+9vBGlpTlnaWCZXg+JRMqNSgppKCZRoiJCspTtkHcGakxLEpZRgaURKoJkyWhqRErSwyZ1WdXYfY0Z1Ln0ahEbPi+2diojmMCSOqNQqRAVkRVpLW0ohgYZVSNDFFrBLTSskaKqQYM6Bv705+LsiB5kzRCdlgPFj2kEgNsZQFdPHiZHKCKqRQoi6Soj0Cs/05iQo2UCClP6tKCGSc/qaA19MTbADnNG6BG6WIoK8IiaYc0i5qFRUxQRNIyaoYuYWB5ruBtBEipltEQzX8VdueGUlA4GchKkqJljEXjimrqHMUd6amHdUTCBsj+Lm9IiYgLGNpitigiXLFOhmrwrCOUqBK1sNHi0Jvqg+bokjE/s/vaH/dVqGiKD7yGZkl1L8KcjaArBpXfrbDJdy6Y9p+tEs/Y3HfOnXW6Qg55xWXf9rlfV/s6mqSigWLTmg6388cSqmE6biHMVmKtbNlEs3Wf+nK5GU5jVMOWCaTDtfp11tdNptjjN1nXBKlOw224kHOpTRvKwFbtuPOddwc66tPnspUTlBQ/LEIBnU1A+weKKF0zpMYPmcnKDHTdCmigB2O/VUTqBrFeQELZARCEMTbZ3alLZygqDiIOAdIZ+gB+xsbPINPyhGEHSR1MZmiMgEDsMTSozyzEr3o+ShWQ1qDNdgwTdZUzV4ZzDYBcVmY4Kbz6FEXfZXz+hvDDy/T419n/g4/t1/ITxWi6rSJTxS+770gr86+CsP3PvUKyAwiMU+Xmt97Tac9FAqLq3b62u3luYOcdVPLqZhEKcQ0ukUiRg8Ep/eojONVot39Zg4RBxIrDZXVtGRuqyPcejXSBv0Eq76wYDaL4I9F4yoU5VVB5hFc1SDyDdqSzdaaxWdZ0EGpZYu1AaJ2JvPvmF5KmjmMqKI9VMmjjLMggUMQkQ4ECfkX8FokDHJoqjNBZU6UcMicfUqn4qqQeXtNfdvoj5MFxNBnezA9cAPbhY9MvERrm8eS6ARPRyBxrFFGk589AsTxEfBv7n4qHplOjqWbMNdmf5HLxTxxCuNeiAob2VqCg8WyTOD0tOpAeX1UXVLEGHjibN+rpDh2JDgiJ9W16SfyEUZ7g8XcS5sndrFA+ZF7eKBC7MiWlASJ9Ib+BE0qQQ06cKU7qderVoiwNu3FAlYmt0gDJSARO22Bp8DUNPAGsasufsuX/QCNQllpTJBqROpWMZtEE28r5cGws+skWxklAjFTC1kT6a3i6m+HwY8f/YKdpkIQdQlPWRLNmSrjWdbBe7JdSGQgXJahNk/C4Z52b/giY8/6QG9PG7TLa/SSbTxkweRNXsIv0g7FJQmwANnk+ye0Hl1rMPozRFu/CQFr+CukDw176+WZqje70KjYR3IzS+3+yuoGrJ0ScrWr5UmU5Bde700OvsAYqjOyUdDeKaR4JGQyeSLcaurrpfgTCQQG+XI3AuhIouZ9ioUVQRYHriXIiH6ftzCwET4DPTi0K7PhCvZdVJnHZp33oqkafwRbQO2MiPxb5Z47EqBrAyDGvdY+TJGn7vUqQ7aI3cfNfaCSZG7XeRHy8idkyK7kz5vTYgsY7SRdR61R3Wt9K//NTXy/oePqQVVZ+R018lK87w+vsFedt0Y2/YHYAtv/eG2XlqamD8cz//cHJQu/WPPH71hGDunpf2joKtW4MIYiBCaVOeJKWCOgX4/e4XQ6WXNB3MUmi+z+Voj+RhfuOAVMFq3fvnag1w8zBLEQNfrgYV6G/k+T42v3MNPFNY9L7ibgzhJ8zFcX7QvGb886FFcvZD3zSiCxiFMwQSl4rZXKqvK2HANepvmqIcJsozpka2u7/vtX1t/Y3z/OXxp/4ny748vHBhrJOvDPgP40Ke5zWsVp8jkglf0yvhDe8kFL+896BcBCM1FPbk4WfueXuGjk6VFZR8UW2QNagwqvMSMZzmaGGCxlvEy8iYbnwleQB7h+RzyxGdqLXu10hKQwCtR4zOBczKVvl9jX0K+mrS5VL/hNDXeRx78WCmA0JC7vew1Qk3qirlIsJaOQF9RessZTvKBdHptCF/f4+WJlpI7bkgtU3x/+Z69FhWo4QmkXIrVx92NjDArOfqZqk+l/p0H5fGgW68ocvfWqg5/hXGSfZP2VZQyseztu+Vm/PtT5gibFK0Ns4PSUz97HZ5qVesMvRkW6AKSamRWaHc1UlrX2hgFbM5QryVRHr/cW1uZEHv3WGy97Smu5r6535+qaSm5wao5X49GCiPmlffJPR9nJ5VJrJNOll+hpdkb8NUSJtepwe5zg5t8BHV3GhzUF+UwHvDkRZmI++xLwi+3+/o5LwIDX2K7eazT9x5OgiGvzxhzLHf7Yjn+vz//87fefPNVHxmwKcgPve7un/nlP7r1AnJBsMZHfZ34d+EJZF73K9P+Xr8y7b/KL+ltEUz9vzysErGqVvqZtSO+mMwymqc3O5nqhFnkc7Efkyw1Qvh9GhbFVA2KYiqCaV8S3SQTTTxE4YpPVk60rqYclcyBTrY5kCAdvRvwMQCF64VvvN75aGcYFkG5Jdj34Nu/9EfP+uHLLqSwh8S3CT4M/NUiWh8jVfEIqao7UlWvkqq6I1X1UVIVgodgUsVPkCoMpyVUD4BQxccjVAx27hHAXI4BmDTcRbmk7QmjfsjPA3d748D/szf78euttbPsTRoUA3yBxBxCjH6KWVAd2WptFEoBoGKx6keTp4eXxkRDaEmW7geMODh0dIGZm5/QZQizuQvUdW44sQzoZl3GJw/cZAx0ON9sJqPbkP1yPdV7WHqPSG5n89N7pXUpE5XcM0W6decGP2jsGjwgTxhRra9jS34w4nd+HsDTky3moUilAOJOqolwqCrQkeU3cevRZ0qH3TconGE2W7Bvxf1900HU3TIMp1/16UABeyFqGvr4N3wbq81SgufLv8/z2xSXcIMvl5jl1lBG8TqLQ4J8hiM+yVXGzk2q6IcI4Tb1UgjVCDl+4YiBzzQPDSkayqeiA/AbNEcRhPi3RpQSh/u3RjxCyAj1WcRLnLKqiMtcnHKAUOsa+G/B44hPyeGbiybC6xqep3lqXt4biJu46o3py2W/QE0VbYiZnmJO74JUtuOCXmDrUOTtfjGPZ1IswB1XQE1XoLpNEh4MAmGVioEvSvdDaVvuyTdEbM3AS+HPP3kxw9XULFqtqUikZlDErF4sFxSldIVmjDsD6qzkciiwgsKwIM4xujpGHY2DUALfcQ6FPmjULGAsBvGW80XEi2W8ZWghqqEJgVmtgP3cJraJkLpyuE0LQ5pfAyrMoDroC6K+W79w7ZG7Xvv1t3yDK97EQEWQ4JhgFtVGutwBN3TzMBp1wVjMbhPz0TJm51hMd+yr1sYYfTVYwjPRztnX+yHmKf7GbQmGT7vlvZ//+M3v/fxXeQOf8OsnbpZ37Oexe4iA5m5nqZ7wszcfNAuSOhT09bKaGMWQ80e1qQW99pHrg2BPlM9piK1mZFRfaSbb2XulpJq4ZwRbEjOWbSTJbB2ilJQ9o+23vBGrgp20nxlzkn72qeuNG1NrVvJoHAWlb0oDjd2OZHmqQaKulJlO9cHH+izjqyvmKsWF4poynLCNVSSVK33W7/xQmZO6M//gpiPaMzzMJowNJfoA5w4pXF0v2FxsYtbGSy8kF2T/VglIGWQabq6K9yHloglvy3lTp0JKnpp5jijVi17N0qxeSximnB9q1rnNyO7GyC+tlFXiKM1Dvd2ES0v8rp59rDMSAwaIL/Ho4JHlGbWUXn5FGgsRdWM43AADY+rk1L1DmlqDH0S33SO/Ir9FpVg2oOIuPS1C6WmBltI4/Nl4A3zLDdd4Ik+vwyK4WneDEhz6Ak9zHMcWXlrrTDcFDBSixav7bQTMaZSGTcgFr+gh9bbhGj984j/QD1UtYPjPmOta5nBeV0BZxnGSUheVE5oWwXpdqGRTaKdK30ER9VYqyKKSwyaTUzQNH5aUsUl1VKZHIlqHruSGgCtt7BZtEdmimZUNHsY9OcztF2MoIzTd51mH/Bgd2zGsPpDInMHPMwwnz8HdlrocDf0O22dxd/fdFfGnXcvPK8/l3RkONT5ZW8l+GnQjD0xSdq5/kSTdpUnKLTLxU+cT358dfZ3wLlxZEbsYFW7gVbZvTpgqQ6xqSNa/HF4ukgPaImWsBwGyBx58ms/oEeQd9enTz7CAX1VkPVA42ARRRcmig9cZ8gDQWT5tmLtZYHbg+rP6vAAG4Ggo63H1WLrm3lrMPxgz6cTaNuItr0UzN9P0zTQ7tJRgnY3rtYxvepWvzfKSR3M0f5hzcSRUPcXWStbGoGO0m/YArJb9FAAmBhYc5UuU8uUZ+QxG8iGme/XrcMHxq9eL3ADh/h/gV3rby96ilBLCobnsL6+XF4a3fo/o7CsayeuWpPT/8PUoz3xXgkK/1bE0mfVLHXlN6P/ZAfdtZnDis+YtszR61ZixMsIT0i1U127P/LAUomSVzdROqsGZkgd4lEgNsD4HZouG2Z8rHwzRH3nZr6mx11r6/3jeRBdxHmRAAQ642A60yDmsmfxliC8l1FMBEKSUANRvvUE+dczytYEXTDLfa1iun7zeGWlznhsiOQYoN9xn1iJIFrBni8CXqcV5e1NyNF1SgR0PqwoscZ0VyX4jsuvtTh8YhlcVA0RyGdRsQgK9Z4yyVkQlUH73OC+WuyR49op4JUKrtRC1zd1n0O++GC0o/VpGqqIUoXHq0Q1kzIh6YEoIcPa5yTerbUKVniB7HvHTnjJ62KRHVWYg/fFAjYmOeeHQw0aghqGfetiZvVVlwf2W9qbcKJHxqJF92AIl0VMbpMKeV1tLpEh0XVdKOoQHtP08udDQyANqwmcGzC+pqREZTpB45UhDPDowDar0N7AJgSZwkiaoFUZrmreFR4vaYFvbRl0MrRj1WaB78S7jtqlZd5ctDKxZGn0dxUAtmU5hBZGolo3qoHKxkc5VajvVNaprEVZAAZEx/+bG4x4/0F0jiXl+42J5qFb6W+t5VNqUyYMSumYxrOWOJ4ARNTFQHFjJWWAlZ2plVi5Sl4VxMqOFOyt1CQVOP/nv8h5wYUDRsCpww6hbcv29ewdDQYb1tUFZ1hEpy+0vKbLZ90JcJ4Ff2ju4nK1RYNoMDb383j5iXlzU+VeYLm4vTe7nxD6qcbdKH/e+aa9xvHQjIOwxzleIIHnDwjuMimRwFVt9B46RCvt789Cy/K6MsH//l5l2y9oYHR4OsiMi3Yk1H0UOCmVaRMCFO75iPoNJXk5UlDX+WXwGGaxVqbA/uHnff/rKA7++/UU/52EbgFT2MDjM3m5tYBC/vFlsXvi3DClY4x7bgwVvZLHlvLdozqFC5ZueM3Z51B85GFAV3kSl9sZsjUoVPyBTPZSzJoer8P6DhEKHClZL4EeUc7zvEFtQgz4xl1FfYbXwc/yPQ2TI5FD8CGolH/dXsg86oUzNbhF277WoM7hgOFZrEd6276sPffJlf3Py59gyWVRF5kJMZV/eMzF3XQDrKLsp5o66U4R3VQCw25FBFccCr27FuxrukVMOdReg01zprxBxtCh8CdhBvEPzew4nvp42Nq/p5135LuPvdkpoF4dIQmdwCObkt6/0o5cCs+W40PId2t7HdFX+0PUbVuWrqmdERzxXvBqe/x2cJ1v66nYhe0sEV05Ckz0j5Q/xsfIjQAYKuGAH+x/3/EDPwWQGwrgrKsFZuBWFw3QIVsIRYSgfVK/7RiK57kP9HoIlKeD3UED2cfxSsD4El16xwljupplQrevb8z7xif7QkIj34JjM13O5quhR6yk3YQ+UtO3JXJDv5Galc6OBrJ++kdh+pUxJOD+XxWJ4v2IkzJGIEuOH+CdvR2d+pK8qJ4ag3WZkqHqy98veJEUQBQgOo1QNoF9TuwwjvUIEBXp8r29CTisSXo2UyZZcsmEQ+h9dZ1udUap8jCYe8lmalmoPFWZD8p6Xj+hVUJiuR4EK8y3dcYd2umu/wyNvstg+GHASIXCIA1CeGj3+ut2DWP56r5TL3+Bpwrs8K5U/iA/vr6kc+HpPBcEI34c4NFphpN3Aty/LPgEgIviCPFRu6r+TNwIOVHsZwKuFkrP2qQdqyltyI9h5oXir/CHypEDLzmkR1pwNJqw7W4OgWduLDnsjXPyVeoy1gSuILROrEuyYP/1ZpWPLaASTBLRfJeYqLFfq5Ok+AYQCwb9GMJTgZxCUHlSI3cc9jVBqd5eEldxpLetI10P9j2nwLvToiIY/jvCHvJLooZXrnqF6AATO4/SswHQHUdlolAIFzBo+UThWj/C0nyQgdIdwuEs8IfbQeCwO1KzcPv3DSHyPBBMwF0TsmNgbWOwNjoW94WbYG54I9uq8V5z9A+CsguQFUMOa0yv1Ge7LHK29sA+NGkS0rEeK6BmC1oi7wy8ixudNsVk/iY6By6P+e/yHh8s+mj2+IVNcxqburQ6X/UeDy/5GXPYruOxXcNl/uLgcbcBlfwyXETmGzVj3JqG02mV77FHaTz/iB6EcW8ki/4dAmlwMGx3181Cenqo3JXjJzLoeq3FgEWZXT+8T53Vr1HlYYln1ZHw7kkw8yE9SsgUfvQAcc3lKqv7B1tag+VrmsJvC0C33uvo7k6lr2RvFY2CiDObdbkU/ixt4y1tMeRrB4sykXLXJBa/A0WmduP04Mk0eS47sj169gSN7NXhTQFrFBKFKICKxPmVu+Yh44qftnFR5Aj/C7GeUk9YvkdPIjeRVVCIho+NHOTU7qbw4p/vWKvpTuYusJmJc7oX923+fdy4oLkSGUJwOSDtu1pXIeBpQ+1e1dK9nLFOCP7tJdwiE762iqu8uoZbqVVVnaf8B9esKVzu1lombmVcLhdxVU6kMI9yPvPv6p9W+r11DlmXyTZadksUvs1yK/W6QvkDgCrgzLPGQfiOs24siKu3QhyoP4XiEA0QZiobLZMbvjWST3o62PP1uND2zkCO/oouqNaEACanJ0MnLf5j+dbBR/2G3Q7ZJKg6spofGqEseRTLBAZUWIm4ZIYnbqSMN9VR8Bm1VvXigP8tsQF1ZGHFxZQybktzpRGhZ7rzy1hE3iC/p4W2uTMxErlImroK2G1NyolOATWAByjMQfNVD7uwwXkQ9r382BKZDTRThWbaGFyOxaYGsya03SBF0hgGm1lfn23QWiJEgyV8kciK7gnZQIue0ap5ebLndBhqiPnrgXMX5fQWeqg5V4fW9i/gzfiBXnVDgim5G5SjPV9VwpXLGWaEstmmKNvbnFGnQup8zG6bdbks0zz9ugtWyPxNCsG1SLKakahTuHvGn61jpDoavxQ7nlUdw0qb/1/MnO+BlcMvmFq37letNJA9R6eTi/WY9UyGh8gE6M9zF7qpcC0PsGvqO0GtcMwGB1VOb4iOmiaz9jDSCa+aig3IEyf6ioQc5yYjOcAF1fVw6kLnlDDUgNeQuEoc5FRNQHAYbpzkUc2iVPH1p4AXqDI2rXtqPX8pFZD9vldUEiYxhrlLKLPxBw+5f0UxV9pRzLkr7cqVEvkTp5LMV9J7KZvj12UJuxJyMRylMuuV1anJes2AyHKRx9RWKXso45L+0fz8sNVyFQ5+YJf5P88h792uux9F71aFUaWwL9VqbGShXZ2S3iM2GOss9mejAVMFcDnCJKC8wGl+ZOmzsqY+vXfogvXC5XLrJ3YnQqf5OHJRLaBllqCjALHT88zi+E2CnYybatBkwRUZB2z0yEz77sK44eBOvOHjVKw7e8a44XPNMvd4w4h6uTmH/G6M3G26/fvxmg/dvfrPh7ddPvNngTbrZ8A7kraUD34+v8V45Jv1y2C5iKBWBK9LbxFCnQhTI2xxFivcx4+oqgpiwUP6R6VS/ir1DV/G3zu4wxV9EHWh8DcXvfs3Trnn1dcA3X/HNV3yTB6ljmOVR2Znim4YE3zxSwiXZevwoMe7dVz/Fq1njz0oZpA8yOYxY3s0WyNv+DzLT8s7rvx3NtLzr+hM30/JuxcafhZmWfwNc5Az/irioO89++LBR8W/8CJPVw9/Vm4Cpq8g4p7ysr7Qdl93dfWiod/B+d4U7WySXGj21HJHxSwz/kjztmqtxC+84YIiOD4bJIOB1dj1PncNmSJTA78JyvNzVF9coTkFIvREG625nx8m5atgAVBjc1FqAyOv25I97cB13EX6K1DJKKCDKg/IWe0Ah7i2OgfrMqvco/Aj6qbNfw49QzV7nOI7vjV+8foPvjfDYvjd+xQtkiCfcAq2dip3J0+jgL8Bq8i/YTfiZtZpKqUOKoNxkjl88VOlppEw+bjL5aldoJXuPipABWMmRTfpMPQlu+PKX9cvqdUTyHtmdm/dev/HOjVe9c+Od4J2bVz4iK9iPqMXvu/7f0G73iFsW8dX3S9dvcMtyx/WT3bKEaGVyLLPeG3z/hdas9zvh5kLgoXt1ZR31WNxX+u71ifdGulJd3BNPt/1rZHK9lJ/+S64yKw3/XPX/5r4xlp1K1XSxmtIuQokUP/7/LxlnDZdh67T9ktKYtptZgdyO6hPD66VXaX4c4LzvMWwsKviRE2kv8h2/yba1ZEt2rd6mo3DN94yMgKcjcDzb64+AYD283DO1yv3JjwK/jmOe/M7rx82T3+j7TaductQviVpfvVZ+zF8xpxe6s6zLVjsxSuUNER8dgQMObPvwd0lPtNgaGF3Vh4VSrdoYNRaJRCjlwS7pS6HRxTk5So3aWK2QpjFdI43ExxTyhwn4puyzwsFwSfisaFPID1U4aY8onGhhRYvbh2Lsop68VBaeUDWuw9Ida/Xs+aNJpI5bIv6zsHF3i92icgz16oz87O/QVL2+O+olqoiyv0eaCv72YkNtrgRfxIeyAJuqPMS4OVjUqV7RjTeWHPx9u6Mfv/esb55+Ou7Jl0LdybdNRP7rPJolVIeasssMLmtNrBMcLjY1SZC6NlBjLftxyGyLRmlIwGg65E2qcznlEevlYGXKQ+kB13PbzdTUa/9a2vNd87lba1S/bUh1bNAPmyIrWrjNw2t5AkyI9OwVd6WBHBEUCELyzxPNpFA01HchBNiDCxpRH3kw6IvH950rOnuzf8Bg6CjE64wkURXe0YnBO6rCuz4C7zpFY/COREzO8K7YJ2iMwLtZgXdi4Z2MwbuBKymj8I4q8I4A78ZQq5kI74jhHYErmwDvBsO7zlNWvKqnagCRAqcHnt2vkOt/6SxsJhTV1epM9iUkGRuHulvZK1JpsGKAaPVAFNNg38YjUl17OQUOPrXML6NMtVhx1N2JryiS1lTqHWfrkhRCofRNb+ClVeKzW5BJRl6T1pxuKDSGztLPBIFMLlUK1Z5JfP83X+2+0QSrE8r/WZ3Qf/Arojynr+8o9kdePUHT0UHAKVPGTpkyHlemdOmSCnr5MCthdIFAUj+4Ex/ocUbAnTmir7JrE5m8tbUi8kCImENIkQlWrnRMNXMokiwoTpKQMWSTuFjEXXiE5rSD/DHFyYAb93HFCvFmiewc4icFo4qTkRNo/oDnT1r7+l4emhMxy4/jJRFv/imCgI30/WPj6+O3qyPEo4/KESI8Zp+4I0RncOOq0DNX6RwrFzpiolquytiJlaJKgrpgQE1mj8er2nBA+Kvh/HHIZNaa7wqt2DFKP7yljnP97jUhXyZfenlsZ9T9TgtK6zNWQm/4qWPeL41wW11t9xHCX6yEP+MMikopqZZ4a6VEEK5DeNdsmiS8wE2VL9614YuB+0KS9IvbK198aMMXd7gvJEm/WJcvhLGV6dCXppQUMreWBweTo1Go4kg1WlT/opcwX1ckfSL+Y0F4w0zlutrs1/bkzZZn7CLhbhyCBzTYogA0MG8rrZ+SusWxSvKSPOuLzWcUIw3LZ6iDAZtFjPQgn1Obq009A51Xzy5ofLGI+C4tIipBhcgvh0n9r94oQcTep8GQg5/RoGCfmgNbEYLj3FNh7vL7AvHfJT0LBFgzi9WMEazAiwcHCLW2iD39fIkS6lK2uiKmMZf5b+smRsy2iRWxgPCcbPOdaHuecyVdVMKd3UPLelvWJ2bTpNG4TIudIQxci8GxBPbIKHb22lA6xbTEX8q9tBztcycNFOCznOSZ5XmKluiKbp/FDuL0h77kFXBI0LLXwOyz2ImKzFd7vss+i5O48uLkMuE37LM4BQkREvbyBamvX2ifxS4uiKshSbts6bnvO/oU+yxOdWk/cmVw1uu3rD3ZPovTNK04nU7nkBat7Jt9FmfYzyniEB4SbH3sPe/78Fv/Pn+qfRZnIvaTew5+5G/++fan2Gdxln4uHX3399164NmvfPNH7LN4HKCMlEPzv7dl4P3zU+2z2G1T/r//8NGF1Y/+xzvts3i8TXnmD+Dfz11on8UTNAUweiJxjyoN1iZf/ak/+M/n/+nnnmKfxdlS0BduPf31n//cf/6IfRZPslW84hvv+cG/2vrbT7XP4hyb8qnnfpQbetqd9lmca1N+/oFsenr62gvts9hjUy6Whv7mnfZZnOcaHBGPt2cQ2D6L0x/6XkbyT3vF+Q99X/Fk2k5PxkiczIP1+1yeb7LZZ/Fkk/2h78svoIieSPgs4s8i/aySfjIpakrVEQERSdCOSJGMSpSiEoHIoktOuaALTUYOYlQgN/Bkhpl2m6cZQqoMGFqTbxgwwvCQGQwyoCcDaDJgpQoQcyIqQbaz2ncSkFUBEFHOIECm0znT6Zqpkr4N5BlEsQsydXpAFU1yT2yTKpnOfaXROW/L80IkyFtAcWAgZuuL5bgdG2dVfsd+OdH0OdoQX8Bu5lO44IJauKChhjzpKaA0JxuThsV27imP3QUkgQtomyQcMgnbKNKECLYidbGlrdoG/iYSmhbIaiPknJvARW+rRH/VRkd0AQbPRGNJQDTXd7KJpmXsCpdpK9xsbnXuCZrM5vZDPmVAJ0NwoTj4LZ4KQixk/kIknJHvxYPyPs2qXx4h+k9j+D2tX4errAvpaav5bFl53i2bly+VHci32n7qgtEEZbc+tewaw22i2RWBAtaaPvEDcJ5H5jxmKCf8pv58Y1kJngIr4S8ufD4UKAqxLcaYtEw+yvBhtrK6QOhHcDmxlTYkZiaReMjLcpY25iKTC94suhsSOTIBXhR9rM1taa1PBXBiHoCfN4CnJi9lkitW7/qwoSt7lR71VmhxhesXK7p8/QB6A2pi0wdHgZAuK7noqifEIbV9jBH2DSspnqxQT3wxbBNy5bikiqinIf1p9FRlJzMslBlNI3KaGoh0bEmFH9lb4Xm42QtWp2tX8RSeHLp7atIUtg3GdmWPZoWrKZY0puAmbOXR5YfskBJxYjKnKKBuonWK2jfMZxTLFXRpztz2ZMzSu7ZwsCY+fPKT5VnLT+dEsWyMQmhLPxIMKoThyed5uLfQ0ip1FbVk2HgGLlPsHJ/ocJ0unPk8GCBkhETCuECJKnhUECfFtE0iFRFtElgVRVI6OY+ELCSA/BYAeUtfdlHqvq5NXcQxN2f9GGk/u6ArZVcK05V57coWtNIwc10C+KkQkNsWwwC84Elh6Pz86LsSkGo7XRsLtKcwbZwDCzhHOsKCuKAJK8UCNfRNjy5FqQU2SC0nLXvT6euwE9HtCGy12T3pJXJzg4yik4+GF7j8o7suvUfnUWC8a+aBda2pOjCqemGuBaV/F0YRXDLAFEDV3mGkdWmBWhPcNZbukHW3ftTTu33RBJ60KZM5IjzJPDPzrGzuRA4LC55q8R8OtAOR6IYi2w1li8dAhFWKUCSyKU3h0YFhDBgXqpmLVNZCbttsG1oSSw34QxY7F7nQ6wa1OAaP/bj3rOZdpZ6wLJZSFral9mRxCnCb0r2jnjxG+VQ/cW1r0xSlRk58edHucbkohgPpaNuc7A4tkW5ktxUd3e4nhNPg7NdF9DV9uJjZ96M3Xrjy14/7XZJbYNNcZmdA04MhzdAM3+nv+DIG93syLADNyN2vjp6jdkqpGwSMUkYZQ53DawCK+vhJRy+mBLXalU8dDnBnEqa+RDAai2JBRmn2G1ZlD0jhqZCD0Qp3LQOrq+Wb/bazM5m+yA8mXkP1zTFMv6u6ZxRYuz4aFqFFadcHO3oxzp39pt6wE2uXeVy9dxJRPEjfHrA+h+6GP75hN3zE7YY1SXbDd1X2z5/Z8MVR94UmqREs+aIvxVHNTInsXSK4wwLukae+lHAjSqIe8IjfAvN2P96qlueCNSCrXMl149krkB8riFSEs2CtrKiLlqMMjpOH4KacOKpVtUTrcikBIieG7sDaHn+8jJ+MNfgBXx/eAjHnsXBeK4eEJBcWeYh/63q9Wy9gIN900bUJAUmzecsmQu+dfK4KFagltajMbRyOp7/SSKDyyn9yazPiv3H/MOgbrknoAH1xwwDd4wZIk2SA7qsM6SFnKOx+k+MoFkp8xLr9Py1Rk9Vrg6OaSgjfUwnfr2E04GNlMDj4Mwg6s7B3XsNu+SVOv7qpEr5dwxA+flxLQLuPIFaDh1xwXYJ3yS8/wfZpj6VrmIF6leSgZ4SLOB2+Xl+AD+Usgk10Nd53XvAyCtxQtaAN/RIKjH3IKylwuKn46ikvojZvYoekRZ2p8Qv6MgwUGQQJMNKI4rKugHagmsm7TIL3IfhDVVuCWd5Ait7ZyCR4gweaIMH7EZuI4qAOoG5FqKFpuOutqra/raq2fPCVJ3hcysXqbPRX8L63nIuIaLi5CBf6rr/JmswlMDDVuZhIfgAsr4M6XSEao/GIsbS6QFKYOuPyIiH/NL/2QUxM5/sSMzIy4vWmm5UZj5PMTpmTqOOGkVl1wFeBdFMGAyqq6PcoUGDB3aOmsVovwFUwAQC7s7uEdLa0/e1ysk6h3XW0u6UaIgqXFMMtHLkSmWQzIuMueqBLIry73tcFrrlKoic+BYKDX+2dpRdmcfzuV8KpjAzabUWM556icbjojK6GkkBs0Hzo1iqgAayTZLgwkuE1GQ4GA6x5QzkWwy0TNOWgT8I1EQaS60JPlS6Zext+RbtZ7Y0o0C8es+K+4uEqTfY7epFJgIyf7oB8dz1U5t76baXD6dq6OzR0t54J51Hrt7lbp4Nh5Sb0gK/PesG4mpAedXRVFW/ZTePlXK40zeltniyP8ejCapFengopFEIxJ6FlzDY9yxbhLVSoa1ChBiOpZ1y/hy5WjZJ/zg+FYo8eZifHuKXQgH0wLhfPLvZdOFdNsBRexI/4/NqFaCRHVI2Gqnp4Wr12FJTXjuKNFgJiayEgFovzlAIbUxFeTrx2FMhJ1Yit0GBtKGILwOlsfiT9Cxk6e0BccOSbqDGWRMGeAOxzmjlDZj0Z3i1BaNefUZawCyG1hLasH7RQN8dljIkA8R+i17IldceQ6RsTAfM02yS3xoUCZ7BajIaE2Z+IOWNZeWgi6GHaE0LzBtXRQrvw8ZvH64tcbNALixq4wwaOcABL2438xAJ1qzz5E1+f92h6cDee1cXuqC3hPht4wHx6EJ/e5K/Y9Ytq2iZrWY3i7I8MIPoHXuU7d3m8bUaENJth2x+Q9jtP+X1X5b3F78uV9za/Z5X3KX4P3btw0pFVLNWzhf4BymfciSiSGW/BlHEKPDogfzFLDXhlLXyxwUdNSnGa/MdovfZJvwvIZGjhrV3mAXLL+Sce+/M5PcMIaEopbxuPeaXDC1K0bPi71JRduk+L2LXTAn6LBNvULbLNnpeIJSO67FHPbldh4UPyLRFSy2iIPQIr/ZjHg8UseCzQIh6LtAWPLdSFCIZFCaCDNEsz+GPV5GlocnoUqO935TRQlvZnXvsTSJMDo5HDrVT+AcRSzMrEl/fUulGAKawp5FLILjPzeMxbIysLmN8LRhBzQM1V8uBdBu9AMxiqfIZ0sKy8rlNeZemMXWXBpqxMnpqU3C6T25OSW2Vya1JyWianY8nU1HCJO9lRteZb5wnvlIg+7MlxaThyXOq541LVfFO2ICBvXQQdRvk7gsQDAB3ZK2KLa6hlgEtQgVokCdcPmzxzbDemXj15LX17Y6Sobs9eeb1yHpU9e9zqCxua/S46M0ivFpML0hx85DHaeII2np7TVvuxkbbbiKRCwd1Bb2AKqNpyK29kyQKQvtjzJi6gcrc4ZPTJyHuRa5OYQ3eK77pK6nrZtVc54UiOPyJfF8mPb1wkr/LCybpzGA89dGVKyQGEydcnzthXiX8ErqtFYHUL9PCdZ1yo79knpL4YnTfwTr/e9HqlUuTZqm++h5Mw+Z6tlqeXC0hG87oo3coVXZgW7f8Y+WqI78A3oCufp0AVc9tPLwEWbXV724JX5aKD7Vy2P59WBxURdbg4TLg2dfZDN3uWQtAByGW/WbtE5M+h6q0vgNFeVOX1LldLXRGab6FYN6FLFGmFPVHYc/cOi+X9RcYVZDw8W8lfRY04upA+FNu5i5hcquVQJxazraxCFoQXppt4AXkHXYuFQ86eDZ2/7dS9ZKkUHGXyzIQEcktja1JwG3VoiZbRQH728Mx+39Bxhom616vTllVpKZJR2gxtpQT1UgdCX267R9njvBrSeT8ABrrdD7VeX6v1UG3LECwAG0VPl0XTeNGzmxd9tSvaUUuUK8BvE5haGRQMSaYw4RgA2d+vuifzapXJEzBmAtA4z6TCpdEuLOGxRBnqyYx3qbqORoaxVdDVVRckQaMSagBVGtTkb/KmOW6GRo5+7euQjmKt//CwNhvD2jawNqI2sDWrYGv7W4yt/r8ttv7BI8PWXf5EbA0fNbai6InYGn47Ymu4ObYq6b3Y817hRPCgyZ6bjUWEmkPCw15OC4xWObodOvn8xJIAqYklhccs6fcCzx+/LawAvTGQXa/eHbgpqG57NcPBaoYbRjJAixLWndSUbstam0Ds+ybG3j4x9qZK7J3ujtf1XqXig954y15WSb96PHm1knzlePJlleQrxpOf6dw9uMhdlW/OGP9muZJM48mtSnI2nlyrJIejYHYibb7IHVhFObc1yT6p/oCo9ry2Z/gKPcqInEKtHFqUxjNYVddZhw6MdWj+SLVMhVV6fzPCiRCYNXMjEqPtDMaF4vS69PWqEujq7Xj1RDXMG1BZdsavqd7WlLxRiW6S4/sIgu+f+vTJ96VnTT+VzRHygcseo3vaqNr3AHGHwZeinf2pNUSBnSimS6NqJG6q6h1OTUqOGInLpyqSBT0J4WxOZ7rIdGg6MtvXs58/IJtTvc0GM3eoNVEMx37a+L15N2Bp77xNSxGiPjFT6bY4+fTlBHFWC2QgAnjoDAu+8pRiNXAAz09cFywrc25sH2ha6/kzYazzpl1OZ0GSZk21uhggHyKSyslPaQj2qLhRRpb+unUNVAeSxlKGevqpwVqRGMATKe1e4baX7YcyNGjvkFpkhyPVHnSorl9D9+MzSMHGClvlAX/UYY396lil1KyMVZP4fWSsTPDIBQOMmzRlRJij63VdWd8ECHlJD6tAL5+tSnnk1JFFNTCxACyWs/iA6m5fdLQimdMRt74EDvzo/1d/79PWhnxGiH0FJfk0rvLqAPXr+bQ5/upbC8VwblNX3LyIZtch1dJVpm51pZtOCCgYiGIFrpiVDbGTfXogjaXZ7H/pGq6Hfy38ZAWqQiiRGwJU51VAN1h5PUVWzDrpcU0zxH3QWJhpNFjE5f5vlKs60QkenBUZW1hdasCIi8quUAKnQ7FefhzpjBZQjHYv1lvCccaX0fAeOKkmuuurdeoClCHYMKRD1Q/lo5sfwvUSPR845jDl6YYiaMqFMbdHxjCoeHGE5dPmmGB2317GU9dgIGUTZlLRNMDHGTicYvxIrz215Rtt5oSldi2x4hK9PCotuRT1PMH+ns3T7b3KivEqBFLh4XogpwkOSM3qTj/V+5xNhgfOcbFFflYbUrYDwYpcYUFFvgTbFKk6TxOn3jHxo6NiBujaZgh6Epw230ByoiUhOCuQe2hOtU3yeTTINEkoG0KXgunAlPW0pgXmmXFG8GAAt8/UFY5ZrxCk2eeFRsybTqGMLWLK/GJu/zxMr2QX27jncFwKBaVnI035rimtgjVVu9QhfiyVC6K5e841+vi7uGddy2oftdPZe1+9IS/mbI8DvcoH05SZjF14wwuPqLxsSV72SrgL4HZpCY8l8iEf45aWjnXBqG5BeViWm3IIgtAy9IWhNNZUgmXgk29VY8nb8FCFGmJ41yfIc3PWorgjoDohMLCBQzZwwAbu903gHhs4agNHfFomAhiLlXwH17WTR3Sr3BDDS98X7bKd+UnUzHfSDjqpXxelpG0cAiKp1s/JtJ1M8JS+B70bfKaYwwkFRI0QSjJsVSEsp1OcEpAgG/JhWkm+nE6uJHehYMPAxVIJMDNFRUvggqJZNqe5WXPU3jQcFs+Kvlhx/PbMHK8taAcX2tS2MJSQfeuzzC5lJ23FdoT1LMvW7Tx+6751wEoV3YlHeKfBfzPYTa0172qp/J2X97gtOyykqIsqALmVqmrWTn43rZzZkNRD/Sdx2T1q82RoGUCdBEBRv3UxhwnbFKImouaZWmGOr+OGYOVm3C1MZnbBgzPg18HjJKozzNa9/FQN+Plpwd4S0RQmdJqCCMFTNWigSrtojhYNRCvgamLD3DSaOf0pLU2g1SyWqoOmgHMDN1oxT95TBFauRrwUeXXgNN/JlGvOzVpBS0reMHRajaBCWZd8C7JzksS6mI3l9DgA8J0kz5NoUZ6LIkNXAgXcmOdgYGlVrX+QGx+A9lojWxx3YyCChxsC3Q6Cbpm0UDk+0WRyVDw1q1Ej1Q1mfrp+mJ/B2bA+FWdyrskrFDjKPKMzyoXqLDqd+PE4t1Atu4VqyyYLFZAJCxX5OcliNX2MxapBnpLAzvhiNYU0bCbMYjVd6eZUuVhNE5nFasotVkTTz0aajuZZROVi9biNi1VGqSxAhL9jL1Yu76TFagsta0ZdnfK8XLT4QJAxCTinq1fuIsaXMAJF4/aPLGFT40vYwsgSdvboErZLl7BlWcKKb+kStkAFgDv/nSXs//IlbN4tYfP/JktYoUtYgSWskCUMkx9L2NR6sZt2jy1hZ1EH8HscHpUl7DtLmKM/bi0bTzrhRY2wqBEZYcc0BwMEhVznTd0AH3PftPmS5NaiKV2LOhSRrEyxrkz/x2+hTtItFD+W6Cx+AGHxOOmx2FDt5MDOiRuqJblwkFPPrlFdRNirNifpGkY5IsbXqB4/gAd4nPSdTde3YsX6zor1nU3XWXjspMfhsePf5fq1F9XIAoVGGZK107za6jVNMUhfqqRsR5m7ktMRNq170uq2E0/QAHnuOPYWDkGjeZkejkLP+CPeeO7nnAQmfQnDp1Zpt7nGL6p6l/vyDsM3iZ68BqCNarkaIdi7F6U8tcMfiGHpxKgfh8TJOJr4k0pZRYDSiOTRNfYL2XaGCjftGZpqv4hmr6rMFfHhor5R9RfWpf3BAPZ86nwRxpcjKJTllcrAecxrASS9Hv89tYy2OXt57O7i+C3PZcXVCqdCBLs3oxml6orFncNcPyLjUR+S6A4xPJ9nXGqXwA4A5LtHgIw4KqRboumWViGisDMQCU4YIrUThkjtWwMRd245Dpx0J0QL3xQniHcjSyFugxKcB3/ZWr1Ov5dVq939M8E7NcCXewZb9XoYDvoDq4xu9QL1WLx6EH5tEPhw0V2xORpqA/UgL1JNrzNUk3oXRf1vboeCWuulekiBpqhzIo8tnwRwee44yhh23D14EirZprC/S30U3SPns3UZpfrlPeQlT5TfrI5LCG1VeBq849XImqjh1QStUqv7AYrLpLj9/UHwQgqzn8dZijQaM48faqVVqlXT9T7neo+x1BMJFqnSqo8+AEyFRxoGJGO9NIjDGn4t6pcXjBIBodkc4FjzgR5q6SdlrXqgr23JpKnZL6NmdK208RynPxuGOgSeVWU+GpR3e6Cm6AAakbMmNRaoZR9RtxT9A4VTD65DPbh4MIXGhFiAjfTUu2Jyy9zG42yy4AhF6+9y2tABtKH5NswmCtRyqQaBm2zgdg7gGOxqCqAdfb2nJrMfMM+7NDk4gmdVO3rdFnDUBu4xn9yP5wGnHY0hKTXX7TS7DCf6hIyhGuauQ1MRXSHxu0C4SEe+EvMlfhtYr2YBpDIoNOh3yhs2GYc+zgH5jFsdVMYBdAgzgedBUXNWogCru4IVrTNUHAfJpghEDMNX9QCMbE6f1em5BowAzt3OYC6Cf7Dsmu3OWdSBwOkceE7nwLM6B1XVggT8lbqXpNT6105BD1LR19F1tlF1WyvGPmNZx2OcFqs1RF+tAUId3fi4E73eNgOZ63bGlKewo6CWtEX9yhSpGk1KSwFqa0UyaLKNRUem1DxtW5LzBGeJ9/uyf+xw8B4NZmhcDcrMQhRmdKsyK83M55RwzStgFiiW2YiHOE5vISQDmkioBbqg9uz5PdXdEZX7I/SF32eI/0oTNinuL6dqwsa6qZ9hxkwV0c118XjCdFky1gDwrE1I7+XLxFsvqGuhzAQWa7o8UMIkL6g1MGpaizV1qpfCAW7UBi4ypUX+0qr/zpsbO2iy3irnqvDM8q2TLNZso620DEX57bR9gsUammyxJocFgWKCxZodSNg+wWLNTmM5ZPsEizUnubQxizUna1pxCnYlKHrcYs0u+7kYw8BDguMWa05F7JjFmtOOZbHm9E0t1pyxqcWaMze1WHOWs13yOOIeuQZrk8ct1uyebLHm8ZtarHnCphZrnripxZqzN7VY8yTX4FOomGCx5hy2oLIE8yvnsmWV7dSj7RiJgs6ZbLFmj2aHwZXt3P3HET47hT87RT+rpBekqImqOSsBUoJ2y7RDIw1KceJJZciiy1bayiHOZJFD8QcP+e9U/nMDT2aY6QzzNENIlQFDa7a6QvS/3RPM25ABNBmwUgWI3CEqQUbVvi8LyKoAOIWr20bIdA5nOkczVdKXZCmYEyOENMes8UaLNYam5k0lqDnM9tXF7f0cJSD0KW0RizXpqGWamqbP0Yb4Ovba50GJhrK8Rh11Z0zniXRYaMw9ftGDPZqCsVkC22lJEu43CUt0iiackhreVmvaos2QLWbPNE7fziFfSHZB4yWfY4rUwCnutlsqHJ8tlRjVzGUfxLeIowpaqkR1EXUKcLeM2omoJSo2iOC2QPiyhWasvm/bmL9JhV9VlS0WU55frhRPRsIZ+QIeJPZHLuDeXACjNxk9mS5YzX2pLp+XhuSL0sR8i/Qg72CdwWLgjNzoKrQgpmO0f/kctYkf51nLFDk8q9VUSgCxqywe58EYKURYMRxTA7Y8XztOkDWypuhHGUNuC21IzEwi0RyV5SxuzEUm124uYn5DIkfiFrpcqqnRtLS2SeocDeBNDHipCyM3dcVk6cssLE2IkZtshSun1Fq4qRnhVLNq4Wa7sXBTIw4JBjcxiE3jMcZYuOnCwg0ePsY3RdQFSL+AzlfmrUWeMbTQ0CtOSZHKWW+p4NU/ULJxDWc11c4/aqhXfGW0+tfDbqqmGMOpsU15rTOByt+q+VPA0Sqm/l3gO00qiDXqVp1ZNcdg+ELd5KuJdL169HtgZdIyoiWx+/utFxaJbsQalFCDeZ6/cheskdJa5SSwRzA7DVdETbB7HkTrHiM8/FnJ/eof3Y/7UI4TbanxS3CCvupkepRI8wphsgfl9aU7B+D+jUppdq/eyE6pjko2/8Af+YBah8U5ef+VuB3XEEXE7DaBXLXxaHr6rNJfUN4QHT8oZuZp1Z24l/syZ3yHWSEl3BRjTgagNXUFNgUXbq3BwAZIUANIVHcSAG+9aFWMB9vwHezguTUcUnjzUO4er1ccPwcsJvjvrLqOYcNm6A5MftWDV4v8ur/gHwrlAllkLLJwglgC5wfaZu3D5LIlHlbv3FMtu0l2qdeE1uyE8uT8dfZ6sYIccOhGCXkVUUTLXKgDm4om6VBFQ0AEoXh4WKoVV+ecHA8HlWYon1oVTbwp8hJ3Mc3td7Cl/KHNnBbozey1BwOAgfd/388R/HiOPi61IotSOTuwQN+LfQ9uM+NQSFU7YckF35VZpGBVoL24h7Ljcvt6IbxHiJRgj9zXhKClIfXkTd1diEnhbEVXz8JtJkVW1TTX7KEczrXkgXoqQYnm/CtBMka5RXV7csSNaXOT27yyJCpyTIiToYqp52CwGVAqxRZN8uQgrIZuykGYRxL3nGejzw3Ra80+A7qglyU9BnRKSc79VZA1lQBj92j3P052Kt3L/hcGSYIuRQv+66qKblY0JUmVdJFT3WYyKLAz0whqiqYu4A2/QuqigSJeJHGH9UVFU00WNbO/R5tNg/EtmqxF6DlnQraa2gRd4AqKCIQqIwxaXd5avCH0YRVq3B4UGSvOManZqTrGyfia5HAIb22hGYmGgB976PvUYaXX8gH7RunqsJrMI9QYMVDdcAaqG+MGql26pGKw0ABZoux/2qJEIFdthhraD4njgfphimvRrlGVzDpBPI7ynQ62JP8NkqHanv0tQkuQSWRDNB/mqY/UgHsRRD97NjOOFeyiiPDsmmeC6/kyExorcouWn9nnpHRqAOiN/h4RW52NbFyh5sHojtre5twvQ+6rdfnm2e8rwiWu19UuAwD6adUEtjPa5NfSfzmjVVfJ3dV1RgwgR3NUrTnI5Tbzq33Raw70UzgRZNtHcmU+VpmJjgnFQLu8Ub0CUsetEDOKLZXyTFKD9oyuuPu0jd7xh3Kc3waKsVsuEaO9Ws/xp9Cy6zXcEUu4nZfszzPEvsrXI3uEr9PwjObWQ3tbCimT2eYDfDCqcoGtkS+iRaZN6lTDErE6Z26J/ceiy/yyoWEx5KlMw5aQxu1sG+K1aHqFMpYM7fJokRZAu2ycHuLzZcBnI40rwTZEqljJYzc34F1QaOMC/iqH79pD7bSe14/kxjKi5MB9MkPTJmMsdje5gKIn2w99fZW+OlMCMUAc0wK4WG6pPZKvY4exhGItCiCqciQv5Kir8JEjeU+P5L3qkXwwSY6EI/lXgxdBaFCGDpWhA2Xo/utt6J4ydLQM8ZDbo/l8RSxL7qgeze/o+7JO7cCZbr6DCnPafJI9ba670+a6O5o3jrgMGlHdGUM8yW4eeiPHzYp7VHdCr97IeXOsJgcz2RaoyUG0BYfz9bJB9c0ahPtGHrAFexfIK4/foNnjtkXNPta1LQwnZC8P53fo4XzBCbZ1O47fum8luFIzBSjHsaqZFWbI66bmPNaS1crtSdh+W3ipTBHwGzmH38HvpqmzG5JOQht2cuknUSdPaMqAa2d5RF+3R/TYAmLaY7VfWod0duyIPqMuoBjgEP46Pz9VQ9frebzgmoOJHsijS+hu3ZzKO+DSLpqnLQawIyoPGcPTHcubQqWQIhkZPQWfG8LRFoDqn6IAc7XirbBEw7VPc59MPc2/WXPEiJ1BNq1NUMNVqcUrkdKSXaQjVRtLtafuW+QJA+2JpWApD4ka7FRi5kFRGotMRVHaE0VpTxSlvQ2K0qnwykOxseXIfNusV01OVkVpPFVRGoWrorRCXdcwt551yIOq9KKop3V4NFRVmh+PG13H8FiuLGGzWqBZzoBeI8vZ9DGWs6ZdzrLx5axrlrNmqSnt+tktl7PpcjnrVpczpyldp7O0CrFF8jjiR1JZ1xapPXldkz67JQ0Z3ZLGyEEnVXIv04xmtAta3jOLG39a1T1MqOciKmtbgkdil7jpkSWuO77ELY0scWePLnG7dIlbPu4Sd/+ryqWrDB0tQ0c0dEJL4dK3cInjdpwYzeaGfGeJ+xaCK9UpYZc4t7pppXmshf5brG7Turp1N1OZzgDAx+Gxs1zadJF7mVvitPluiVPq75Y47ecjWOKum7TEudFzlY+vbqhw4uqGpj361c1UOU6ndrrVb2L6SPlj2mWj653ToTYGqoWQu0vEx9h06Wo1ecfllqlMl6mzKNDV6v+WHRjUqGPVn06M/vRjsyPbyYGdE3dkJ9kFjGKjb7hha0aJi1eEnLSOqRL1d3Zs39mxfWfH9i3dsZ2FB7Spu+jEd/Zvql+N2jAQWIZctXizOFTVqN64r3MZd45lHN/rofZNtKuPue9DcHPO/LqSRJWhozYE8izLE3aLxVw/4YkFWy8briIFjLOJgKIOjyEVZkSBmvBDPR/EeLThW0A9H+CwrwJaDqgJGMTSHGY0VDWxy5GpPUtzmNoBzYKya41lier0wBgysWZk5kzvKT0PxZhm8XxINrQSIl1ugZR2eZFAZbSNCC3StVL7kOtpipwfUERz4Af4ffpa5/HCKuem6W95nn+1mgDKvnC9qor61miLan8Eo9ofvnhZh74qhL13/NO1B2sAYPZFfE2eO8eEKr168hX4hGL8az2P1D9O9Vs3q52JEHWemsdaWYBWiPrdcELpxH47vKrysXN94FnfM33qv/X6A2Jd/w3Xitxf47Ov6ilAxWf9m+DZYMyPgmWGFLiBdSyJo+6IkcEmJaRx4SUmLuLX1T68mePY+0p+WzHeJNVrfdWZZEuUuz/9jk+9g0+4fTF86b1EHWwTn8P2P4UUjuTHp2psqlIdMGYfFwvF4rUmONE6Q1NnImr7FcVLVgr1+i95IReg/grku4iC0vOlVKPeYZNzzVdQGxcNSWfS05Oy8QjlgbTsE2jpkp6IRqLOiTTUZTUJnJuJTpr9DuJq6Ws8tmwaXD1mXtSXE2LRGFC/24xdFb1xVRmnGOsYTtWsC/4o+xlweeD5cKacQbUfge7wMDrmFMjTEc/8QfoEz3sleaeqc3+x0CNwk877/Gah5ZWOWtPXetbTvGeOaS41NomZSgCJmah4mB1YORiWSIzXKVoT9XNRHLWK+NJNORkMtB8yJaLLiwAWXkOCK/QV4FKvCI2dQl+/526kHyj9uatmutHiD8w7EEXM23n2Cgr8K3K5EfDDEBe4uvF08DDxjEk1ffBwoWz1C4MKtKRYj6xJL59INPAkNNWnFInrm1C+EpC7UpGFC06v90bM7Dl/FcZvZGiMwOr0s1YMd0oD8CIKvfIIcZAGBE3w4LYqqmJetLBE1leym4Eafe9HALXAaVmE6Y1xCMem0KJ2hCY2yTH0Ynb196gTeabHH/8DvWuhFr5Dqm+i9t41Brx3UR1FZGogbCceojpOVjUiEju1MI5NDWhkQJMl6rPu+GVXQXXaGoujELkihiRCxr9r5M6pI7XnrareWnJdy17GTxcIYyvJbgEsJDrXLLnctJBbEMsSIg6hCzyynjCsNXt+SnVUKXdn9ayeihTDg14ADZxutG56sHTtokb2FtRZRITMRZMiaLxhu6itkIJyKA/wK1ch9WS34pulcnltiN6R61MRoY5y90WRdmxSV1IE1XZ/mZyVyS0FMnDNalYAb+rZz6ptCNRblxyyspsh0ahE7oaUn3Ce8qsQXynyW1D5MHCqMC9C7URdlcifrSMGOgBQUwPtAXyMt3wgTwNwgMeryBbKTZDaEZSZiIGXW2AZLo/h0YJZbdyRyhSQaHZlQoqzGm4Vpmbs1spnMnnTme7bqwNKAiWsR+CuBI7C/SlZFCz6+Y5Y/nIYgc7jJDyyE/5QXM54c0/Iv6QqKwk1dsynMRgRYG0fgMVbcjOmdHRzzvpwr5DBgz1Aez3BMCOqa1TInR9nEZuT7/+6SR4OC+ernZJ9/+krD/z69hf9nHiaLF8u760VEWKGzlHFbQOOG7odjCQfvm3oWE2DoEH/YLwCI3Jv+zLXmT2g1yX4/CIWHQzyqx4uumfuYxX4Rmm1+zl714xSVehcGHKBUPBqqEMwkHz1zCUgsjwxGM02tWVNgfBJOjtwreNCZBVgf0xf9nAnoAV8ayniOuBXyxNj8wk6SgkurmwoiYkAWoElZg31NDgBeKt3DPq7JBPcs8QbjN4FjBWKgFhg2W4nsEZVxV5w8xCPyw4LPipDA6GF9RHeB92Hg+1XrmCth8uWXLB1kIfl0KgfllxYBvKgfMb3Ar3SGrpv1cwCyMICtcSe/mpllTpSG7EG627FtGulAqdPnqg3qf6mnDr1f+t14FARb7Q3PaZAmvQnSBL9TV0YyzLL789e0exINS7wfYlWXU90sjRC6lVUUD7pBaqiN2mJ9ZUPhxZkoEycXTgZMtKG533iE30KsuuFbocUlpFX9AoHUnLBK3osK4yyV+MDWbuj/p3XPwUanyH5V1gXexFHxy9dwaCVeW1OT3Ia2hSibcp8Vhbs9L56UBdKQrX1AnqeVVuWVqyJEeVG7o5+/N6zvnn66ZdXLz25pgeVpgtxcXc0wReHPKqVflKwhvumQ9wktWWRC17RY8c6ri0UrymEi9hmOTJU/4FgW7mcfU+Uf1/B5VAKnKYn13PbzVQfSjVa2vOR4zZHnUJYYaSEsdcUOXTtrPNV0igF9AEIVa3kjnCEOg8guKivFpXzsioExSu8TSD62EMSciyGZOIgmYxAMq1Asm4hWR+DJJC3fhxIJkz2RyDZYFgCfinVJ8AvcfAD3MjLmZxht9YkCz5ohqWc4KW6OYSSM0jRKFRxZ4JZe6oxzfsOXA1coVEqkC38Higvv3NAIOhdohMf3KxwDeue7zmmnCrUS902eesgSxWoanfy0JG3kjrdcyeWvEz3Fkl5gbMloWW9/Avy+hohSD4F5fbQ0UKf/CoN9F3f/MowveXBIL1mk32N14fheX6wV6wi7MEPRv/KPuNB76rC09b4Nsu1nMVzWbzeVWi4eAx8lxih1a0NxAQH0egqjfwpQM6fBDl1wKQAVGA4EMyVl1kzKTx7naHOAVh008d7Xs3NpbB8uaJnUCZ0MBOCvw5GqTI4tw3Ts2pGIPVaWVOwY5A+kX+qL5tu/2n66GOQ0nMYivgge7VgqZ/9o5qsVgZT4GkcIaJfK1DCxBX4/+z5ujH//5jQSaDJmKXb/5cgCzCskyKCdfULSJzM7i7Q1ohkA61orMjaw/KKr6HmWtqp9X8CsqbsG7rcznBh2ccFyEn2VgH9//K9aFzGJN34urspUZOWqcBJujKixRs4Ld5gXIvXpUsqJs0JF49edVayf0ZWu6evZf+ir1ACD2Q/0Vct/UC2nNjPRdjPEVgqoVuBZpZtP3R31emlXpVHXCDqtXiE2LiIfyqA0sN38BwgN965WQM0iyJ1TobsecBP3Z84vVrfYfZ/xeCiCdIAX/sQSJ3ky7x/UDpjuuMJirlX4W6wq6puY4ALgnhpeh4X3+8adPD7N9rNvq+bfR+z4huKhU6cEUCWsRf7JbiVxFA8hCwgb9ppGQjJ7CurZXEMKYk0IklfYNCW0Bs88JFAM1R4ghECSy19QATHI8zgkibKDlxgqywdsknbRutJv5tb2s9MH7lJFTme1oQCEAL26N5YkYiCys4vTP8iCBvXxMKKObmJV9olADMtRSls+e3AF6wYxbQqQBSjoLqnlAx6XyWUS9fKrUN+xh4Yv4ptmpxX6YYOLk1yq/3dkEynB/dfx4QxbxIHH3gdgkZw3qI6Hm0R7gW7yKtezCDI8Yc5XJ00bxnmnaqpeQ93dPKQn5mLTl1Q91wdytaL9hD8qkdThFANpQ1RI/YCHj+I7/JfayTpxC3yEMiofZgC/njtPLQDn0wjfleeaoYuTR+m9lrRZikURlEu6vCLbnvgvEJ3bSE1K9xFU3zXFFn/KZhI7paRBw33z9Yk0pdNmZUumE2Z5yxP1NJ5/nFToJb9mczArZNi+11D/p7keWOOM9RpRcv5rHiVHtq7WX0mf2V3dYLaKvUlc+MAs5i5LFNF2qqRq/C9fihuvdxyJ3u0nKm3ek972q1fuPbIXa/9+lu+wUNf+t3UHZ7yHCroVlG53TmbA23gsUpS9U6XOHClOj+Bk98wooMBsPLB8iU6jPcvm/c1dw2t0AttenUOEhl33qFjEnIAY1mXJ/wE0MW5bx2N+TJCoP5oJQ9qtW1BWbQxQoJKOJBsqAKy5fSuIBR5jAPaUd+tVdgFVJApNOJ2XzBZ7KkIFLwqAELyXJf1JpcaPzFHObSB/41Ar5QFU6r6euU1JLK/Lqdlcn/MVVyggxTyNWVb9LoWHQu7WD1uKgPmLGh/wSATSU8RHC7CNeMzMRwO1wzTyN0kDzL1mvZWJc/6tfYXYjPxBl6fUI3n5EhFcrgI1uSWTkRBpQasraiYBSaQnOFEdwOQjsth+TxOjsWKmKX6RaC//6jRP1T0TwT9ERLnqzoLdFzzZHQ2BOVsSPDKxLtTYn8NaE9x5dCvaAjiifHg5rEw357G1hXzVfC7AfMbkzAfRRvMRyUcaEzC/N2Gp9TLqt4KGCqs9B5fv+khmnuFTVvQy94r9OVe3wsqFC10/Bz4jewNr57AdKkUNhrh6SLH00XjPJ1LR6rydA+nCtyT7KxI9huQXfEK1pHeKK/KrpHveLsIl3w/iq8dWxdpvqBk66DFBSw2bF2kbF2E+pX1mMDW+dyq35JyA3NIIYai+En+KFsXugXg5/0QptdwBvOo0BhYK4iMgOwODxt8PjYux5NxGYiFk2mwWkpdw8mEWw3OxCeEvuEmhDssCXcI9A0noe89nh8+6pVOjtY2QoDzq5BcexqDZZ/UU9QKwhVqD/V67oYeRpN6iCJND1E4B6JJPXyb54UVDj9UTI7srkINJ6hjZgjSQnTdN1sVxPEeT29z+pjLMUKREPsg+3GZCnajU+4MArwCncHmytXx6s5A2WA9cHH7hH3goY/WLBPdv8PyQ6FuFODXEi3QRmeHVKpgOFvAemzL8KZX/zvYMnwqCtrCrLkNQ+AIKs7BQ63c13GWHuNM3Dhrxlzuz60IGpuYmGPIXSauwVO/Sapz0hmStJPq5kDSJEGQskfL6W9bNZENkYOQlz0I8oVtRD9zrym/hloRNOT8/nbiv0t6miwMPU491Zvxu5xXNj1UFBseUyXJj5BzSm3o62fIKYcmHeYHNlGdwWzEWRHnKZMJmQ+P5NFJmKmNLI8CdbArHtgg4DkDbrXd99lhq0+gBsd+WmcJPoEPJbgC5jCcPHpSkKNflgOQKmkGGcyEfsBT21cOWmL6AuXMoIf5DLgst43KArmETR6sdCDXNHk8/Ks0tdKPGSYe7CrsuWqFsrKjA5pRPY8N9gqyCpOJxaiq89FGljZNIWrKqG0DPIAM4KIW+SDBNPJAF9NUoVhWxoxtlO7YuFHaNikWREM3Lrsn75SwjGOzlN24cZN0m9U4YbNfClAPM/GCquc7TT6jkrx7PJkqyTvHk+cqyd3x5KSS3Kompxxb6d+nPC+62ijOVPhxaOL4yl9WnRVXz+hcbKwekwXvK+OqOg61EheELQeVj4f8kPP/yl5jODxM9bUiHOSxsCMUjGWQT5ErjykCd27WzhhHm3ns/CGn6fs8L7xaHZNlIFROvqzHVWWf9o5OXAMJzmEOWUBH+THEWSS/uM+KCO2p7MAku2Ye8tZCjdNgh+BycLO5F0gT6knc9FtMRAJR+te9GMZt1V5HBA64BquorER32agvRfQ74Md9tZWRMYHCsnvVQ3YYRICMt0gqllaStWEh51ui0NSQs2apRxxe580NtiXrVB+IGCelMG8xwNtcdItayoy1143VHYpX1rnghLRAka+gqS1qYx/VplR9uIKRewbHNnnQWk+XAftvukjWCESgz9pMFv3QaadKEopGVSQbTk2CHpvQOFXoVyMI0OnQolKU1ffSv/NPXKkQdYwpFRYhxzqlQq7tOGqEqMC3aoT+j1bUCL/J/zyOfICfdadG+NZXOzVCV8vDUhzc/9irDN726kkqgwB2Nnj1uMrgYcTV0v9ZdUfu9EGf9q6f+/OHbvz6Pd94Mualb5T91ocFr05dJ2uQkFp3dOSDr7iwtEzmvMA2zP4B8lssZ+5Ew3tsNWJuBtaM9QN4apGzK7AoghXZ9infoDZRQs1i+GcrtsJ6bENG2SqkCPmF/724lw0R2d9l2Divf59dmzxlWj3SE5kMoVP91rn+HEIshIRwstKwQOYAIGp7GpiemqMblZe3qHr4IIWrYM/Xc6eaWzsqkE6fBzhvYr9HJ5UwVCEwxxgL9bLbtcNgqx0eSSV2Bhde5XRHl1/S1mdvr+ywzZiqzSvPyhz5g77SEcuaW60rX1XwNpyz+DAm4pPhO7RSnB6xM0d3evShPErE5WHj5YrT6IHY2z0wJwZBYosVffblOLiZzYSLbKAvu5Ab5Z1jzjdJIm6/FcFUv7hjwxdvc1/c4b54F4LYwQ6aKnI8EMt9sgSb2kiCDbPeAepVqb4sNoEY4TfXtmPEHpjpS+OoydbnVlDizEr2TqQDnRQ3c4bRet7SjbNoHzSBwNk7kDiJ96XWYKjG2BLOb+1YZQCwVRSjFPxqmx+eGoCb4r8OFy0toFQ59SITJhYfae3UMSpThVdaCAdHgRwo6yJcPBfX2H0O4IAirB4f1FpBCnfkfrox3kv7AnKqZ1/R3vdhOwxRCEha0RTOu5m9Ex1HOWKBr0wXPkScqvsys9fKo3obYMiBax5afXi3KU8rRl1T3ZJJxTo4U8gCWGCjY+poKjcPDPSQrMCuWN2imLJz/AMZTSFlCpAtWeIOKuv0M2OgG8hS1pZP4yBm3cs9HQyFPNeCdQQjhHIoXCln/V771JwU6lWjr+jlGEiOCjRS12Ee8wBjPoP5OULWa+X7f9r7/F4xq0pIWmQbiDvH5XCnb3toThws3/ZQ4eXzthVHLrRPClF9scANgBVf7TnPF+6zbF46E7SAu2L2sDPBeu4WdMJxUx4XEhodnI6z3+uTj0ppCy3SFPi91f2/ygjw0Bzu6HzZ41L+zqMtnN+/qmduDYEfEF3vCo/lWbW7FoBFGRfPtYUyOTKq5x0KEc/9mVqhOR6BF77laZf+SfsvL7RPmudeF/O0QAvjpn4nGvqFGcXFcTO/iN5SGvm90z71yhEhRU37ftg+XYox7PtB+9SUAk0SSLQsF26fyDAGeCmMtnAaHvpfadr3w/aJT8esAPOnE039bmbodzMzv5sZ+XXGXpcA6LFGbjTxO9HA72bmfTcz7ruZad/NDPtqvAJ+cYJZ395D3zthHmyB1dplNki7lbq0FQZpF6k30dAvCiBkl8wLtET4DEZLF/SzSvoWQTK5NnegqcBC2cUWiTrUdOaZ9X7kgRawm+ZJMwzkG/3+jqb2ymZuY76wrMDIMGZpBn8XF/VekanK6XTeGZ2+U8ILTKlgn5/XrPCsFNN+ISY1Dm27jsjVQkDlSzJ7e6ZtGq33zzcQODkKxg3uBVOeztWQJzW+ybmUspDCl9IXpSM+LlkqwXUEFP1G5eOElDqyGHdGyYcVl2TalDrsv6MdSgGthVltk33TNmqvWtd/4SfeNp9+IrLPCRVjxV4vPKwRe0VfnRWt5faMV21L9qaK2+dde4cD522aFU9DnOE0AYIpuZDGgiNqivRoeqW/l7sV6ADlvozp1CUYKJoRg6ObDdo4Nj/yQXRj16yOnWFdtoyWcL+Xb4Gu3JZxYMFxnsGH7iPAh+7DwgfATSBTTBlh2SyktFMwSjDNCbjr7CuXJWpBU7y3Hae7pjUdLLhar4DBgZF4NmMGcnO49RlYDulYyHAJ7T3d1DEmzjNBangey30kFtZzqCIRjPQZIw37oxvUaceXzFKQb+OzEK/v0zae3D0RTQr8YlQEHhhd9AR/fFjBfrHC3+ElOCa47bLAaKLlyKvCUYWqclPcaANcrPdo9FXKpVKD+5BwJsAZtQYr2gY0v1njXlzDq/b9/FF1vH04vZDceAVsDDw1qqmvi3Z0feQAP2HYBUUFV1C5jt7et89iAXlt9Efts5gH+e2CvnCA5G1htBoQbVdNVq2GukKp8TUCm7ev2b9SmX1gpbJ6Wf/AUd5DqYHnEhapGP1kAhACF2x9eafsoUA5pHrenLRC5YvBXsxj3OfmXnXcREbvfH2V/UzibFIDVZVBlmk1NfJRvrhhLukUyHQK0CIw3nFOffusRn7UPgXUCkidNQIjANFZ3sbFtrTUG8kwGTLdHck+6JV5Ji1AonKuaf/APYAj5G1tbBbED4hPWd45BoRCA6Fmpadoi3KqXdd3DLSgPOkGgnSO+pijUyqpE+dkUwwQC45xttutyAc9kfJhIqGbme1lnpn1STsr6/mRKF/UyaOVmCnkiCUOlJxrukXNVSFGqBY9GaWJvoWmlA3kmpZtU6e8keMTRucYk56YQOFDQfTct0vrjKRNC8ymaVaes7QNV1m20RyANmf8lUFsm+Utt69NlKyuKOF3knPdU2izYllGdpMn97t0gxG85MXcTizvWDdBtnQLYk5yb6PWIG9Vt3SQYrQgejZGbfXQ4+OTtMPGYvt7jqsdtstph/38xoOP8z1/VDvMHkConFATNNVYIa+qirnaC9UGRqHg4rIDEAegtwwNFYqNCHmShyvk8XFWejEqwSk0TJVwN0X1GLOeR+7A/QwXDOFBBAYsPibcBJ6YeEv6p0nqQ2LPf7ifap+BO/13F+hUNItB1NZXNG8i2QbXKttgNAm62irR1/1tbQ23UsQMCBQqk0nitzBD/NhutolZAp8OjiVu8WsbxVDb7manaEppKK4swjw9drOttaFsZ4sm9rJNalf3smnfl9toFWa0ZXlz3cs2gLppPxRMb1CcJ5QKppqbci0Ovd7euIFbgbwpT8IU3Ffub2u3rRUZrAcNimkK1EkrtQ4XLbxkw8PDYkaOOOHIzCvFLgBZRPwd9wB+LfhnSNP60sTLYJi39CAJKIZTitEDFO4aik01Rws3XodDmjnM37fyGRKt1eqhlxx1FG2Vrsj514Nv/9IfPeuHL9XzLzfGRy/kc6IKClR1V1ujbfArVVCtCutiZs2lZFSxRL92mEFynlMwwSHQzNqQGziTt8xRmTZSTNhTDQVf3lPzxDjbOVGOHj4bKBXW03Wgvs/uI/KW+tETP+t5Uol3uWcqH+oWjV0MwNmH/U7GIMUxFFo2GMgWoZfXTVun9BYDjzVGpohu3hd+3/98518959M/ckVbh8k0o14mYCK13BuyVN5ahMphsnlKZkgqTrdchgpGKKqTZxxV4o5+UuXFfWm74K3oIfsqImytubGpHFxSAN6gSrvvm0S7x2L7uwz13FHq6GaFPcnEnRHPSfFBbt0HOHgb1QGvnIFm71PSradjXn8QrK7I8gwV/l9BGjQXOFr8EuKplwKMCg0/0x/2ofWIJinpC0rtCnu+HCIkP4mo4qjHtTyyGSgyrgegkaTKTvY6qdD09JwNeslqA+JDx1t1/tH3QnT9fdCsFpNfKgBGvvd5eSxR9qb+uMy5rjJnsW4lp44xCDhvYgTRRNIcb5Q04zBFbVHz0mNq81Hfx6R1R7xC1F+oZgTNdeNERy+8WhcwqvDmTxIyJ6WQuQbGpmaVkuucgooFYNbvYiAPPSXrFqhLLZ2p4osCQKs09l8S/MTl2W4o40K10Vi01VVslNrrYrZORqtvLXL86U9+LcQC/349MiT9lLzsVxFRVGxb4GGwD4v3N30uQtBzXXLq4RL/4F1Ny6BH0IuoiaoQ/5RJekV312jes8/xz0aIN7F7eAe7R2OfiTY8U8MXneNfVB4Qkj9ylOidWvuBc2s/IKHg0nODS7mWe2qohn9dxV9EFH5d1AOIwq+Lut5DFP+WUVAUOuSdx39wIopk/GYfsF/cjij8Zv/7WhP1PkTh10Udkagj1aijiMJvf10k/FQT878efl2DxPovfsuosSOyouYG1HFsOmKGZfsvIDNKXwy1saezvqCZqrMCtjjHhgrYL9m5GOpJrkDeHWrjxY4ALMNsKN26U/G1Eg+MKAwDZb+mZEHbLJwiSM5vX1dVF/4g8qTp09FmVbsu7baI0MBTGMohYEsk+fywHkQpkriSBn6XF5TUyR1Lgvbfc7WeGvnqPjIPbBw0BapnknqD7Q+UIzfk6xc9H5oiTgczMu4rUHaoapc+Hr56NE2gMoPFFYmJOD2W9iI1oeSHVXMzU61M0SulMPtoVRczLHUxQ3kVNQHoYvKjqouJlyKkeFQX8+k8RKWBlqi//hWzgEV6qh1BiU+bKq3PfgNVy4l1tNn9rV//96CM+Ymw6kCnqtluW4swSolVhyE2bpNdKQq8jIzTa3WUBtXNK6/CR3O4pwMrHMFqqZIZGtcvmdGbTDhGtAFUc1ZxDofvuqg3dA9rFvZEVw98nuuxr2Y2BifMmpEMC3/Tk9xUlCrsqhqI6Hryce6ERRb2jCitrrBAXcXLQFUoKwe5Ei8KVXqXDYDYdH2NyvU1wPoa2GUuNRe0BOct/xUZUeYcd8Z4/6AGcguAgrIqLS6R4ihFhtKPE3ZPiTPKYaGuzGYoPcUVYXhZrjoq1hQb06dRJUg3+RxPOSG2v+cEdCCha/nbG0UBe0oVyG5FDXF5XEsxLJzBrjFBwG8GAdwpl3cN7mlU9bYUqURhHnM/e62QUBl/H3zN3Q3cw6mvwPwKRMuoPKq+Zc43sg/fyJeRP0GkFjA7cCX5hOcBTwNYiVGHfwX5uCSxqvo093j6vENTg9vxrHpGHtjv123gLvPJ3Xje5znPyELBWtqwRNSh7m6sCGmrYvt6oDnex0/tLdeOONBSRoC+KmnfEazsm/7bM6+9+Weueopxgh/aTAohd3yjYNKPsj9GXlVqOBINquZEuGC2X4C0Gu8ZFZzGCXKKVazhMO5qH/KRMdW7vl4RZwWYI9wH49ipK+MJ6rDuV5Qt2bCB3PG0McleGDLwhQX8CVSqRLn9PXlQVUejIL1u5Ir9gZnRq95/qGsM6jvqm6scrlB99ZCaZX+MrNowLAXW6MJfsaXET7pS1qUUrqdsAYVr6Z2eZ+3jJIU/MHqGPMXXC3PVDON9uHCKtuRXzEEcdjvxzbKYVpaFh+OFe+5Lb3Lhm2UZps91BICcv6yI/PNri/zwoLwXwX5aYldOVZ0RAwjw08w/i8bxUwTC9BcCzchpk82UzBeF2b8gNf2w7/njC59zgaX6fKG1MNcPhRIwFEZcpeqChc0/ct3jW1/4y+rgvQvBKnoBRg5tvkHa7AtF5Z8ufhaZZ34NGix8j17pYqqOn2w/k5AXKtZGuhxatUrJnpWX2f0RDUTXHs+1x9P21NCe2gk0Rrf4KMnKOsNNIPrGg4j6Dc+HnysBl2K1Ek3fSZsCS5dDsxusXADQJUsvD4lbRPCbaD8WK9FOCUpv7sOqEZV0/Com2rUGjenhms6bshKlCD1JQ9LdnjGydepevqS5lv4AY8UEaQIE6cYnIF8VVIJiJAp5WCoTCzC+CfTaIEL4q9CfcnTiHue6X5jNQf3BlJ+lD8Yi0g00ELrP2YVkhyDgRciZUSThKyTe3dTL8o7EZn+CBohQ4ac+ffJ96VnTT30+oC3DpYmGhRg0ZRywx2uCLZCtdV3FAOIQL1SF3ISrhkNPJIufeEogazIqV4RmHAm0GS1kVSP2pKftTVGxWskz08GAUumiZUykl/xyC6a33LXJKDCX5DuSUwSwFFnTs8ivkV0XaY5n7jEHLGo834iJpxDncHBautYCTw49cprC1Zmb8+kU/BnF0ki0niI+9eA0KJTpJ2J2kWYo1FoNM3gPTtko4zhO6mhnsjcKXz5DMwOaXkPe1OrjRWhpxAAzOg/3Va2tmUFR/qsuaVa0QiZWh/FuNfbCqORWwh/0cZlbOnr9n/xMPw9cnxXw4fC2PAIllUKi7NNSiP+8IsZ8EPscMOp16g+96df/cdf9Fw6vkEmX/prnhW59cYsLLlGTfwtHwV5Xb9PFQ5eOyrrBIlT9LjrWdwpDvVYUmMoP3wx7hjdDKw7WDCmUwsfi7acJ25YNPeN9D/dwmisVqBBy+3w3Ow9HDNypVeLsTwEdkY9H6OCarHfxilqJA6bIdrh/t6Jcfd8v3HfRWd+ErT4MENOdaN8tN+Pf1y9kf6y3J6lebdW2hOYShl/aQYxKkgD7d+GKjPKf6yhjX3W7HM5x2u3+iiMLksgzR8xJ16oJSiAg5TT0bcteHv0YPR6I5fmkX88bes3d1ihHNE21Mc0PnuQUVPnBA6L0L5NqvZhyl7BMDV/H7Zf70cbd4nYjwu/9vBz/gV6WUqsbIyUSz9E6efsLphLUvKRX4FiSoFIpfhym1FtvMXULTem1MIrXiikcqUxRCmsdDUrwhy8J32Iqejg/zfTwLZ+B44tVvjm2ns+6+aCKF2HuQUdE5kaLyyvmwWkEUnaxgGNOab9SJfRKyZLrm6SRidaxgYmCRWAGF3Q6INa1JGoRE38RsQcjWrSxAXGlDwC1FhR4qGi0WLOJyzSU3IJGjjYhs3mBBQ+/CdURQVMwUGiKqYO0okp7Hqpxsby/IEqh87JezNP88DD5NAfkmFsvzWLy5BoCmfriSt4DWfZojjoXC5VGLBg88HLNoivLhKdbfVn8aZpRwRb2gKrYeDI6Mlw6y1G3pKApM64pmdnTTmqPacgMGjBDc2qznmrU5frO4baA5FqPzHnDHuK3+ZN23xq3VFLtgd/iACiqLH2KBRyEGPGY2TBfNRvmX2QZqz+IwqYc8oZXW9oQlrTB0ICDvt1p4tsR/SbPmgXo+3lszbr4xH9sVriu36rMHNxXafWv2Sf8seaT6ovzDGuoOKX/MiF5enWVEjXHQ22KaWqFmqvrqr7Qoc4q7ma1R9fpPBIlLSg58cc85KqegQpiauVNzHJEpco0auvy7DNK90YkL7Dm2eF24XSqvTLSlb5fPXbOoIlZWe4xvfWWbWyo2wy6QWFVfbMtnAqIRcaU2zhH66iR1GKm0p12hfNsUweH//yjKnkC7PViVg80OZnJ0LCYphk+O973Q2/967P3XvyN/49ckBewqexvJe8MnMGskF+926rEz9XHX37zI096/l2v5aVrdo1b8r2nv3rvWe956EJqrw0Gt+37n3996WvecdPnLsQotAdDtT+EUt136F2mzSs2/35YacXQhO67cLC26QXbCIOrjvELgEIXFIPQr/YjXfYCRmo9N/JxFNDitVinByTc5A1zdylQ7TS4VTlxwYbKtZyDa1hTbxoPBBzbvkQ495R8OQ9tcOaW4jC1Ss6MF/CG8KpAKG255a8Sag5gL0fbGZOH66Bq+7m/rIaUKJJd/J+JfDgewjHzAD24bWhlest718q7qqftXRswB/CgZ1ylhypUV6I3Ytk40CO82+sM4Y27otD0waMQzLLgBroRWOrkrmdg6c9QxC/99KVnPemNs/+NmZq43IV198qFWq+8skrxYS0NZ5FcTF2tuNUpVOxHd/kPFn7TkQu4Mgq4Z/gKHQdvTZuTaHM8aPrlemSRfqxeh7ANohogQ3nr7YBf0jZddx7wJvoLCXm1uY+TCIG7beCIDdxhAwNPuHilrjgmU1ZIQxtIylHP0stYD3/AGw3dLVahMdkkapmgpUSJVJmZpwANi2FK6cCVUrSGWHCPekNKXSyiBh4vVClu8vYTECDlM9pYGwYeAoKz/HYUb0qI9RAUd9ixs9kN6I4S6o0KOFMqSe4oSKQaMQPt0M4VmGFZJex5QAL4oUn4vm2V1pwKCE0xwc9bVvNOt6XKHNzv6eDo2z2ejpC+HcXbwL5l/HLUvhC/3GNfdvPL/fbaCsXPcqsEmHYzwnH2v3S3re/Z/5Y3Tct0ZWhWdF3MPZ2aaGCiUwnDJ6quAy1dLUTbWIe0hWvjapZEBfMkL8mw3K9iO9Wx3FFbd6ttAz197+I9GeCLKfXxNqrP1GEN14J/dLIgR2T1GkeVfxQaCmtsvysNd8FUutgWdUguFipGwwLjqj3gJnQ5jaOnTMyYdlUG5Dpq7LHwHLWk/A89PzbaFqoI5wxv+xQIixGq2EbvHKvzp0Dlab6KsUBKxY0/J3nmjWIh58poNFxPmjw4/IWQQLEsu07NNZiRqlnwcgm4n12x2J0HG4zgecbgsd1U657aWJdMf8EL7WZMOqU3CkUhkntTdsNqDkmXXWvzxCgUN8jP1bJ1g11ZGXoqbKLeYU/VGlqozVW+UtdCpNqbjJhQcmrn2lrUjdWZf1IpLyr1rYv3pAiqTt7LMAU/DxJsLIbBUDHgf7MFyzWcFxFlflEdq2yMgw8/7Zv2X+26kmZ+s/b/6+kitXmGshUPXIOJ7Op8bk8v65pWFT4FqpY35Kbi5UZ98StWv30ITn4yGLGjG4/a3oLYIrtnknEsZ1Xe2d+qO/tb9XH7Wy5dUgH1h10NNFM6K+Unn8UnzsbqXzo7XOqzwZwJ1nFmXt61349fKf2ZK/i9AD8XrexnQ7Ur/EeRuO5BH7QocSsTwVRXcjHaIu1CXF1mKR5hUbPH3OMWWOvZnWoCLK9jhJA9r/NzowXW2B3B/bYXqlpqVUUg1o7WUXVolAKMUwO8NSmA7PSbrK4ZwKiGehJBz0OQzCZ0BFi62hXlBBRAlEgce/ulBuLqmHoM1b+q6g1Epd5AhFe1NAu9gQgRTm8ALwWP7KjewPfiHP2gZw7S4/4n7SlljAyh9Fmaj8Zrt6RT2edKa07xZtac7v33oEDwxViOUcspOvDcEU5tAicXy7oK8AOvcbx4hqqy7AJ2io0BHPx0AR01csJf+PuoVmXdLsOxUEVsyFp7N4Hz80vDIjtZPE3h/l9VUizaTbCqdwjtbknwJgEEmkCRM/rwBYwZDOacUO4vqsEB7UMEdxNlowD1YfXMK4KalTnX++MLyw0WDiS6vSGF62ohcp+9VDus2n5Zy/5OqqrDMk/Y9ynEaouazwbYjvn1sGCwvkBPtaQ2UAuqG+7rMgkrv3OpItYV3JV7a7pKc/DoSK/Qj5u8fZ948jXPf+vg8xcOTb9U1vk7/F62NeS26o35OS7LXn2LtEQKs79HLiX0AGn2D3g3KyElQG1ds3VutfDoPw5aJcBj7Iey++UL4DUGAD7Cw9Vz/D2V3u2t9A5jCvipwJrCS3rn+Pukau0TStidfcmUGUEMp02V1n0Z8UqwduqxSaRYGzqtA03uVpKXx5NbleSsmkwldPH7guwr5hRz4I3qVzga5YxMTYgFVTsxBYu/2ahggQNZ63LfKVg8c1zB4oJK8t7x5FolORyzEuUa+FavvHGRfRWNcZ4qAvFUgclkUjgWeKS+80IKiprJ5LlMT7e2DqgGwzpAI/0CfhjyUI3cUKiZCzkNBNXjAPKP+yC4PQrCq7HeVXblVRcjZTQ8MZS+GbjQdXdiCQMsZtZ8jUU0MbJa466qELeWfUHtYmfvxHO47x/O++dvPO2sr104EBuyh935p/XQcEt2A3IexmnmuKXYQEFg/H+4GVpEFU8gdYVvpWnCtCfiUdMb7e+m/fSq/WzQxr41jtm3xqPoW2R9cyTAhoS0Q843Rx3Z6sACD1iwoZ/g1xUnvq17ik2O9LVIekVdqAQH0KdxTD0Yec6uYmUhFsNhhernYZ6gMt/dFLm8iM+vZQ4GHlU3ExSLVnwEtnwXP3yUVrE2yOkomiBl7nv8BroHOg9/El0JEYfmEFKfaxKaU9M8InZ5kCt5KfcC2q12cf1Hla/xh0o458bmmlBbnLvHq0W8nnvGnEtnxIWYTzHG3t3ZGVFI0MsGw5x/qnow5HHxKcyFllso8ipmBz1NGJJ3eN+vfOSKu7703/+Oz8F+QP79itNDELnmGp9wLq7C8sPz5cxRU/fecmRt39LA4/+/h9dovk4jAjS/av9ZKyHPItHnuWb/ME45x/DENhTISyH0dDzd1WG0LU6G4zgZEqRQ4S1jqOgDLpf3Rho0qeIcMkujo1M1h/hBVY1SliMrVbDmHPTvzN5s3bjCt6XzewZzeOvW0Zke/VIwyRzQbcNOagpV67KauQjRr+Dww6poWCkXPimDSQbGUJmyw2r1LESUGEjUazA+zJgDwY2DjFB9BnsjWpjAJVFo+5p1wNjKA6NFGzobWNj5BtG4665xw3LGQlvEm2OYlquPmJbj2EhNy2Gsqa5G38QgsWzRROM8qYj2PZxpeHrIVR83NxfB2BxKCivG5iJrbA6FC0tzmypi49J1A4ub3IFxtcfkO63xzVsQVQzQhWKArm519esUOl19bMG0ubrJAQGjhm6BQvtwm6SA1M9Odn/FYW1dlV0iazVMPYQ603N3qLfaa32vWUENd2hvzuwfUBP2StdWiyj7ukRgRKzC7jKcomLUdaeeJ6rL3FC9+qba5oZYF4W8qBBl5ZY1I5BIdMplCyxTG4+dsWTiJyJVsjd6TcYo+0a69Nd0JxyIcpp4AirVfBG5Mcbh5bXbk5SntpWbta6JXm7F+V5FhRw9jPDYg/5CZH6lHFYAHVYpxG4p+ycAB4M6sj1RXj7B3gF3XPow8ysDFaiac97QYiE3O1tMLM9pjjzlmF0jMS1Vb0NMn6vFznbFJLW5QsQXU9b0B7c3Ve3yqfW8s4F+iOw4poyiEQrSMQTEgVv1q/kHAKaWMTaRz+CmnxpPn8HQzfKQVI4tVRTkIjrcuhm4Xq1cjDqMg9ZB3kltTRl1hrj9XtEPp2marVgGzuTYbgbJMzQlQy6QbsKgGZo2x+i/safz3JiFUjQGq08yItGLirjad9l4WQJadFylLnh5r3BwJBfE8iFVdcQV2AJY4NX9IM+6L8wXpco80m+UTSk65iZvZj6Krqx80aWOtARlas+Ml/NiC8a3SxlAtQiILSI+y9WoPYNxLp+hLflUAIgvCqQHgPQQg12+DASQgPuMPQ3WURi5jwm9GSX/vq57VV4EY5o5HaeKuzeO5/atYWi5tR5tkVbpYXtHGuFOpqrH6zGqjvWm7YZ6hMQWixtrWTxsa6nhbVC9Ijyh2tsoOzwcrxB9naMtYlNxWmfRUj/iQ5WeIvyyTqRZCkDvtnJ7lmStqIttpCVcd48Q6vW5ZFge5RxbJImWYFxm2/58O0JX5USwgoDbvTn1OBRyqGD83MF/O7F2TLiNfhLfHb+UQsITq8tW2oHGFZGKAkImRIRwxuHLuB87pR8SU5xEJ8F8xckkme3rKdy+bdw+c0lymhItUGzCXSkyLQ1fxuGM05coAW4WkeSLJe1SyafhvZJvliJzlAAUgzmfXRyXbIg7VakllBYgkJAd2gydkp+k8hS5Un8SnVo1dcXvu/idYiTa2BmxNKNEFYWpvwKQJjo5P4mAwVbbcJu9akIYlIIKAEM7q13hMrW/2ht+Ves90sW82qETajway8Pmmv+wW57S9hy3/hhtni37/R73JZQxilzj3cghznVCxn60E73KGIYyhnFZzqVcjhnZajm8PoyX8207xkvKAOzA7nEH7YRV4520xTq3XsLANxgGC6sy+2bVdj311FwLus3lLatqjWi9VkwMwCai6lLyFzoPRZ2X4qrdkY5ceIKxJbUtTTNcN2CzIgsbqI6eLtumLuBtgUpjlnNoY5vmwNvNjUifWqUf7BbpkcBIclomp2PJCjvDg1CyapgPYn6EqSzi4V4ZN/FnZBSFJVnBOy/50uFoVHMpohkMRWJo54phDLSaSg2pFJdz/9fBDlTtFsyDN7wM8LdxjlOgmR6v8rymzTt/0XmXplBlHleGBC0TK0Wd6hqemfW7SuTd+o1BKkk+TdEsTq/nK8nzlrfQy9/K9s2iuVdIm3Ehbv227A2y2C/ZRR2MQ06K8oxis/Zq4BZLcWYBCZ5jnIQQCP4c/22FXErWF6wX2BtswUj2sMmRm31ji4qg8TKxCHonFg2F4/YAdGIHLSlqb6Od+VSp9z6LL7aVE5QBgIPgWR7tKR1dWRep4y6lb2AHZgAvoDIANg2AVScc9RDXk2lX7NA4baDMA1rKY2nGNJoxQ9GKdBHPad3uRDQ9thAXK/kcbUWJW4ns7NhSIvmWSXMAkNDkEMlXTJ4DZ1TmQJ5DER5fGETNMRQzFl+nKvg6EVGnJiLqzLcAUWeAqDMbEFVpSRVRtQuh9GMEUacVUQuDodMOQ8FUFiWG7qDCYOhSn5GS/8hiKHieORQ+d2wM1YHeSssr+XYF6BbD2WyhnTRtMXT7twxDlyoYOm0wdAcwdCfidmqcNlC146fzGWnGDj3HQP+gZrjDoueS1IQyRmpaRswyEUolKkoaXmLp3CQszcvkfCx58h6z1r9A9ph6BdnsNPWsSEdmJxeLTwqhDThgZ/iiKPV1wvOzX+ehBUbTTlHxmHUzchuTjSlxSzLb72ApWxHabsFCEYA+uhmEma+oComEetiOz2Lhna0scQqQnSre2InO7qxOSRRkt+DtBs7e9S8SrUJvkoMynKg+R7dpCqezISita2952jaqu2541s+beLwgT9WweuMYh5JN9udQsSlkvnMxsr2uimvlgC2fKt0yT60L81NkFYFkPi0tmhoV4sJfy6gQt6r7BLDPwHsn/1Ta16aOCHFntLq8jS5VKAp1rBC3c2whLjZ/7HzTCXHb1N5UiNthIW47pczt1krh7ZCm9UM9PxgMKNvotvowtm6VTeLuvZDijve6BrKblfF8wcs7AXhkI/CYATyqvnQyC4/s2PDIKDtxeGQMj5mKDLlDlq1JjgzRqPaYSBnwSymAEjNYxM1RUE/hRlAs5oMgoHhWOQtAYASZmI2rgvThAq79rwa4dgVwnlZCWfU0oH14IgRtQ9V47qBgXAEeET9pxp4GeOOnAR5lOIfYeBrA4ABcLu+NNGji0LV4ikFrcsijfgxS4M7U2hRVjtQy8iuHpJi/VczJqGMb3x5vfEZtbnx70+O1zVCthr4NmE4KwSvVpI1ed6Nqj0yc8yIhGlDdxmcc33R9oGgIG25c4JXglkpdrgvAYKghwLtqoPuVfuMmlori5UaT0ukXFUwg26U+y5C7x2lTFK/ud/FnaXzbWWarom55d4bbM8Cb/tMq9lzcw3ngLIVO+0LZgNE2I9B6kWwLq94a7wm9qHIg7usXegxTHWrrob+I7HFaldzHepAxdmbnPYIzu3D8zC6szNLQztLw2LOUG3viZ3ahnNlRNJHcx+SPkPtonNyH6nNzE3LvV46lNZMj98eHR1SFh547RRV4RBYe0bHhEVF04vCIcAlgxIdtUCX3E08Q/VRP1ipqCh+4cPi8EbWQf95MLQQpx1ULQaYTVwv55xNUC7nR9xrjijU6D5LCWp3j6aDenURCbw/SjOmpGDkSwoVwnKvBiiL/ledqQfVcre7O1RIK0b24vETtKou4sv2m3Lyh92LU4lKo/LkPJ3uizObLgWShx47WiWtDTLBShAzyCOWBNHNchpZbRdIJB2TPFYMcm9v8c4a3cEhtzgNDPQ+MBJUjd1ZaOQt0Nv8Oeeq/1ze+XALxs6kvuag6oIG1qgtG1UOqiLo94wVV8irmkOf8CKritstfsTwX4jFy3yZIv0u6ZmweqW6nnAda0RHUrKRCF7G8ISL99SAAMx9MoKlFMEnTCE0P0VNvtfCYvX/4lBR7xRiUI55IOWJHSf9VKMdk7YfoEWg/wJKjRfv4mNoP0STthxjT4cS0H6q063np3zTjhlrovXqDjd6o6sXpvg0+mT7jfDJpkkyeexE0e9y4L3ms/y2WPKuvJXtsqnYp2mWGvK41PbChpi+6mh5wNX1VasIk4X7jVhw2vbu0WXrWmshFihB2pkLskVtUx6OyHZmiADoFRniTnBrQuQEhZDQxMw3rvRpw5Lv8Q36RqQgho3TFpCXweCAK+H00FlvQB4UeT9MUxGk8KFOlCXASW+YNauNYu4MZ2dl4FDaFbnmm2e2+nuIGebMKNe1sBb6UqdilmSotb2EMOhRN0GeeEavaEeFJ5pmZpwwPbk49G3VU98bTuACT5AmAhgtleaoMIIDElja4Z5Coo9MNPGYhgbpCtLASkOxEvSU7W++pxFIH16Qg/OEaUlRNKcfgsR+ObSlVK7mo0RbLf1f08ulSRQBAbHApImcUyRFcrbu2AdzTVJfPLy/q8LA+iwgto9o2tDyfAwDhYArgo0cJrOa/IrCa/wbAmqeYYNpAgDZHGYEZz34dVnSyh3QSOB5+nqYPF3M0V8bwUfv0Wrmxoul9/+krD/z69hf9nMdNngVwMefu80uxoTNkBGmmQNlty7iv7gxfxJ00OyhjaPbwmgANUjGaHt1wBLXalU9lXk+8fd3lP08JcaLqSE2DD2j/HE33vewb6BjXjTz8KuZzZPeP5V99GFif8RD9lduP0+OeGESvX11n33mW1IbuhlA4aRuj3v09+Ihmhuqyq3gEiMeQucYVpajUAKFoii5OkU4qQtCiZWSI0jmmRmiZuSOf5h1DZqaMVHEV8sQZlTSy0C9Hx/2LVcuC/xbFlk4X5ThXOjO0AL81ciIyL/DfssJCZj8PkZf/elxBN1+mkL/0aVlatZWWqNdPRGCM0vLtXBtBMi0r/TZahn+SItT7leGhkCPxQvxyQF/0UPz+QF70tPyegLZqBXD8kOdGk387mNBlWpajyZzruyew/hPGHScomvc9FQBfJb0gaudciEicwVT3qAs3ByFNy21Pwa0uB7XvW/G2P9/GH27njpP0CN6ktq88wk75RGOdAtQefr+I0H6i7UDX7ebwnDq0KKOyvQIwV4EUvwy8QUgPizcWu4BiF2hOIZaI17k5hViH8UT98vBjijJ8l+m2XipvwYxKYfXwt1W3leBtqdhBO4Zrcii21ZHak/RCdJePKvK2yI2BqKQd4MLabZxC4+rh4eJkOnmYn+K+3UFdwbOWrLXF9hXaSafQDuTODhe7aBfThFNHtVi4RBL1As58MmcoSRadSqeWL5f31vC5+ZKODJ0I0JpWki3EDhfNjVkGcV4WWJxUSTjJHJM5DYcm1aW94pc31EMaKXGZu7IdBbdAnHfIHmFHRU9Ra8C+UAtqQL9RPi/0uwQROQoqTqAEPXLqWobuDOh3A/sbzL8obSDMEeCjBH2JVC8oiERQnRZp+hyl/ResFKdRF93jM8PTsd16Bvi4S16cn6EW5s/k1O5qvoWmYWQ/hKuds8TYQP44LLKc+ko+nAASZDK0CcrarbMtyx+v0yl/AsVUkImuFTlmnm9nXvFEzD3uwgRFnbMxEzmJEDiKAL49ggC+usN95f5p+QOb+ZAHEsowOwO0+PH0eKjrPImeQE9A4Bw6k5fV03minMUU+HH5rNJbAZizEJDitFFZPj6MFuK0bInBMma0urzJZeZvR6wGmVTpMBKG8R6dtB0mVTNMgKdE7JlByID5Q9u0TCUnKPSckhiQIS60rPXQdkQ41z6oE188iYgDNvN4tmW0B3eOCGOp7ZG6t7r+aNXajm913bQVCMVzDY9t1AYytfsQf8iEaRt3JTT/bwaabVprTlIh9AsMsd5aEuk8548Jr1qmVEp5dRUg01lCZwkPom0gM6y4pr7I1MeSzE0GQwT/TznZHuMr7S+gtERtRUZdmZ4oi+YT7AqFlhj/UTltc+sSPVGavLHXWDm2A53p8XkOGRltR1PVNJ42DlxI2bYFzAAO+qZ5nvF/BnLIz4GnPMVWgI4/UgA9kZaNb1Q7LfhjeT+bzkZT0Dy0SkG33aysS6rNt2Fh3Yomt7mu+z1tw1HThju0DbiVKV3ijMApWScxqgsW6ebBLsxTB48OzeAxozzELHlYk9kIlojk5FotU8NSKXaRwSK+NmgxXwZPOkZOAKjJFEkZDyF9GjAMR67MRoXEtDGiim8hB7fLstCmZZPOxLekNhlgqWADWIj5v2VhgGBpgUQlhwPdfMlSGlrKF7issFhCUcotaVXLim1SJUmV59CyRR7WL0B+rZfCDVgU0pMka4asmpyVyZkydMAIgsc+bhr3hGvdKohGCxsbEpqGLB+jIf0XPBZtWQaYXFuWQH5CR34gGT1B+LRNs5LHHkRaO2ntdmK5uV4lQltPgAhtU14RU8PPt3JNJP1U15Mb6tI5n/Mn+ZIYhgk3pTrbKlSHjkN1QGY2UB6lOkuIA/4u0VylfV1k/7+KECn7LqQmD/nh8yjCIR55VrtymTxGw01piaMcCKQlbSiIpkcIBJl8mSVVZyupAs2ayrcrWSDmAWUDx/gLDzvQGOUq8nMkQHmOJ1eVnyuBjOE4JWSJoUa5KLdazN9D5+hAF+dIvESeR7lGcklP4v+eiKQ9dK7JeS5ez+NYeeXCwWZiJcJ83K7cL8WcXbqrnF/GT9u/cwQggNp2lSU8SZuJYokbkBS2A1qDLeds7Z7OSO2yzcDB0Q2fm2U6OY4/01KpG5+MUjXFX915Y9PH4xE6tmR5A91QwgDE9hWZiKfLE6jJ5dTzUAmEFkhmNmw9xmxwM+HxbiZsQHbauJHluK2S84kMeZ0jj7dzZJvOAW0embmw9RhzQedBSpHsBtTLsu5s9eUQXjJoZkME17jY+AhrqPG24KX94MV5j1LqmpUw91GobkNEaLJkWSmCpSJMCbujP+JX9vpH7QsBG+zLboy8/whX8IihEUPI4nxICp4IdBBQcFM+WUTgT5IzUD4h57QsWgTlVVnSUwqL7eOSCouminG2AbbkySg3XllK5BbcsfaNF45KT7z07TnpNLfHp/ZAMsW8fYz78ihmtBbA0KgCQSecG+HNGmWLPyYktqqXcV8MUejLAC9kXg7hJTMvB/CiVtl49m2j3jPyEHMR24PQHGMbC0HFMh4XFbDVM47Wec5cLEgBhBu6HE/A/SfmOfc21808L+kpngUTAVCCfwJFUNqupgbt6cuyLGu0XZa0ihhIvYjqjs5AeQfmX1Xzf0eFPyh3JQCzMRvJn6QXeN7VpfWlkILbxAvfYEgRREqX3TYUxwpewYnuoHaYHYD5+vS9uH7svQKw+aKvx8yNFaqz7AVRTAP4LTZv9+GtaFTOLdf0JKFOdSck7xX4WvFXPrvXx++AS18Va44+zAyvyN3N2nfhE6qr2bj3wzixxPyX3h7fHm3jiJhzO/v2afovgR84ZxZ3ONuIVkvzM9aXBeCSXYuetj0x+AhHu9bfhdw5rp0aHPT5CA5BHs4HlO7qy31CkZFdDuEivSgeqQVodw6HJnZZU+BWDAGk9zA+dJN5qSH/ql6VvZHj0ARC3270V+DgAo1WY0G3+9mr0FJnhP46vDLdL5uLduAZZl+HDF7bIxJ8nCAQ7IXey8X+MxILLeNjqAIfftJT/3g1NcGlxs7YzifSXZXXo0qkOZ8grj5tQciTNSn9gxhFlL8p9Q1pL86VYx1qHfnV9eEQN2xuaa2ui36rjtBVztvI+Fjp66vxyhDmQTYID8tPV1MgWrRFjMdlw6LOyI7gc4YDfIbglRwMpbnGICTFFZW1eunCZFhRTyvDgwvYEumybdNr0AgTfi3CfY8dqQXXjDlTcZ5LDuon4rhBNVjUD0Ie6D32sOIfBXMWfm3x4SqcFD8rPdoIxeeOM258v1e5Qw07MV/09OT67mF5cr1+G4LGm05fbEYdHEjUJpZCb9JUQvj2SnhdwzgIv6EMBkc1OOJL567KV/dUwvdrGAbRbrRBbs3hMni3iz0gsYc0TR3v6Mm7dC01qgDDDaoAeNdsmqSqAJUvDq6NfBEcWNsEFGiuK00+c3P6Ps/OaZ+LNy88luWcvgdxShy9sQPDgi10/QVnEPDxE/D4AzzXPSUC93hKBCqU6A6vSooGXpUWHfKOTYxu8lKt7ODm5mFfZkzAvsA8n2Nsbf3GhbmzWqs2brmG0Z7l9dIwVx4DSHWxqU+x+u4p6qwAdCmi973x735l8E+/NXjq88+vPZOCzZcB9ueIZFgSg0n3P/A45gIJ/gWCeyR4FMGzEcQxEKyIIfhFxO6S4DqCOyV4D4KEoJolW5bg3fisq2Qyj7XGzH0652psuRoT9yn43IARQuwXZK/D7M4TtVeL4pjc5HU8XpY3qkspk/rELaX8BusDjcO4KkSx+lAFgJFU+G5dra+Rb1ytVtfVWNfV4EzGKaXLVRprMIJ5HPVmCM2c0/zaB4fvx1rqYxH1Kx7NFJEe8FW2gy+EwCnYlJRo59GtdQ8Ff9HLXo+eG6PF+r3ZqCP9hwpdSIyNR1jDLy9ifCoxFC04LkU7+AvlxL1vbYyirb/tWBTtLk1V88eV8H0aBuX4kAaFJPzcOEV7oPLVIUnX8EDDmMEfQxYEuTUSq8TNBe+Q4BGNqFI0dM3Sp5tcN5XS4l2zaZIUdWPli/XRL4I75H0yRRu40vDZvy+KJmwgMLuiwueoHIx3bqRrsaNrdYAqVrpWV7oGqnYcIoY5pNB45v959OwNQs9iMoY0nwM9L0EgBN6FgJC4oq4Ur0hIid1hcP6UsH3+2NCHG1BShbSMkhXM54lk5Y3HJivq7vdRkpUD7yxnzz2/MEZW7rj9WGTliKYSwkcr4XsQ1un7vjIYPHD7OFm5v/LVwbe78E0aBuJ86HZHQDRWuCMXvF2C6xpRJSvomiUShxCukJXr5R3ZNEmLuqHyxR2jXwS3y/tksnKTKw2fbU5WvkNWvkNWfnwCWVEEQh8ROFGy8qZjkxXM50lk5dAjJStfi1g5Pyr9VW4kKVebqXZbOXEO3MLB7CdQ35JOD0l00+NlldnxkvHJceXI3Cj80dlxfu1/OLR/ThXrL6oi/Z4S50PF+XAE5/dya2CvFtD/EFwa8uuelezNaLROht2Kao9DoYBHbUV9cxp0LSLnbhMmh/G5yegmp3Xn9XbkIfXFtKeIrHGiC8gFoXvaVSTbKzj0OIbE90voH4BNlxovTzCpitCDiLxIghmH9iGEunUqSN8wFRR7Iy04KbO3XMFhWXCNIu1GkP2kYmufPz+E0cwjBA9IsI7gQQSV699t2Hzl6Uc4/Ia4ATEIrJjc2JzTj5TTh8SuyunrzQ42DVH4xkxXKJMHLcDbC/BzhahaRipC25SIoJirsxvNBAr42zEu3V2X/rlo1Ej1Pc6lUmX2gb54zm1vgPXzkL8pHR341vuIDRzxBd8gDxOEu1WeXEigz3s0Pbgbz+oqetSWcJ8NPGA+PYhPbwqc616J/ZCnFb1Pn/AFjM9A/92EOjSyjhwYWUeuPPYy8jI7wSHx222neCykV6d4rFNcSbDaiuDnrsp8AUV2YkMalxoua9szhVVLe5aM+mjRQskMjU4LsUpnKgWU3icJN+E3+6kNBFWNqqll5fJrLWmX0NTLyFdyaiyojZHTMxRCkaKVibzJ01jp5q1e1SaBZnhfNcP6SAZtgPVmjH6UrpLu8n3c5h8z9yhX2D6l1iKzn34tPyHsRfPFJW23iIYUrhVxeYuQ396CKToo6pdbu/lr2Q24sXJr9iY8hkXCkfGQkjWqV2y5DvJYDCruO/O7lr/wl+cs3Tkoi60h2vlndN88GLD69Dk+4B6pbxS0JiRTdzhedyyXLCneWHeIukNb94XcfFd3ffO6+74SP3c59ff8WI0TqmUEf6/z85D9DABYBMR3qDzQm6wIhVThLqreoWOF/V0MH37Qvgff/qU/etYPX8q3kRtIlKxNJHXh6Ieal4vrQdBCJLewoJR3GEuby0hK+KpJb8jFXGFMruCqLwbN5iYXvLzHMHJLiwteIdISHHVBAx3N2M3V2yJDTLY6WrOWvRGQfsuDTJbZFz/x30W9ooX51aL69+CadkwRxqeFg7MseyOMPALL1DU1bDQgRhyAfiHwIyexPcq3mRJn4/GrnBf0uDTLGMJtC95SSgyTsNNo/6MBpGGu2BEC8eIJdzzVqZ9RAjNN/ElLQ0IdQJgSzN2QH8tYlvgzSKfj7K7rjdX5qnRPDWd+1ze/ec031THGg3Y1aZK/igsWI6tKdhOQYwkNuge+XEasALTVJZvo+Du8hKMK/GS4dQbrs50hntltRcbzCynd24oY9gPFjOCAOHpAKY9ceYIVc0zFSs5haq9xdTHxH2NCdrPMeDl5OBAoE06x1OuuW0iB+NnDV73Nqi1dXzOHVsDrmqKJugKpUKSEB/VEZs5XvzNzHt7M+T/yFPLGKIr0EuMr/tUnfVJO+rCc9LXxCW9ne97SKZ2H2vd8SoGRdyhR3iKZuN2vkVKSFtpUz/4ReG0JAvckQU8Cc7cyEW89iiYdaq7SlELYH9sUUyBaA75QG52hAHtGmcQA7O76sMqt6wB7XWzyARq4g2VC8LaCF+Pdxc3W49CmGYIF2BaIUqtClGYtUZoDUWoZojQLooSbXTRniNILNiFKMxuJ0tdGiFLTEKXWGFG6Ukp1REnA5ehSq/QS0TJeIh4BXbrh4MOiS9+hSz/uwU/RY02VyIc6GCBzvexHqH68PVyiG7j0T8JQSc63PcEJDcFpPTKCEyrB+XP0mlIBVyrgAskRUlPlXQLHu+BaaKfkWfxVhV9d4ackI1NiVSs8sdBnfD+dMOGY5gZm49zMjCUcs1VuZgaEQ9zbzx6HcExvJBz/6zVVwuE7buY4hCN4JNzMVxjRX86pu9y2XuTENNE3lerI1AhPZPQg39LXg54J3GQC2HOLIPpqEin39Z6W/IB53qXJcIM5KjFfNxnutwUdNQEMDjyiSlM9aerTruWvMpYPYJ2+O0DK9ZKiHxyITOD+0BbBgfRLvheO+wwwih4/+5pJTuxCgeWIr7zQ+coLx33luXRJBePwMCoA9wEvedlbkVndxnFfstv0VZwkwfS5PcL1lRBiakBuzkJO+b3Xw+9zVvYbl4hhxR+eD394XfH5Yv3hKdrEeJT+8OIxf3jcoeyP1B+eeixEduxMuUWj/vAq+81v+GK8o3H1yLr0068ZXZdalXWpFMIVTghXlAK2yiJVlxUM3zVKGZ5doIoGLh3yM5X1aPOlKjRLVd2sK/WKPQ9sx+uYm7oQ6exv5W0EkqIhphISMl9iscEil7hFzgW5iAQNTsvVbSgtRQvbkKzCvBXnSMp0SioLISwKJnYZQwfxaFOLH+MLWkhhZUH7uueDXzVIT27tSDDCyyrXHtw2eoR0I95Vqq1JMi9vRTDtIxG1vQt1QEgpEXnD+sFrqPUUoAv5lr+OqPlfe6qWkOgFzXAFfCG4vMCYfmzISQRwyldFKrkbr7tcLDg4jkCoK9jIZYg41APY2c5N9jNK8J03hj+JYj0qVOsxlfWzeQw3fCkTC3jcw7NLTcZkCJnEHWP2B8YFWnOXD8vKGmKUkKmia2izsobie2rJGjqnIZyuyFX4GmZuH4OIGsTWQvZHsk3vwPRYXT7rk716f/xSuZzDnA5wAa/QuibHheqcj3ytJ+ZHwl4epKYMiAcmKaC6SC7N6psY2ENtjb8DJMK95rnbPMk8sw2m7PriaDPOeQ8lJinqMM6KkNZfBzUL+IFZqy7xi2kGwrRapaiLl0yrGKyOmQOakljyxSpFU8Ccoi6a4hg89otV1SksmFqpLZb/2MRDG+VySkUXhlsv0w6NyiNpq2thIG78Aynk8iKABdlpRGhJ1RbWpAc40wCpbAm3AVt82WcAyKojaYIrZBjqu004i4HsNK6klizk5wnCeeARkIrYyxwRQjqDvbJ2Hwh98Po4g3KWWfAMlc0DKqK4uz0tFLEta14i+zW0zdmz8B2RDRzpFb3iy8XQl/UvVdJYdZIVUIj0il2NoGpXI9D1rcvkVTSXQB1G7WZwEY4b4jLX1GSQP9FmRifVE6OJiTCXJQY1jBcZNfjjlRBpZR8U1ko7A8uvmg/0bTIkQgeJiCLpKcPDQSA8rBA6DgSqMMAyG6jFqEcDiDwAVX+x51Vc7YTOroc6VmTWiLwX4Zo8eXDXDMtbXbQX1IEbrsQUISWmwL4Vnhz8kdClFpMIIQWho6Zv8z1/krNEuCvU82EP38EnjsY+WJsUe//E2Hsnxt49MfbjE2OPTIw9e1LkLhd5s2PJlnWzLS41qbrZ1uSskjxXTXam3jg1PZ+BZG2Tjfh5zG5FVZqgqWr2xdtvXD2mZ3re6Kc1/dTwYx5y1x5h7udos6yrXWUDIaoJRMOh9FkO4YsasKvKVXzyvjsPzBeky7W66E2v81By6eg4UI4VPKWUHKAZfjawWu7KhwITs8MKD/Nd6ao4kFd0ghsUYG5UXRXjhSsJR10VX8Cw4O2BcdnLh1nW4WeADHr8wa1YEyLgo5LNHBMPX/PwHRP/P6jdmaRDh7A6yMd4QWPVVZvHPz+sLxleMvPSxUtXXs6sETYR9AyhAf/nOT3+ahLAztsEVXnATm2fIVTaPtOwSAL6QqEhYPCyt8tYYft6Ow4fccgre1TfTXUfXUxAJuA2DYSBn3Wk8xPx7+NnQxEc5yDBCuDT1LnXREeagqYYWyxwqV1yjRsh8rPbhGb4VCZduCEJ2I7SFB+hA8Pol+AN0L1dMOhdntSf/aW7MDCSlr1DiZAMVWGiMcRANg4aArS3aOGxr2hLq7WMYgq+HfWTIqIpfAabLK4reUocL5ec+Jl74oo/giMhkUyiuQxvPTFNhdvxwKzDuws1KegpvwQYaSkAeUM79E6ZwS2AoEVt2+l9eVuam7fQ8BY9nOZe+C1pbrJZc1MjMFHInvFtANn6sSB7Rt6W5n77QDbeFLK60veFrmZvxVxB267QuzEv4Bb4EAElWPrh25Q8FMnMhhaoLgl8Vecple+u0cR3GR2vbIPz5/vHnD9PisU6oYviVE2dPP+C6HClvzORv1GY3utVVv/7vNHlXyiQYyk+gOKUUZkYe2Ri7Psmxt7uPZYsVKVlI7EnzEK5rLvGclaHA5BycB5GccDb8FhOKLyrJy4MWDexOmbvlgUYGoWIDBGZaWQeqh7MpRPVjiJxaR4QnrspwFJTU805LC+JuHPXcBdKPqIMpia2xQ+bkZuKoas6YszymkhMAypdF7MUBsaU1QFE0zg6aqoRRCEheLSfm6eYmj/c9oxZXGsSsZlPUVM+UadcejNkNftFpf6uUtkoiCX0Oj8vWFET6JT2vR/JUytDM+0ujOiuqetFE83Fjtv6ypQOgllLnv1iEX1PiW0FigHwKaqZwwb8Zr9kLgKKmWAt/4KJE90XdkXa6px1tag1lLZQ02zu27wx69zGm1e7YNjlFPBxBs2wLa4aNENJmxg0A310BWEQEoBTfXa6cZQxm1Jjb2q23QEXaZpSISBBeqcXWq8hysySLwwXKvAC8+6JzWWId8Uisy7+sZBJSC9/WC/qXslfqN9UXy+k+o7ZlF2sJ7eftQIpqS48Sp1UBPpcRFOE3mr1FEGVOBS+2th7dKUiCxf8mPvl1eMecDRVv7zvf82x/fJ+PPAzVtNSonnUU+nBxz3hWBFcx9pUEyWweL+Y9e57VMcONeexZSzMG2gDkgSD5exPzRroMqflUZuzFlPg5wz6iU9nT9SsYhWOB87apPsUWoFjX4mknEHbMiyicbTSVr+3GbXxmMYZ94rMTgBDOG1Zd2eInyxoqbYmnyWJPjJaXT6H6LFWFPMa/fHRQoqF7A6he4s0RzbMIZo34QWaLcPzFIrQfxofcx7+5vCA5g+L2FoHkTrUgNWnxJgOVURqIbJFKbJY41eGnU1fF0Sw1xxjUkw4NanaMcdbC3z7e5RUA80rhhVltuSxUmjyD9+slsQDnchV6/+j7rucXCsw7HPg4uSkxDLPSq5jRfe6oJv6Po558jjPyLWSqFedCqeunS2xMBTLfEyEiUJzjR+jhto+EMP4hZrYgGwSskdgU3R5MdXLOZnawjW1aYrFRmrCReuMU4hNQW31eKXlOo5BAPRT8sxmorqifsrzwvEtlXN1nWjPAswcCEU99RQPI/++FYRJoixK2S/rNhexVTfS/H0e2Z1dhO2eGsZXyiEbOD85V/PLXs2Yv8dGrKX7ykQebpfpZe9V9or8qkX89yHyX4tq/cpxqNaNDNyqbXlsjYdFIC7qB7flIUp2AwWBIKJHPexcriAL1gCNtcNUWxNaP2pK2F0jUZv6g+GaiwnwOcccHurW/1mQS2zqK+BXpU96WIJ4EERJ9CHHgP80AhzNvryWPg+lTbzh4xs0UoODAFo5mdcFTSBIQGQotYDxkxcfLxAsJqVUJH2y1GKE0Ip3TMyvvmo/57LCKrRSk1pO+MXfdmr9B65lXj37hp5dvd336ifmQ0L8rjsfEmHFh4RX8SLhbfQiITcM1IsE+uMmRoQaAmGS7IUBPUeJUKurOpYZE9oZE1JsZgySQTB8fNFSjxJSaF1QT2ePT6GWHgOkkc4eeYR4SJqZPUr06jKhxqfRiYPqO6Dqq9jU0EfmBE2CYn3isL7CteFhcT9Ji9ro9wdepd8jg8rPHqZsdjjT8IzD+IifAf+VzlPumK0c2KpGe+O84NAsofvuoBpHRAc5EnejwL5nf4wNNLSlxBNK9km85nJ4dntTHK6GxtHkqerNaVi01rgIT682tMnDrZEpPK4oOvuLDBz1tDuOFKS5non/QS5L7lV7osbTWIPqCzfmZRSBtRiuqW+9LsysQ0/nGcUcIAFeJZ+i2bxD0/CISR3IJoyLEVi6V/vNibhUBTsw7y6wL9MsZSto1ZSaFIaPev6GAyB7qt4DaCV6LpFJ8ACCLQk+oBeCeAh0uZqhJPvQyHldviBVce+KKe0pV9dvvZCmMV8A1TT7NEAKA/0VTcCqb/eZUlGBXPCK3hp2iwe90uPUU/hEZ0Hryk1d8EFeM9IRWlC1no5KdBJq4PsDHrZVAvMWBjjjtyulb4dmuW+rrscvUDgg9goJ3m87n6jAoNbnF0Xm7MPKbqpmQOi+rOb5iOSZgquuYKWYhShAME6bhcYkNMUvQMd6didyK4bUCJeLcI67iJ0M58nefe1I6hc5tUsuQfzc3xOKMl5Y+qtZFI/1u3w0oq7eExYNCnUYgdw6PeqiZkrQazROEcyim8MzQhvrbGPtquwrqq8inL6fT2Hmi4StI9s37TR+D82u7btpWmse5hFxujB8/IRrYqA+eMZ54Rnh/pJjYsMzxvDbgfrBM85T3Cs6aIUCJuPHrV+49shdr/36W14JlCjB9QCDK6MprajwCcOeHRGAK8rOGxTeoscFizyz1521GzEZNcwxshA1LFECiUhP1CvEQpUn25p5plXgLWLZGW1F7PskNkRsE7HqU58DIBiy6ZHoYhs3iS1oQ5CDvU2s4neOYQPoBRDFnpt+g3fOKtXg2m+aXaFZA/Ep2mZ3apCdaFDBTXXqZh+V3sbwqXL7LGAViyOVm2ZFSy0TJEmBzqcGGZI5ZCzi1ZQc2RaeeIM6j0GDlm2DENIGBdqgrbZBnYcHpq2uVZ1H2qpe2arehlY1K2CaOpEGxQ428eYNmnINmnINgjFUmtKWIFQ5HOpUXXwmVafKkQsGLtgIKjoHd1a8lrKmExTDMP9lo41TdWrwe4b3QY4bnQs3Yy86Q6muSwO4EMbUkJnMy08/tGL5Ls2bXTtnxzIKtwzaWZ0p+GFnJej0bcPsN/DMZ1weHUOdOnZmVeUAKaVDmqrOx/H0QVlwKrdhAywqSuNpMfsYUqp+GCmkhQGeKauvV7gICm5GlweVKOx3GB7QqRsMuHsQ4Ij2G2JxzTVhytViyklb3KFsAI1brPRtIFd1oCCNEYgWKFSKxd3XzBLjaVDhaaV/zP3YLdpNUQT+SNS5SudRkZNFOC9eY4Fa9hHVT1brZXmk18aL2F1n3VysXDdiZTx3673X2z3zvm4Dd9nA3eby6buMPYP3yZM/8fX5gKYH93sbbrneZzIOfFPSARs4hE/vqGi+Blbz9QAEIAdDp/mqH9wRmcAgskUgEFZcckZ8BdK+H9hLLnh5zy2fD4K51h7bohO8nl8jdUTXxU3R6tVyvVcuknVIY3aRpwfdNSgiqQY0buar/hHu8UcsHbdXSXVXWN5QPj3Ya+9dR3jsyfUG9/uiFWlPdosUgqjbbdRbyqhbbRTOJhBVG3ntPxDwdTbdLcTmuqm24yLl1OWDZ1Jt9GpqtFIy4iEZraDD6dEwmAZmjgvISiloaKSgkZOCxkYKWpcdWdL3KBEpaENk8XkTNSDJSUChNbhBCjqFJbgzSQoaU12loCG1xAF9tEEKGk6WgkJpbkUT8xl1N03wOgXuHI8ZmqasKgVNICxFQLIojbNXR4xuU6SqBzOqlTAFLny6f31kLEb8pn4hzoB0pzgj9HCW+HlktKHw6TQkpIASdjamDPh3Gi/z8KAkN/BbVlY7K4WyxHSs96MSHOQAaDub5pgGwZ9BUjGDsjNAcIZ/rMOVECcEGXzMZNQwd6eVMrYR2aYWsrSsc/N0o7Qv/X3r3FMEnUq88SKO9MYdfSJXMJZrU6efkz84IQeg+DDc8OEJOAP9WiOIrlbPl+u5FsNfGv+utVGvjNgubvDKGG30yhjBK6OLFfe5I14ZI9GxcyffpXddCo7tlTGgYMgLXOmVEbN8U6+MwRozCM4JYumKkaLD4K0388QYSacDBnCliUPjiDFWR4xyQb3ijDGmgCuMx50xRhRjEc4j0WQoq6RJ9Q/NmGVFvYJFCZCCQ8IsJfCWGUz0lhmR93//uHjHG5cmNb8F44LxIC+vUQOztUF2WKArmnJCglISzEzPzkxPZ+ZjPV7fGS/yKDmRESsavUIE38QBjMw43fu5hVYkx2d6rhwJl6Bhd+TRKHUg4r5vZeuuP295MMAsbaqiWwZNnHi1SPvEcSqLU4e57uVs6ODEKrgAJ4A1Cydqud4UgMn69Twsd0XZm1G9sBZtbPXW3XDDVkV2Izp8nrO43QR/zj+6akEvNu9YQXMmdcFJ4LTWNdPHUWgnnwv22qbMwiiF92JuAs1xk2bQHhy6QSEfK2mIZdQc7Ns6W6izJRXOwVfRHEqB8EnPMLX6ObinlGVZlCCKtgoH+SHNVpPAeSg1hdU6UHjbjl5j9J5Fg1IcNzWoAzki2FdwNA25saHXNfJ5fh3qxYsQklQ5l+KprBdXPM2cUEPvXCypwAzKXPjZBaliwWOK/uASY+eSXvbbTid5F6e0VtlvBnaRC6pXCpkukCBTB8m5pw4shXnJFA0wb2Uc5sgTfTGM+RQGwxGIxWBsqwTvlT2agsx20YiHG3vhPL0F52lVl7YKRt1XVPBlyuDLsALfsHLEGRpog8i0aA5c0GIledGOa4xxdd3hhk/3FbOKmf35rECCYkFrucKq/dSz/ozrnCuxikeeh7063DQ7glKU0Qw4tTkkM3ahAdPagFQVapsqu2/KjRq3I2CQFpF1IK9DsIEEhxRvIMEOFkYoGA7zqSqEitA4mJ4yJYcbHUwHJ+haOnTEN6TwmK6lw0nEVy84bEZ8Q3RXiW80RnynDPFdpMUq8Z0Sj9JTG4kv9x+AYOIbGo/OTT3zbVNDRZ1ykwD0YZUaKhrWDE2X4aDHGdTcjcsjiarWZgmiqr6h6StlBGQBXalZoyRYLfxezrAFl6m0/klZ7ucsS9S06W75mABDdcmHEooeo5ZB7h7bmNqfz5D4s2c1I1b1oiXg9DJtwSMx9z2n4RygCZ9tBvET8sV9zVWFIDYyF4zTjOaYXhmlEppVv6qZaoQZ3zeC2bPYMcE1eD7V8qreoR2uhpRhuzclCqWHMU5tJaFzvF7wAE4NKBo4W/AU3jykOd0RgQBnOuEytGcWj1lqwkFCU72ZUkKirz2Dxwz5UHPzKcVbaudjr0LoE9lW7rvurt954e7/du+FwwoB2QrJ/TB3VzjvuGCoYW1ZwfNtm9IRLAhwseoE4jlREwK+nDO84hn5Fn688uJ8uUIx+zXRBQP10YMoj2L1PZSRsX+/N7tLt0fg5BJe6AqfIVRpYoBcV+vwcx+VfPVk851P4/HMfEYKypu+Hastwq7n6DevqJTLMVcsRjBm0I227D/hm1FpXj8BEQ2F9NHUsBwG7JKrhyCOZrR6knnIEDLGJ1BZW5fkZvUblOY072ZBaKmFQWoJzV4WValF1Ljorr/l0QhqqX6ir3KNUdngNDXhSqxsmU3lXvVohprcMbRT8AjISK31NWkzxDG3UGg0mCDghfh2SvCaG+gD+UyjO6qijHaCx8TXoEHIrwQ7pUxzZgJW2i76Z/xqYFpMXV60enmG4okDoeMlXqarW6qfTonOM1cE6xk9RQ0wx04UO6Q6bcUYDfPQUoVWecLVVBKA2kM3FjfDHNjmLFKtitSQPaHFBRUUlkYJD3pF09gX2EZT2gYITaZuE0owGMKGgTJJlChPBS6GALDBUNj7shO1IwOQgGFFjEzhUBo60MsSvK57GBVVVFLly4bTvvmUzzpA43pM3RdeUt6RJ3nntnniKKwnFuRELuvrQQFC9qCAAsziYMTwOT5kWmPUivC2HwcsEZQ7j1vMC7QYo+XSQUDv+eBMxMRkv6NMG0e+81Pv+FRN9Cpch6T5AWhCxJXzH6tVvAP5uBZ+nHZxL/tdFFA28JG3Lvs91Wc4GolWgc8Xn71yF2LNm/r7i7qC3540++QP80TITYQ2NPCoFdAEdDO0qicn9//dmGO5turH5Omdo/W8o7e7MvZzlE8jfHU+I7oi4m12rlIclBKfkc+7GPi7q8NfaGzEl3WcaFOE0+ZZfggZgGCxqS8DPQcpUqdY7IJ8gz7FwYzY2khvG3LeDvHf5b0H/aIBfp2v9GrpjJu/ehhlDUb8MdsL65EYZHBulSLjOz9GC/H9DGXSbg5zP4W+aw0xAyjDq25FtMxEywxRJilVkp3tPPAbU0er0OJREUVcHOzMuCYDEgJUcaqN100bTIs8LGDvMS02wFWPkhagjtCitKxND79aG8oBIywLgDxnwT5jeRGla9VaSPgELU/x0lJlz1Rmb1K9witK4/wDglIsEFd8ea88yYLBWTSudAPzVc/HNX6VY1vVYvJHT8NUxchIub3RtCIaFeWGI6/61d1jJcIsxi1w2Ka3gDXbkfHCGdS3FEaQwM9QnjDmyPTBVVwJMlKCV680Q4OaqN8O0v9k7BFBN0enFdz8VM08wtIx+UwVa7BTWvjADf5JXB7RZKTaesHPQYGXw1zy34ZeMqr2qDJd8ChORiu1jgJPxFXrYs0GamJGKORY/TyZKJLyx0RS7oaziB8boEH8U0EQn2LZDzW0Er0+HVf2Q7GpneJj74q4sbwr8t2uyCd/011RzLsin6eAowDlxgg0x3fr92BAdddcbcthc6+kXhodBXqN9xon1JJJ45/PDN0JwKM+Ao8G4FGvwKNu4VE/NjzqVD9xeNQZHg23SwQpMyUlR4ZolD+2yQH8QtmtDrkX6Y8/5oq+ibnReqov6ucBZ6uo/H78OCq/J8l9SzG8bawFKkOPyYx1VlQT0zcFm2ldu7vUgVWehiQnYibDsTIaF15i4iJ+Xe1DZxYXp67kNw4K4amo7AaqstvyoVD4aeYRPJYDk68HOZxIgTAPn0IKhcpEsE5mpHrdf6gKu4BkcKJ1hlon2juqDx5AqvmSF0IAJWuSfBchd0UrXM5+qlrhntEKd9YGPJQtD3elOPsjOX7VezKRcEtIQ116UX6DvvgfK1NzixcEwtSU148xhBFCMKYSoUMYWJuUx2p8xGb3qG7XCUYeXAHAgZNc4oooEiUV3Qgp54rlObKcdgOkt2FY7HglxwLsiV0SvS1xTlXpU5BKu1y95z92bSJ1CqnCN0Kh9Pc2KqR+erJCqrKfyZji9IdOXBsY6KnawIpq49rAyKOcq1MIVuQLFPmcQvAnRhWC7QyNzQyNMEcnqAbj3kFs8QxYG1tT9nFFQTg8loJwzFFBeRG+pXrCiT5CPCQt+/1jKgj/AVIfoaL80Y2K8uhMqSiPlw2K8nsnKcoXmKKMKCuPQFtetZJ1GKtayWiJaiU/sp598uH2bHfZszD7FD7+FvTkudUd46OxZlGExp6F2DzBmsUfOSVvNyddI7q2ES/0QpnvKsML7MXM8m6Y3MyUp69PnK+tYhpgxrEAPxDMNgkUYSLpe3a3KuwJcY2VutxaD1KmfHPCC/6QalU/RxkNlWGW/hohGKIIWiR1lVJBRU02ZgmCO9VK5G4Vs7ZUwUTgllLLsLQF+EmhYAFIAugrJAHmuii2erCLm09RlHdEju1RWwYZyebBjshg7ssY0Z3CY4o6oKGq3RpSHYoFKjtCL9Xdsa9VwskjzMP+7BVFTBnzuG1sIKXPMxSqK0hEiwrMrMCkqJN8QFMrRbq/MAoWczhoYN54Hhk7+1fyBTFWm+J1kQWjXQFGsYUrlqzUYms5S+gndTi5gR3IN/j+w1V5j/s5v5/LhJ92qqOAaH++lZYA6m3oD7XFOcRKYeC03Ubu7//YikY1JarWj807cUHfrF0iXmZDyVoUNA2XEQnent0rdlBds8aERi7py05hX7iqVOFlJMk1SjiSZp69RITrxjI8KbUvYUVKngE6BHh25DSx4H6oPMajnVA9pkVuPwuMsz/VmQt4oPguRbRjFQPZgEa+FIvJPHXMwdZDrZZxGQDooqyFkbKWNy/r6omIg5uZip0J91MehXJdOb/UOe/2nJ88CaTcuNq0clM8heKmDMop+0CJATR2cLrwbKcIg9igbUAEwhvMnm3FMBoXM4HOzos97xUYESOWQn9cb4oIDQhJHh4a4NkrmSE6GZKP5vgoaTJjWtvImB6GO1zfHiPv3l9E1av0d/iFuydzBoDgbm5Y7UzVL8qKGI+5os790E9RtWf0wWqW2ZNTqH4GlxYRCD1RpKam6jDCd7T2Qr6J2Q9fCoEURWIcYKeEzuBQV81kogIYblYhuqGV4LG6WGb+QpaZRBQGId+ApUdxOGNEh5Y8RHrigrJbgEeU/TxWDfACiEVpxvoNJ91jkLguCwIexnZOoFZbNCzMoFzxDihRSzANUcoP0AziAMeaD/RYUD9C8yLSilWzEDDabRiK4/hofsFkH81qA7bq8fbKIhZq5zzeXuY83r7sUXu8/dKo0Yu4ahDVQPGzE62W1uU+7YhZ1Lozi1ofN4vq0iUVgHzY1QCTOyvlJ3/pTKQyFLK/ciZS6zK2agIB455kP692S0XjFA3UfKqRCXuo92CZB3+rBlFHcCZy18xGDaKG3LR3SsGROgND9rzOTwpHDaLGTr3vl5oRBLLL1wROlfmo53aX6qFtg0HOtzmDnJoku4h3IeiEsrrnYyEQkKqfWYk7WPI5dCyTqYopTzEviXK93YdZQeUMwtKEdA2hZqVcvhRtWiDlUMhfMeeXsrUfSs+ssbntGqWgI62SzmD3pW6/8GHhiXlI5C3kvlYD+c+W0682lh+sSXruJFUsI3m32uunVh5Tx5hhEK4FhasM1RJ2ayrB3R0vT8/QSJTa6tdfAl1YKKfgLHSG2iqFhtIATa8i415p0DxasCtf6Hsif+3y3xa5Fr4km1KG/QFRuJ6nbj/G8R3XMiMrWw/MgZ/XkJf/tnLRS9wqfNlRGs6cwjJt7SdgD6S0POZqpszRok/bOVudGVP4I9rNF1WOYIbghfjlDvuS8ctAX/Q+yyGPtmkF4qafFPVxJilbf/HOT+TL/cCaddBv3fErK2Bl2h43eIpRT3oxJffea+KmH6yPsDvgG1rPKlf1JQ5q37fhbb/4ro+541PSo220RPHKI+xUh6bGOgWoPfx+oU/gJGLhvmm7zs9Z2iKjElcA5ipAeWInXEtGscHGYrsotkuLCrEk38IlLSrEZhlP9OidH9M0p0ewwMcC1CaV6dAOqCYcO45+PQF5O48nXEXIc+IGkppLo5xiPIvioS95VDz0T572OydsanUmZMrp+NAyRn2tIGUotP10vPCcKlRkB2DR9wxCkoByB4dAjxhYL5YrMjvI41eBGwfAWaFDEbXRkbPt5Ga1Y7zvBVQ5ag81OJT9lDiV2AGxP+24vAcJnUghQqrLqIAoec42y3/woTxc2Wphk1rdboUUKgORR3hVxmUFdxScLw9Tg7Jr7/G8qGK0MNY1pK7mtKIzayIdEmoIcQRIaBNDWTVk2BRl+sZ3I3hm7V3Q3/+mdxVedWnhR5zdWzVxqBIRvMZ4VeMUMHEYI8KZOMQL7E6Pmji8BPb57rImDuP+DV81Zq1iZAhluNVwj1oEkm5kn7dmT0mqY3CMWTz83COwePh/nFXC96cxS9nYy10T16zLC0RehXHuYxcNqi4cMhu3r2oCXjn6+gLNdJkzQ/8ctW6oN6HFylQeyzPJ60C+84EiIlu4Hc+6tZsfG7v58HdgrR4ukXqEFeE4T2l5ftFjnIzATfDVavGRKnIwce4W4Upz9kV8a7LaTxs2B1/SEc62WbFtniJ6XaJbOPKDKXJqkzpOK8mBWKPslTosO3kd1BO4/b+q7hGKNPs7VC0unIpsQFP7PvHka57/1sHnuY5pSktr60PZv6/rAcUk/Z1933vJnb9977Z4L59MzGR/J3fWE+0dwag1CnPNn9Uc4Drm1ou2SbkU99n1Tuw697A9LNoqHcAF2fV9L5/7xe/+7I9dX621mB8OXG/btgZWa2iPR+NgzrHVFPagXoLDYukbs17ckqH7LIV97sPFAmVrb6nU2FwrMrZMXfg9Epc6c+tDBnxG/D4/tB0Bq26VgGQQdA81MjhsZYwrd12HBi/+Lu89Tz0+/r2x6YXI5/EK9Or6xVflvnWS5LflIrG3wU4fHMiKtz9POcgHZZeiJvqyD19vSoRpnAU3HtRB86fldH6Gg9k/oGrpnV6AyhDyITXke06+Cq4ksQ+ZEQj0PjxXOXAlAiucwvh1pHYJWoqWc2f7SfaTByxenL2i0LCqqmvZB5BGEdLQpy+8HnLF9wmW1oT8XoQ9FATSwV4lrVYej4+w0PfX34Bv3lP55jnlN5eOfiN90JbVdEPqZ+vaAnnt/8brN5ZFZVndjfX3u2rri6/z1VUIK0WGo0Ve+4iKVECKhqUrENQ+e+2rXUm7y5J2jZUEl5IR9gqyv8++Aizg4BcRgcT+P78KDXuLXunXlOx+s/7VrD+CycSFOhRkX0LeFIPgjdp1dEuds+s4IRaLo8qUIYGeYKcaO0ex9/i3uk90O7Lf8Ea+cIeTHuaGmJp1hg4R+8WJsfe4WLGUqLGfnBh718QSPjQx7x1jeb3sJ9UZn+86gansYPAvvp/wQudWb6yZo3btikjCSl7UOrHe2SvNOuWxznPd/2JBkwsSYGPrtpyu3TyanSOcD8FKIXnqtKlQ1srawmtoa5ooP4HuYqK1izMAV38itvLgFwdxbV+iwB3p5l3y62dT8kWdkDlFZmjmYQMeEQcinOchAKqoZXmEZVH7JvcbU1OttqeJTvJf6mpnQoduxpTkDdxKztBlCwVwaaP9StO7A7/ir4lGXEkboZZcn626KeYa9I6HJyyrsbbxZSDBOf4PnUjer9iTmudAPJWVfshhjiI8xqqbO5kRDlDcPsADdasqfTgFAF+LKxUchqV+xGDfgaXt8Tff+dQjomiyiQK5lk3+oBhVkiD3Cteoqk+eqD55RcGEElfzYUo2qpTXySP+452Fl7o2T2pNLjgQQzsmghcX7u8PvenX/3HXD/0Dg02vXwWl0gD56Q9PJi1kFs3sqxiDkpv7R7yh3lEDqiCqGCVVIwejVyVGr20H0NVLtR4U5cRycf9t3oqydsroyYr8T6AJeZ1TdUMAjo9RI86+Jtx/om3DXkZloSF+5CZJUhrAw0THeLi7xrC3gBQ9GoKGWsqIhhM53XghDWdHGZgJCHTEoqjeJz5MrbUHgzxLpSZcKc5kwoNMTJtabXMT6PzKLehpY5iQOHBJj9v/T6U3kqIpJYFrsudLnH0aQRBHrgJSoDaMCLiTB+1rhrL1kIN3TeCbEYsaFXLalAM2AbVJ2oOQ60E1P5/Rpl6tW62XqC+xsMi0ZW0VIUKt3VzRbnK0vZtNNcjU0cJpicWeeG5FxJ5T62C7B24isiZNS7Wv23r/mBFSYH9ffSPwtbQ5QFtGDJ3D4izWCsnnYkU2riy0NpQ6DBLRJtZjNJz2ZNYKu4ZVtVT3oy/Dz0uAX+ALYtuPszno6oZbkxg0bReJ1UOah/Bx7lkvLubPr10EZUucC1x5VdGGl3apvYNYmqP5Hty5I9zZD2/uMS6I74XPtOwBnSRaJQ+43QrNGUYxhlGq9qrIC9sMI7UPii5QO/t7dFnVH78q9z7UwqSqhcunigsdXPuZUVxsK2ZmqbmTjYIqWENamJvdy3zYqkFj92wZoVP98NyAMCMUXxLFF4EnzEvIACkF0Gt6C9pDKzAF91ksVuNAmsZm+3usik+oln87z1AIAFE3m6vIqdMZPcd8BI7ayVnM2yk1hwKngK1zAgoOVVR0R5YDUEud86KIr0gx70SzjIVreStFw89WtJ9i7FT9cyy7ZoOhXyNaVO4zO5FnMBAzJN3slGNhPXFM6c5hFlNvUbFqAQ8FwBTbLS4yvf43g7c9+Dm7SFdADGQCogZKEZ6XOeQb0gNyh+PFyoXHFBLlVO4HAnb4lh/ms7HcGXJnmhvoxEPOrZ1VWY6uC6GuCxM2Xg2z6WqbTVcGRHSbLsyxjYgUK2oK3VfmEBN09LWprw+Y12T0tT7yihaahWhZDU1+Ci/Mxb3tU9ey/D+Rqrz0UByGzOKE13hVt1qhfqp3HGWIIjNnI7u5i8zmzmB9iJye7NCzL71aYw5kUNa4TQVd4s8GBDoTj/s7+2al4wgIa0LiSHJImpQMzBGr7HgHKzuKYQ13pVHWvMh9lep96BWosFd9PQzLIoaVi41phXdKrV70AbHaqisJWMVKnsQoivUzZJGTGSHBIP+r5hJn2559tHBuMqV2c+rUWs8bo4aPsonXNjs9aqzhworrI6rNI5ydjPYzgshhpJP8aaV3qvQ22kl3rEJ1moJd8qySnJUn/ZVLwZGMvxjDlWVenQ6puA6DrpI8XhdagLwcTEE6mP3za5xDxn/RI0EBhir5tc1epOqcB0RiWZMVG8aT91WSLxpP3lNJvmA8+YxK8u5qMoUVn1xv9UoXO9mDaPi4pQ4KNOUY1jlcphOyyEGhZj4BKxy3R0EoVjg2HBcaD4phldF3LrG40HWn7Qy1diPc+xqcI47sCeQWveXZg3GePcLle3f36chwA9ceUDDOnwcKAmNtxIkSi6hiw6Ku8K00TQ7VEnE/5432d9N+etV+Nmhj3xrH7FvjUfQtstYfErkzSNohZ/2hjmx1Z/1htJ/OFsS3dU+xI5O+FgkfPMv8Tjazm3CH78UTrSkFTmnUbXwKVa1T16XG9nudIhn9RFc3kF+OS8AYJUahDoUZVVHRS80eUsKzoQo1Zx5bPzF1rSbSk6LYMlEFjDZZhxXmUz1O8UsfCdk3pII6GlEv/aWOVlfUZaeo94c8VetQXyh6ctLSpupaXbEYdLmQHtVk84XlKoJS/0ElrWzFVy+lCZgZtcpdnGpEop2+0+BD66E96VSc/pvnH8Mc9TdHbq9h78PVaMfAJQHazjA3eaz2VHgqOQmNgepDgRdNGvWqrr1RTI9kuxiP6NpHfJTDsZeojzFoJWkb9ERQ5kmoesBqoWmkDZFq3Dur6T5wFVaQzZXD0gpyZK0ggzMXp07XlUrPI/XWj18vlIfQ8lGt+5ip9/7cMyJ6FElhRd8+RnOr+vYq3KsaRw6lVAEsHpKW/dV1Tt8+Vn37SAZKj8iCqib0vchbS1/zGN/Z4MUSHaGAA9W7Gm987THvajxSxfrHe95k/dy+2KqTSmuqjGtQ/AutMJTbBcnVExFRNx+h4Wx1glW4qzq/JsY/wBwmEYgrNfi0AzHdFeNNn+o4nwE9ohCmV8U55I+8OMcrtgvGmbK7CiR6Tyws2FyEBxfCLwBPAdmE0RrKgdEnfuImIiB3yvkyPuSstGC0k6FN+Wb1+nYL7UzZELGLamJ+VpchVV6OydMmUazmA4pO9fZYNtGaRnPMmkbTNXBar44Pc/6pnrPRlNyWmtbq8qachFVuS03Z21JTx74thQvOa0XT3ZZqUnPT21JTfFuqmVJn4u2xTD50t8c647fHpqT/ncm3x6pqWdOayd0eOz48OiPwmAY8OhV4dCw8OseGR4c6Jw6PDsNjuiKInaLp6u0xfDrGMTQFmTBVBkM4v74Mx41Ot9GE9u0dQOw/5HNmNjmujs7bVr6Kvqlnl/WivvkUqCJ3xwWnHqXwG3i9mfB7ygq//VHht3sl37Jg2TgLllWF39lG4bfP8OU/pjBTVZhPaA1noJQRW9rjTeYWO1R36AqDFRX23xuBikecalvdGW81IxpwYVPGkVFqvIW4Wi8n2p3BQJFgmtquQVQfOljA//qgfB3ReGXk0NW00pm8qcZgoMKkzOJ6YZN3StFM63zZpgUEsh3iRrvJ8ACMHKwP0ahEGMiEBRpGfOHh4HoGJNw6nwIWXrzRyuM9oRdVb9+aFQ6LRLDxpm1IoVhnG79pGz/8m7aBsmOw6zR6szQU2hBUb9qGFdoQWtoQHps2cGNP/GZpqDdto4m0Mt5w0zYap5WhWiw4/k3bQDM5Wnl8eEQj8Ag2WmKKNOFE7DGdODxgjymozNuQghO5aas8mdshf+DC4fPSU2WDTNaVqDoCAuv832Ep6ak/0veya8EFpY+5Gx4V6WJaVPm8A8fm88ZdcygjWr0J+TlEbO6a40bfa5zYzcci5O2W84PiV24+Oi8o/kYvKB5sByv/D9lx3ckpE4LnV4ptz8lVFglDr+XmDcvXxxRZvt7HPhXtJ19vJihgdNfgUUP3hBEyyCPEQ9Ky+69zNxqDsRuNdyj47s6C+jXBiEveSPMEe3GEjMZ5uD5XV/92iexR0FTdPOp/FnmK5lQcxzXPD8LUalsWdkuHcGrNCpub0U3zzlMzwqKuvWryoxVNLsF8oUcOgSJhbOKKtsa4eoopOaKntqmgqRAC9OzH3oYmpWNN0l2UNInr1MJqWhham2qSy2tKH2kuQRchdC2Qj8JUoVnpqWJjtZOum95YN+NqN03boHSae8Lf6+1qU2dLmuA5dU80X/QcXKc0MXGJGuF0RKSUag0uO3cmzvmLgNJqxwEIB9FA8ybgB8oxSFzPWrav6eg3aeUaaWvCSAUbRgo0RLT/hTjofVWAmvzsVaA0LR9D2ewvfo/ALdQrKUa0fB1yaBF4vd59EKuandBNHw/J8GrRtxF4qKG5q68aHdMGHp3qmKLua3EGh7AFWTY2vs0JaOyBW1Irkhke4/CuVauTL3Q88eHEMTexHMo0m+Te0G6aqlSe4jREngElru0VjE0xY5tImt7QrRBFTuhWkzJz5q+1N6u120+zSre05SE+nNQtxIbarWnNhpZvbDBNucrBlZnuBVSf3C00YmOPkk16lEoTqK490o839CiZ0KPEfDixR4ntEbJp/9HW8R5pGdgmaY+0+g090j6NjZKCfjJxmc47mBupAFVrQY+r2GFHxK/Sy7Q6WCiFk13+6bFSbNn8K6y+KobU9IPUUS/AcWz2pJvPnlp19mycaPh0bPZoZVSbNHvcnLKgqI3MnnR0UDh/dfYY0lOkamGIp4w7JEeEe0MPmProjiQ0lOk1IDw5KtejRhP9WkTDJup+cLZiDdOXqwstS76anOugfBwLKQphN8qzkU9XAi8XEHiQ8MR9XIynfgsoKXso3+YqUZJWuD3Mn4WxWjTWPzREBbTkV5euvK5cui6XicaqA5BREpgqFtapIbDIEzRHl3JwSXhEo2uuLSIeJ4Xlh2I+U8ZUy3aroKGIiWNJSJruGkmplOghD1g1zdRUk9wRBRvaYj/T7bzFkmRSwa4j7gutxnzo4OW6OvbFSOO1TeGGj4Kxj0yLQltNMPqFNjQc7UqiXQkrXQk2dCUZ7UowPmr+hq4E1S+UoTcfpuldXhAJXlU2MUDiQMO68qrRy4jMIYMe1CAtLOoWqRLEjNUW5T74W9S6Yq1EQCyDanIfeCffYYXzcResMVKCmGDiz3TvVRfciPAeMdb6FJuGqlh56AXBCfREexCiEboORs6ymD8BXqFcWDN8fw2Mu5KXoo7bWJjBY02uU4Sm4lMKR9r4Wd+LXPsMt1+E4Pejvn+RREXE7y9lWrYi2gCqYBOzab++/8I81LZA+J29TshGiFxhaSmcPFFJez3ScKwZVrSR8bU6YNHJbA7bnA+p2hh+hWQuU9X1EeByTPYGKR19c76y0XLpgjLiMRoqJEHFzPptdgO+1GvwdSlarvOWfi1jW52e32E91u2Q7VAsZaOm78Hxo5rZq6ulC/Xn+hE/8OV0AfWO7gbcbIOUR9pZXRYUX9Rqf+GTWoSSGEJ2FOVAo/fkBZ00FQ0ezaJAkYJqmsttvlyllUyEFN3CijkltzkF9DdWVNSrVW2soIgrVaD8UrNLZ5sVVyjgQf71ylj6O36ARSa8hgK3Z6zCLmcM0ANxmGeq6yzEiVkgozaCUhFqB71dUREaDof1UDdAM7QjLrMBKwZA1TQm59Ke+JqraPC74oVv/dDo+ZCl8gZ4gbY0Hm/gaHOKZLQq1ALgmTrSckLhYcAHqGploeJv4/xamP5xEoQiEeh7eeBP2ORPxVG0YYvv6xDqabttiD+2+obO/BdQpO91JhdR5Q3I37D5TRDjKhKLDDoxTQ2xuwhoPw43tCkaaxMeoWmT+vd2nICq92iay23KH2mw8A+BbYP7SqlL5DqrrP8oD7Sxsa6nXrWn2jrlgfQYTw91tVLDw3juckfsmFbXLSQmLtHk1qIcl+VqcNlDoc+YnFG154CEA6qveRN7xKz9dT2rjyxj7ptIqwm1I+OD5Y8N1rH3+aMoFmor/FGoh1UZkrIEm+OX50QefgXarlm+ArQCa+2VS0KEGxmUMJYtTKUnRWwZAohKxS52YnTuQxKK0HIANZdr/eo6mGIC69orfIyvgxsIHyOsvXyHeReAj4lGSmhbviXA5rElvC2kotwKrISgS9w+hm+KTJD+GGLli801Tw0GyNfpm3w/1Hvavi63PlgDdnrK1ePVM0Pkoa3qBaQQkfRGg6skOfDST6rrIDfeZCzi0awa61g+TB2FiiaWM7zghnnk54GpV1sRyVs0oRX+ibUiUdJvu6IMYfqWCt8XKEgqaEqBAY+0sPBH6Go4Yb0s6qhFuuXnRhSsJnUoyT3SIq/ZtMi6LOnq25cDH/D96FijpcaqGTp5bEcOkwlQ4naR/71GN6UOJN8AOcR5o3F8HBmnLvNoy9wYVneHG8fQriqFhzH00L5A2qfgBX5Lq4JjtCqY1CrG301a1tBxtd3RTWD6sx7rp5GvjC9QyexD1EJJBW6Ys/Ih9yo0lmcUgBEB5hCmMrXAw6wxhIyVNiMi4c9H2Tceb2xghEHFwJht0zNFmSn9lRM3/3i0Vtp/fN/nP75lgvlH5Bmz//hezsugvPm9n285648//tqq9Uer6xOpts8mDuH7d1zzQrEk8611DP+m1x7L7uMhpNbS//5IrCP+BL6tWkdEb5x5RLxttI/Yn2j5ER8+StOPGMGqqUIUaW0V/sNS0jbu5T1W229dE73cmoL33PVE1JTrCppHFhNwZK3tYQlkZvuEa93EP/uMAnvRUNkdovKUAtzNRh5NzVviK7Qa0+aYZY3px6uy1K1IkqpHIL7oqGP3a8QGEMr3qbOeZxt9V03LhmSaaiO+qzLnu0oQFDYRxHi27kipXTqo4s9byrHNmtsh8xVNGlWidBGZ3FKqYdGeF6YIl11wVWOQZ6nWhMZkQ6jnqH6yGoqZoTnn14Km1U+w+jvqIIOybxATTqFpC4xoG3qq1oisIptuW2BQqaYyv/ouRBirStS1LFAGjF3k9/ClIwCqQzXMAAlNz1zjsqojewdvckEcPqNJJuLohUMAxqjboeizJ7Rk2rakc9X65pcsOF8K18i78i14UL5EmUnoHbeK5ROsYjnlQl+vXTfw9lWht9iK4nu0xIO4ZTjAMGb8soWW8bIFebK8hgdshy7ks7RVTBjO0rTgwgC4MOT8tfJlIEMNzGDEwaPESGfWEF0VZ6o6qJkMaeXaB0dPVy5fuTSOp+nhGkaQW+7RVmmVioYyacRw1JGBbQGq9nVfu6EeEnvvWzbWsuWwraWGN+ckGjAar/Y2mj48HK8QfV2grepAVef5tn4Ec1g6JUmn+hwgvJzn3J5tcvZel9O7bbhgKAiwHXZIjL3nrZJE28C/FPvzHQhdle+kOSpQT34SbedQyKGTeQadwn+7sLUGsVc0t8/iVLZ2dCkFhCc23zmdgsYV1iTVlRSUtqou437skn5ITHEqnQoLTKeRZLavp3P7CtVBnedKZ2heC+Tqa+GVcuFSw5dxOOP0bZzjmh/hHJLPl7RLJZ+G90q+ObIcgdCeh+byM3CrckPcmRTAN1VulW6Z42UcPD0/VcapJvatTqUz2YYUzEel/Obz+xn8Tj4Sbews4NnhQu4xhR1BYSCedFp+KgGDuW4PXsALK3TbiUE5mU4GMLSz2hUuU/urvVG7Vda21knVDp1Q49FYHjbX/Ifd8pR25PPcYEYbFYhtxz1WGaOaa7wbOcS5TsjYj3ZiuxtDKcdXvy3afS7HjGy1HF7Bxsr59h3jbSrTPYXf8lNoFzaEu2irFeRtU3PB26hrnPPhBpuAtQNwoNtcHlHH3b+crlAgWBNTZ2dmHtZIXN9UrY9lVENrZ42lMl65uW7AZkWWXlAdvZNmm9rFW5dSi5wLaOMULYAnW6he+BIipBSmTTUk10aSW2VyayxZqFk+Z5ZlNWQY4qcm5ohuy94gq/g2WXrznTpuDKc5ewtwq502c7gFOMOP+kuEZC3wH0wEC5dFoHgoeSvasn0/1n/UNkYWZSCIFlbyXWiFWnY7JQCmn0LbdHAK2pV3lDbB3C++KEoUyzMxpjsnTjx9xSeOhqWi0kj+6II2CyI/625Yd0ZQhrYjbrsgTnGKxkkDdSRpm7HgPYNm8Fq5Il3Ec8ZcgaCZsaXkZNh0zlFiTjvt+G4th2nr5GEqBLbbFNKnmKGYI71XvWHEihkdIB0H4r+ddiywPqlzzmOPhXYpJ1rJd0j5+VZdhbh9u2jGjsWOb9lYbKuMxYwZi1MwFrsQt0vjpIE6+2gmn5VmnKKSK/QP1q1PsQOxTWpCGSM1EWKIdqLUnXrjVUFkhmNhs1mTKkAND7uv2FbOg+06DwpMm11IVCudWMY7jL3z/JxxEDuFCtCZl67SDDOByImGzuc+QAewAV6juwJc2a1VOzFP22EFdAb0bWaEkqAzu9R+6S70Y1elHwEKMifjf+15/mab8GcWfnneeSn5rgRN3ltJ3jeefHYlec948q5K8hnVZOwk9QYurP/Y++OIzFZK+yQ3vtYZ4a0UFI4W1M+chaYzq5dz7CijWCNBFw9odvOafmMmbl4Tv5wt2b+cXTnZPeggKE2clOqR/SN8Lkt6jHOPJ8FEb1cj2BCdapxqPwPqCZe8OEez7uMFCx3Batg2xjh8NT7QMUxanhGeuDuBcyETzTNceLuYlJObFe4unsAfzgl/GBOeOMnBd7v5iS+IJpntnOeUjHPgWevrPiNFFzPKwB/Ogn9HYA6J1MoXqZ13yYPJWdP3Wv8ekBHyaAFmVPMltoiX9xRGynJjj76FerCTqn3BwJkn4FWjHkBX9PoPBCKzncqXaTHfSt18W7DX0N6erRByYp50WgFeyPAJ1NMKaLtEfMlYWgWly/DJLBEHbOaxbNqIvCdtKtAraQtq36q1a4VaO5ryra+ddyJXwqztNn7ANi9L9YplbdUyWoRvODaCKdOcbKPwhWksvlriHHVjpZZXIq5jGqIFGRvC2QW+Fta+VrYvp636NtJEcDXb+xjdjEvwcu6cuNUECVruBwZeRdmygrGBg/dr44T/w+TZjX7CJCgX5mGpwTBTD7XlOfWUK3SIQiTvO2gHGoLGoU0CWoEisizJ3mujid2taPAywGJacMS0gKQF0hfOA8iiHwVAX1jQL/YPBCs5dut4dmmLPOFqd6EfsH0UrKaBUZe4xEpIOA3Ofi/GWpL3sN0fm0iAzoSZiO4e8s2kPWAD93smcI9XTrDlfmV+ceu3y7qxzBOMZ56bZFk5ybYDDMQjkvf40+0EFQzCWGU8WacED5bygkuoFUtqBVqyaQ09wSqtiaSmOepZNNlG202FVNuALGCRkC9DPk3OyuSMCG3aijZhEEiExnWubKsgFBVj7aiZdvQ2a0f/BY9ZU3oAkTZlCVOuZgmBNoVMU7YKmqOZXr4U7AUAJ8+ybZVZRseeZQDzxpmms2wJcaASasCbGoy2CZwK50S9/ztmnhqtxvxC5gWcRfTyBWjM2d1bj5rPdqtTbicVtg5go2aJ6bAY895ezoU58F+UU05z6MJ2EO0eICOp7FhEYV/MCxHHMi0JJ9GcJuRzxACgGSTvpFmTexavJ3Gs5sG2+UrQ7UPXKPuqeFCZpT3B2WktJ6fZMbpazjMd9WnpzpwdfYd5GNOtm46pG8/MjeeGIaMNg4W4rZJzlmbNSGd2pLeVI+kZzEf9k0dURzOlSFgXijHRVIYk4RqHM/GZAr/q1urZILBs6Uc9Hw5h+52cmbiRS2EuGLpgJMo7Ygp6dZ1snsvYPu+wCOEv2QeH7Fddesrt/mv0hvuIyWBrLthJDc1dpS9duEbRvuvXn/jXX/nr858y3PdjL/uDnzr9Z3yupJTa6pewLTFIfyMJm9d4r0Q3rBlnmJFwRxik1o+X88BekAe/i3C3YMvJ8EZg1AH0EKaOR0uv6WVyjtH/zBC+Du7Hr172bma3gDOGiecErKb6zMVmMYeHu5R9kqjGsJofUDP3wS4TJg53TRijxV9yi9SFbkt9W1RTJ3ylpelXak28LRIK/Th19zV51FlkXnQoEAkR3rrUkduVlLEwv7NW5qVOxT2uXn0NarUrn2oE+b7cS8fq27Ge4Q94/MfplUvLchwJw8+Vu8EsJp5S05qMiiPm7aZg4/Muv+hAtCxjxZVoaKeGotJncit7C0CuPrSXaeq8QPPBBUb1gqpuPdroNVdHbXQ4kwMZXIItpiodnqp2eGpjh7U5ps9TeWdDn6dG+4xr65X74dznDrbZAhvX49z0mBMFINJxRama09WGVe+WYqlFUBxhJzSGjMfAw1oVDwHKVok5ZMIk1KFVYpqqqigOVaPHs2sxink16cK3L+aN4x0ixYuDIRJT6e8345D3oAmfhyblPrSoi6muI+n+/t6riobJ3KBwj/++hJ/BecF6ou5Zjq6Numf5GN7VPYsmyRX0jyOY9iVR6I+M/H78XmR8QxszaI0+x0m+osnmDrm2CfxrCm4VDUHgHhs4agNHEmtRu6XEro11HHXx2Pj9PRAANWRNyfh5oLEi4WnZ/tWpgzVc46nOchAkks9BBORSMs3gMXdYDrMooLkBQjNQPJ6hulj5texFg9tf47bCu0fTvN2Dt4F9O4q3Q/btCN4ONGnKaplMoRvzKkeu8+aLB4T3A/29K1WHLKbfd6QmMLCBQzZwwAbub1qw2cBRGzjSFBFbvoRKu9RlWSRCOxHqmV3gNC3LfU/lPbdaMOnrNsBPYZcK7GZoRtiAbTSLPLWgwglgBJojubZSbzxXvZ9VwDlLS2hVD4+e3QsmkpQp/JoqJlfQ4iUzL/fghczL/XjZrTBnsFVeBngh83IIL5l5OYCXmg5JRlt4VpruLnCrqSE9EcZmG80AVSS8HfzbViEli8jGmwcwOxvFKXdyj4ttyAbgGbBMQHw+T+HP+eefwFxuRXgrh/EqdSM8DjXgUD6fingfIuJFQR/q4hWbTWDsFpoHk2QQL7WgaZqZprBpmummwGmaOafQacrEo47sUjrky9MXrI3h7s/6N2zrMYQijpetydJWhwSX4GeMWUyqWbqwnr0NydQoXU58k8n8A3VqYKH4Kp4HWJnk/jrAf2pA5waEkLXlqmG15Yow6HCwBhutDWi/3IheMnHC3OCS3geLjoc0vI7wDRq+A+GDEj7Hv14NaseK49nbpfUBJaWLFuevbDd+9hSx81e2y/kr2/uo/ZW9Lgw9FR5WzGs3LfM3mWjCmj3h2aUmBGV6YSq7VYAsnlzmzG1ZMIBQgsQN9ixvU7Pi9ANf4/SH0+c0xEDMSLVimRXTsmHDPPsjWOuETZ6E6vKJc793/BK5nDVO52ALaKT36XAFy6iOaj0xPxJWmJGamDfiz8SxHzVwVCCmj63ya6NkNFrQhIdLJeTKhujlUd9pcGB8GTBSQfZWQEeYIPvZdyGbyZPdpMkpJVotL8UwaQ4ZZas8ywM7lt2md8i4Ql4viACpNk3dBvso8IbXAsrwz57hEChak0Z5BTJx7C63W0D6bmo6cwFHgQr+1UAHuxEInS6Ts30xFqhlHwHYcnEjuu7nEfGKfsQXXSeeVzeFFExAJLhsGXASxefX1vGMKHRYWtjwZYBjr2DfQ3cYN4RrbykTD+wlF7y853iUB1lT7VbOjy11H7ZUIe6V1tyFuwao+24buM8GHuAAmI+P8xOU4ZPy5E98fd7kS3pwCE+Ldndec25w0DclDGzgDvPJETyP+mjDXZ60AbEv0XpWtbjLzDeX6mumlbc0a0JBFcNRQBekTXrGvzeFYvy6j6Z+UWKO4jf7KTmNCBgP8hCP3XmkF4KWR/lNjbxUIwPQse+vniVp8mol+cpqsjYjO4rhX8IJd2iQCYN5OP2PVevuVaP9anlPm54dlKaKa7sbD73qoLqel2S1A/OO145a5ztBl56foDRkdM74L2CU9vF3te+Y00beBPmdrTKnypTenSlTetMGpvQGx5Te5JjSGxFM9YvbN3xxq/vidvfF25SNvWEDG6sUDWCQlDzNBkIU3PyvWgebssxpR5nT7NnFdLumfOkMaF9YQPsun+NOHvRw+ia8qq7d6Hii4UXkncu7eCT5Fk65J9OUpUpl1Ml75IN3g3djmoEnPs1KrHO/DflpmYOWuWWuAg8CcwtuhWiA0FYwt1upBVahVTK3HCh9AAqFna1qam1nkonTetqSF9TNd6DiCeRkJzhXrNUIDGzgkA0csIH7Z0zgHhs4agNHZqjIt9GO/CSu72SImOlkYFlL+dKdtsP6egogoWyqQmGrSqSgCsCv42zqzEiunXTSeK5WP3OAgSIDDkNOwuMkOhmMz8mGTV1UNlXFZPpyFC+ZebkHL6Qv3OUqm5oBUCUvhrdByYtlAFnJi+HtQEILOkKUs1GkHmAj3T5JOwNEUhzg8b6ZBBMQGpQogMG/oofRHx32AllxRC/PHZQjNadZ8I9YT/fm2w1usNg1QZ36JpXRVigFSfmXF9t6jFOohwPbN9SCNuS70GaUCYE5LQjyzp9gOXvKYjgupV3oyHaawh+EHjQjHOoMLctzmVLIlFLqYbR6lCmbOlUuUy9gMdxtt7lV+C3FdvOydy+54OU9jdd9uAte0Xsw4OnmvQR4tLqen8qzBdMeF/lF/2d/ST9WMNcgTDvV2Xwa5lQhJtDThcYDsW8rD0HMWzAK21mPn9kFLUAtsFNH7bXnGVjYrczuJjwcR7MV1Hf/m0G2BRWyw0KtXZa7NMsDlSxDZEE4c6z7acq6bzdjzKSi5NrpNOHJBwmChik/pC/KlR+QF7Dl25ktvz1RbtvSuzqWg428f8fw/h3L+0sA8qLs56Q9EYwdrO8787uWv/CX5yxd6OygSTvXeNho+6Cg7OeRGy/D87hUn8cQeIY27OJC14eYB4S7UDIP1rIboCJ7a/YmPIbFLsKXtGuN6LDDiQFjfl+WDtruWvCgWNY8Sal9C/OPXc6erksHvKvzSO1nxFhhvMi+fm0pBJFyig4McTegtkL6STG9f1W05jyOmqaM30LYfNrj8COs0GAXJBeEasnpNP0sdVxwNMt7lTVmvrKS7Hg4hZKfbykXly0UZL8gA1Jw87czjKf5GZ4X3I8nT8b78KTzgnumcdSCji2pHKunVzzYWQbrqeEsOu2revry5gvIcRYHDdxhAwMbOGQDB/hsSdZc1N6FatU2hHYiZNeUHRvWlGJ8PcFKcfz15MBjuZ7MK8XX9URfDul6oi8DvJB5uaO6ntyvmh4Nt+xcpi+6IF2qL7pU7cUYyZ6QliGO5Md+bl4CWntxL5+lLi3jek+pngc9NLyfzDXnCjYGLk5b8xVO2J8vlWtCvsjB+6eZYuFIyfgKPpm2crbipBVa5BB/v1XlKafQHJngGQwrHvu89v6HZomf3vsfYgHt/+MzzVgi/vAUOmNTUcsp5jN+Vj5rTUCuM+gUSFlOgYjlDNqJ8E4jcWlVJC56dHUSkF96AmGYz4vSSaJL1g/dAglUz5dSlRFh+cFqtUxLZvXkeZHvwvOe6ZzwfGA6B2XieYOLqFtksdpipwkUuTviVbeYptPd3YlMic0MFzrep3xnyxMds7uyHN5sMyVFct6fVghBUSEEixOKObOc7Gk52fngWObCGTxBWnrWjRX8zPwMHHFr43aISLPNmJ+foWaYd6Av34BZ6avkktgsFjBBJUx75PuWTv15mfpoRZfRE4wkpn7upv7ihqm/9G0x9Yvq1C+qU7+oTv3i0U/9HZtPfejknmS4vRY4NJrFuTC6byZsqxSGnrX5jN3KEDvr4U3XCehwVmWynjU6Wc/gHyCh7mO2gdfbBlCj1Sfh8J+BK1NwRyksvQz7rdk+QeKcSwdzM1tVVpoaXD9zFNfPyM9UdY5U5mqJ31Ay4fZwqnHuNaMsZkLtKqe3RpHApuJzdTBETI3aY2JBJEoIh0Ycear4bLufJS/BGtvCpiktWdlXOpULD2l7pRQi8+LjZZez6VoplSIwQC71Pk7dWBX4KDYRhc0CODr4r4Lo9G4oVAKbwKJx8JkSvIBDF0loD4f2UUKn4ZRPkSi7XfkyV7/cwcEm1BdN449nhbqHMXIQjf1kpkYmGiaWrCR0e3qB510tYteAxFfIbUVEEQRuESRsu28bUk0EbZxYkbFlN6Md6UWi1AkJwR1GQsC1gDt7F147aZ/0XmH2+0L+jMhA89YgdUE+DqRf9r1wgkhFbVj9QUXZtG0CYRGiQ6HpEPyDRjjBR/mRs+Jn78CNpksqsOthVABJTQe2BI4is3WMWcv+UF9x4BmS2noXresQKgM4kRZl25VSHrJzZX//ZVeRv2Jc24b6rdwT9PvXsvdVcd0hTUCc3vdVdxK1iq0AD99l4ho7g1Qq+yNpiF48lex5yM/SgQS2BVHVsPCxYf6/v8UwRwUnDvO/GIX5Pd8uMP/sw4X5QG37BNcACnokg1B5JKNhPZLxsq8DjLmvngouMEb3s3P9sznoneufATH/+eImTQWGauYmOEdS4Kq1CHlb7cMbEboX/uwVuFC+AmdZXISdzndaYnkA32SFZqwztcomZoo4JdHKwiKCcjnuzKMmeKRh4oY07MsAXI4CacElbuLAJT3jKh4JHi6K7xfbDj4SxL3Hu/3QE+tHEZMlLDYBWkVqvytA2RF3YGTXWxOdq7GoZOVpEoJ34yLiDbNxwepL8zXN9Q+tW+ezqMPcbaCI2xiHvCtOKBkUydD4WlG7A+I5O6lcbmySX3lLtcFafdy/vf4MtQ2CthCYwgQ3eyWZuPihvjDW+vzaPEz1w0Nbmt7HjOGflWxLGs8Te1xX+ripTTV70ufpSZocrslvdw3mBjAo2e8CWwFuNTLS9+SQ0Fe7Kbv4a9zff6kUE/QvhFykLLdcT9P9OMHzcl+H2S2WGta+F8Hh56MKT++fVG3Ya15OR+u1DEgRjH2Pw7hKx4vPberg54f9gKXcqpIBPIAMWO0nyIeApGofcJoxgBbiUT+s0CQfK+dAXjBsRsWrQIGKDGxsC3U4DTHnmy4kH0isBmAUz415GHFvCZ/j3K8XFX6fiP8u6clE4/idK6gZts84Wd2DFpHeSo/0qnwIgwNdtQk0p47PMnF3djZTFpIQuIBlCYELaElotxztxeq0njxR88o+oXRULfBoDWoay0dPa6RhMXFjxqJONbV9UgS9XGxKEwc41nygxEs/0TYmWpX6CQwrCjL1//Phd/+/Lfz+wR+5/xNVF2Hxc/fOietkLHdfRhbi2C3E8fhC7NIlFU18eJWAdGEx1g/e5RbkgGrZu92CHJPzKEUxFmR3VY5q1rhJrJlDVdpnuCRYgXXJRVysoxELT6D2s/yxFTjgxr1HlSLVA3ks6MFPCqor8Igp0nd5zPWgDdqCSDsRm2UfQxbgkZBvUE5tDipvwUmZeigPxK6FCXUJa4s6tmPg/KJyBVoBvtM1L8SrdgaGwQQmMKoi/srlpQit0zHrm+hiZrBZzVe5aCZ3t1tn9hEyhNIxaSmaoT3I7hBe2x+1Q5Xu9WSZAN/tZb+ELDCwpDC1s1IUeM0CjTe1PiJNTKC6oW4LMb54SIMFbgjLFK9Zd1IeIjge4cDa/fJRGIYuoUArUBueo/Wk340+Z6bLGHdnwk1rQgESUpcD1iJMIFEKUIZn+u46cxIxzCpVvDSFm6uAqHq0kBYF2pzCIWOA/bQKz2VcQAaqZ9d7+PX3f/qhD3/8M6+97ggng9niY31Co7P340Ox8wIXToWPzdF9cmYQ4h7dryqqQCEydhxHzBwHdmHMjlT8kCSqjV1VwY5csOGCTfiWxpGvaGMnFEENuzHIm+LEKg+q/jHyyKlhq70dwfvU+caI+s43IuqBPIeLzBubFYP8/WSTZrZcsC1OcVujzWwN8vbxmin02DJee/by8r634pewwoZElK6vjTjhoaoTHmpo2uGiQY1xdxkNqrlioxPx5YNBGyvH6alTk9k2ag8HqsDiZ+sYfdfJIirzkguy2AAopiJLXw85gv24xOIp8vsU8FHFRhMwGKdgPW8CaWTIvGPaOQFrCTSsAt1BkpoDquuZkFrqoNC4sdFRMaZy1EeatBQSILUT5KlZrMfBvzdiKr4Kw+oF0Xn+cfStlv2ZkOttk2JBEfWi6O7JfvaxUOGuY/Y+XZgc+d9jfIeUt2t9JygB0dJIb+wya8qxlXrf40dqyhrUxc0Vr18f96DjDcG7VnDZc/fSkb+fVK9SeJOmjZp01SsWPFe8kQsW0QAsEaZMuFk1JVKWWEuBxX2PvHHc9yZeycBNCSWFFWWwYN8zFv/LS/7w6b/AYY/i4VrpV1k/WnsLTvhecmxxwwe+1eKGDzwcccOvjYobPvjtIm740MMVNzzHh96bdHo95/S86vOo7wuCGnylVbEUsLp+mAJjjQqYxgiW+9YdZ82I1v30oOcFFS4qUGChN8o3RRSoiQa8JhwjjSTVdPOzD1c5JL/kkHy86swDh+QjwnFIeIH3qVEO6UJwC0cshxT0P2ZpRaAcUmA5pOzOki8KNuOLPvII+KIdJUVpjVIUkB0lF//n8U5/E01Bscwa7I/x1L+qK/cDsfMBhfFQsZC0ClCHSUOeCNlvqhowlJ79ley38Eb+hPOJUG/Z+oTAPTZw1AaOeGb+indjSFc2rnmxUTnX/HfYDwc2cMgGDnhUV5ue68xWyWLJv+CPIDiqU2P/hMXyiF0sKRnolFqTFQIU47fRKSUAEQ41OCQmKVpCDxDX1u5TQ/S9pyq+BANc+IHdfcjPMiiudIweRT6tiuLECbhUIdZPMI1xczlF7DxNmzbM8b0H0ZSeN+cB1C4zIHFxNNHD0bJHs4QKby661B3QAoK0iF8+wsCVR0zqOSssmaFZfGkUgdp4tKu3mPJO1SZsSg28NPRFhTZoqvZmruwYttJcEx7T3NZZPSUZFdOImCePjHt8xQHvpRcrHYA5tNkN5QOIs+jBBnEPepCg6ngD3/GxSXzHWCyXc4J8x29s5DueVlKJnRUWY1eVxdDkbiV5eYwDcS240FAjefTrKzzRCiVO3GXRGVVTNEscMSdrU1iJwz7YDyoa0Um1FzhoustSS2gwhqzB2N8jy4W3ycTdTR7hSeaZmaeQu5VRXV8fizQamv2OsbhprrAGzBsW/IPRQjsSC74vBRFM5OKvBPyhyMlLsA9GQyNuKEXV2vaOvmaoWpwSEP9dArlNRD44bAgpmRj4eUNKwy6q6iixKdQlrUa2rIUOfCrXbzHH8laqV4KpRQmHdkksp/ND1EYhmYa50srMgVApRbtS6XmTP8qbdgJlZg5kOqxqsoRRLW9spH8t9HZ8fGQU2iKQrhvL9y2qr1u6Nig3AT4EGMZ8VtGELr4YKgaseutDSvm9snMQOpKiqSmOJ8UEi8JWWxxIc4tYLzsgc0j6kuClwdf584Y5CTAkI+JBtUP+QT8KymVH0TDB6I7svQ+Eo+93hTyAnno16O/Ng+pwhWL/d6/wKDCC/UCIkRGfmWrEPBCBcrRCIfETqTpg6mtPGB+1dTbS6A2D4OCjyxHaotRJAFnvrech1fPAnA74xPXhQsH2q9bt8hJWVhypn3Q7LPyo0rJqU3wQciWNBoy19C4/xn0HANAfFc9OwI8iZtHHbooITzLPzDzVtjUQR1fKiqNlbCsVW3CML91suWTd3teoBTga21NYBamOZo9os5YfUftmuFO5uKe2XdVPJBxVGy8VKX8jCp0omd+YMqF0g4qYtQCMjzOn5FlYHuATdqBT6UfyRkln1N+qQstaEgpLxXsGtVG2p2b6tjDCWVRwTaCUR7efFWqpdoJwe0iv2e4xUV2OEjPPOI7zcLDjgSpkn3q18xIO9tLphKvvUDnAKUKcej0HIoyIEQkvlzJeAFmHwCmUlCd6alMdk6Av44ImnBpwY2z79HRRrwEjSo8etXUqBm7iIK5B/HdxT9lLHAZScx0HYnirNh5tvIjbFmtjU9PYUJo4KFpyNFanEAMeauPTYZHyz2EmQwGk5mJ0acrRsGvUo03/FHjmbyjVzEOMDhehFuwxLw+j6JJyclwD4+80M9xNm+yLwgRP9evEf9/T6z93JftbiQJbHXChPdijV8sEXGOXuTJ+ZMa7SkvO18y5WIOazNeYAVO+w4P1hfJe2zmTjDWz77/9Y2aadUGfbKH5OK7o/26CK/oHgsgx6c5Us0XPygqGAjcuGOAWusKfO6coUd/HHs3xv2PrhHII5CnXK0cmQiIQmssTdTPWoAD6HkolCNnloybAu++v4qd97I1f+IqSt0RSJ6UwDmG2NkErmpbwqbPYDctndeEZdbYPPjMPpF/h5H7d8dj1609+/3tPe90Dtb1j/XIpj6hfStY9ZzeOoke7Bf/jb90W/J5Nt+CfOv4W/JPf2YLrFvzXT2gLfsQ/9hZcXZC6LTg2SNmfH3ML7vbND3PDfYLb62Dy9vroo91eo2tMwKP/67fXYXV7HY5srwcPa3tNhummE9xcDyZurml0b33E37C3vmfi3vqeR7y3/tNv+d76lpG98cCvtoJWss9Ut8YetsbdzbfGJ7gVDrP/ZbfCNGEnPPBtZ3+jui3CyGgz/PGtkTf6frvX960+jkySoH8Z3kc2SJx0GWhiQL6YsKtukBBXREACMGJgf3SDZFQlfGkpePWoH4hxaY+ip2+6QTpS2SAFEzZIvtkgBbpB8vud8Q0SaIbUT+Dh7AaJdDkFHIPR7ZFOFrg+mbg9osm7o3+93RA9ys2Q9zA3Q1TZC4XH3ws9WpbjL791LMeDm7Ic9x6f5fgrZTm+w3KsRQn2uaAtDb1ebqfGUe84bMYrqzzGHR5vtTbjMSYxFiFmxO1eHuE58PJ4A83QCYc1SOwUePo86FFi2QzG6bxpyIgnoi4xNEB18hjbx9gNBC01aWzKbiiT0dYecUEhWAthOXK9nZ5nnHbIE+tIFPLkRn6PpqjFAWUqqLVu2A0YHgWXMWduxWTKQMyaaltjHEanzIDEMQ6jDcI2RzObchhzG+4MT9Mcf4lrGZSCjOCA+CAaD8EmieoGiHYTaS1h2FochyE56BVzFFFEc5f3dJAOISamWGJiCkFmQ0NLqjwEBFzn8dDyMz6Ph9bwFHMTeIo5tFh5CiNB5DjlKY56G3iKByfyFA8+Yp7ivm85T/E2z/cdT3G0KkFCA75gydSEBSgwquF41lSIg0dlbU9KPsLPvqh8hJX1TGY3spVKTm6NM0ceei/XDcbEpnjGSg6emXnWxtShqq80cfnHyq0iib5nXQKLC4xI9LB1ajo5jwnUjIv0uFfU3TwudX2DfrBqP6XRDFis+VN4JVQO4LAfx7qTEnJX0cCcrBimq2UsPIZSI4qU6Lg1PpV+8FIq9znbnDgF0/MuQyaznrl65zqwQ/6qvoEhyPibDk1hAmJSTtH0CEOQWYZgxjEEDWqodf+YiYT1K65MANzQzwxyzOpEZ3VHZjVLDKmzcbXv2NW+o6t9mn7Y9wPBA+tFl5uKFcqo+KiDV3zCDYqUoLM7i11quSQDjygklLPh2cUzXMUFxuzv1d08oluI9tFq0IdaxxgcObLB4Mj7nMGRI87gyIfU4AgSXR0RwbrPavYuiNTKpvQ5IPmOUbm6rn6W0e/QDoFxWdGPq5X40hHbv+wf1JSLue+gkrlPL/WwiWAse0W5d38FMM7ncKCYx+G6vIeS7nNey40WYR5BSfok2HGxVu8nmquuG9PyeJJ5ZuYpLQayYsDUGn6SN6XvZpGMAchPqo/rFAxCu10TC05iUpFSqC0yTqYwbpvx4wW8XvCDcDkX+kW8qqWQkYJ2r+fzMHo8v9JPXpwvOLxf5AIPXJh3nT7TFthNBqcIDUDWyqQ54j+++N/rd6AoViyLcy2Uv5VS+Pjahkcmtm1DrURsTxPB1kWIv4t7PAPWafvhYZFTLlSBMFuJlinEwCgPiYO4A/N5gR5zDT4mUZHvQGd7WL532tKhl0UF7mtrDIW4mkpq/mMb5ZcXW3s56s+JAzntFC1vrYV26k1KwoK/w5ZIC0LrQiIq9KYCF7ITheQcwQGORYtDuYhZ4JqkllCktEPAQPN4JKaLxfZBnvev4XpmuNmZAGRrcZJCbWcRYrB2agnbiPCGmrYZj9EnQfJ9Ete4C/EhrqmczFXn8sHz9QotV7BNKuiUFdhyuaZTtCapYJdWAHjs0gqs259Qk1FBHiIZZQtfLLAPqCV34U/lmk8WHudkhoF479mFKP7MxJLGnkYF7Ticn049/i4/gx+dq/IzaRlvZ1EOAD1Qf37+OMaU3eTljxc0W6KzVoolvnMAN+IqVQcKlnCdpccDRZ7AgSdc3FsfgfITB/nZZKA6zYHuavEk3N3PiB8K852aerLC5mQFSW5BcjblBiQ7ARIgyj21EuhthsrZDugGqAVxtTl1+J3rC2EfIKNQ65vTaua44pM19yZjjBvRaE6oyToESEZNXGkbS78cWp/D4bslnJ8rCXs0fg8Hj2j8efQ4rCHnK+LMKZzzJwsYCimaZE6dpN5V5nCQk57JV4xUT49TdtNJ2P0QOMBtPCm20+loWlJsHxaLxzjDCft1CnGGw5QCxKrKF2iAQnO2s2Xt/XmXqxL6gWnnbJ6HtAzjCSCqISxwbBOoMSoV+dAxCzCxhpWKM2ynSQlQhQstZdnK4Jd5mtJJ+e60/8r+1XR+j4Gzi3bd6tzpFflhVw5tGSk0bwvUTqGTmHCg3axNS/Eu7mYRvoSdg+VP4jqv6b+Sy13JH2f7gr5t1b4daAADlsVhE4kyIbVxYftxL6W5q9DkrdSlk+hJV733RhD2O9+8B3H9UPAGD7KdAuoVp6irP4XgFu7I4oCp3WnEf5f3qNqR0W48bkOzL6g0+ynHbzYGBU1/HJpuO/EktPviHsc8ZbQzF5xwZzA0+YO8MPd9bspLtAn5Cp1KCe6lPJ68/VjLUeuZbCdJxuJ8WXwgjGgI14J0GDMYaz8ExbibT5xNCmmfxmXOnebXbiQO1t5cTKk1RH38VzYzjfZiv9SBLYcXyyV05CyeSk+lqf/Sq3RnDo8526ueW8MwPGieT82R5qE52jCa47iivcIF50+lU7TVDFDbTDqN1/8pLHAiHX/qjRiBFTQY5pnhUZp/1EAUf0WbdGLOdiIk/mq0E5wocuierrlnwhLTGfg5ycD/DLCZoscKapDjkeUXOgIi6IcZSBcO1O6JTmcdg7Zb/fEpGF633peLKJrAKHaxAdlJplglQHvNurVp0Rdy0dulcEyAXbKw9YrT+Eb8XkyGw8PBsevE/UYMBP74dtsc4Wgbi5E2IuP4LnvIlY7vUjCc5kgWGuJIFld/Gm2XFsM+uva5QOe3qUQf1U8kS2YcThEJoKnbTIa8rdVMnJbAJTJMir1q8V0DG/oNBsmDPrVfIlMSzTj8/gkzURs1h9bMof6HMfd8mXvfhrPOk1n37T/faphvtdH5ltI5dC44qD10Htirs+nJzCjRE/LH08nMqe1kdvCJ+XZ6AvkoRvYDedvy97hX193jH034ueW84C48F88LjiQ0Ry2xXSwCnxhAmOJnzjCUDseWc56irdLq/yKcM9pOHAAEQkBAxVSyZTPskxRFkTXH/kHK19KHPC+6hgJxcUbeCp67oS6zn/jn4h7e9xThqnrfF6fvoXpLq+/HIKnXMKojFceVAhbdvV6Aa96S9xlF/WJhTVEIJZIXXxTRfiA0lLZkh8hBbiLA7wNffIwlMpiztMROOttGFGrarVd5zgAH7BOaz3lN21FRXbfjvtkyo8XS0uOoiHxpgorIvWFY182nFYFR1ZW3bu5DbO4jwjggzl5JoPjiHswDj23v89BufnUr3UUoAcQgBgsoxoUuabrc1JV8emUhwSNBRAOhFoa6iVCG0cbBzdvUrPEcBYieE6OqEA+ZS5+BeqeTUJdDoVTWoCalH4RFARH+Z1+RbX5zwza/eZ44M1Ahwz0bhAyfdEKGe5yQ4TMqZECi2//XiZVP46qQARfTd2kRVTgkZfcT7X6j7H7rseo+Ot864e6j7SrjCK2MA+Nett4JaybJOOKRrXTgrCz/YE1PFUqUwlPIvGcRSok9+fhVd3SyvsjCoUsFDkLl9BMrRiDYe302FRlBXSSiEj2XCCUcWmEJ9HKS/oEzICyxZr5Fqt20eqP22CosWlWNu7aY2BIhxxQ/d0PWEWNPlZEnZG+aovV8hss50BWxxqzSffhwoXR/kdA08R/zqPNGciEeY+dRxCJ5kFx08chE5JFoOeKiaom6tEgJ/phqpSy52HJ4CHvWIrlYAjyWaMGI1BXcTZZcdI1z83mVXPTEk7na6NpqSudvuaYezhw1hhI+PqAlORkoumyJqFjsceEcIg60aSvXkpha1AYU5xYv6bZEmpXjl4QL6anXby5kKwppcwQHOBYt5u5AcrGIgqSEHozaAQw0g0diulhs4dPP/jVcz5QIF5ZkF53w9pVfFwuWOZRt6NISolFTV3e1sCYH+1SJJifYeiZIll1tj7js7uZlb6+UTbbsLpEpezvK3q5lkykbyUZoEVEMsC9A2JBDB0SFDQVF+Q71LUo5r8MbBQ1zJRgy2iEuTzmwE4KGKlBOGvBe3fR9igO88WcnqdMQAijOTGs3prkbWyvdaNtunExt7Qb4UHQ30WTtBpIFRAYEPeIKwQptR03iMqhDidbU0ppaXNP0sQdjGjVNbzIYW6TtRQub/LYYcc+KXQOW9cDUvYBYB/MUBWR+GnBb/1OvxNvBuXqpfV3QZW9R8VLnU2bn06nEPZW9gJtBDi09zIGF0ve0KYxaKl/KT9202F1c7BY1s1V0uRL+433A6bwPIA6fjn3AseuDTMfnP+wCWrSd+8O8JGr3uVxiqKi26yA/nRnzgApekmCot9IW4pLx5KK5TDk9XKTTiXQqdnlHsEV6j1CXtvDY9PjZnci3dw9La6nL/Pt28O/cVpTLHQgrHWjxqINUtoI0BWIrtDocj01LAoom1Sc8mJZIKNQSbuGiEAviRm2hJbNpaZvWop26adGqLOQWUSMoRyrOMBRUeEPNGyGTHQsyqAczamL/26b/7RPqv2ILPMxobYojMleaWvNOkIv5fJvgSsvUPAT4h0JhfVpU+3YCtT1isG33YKi4ukteaTCQvAh3JSazGRJj4G0A+C2V8FPD09spQFXQseY/E4fmb7cwbeHBkxhdWxTSUmwTmJ5Mp4Fqwf0DRKA0r11BRDh9HZZP5Q935jsIJja3wspivoVYOq4qSerSzKyRKU1DHYUHTrYATaE6/NSlCMuQXYLaZhHauATpAsSQRemWqlnr9e30px+dM7f71k7AmdsNvwCeb4Bf68ztn/5vd+Y20Y/WibptqzrPKn1zfbt5b9vMZdsJ+mnrTOziI3DXpiio7trG0A2Y9n+bu7ZHjlubYta4f7YfKQ1Q3vULo5u5D+FdNnOapJu5jyGYqtJZiJ8a73rFPAtF6nxnxPpSX0oR3Mv+BSPEd2EqPoyuLGI8XuB8GF3mfBi97FH7MLo3ij2rAe4I39Haw3dkxGMGBusmX+4wYLzv8bMHHgu/RtBSOIZvo84j9m30cw/Tt1GGa0oJzMnoohZn/yj9k612jEdL/G2l4pBdn7vNk8wzq+wLRRdWrVLlUT8RNfc6FDoQ0vrr0ISI+KGLfqBK1m2a1pW46urO3WGekljyn6ULJcCcoi6a4hg89kNJRZzRr2iltlj+42nVRrmcUtkjc+vb6D0alQfSVtfCCDwCRVLI5UXU49KnEaElVVtYkx6U3pmEDYGfyuyfAcgSNMY7k8z/28DrGO9MV+LnBRO9M1027p3JqRw916vKpSKN1Uu5GT88NCgiqC3yIxQEEPv/cKmj1hMjQTo414mADw+iuRykh+dX59iGcF+wmSHcr6G29PNpI5Vp6hQ8yl7dX9vv9DegJrYK/RJVvHgBxSBWl+nbD+nb9+vbpfp2kb7t07cLZJXJ6ypzwlSGIE3ZsSbFiH4OKyCJtT2sNfsZ0i/kCBiEWi1SDHewCvW/l9jZGKv9kRalgFAoag5tWOiLCRgiccUUm+YDVhKm4BnqepjS7LUHpYT+J92bkw6imdp2ZLmAsZFCaQ7F2UGbdU7yS3TesTZ4suodP4D9Jm8N22BsRBPpCcQdM262zuLk8bJ8TgU8833vIrGPvqgbFx7zWd1nC1fOXOw8+eCO54wsKqSWCshy35XZo3lMJCXmBzzaQj0UwkzHMi0zl7P1NqN7PrNCXY4p1z5i++Xly+W9NeQ3xdKR4dCtbPg8hPRI9cEf9Itt/Lbtol7lnNnHZPep576CS3RM/bowyrmf0mwlcdbuPNVDi7mhDvBckCcKJZ9SEf0l5NvzibrQTFEEdqJsVBKikHIQISajDmcbGcHCVyZ6UUcxE2q2aKz4XVT42hE1p6cNqVMm+6VQqi0SlZyRL9XXyccjwRAlkN6rKcDkmdB+F/1aVMCYDdRMnl7MtPUuDq8/kPOlhIipakQdLahbiOomqAoci1DzaN3320YuKbRCSmUHw7svbco2gZiHoMyOmRVVwsf26mhtVTwG0WHi311riiB11SuvG/hOET6h+RWhtg7e2jyzY0vQykShD25Q3XvDHw5rbr6U4f/zkDwX2xSq/AhxTEbbsHjGpMPFn5wBM5gS2g1BPEJiJHMOIThWA1lFcI/axtQxVv1xNZMJI4uvw1hbaDkYnZGH1u+37nBHe6S6khGl6Epq5S562IAGF4mowsvdEdKwSAz1Phn1ZFYUy5cX9R4OQjmCAxxrPhD8Np+g59JlY2MzFoKjMQ9ojPRsLOqTNuoDr7FR92yI6t9f8pu99FAwYq4z3miuk6LsoUmWpvQ8pz5iyqruTFnVx01ZuXRJRWcfdjVofWel/OQbzqxVSLXsm86sVZ1wLcEaLKa6MWxFK7Ir2y8nVVKBROySSsXI1Qo0P9GBiomrCPY86WI0xJq40nke4FGauArGTFyF3PJ1tJyYycJeAdnzOj8pHDVxFTtF7fd4YoDW3UqJtYd1QShzKgUkaQg+YZEcsegptL35wzhtg547NSS4yz/kAcXQhxj1ZwcOPnKjnvXRyyvfi+sad3jmvkbcv+kfVW1dV/hQeieNRZO0E2KeNnvVQXuXJd7sLsu1B/8dWPb89SgAhxW5C++OcQQg7oZbTEExDKNY/D6Ip3ceBlvur7xsVEv9ytHXF2imy/hxrZhcD55DKHDELF5gzeIVcfZ3r8FT7FzXz2N2RXmGPBF+TGx3cN+uVqutL3E8BpYyzgPEG+67aVoX8WGZDiPaoheP0619n3jyNc9/6+DzFw5RrFio4R3lLTfj3++Yy3Qppq/YnvGw4AwoMSzhujFfed1dv/PC3f/tXlOH7q+/95I7f/vebTHbEsz+7tViRoYizLOLtNUXaKvPpoha1pKEhtVOvbLqu/AgTzYHEbD1Zfh5CZYQsI4RpefI6UkDnGyTouwBQAx5rigCXn9lwxWUh9qogILs79EeNYz+1RqcmN0mlFtPt+Vjla+3KRVXIsorFvVBIcGDOg5V2KpVh4hMkdlXjZPO5ZXs6xLUqYZVk0On+iHMZAgcEoUD+huBORc4m0WipvVg3cq+pB3T8mXi6KLEEQc2XmPRmV+9xjIpFrRCL5FM6X2r7Cfl5obcMHGJfztqYNHXqvQwxZKCQOVozIf7P1rgGNgmJdCaDzn2EhMXibaEJxgIyiKcFIdJZmHLBzFGBXwJwZftv/ejBSciwyW9/jfhrYgjH+Rn/eIeAI6t2S8DNkI982DzWkJTi0rApOHa7IBFvvvlroF8ESGfqrXUpEjQ41P95FyTPxd7+0pdQE6U1iT6cJQney9ataS+liLxhY80bpjSG79cbDpp9j7kraUf8L34Ggc70zoLPoU1V6pgRrFQTVGD2r6xMq0HqsocJmCYEjl4LmJgqBSN8aGwhBJ2/fp1LLxzXNkmJNAhSnQXX8fao2OlndDX7PXKxblxQ0fL5vNRNoYQ1YWVIUzsEGbfVEwXxk0KLsKRBnHzK11RpaZqg7J7rzsBGydvODiuwALjKiNGVHQRs8D39usEoJpOU7vMfq0ZnMRucX13h3FU7SUPVXJ49wbJ4ced5FCTpNxPIiiSGnQd0ztcUaOdc0Udj6zQzXbRoBhGdES3Xez0NPVkItUrgy3dGrd1ozyldzE6isGZ3tOYFv5kGv0F2YB5Agwk3meB0mjBnLzOg22TBlPG71C60U3IAtq1uOJ870qmoivZioZsdrdwJYuAZwjRO3+xW3bDEXUURRfzGm2xaErRCI+P/iOrOS2rAXNrirmG4jSwDRPpBGbWIvtP49Mg8OrdfFnd2EGZYBX17pXmbEM7duV8AJ+TcW5WiOGIHaLSYi/bQ+VTbCjuRPPlBiltp51wR+bnEbJbj4RyR2sHzm6l/AbBQ1gCXVkpMOchLi+WBnQKZ6vjBpqKxcMjoGV4IbWJoS/iV9a+1NToRUMrEJdnu6puShJKxJHZLgpwS5Sj8OqcmUFy5Ux6yTWtul6gB/ibOWfgeKvEvwN3uSNatEpli7SDg9r3Bt72i1JijTtelx41aAfVVh5hp7ZQfaxTgNrD7xf6BEqhRmXpFMRBHaKQUalVAOYqkOIT6xpNig02Fpuj2JxIIZbkBZdECjHrtLaHLKyfgu+2KurXwDEYxKRa20snuO7bZezrPtOMRDdPxnMVp+a7uN27FGjQacWzOA1u1U6DWzUBR75LWo2ZggcG2BczG8q4zNI8jxrsbqm817GGpwMufc8g5y4B6+kYImOfTxUG1B4AYMgB2KcXeHNGkRqfQWfQ6UY/GEetoBDT+BHiAeEFw7yFCH6eQqmGsp+SjWGoAkYQOOzBZrj0GT2/UjJXo5h70dN+BO6K7qM9q73nF07grPb6d4Iw3/ROd1arnuG/c1b7nbPaR39WqyioZ7Vj6AZMewRntd85q31TI/FFi1OPNDfQh0jzmeu/79xw/RfvypJpkl7/RdB4GYj7yFMe7rCBG2V9HEGtG768xG/w2/d5K+VZL0eNlJH9uIhb6sL02XvS1p4VBXmzWuDY1ypTZuYvVSKWopUtmmRgpi1HkRHhSeaZmaehWv3k2aijatgKE0OuqAZyrzzE2aQVyMLfbUZq37RD03jMUIdmrijvijh1+0wOJnlqSiy1wF7IeaFOmJYcTOKxP5+mQA8mpZ7QFst/wCGrwzsNXnDa7LM7wivm0/3EtS2jaSCkfH55kfW4XBSTaRnVtqHl+azQfdWYjuhRAqv5rwis5r8BsCDYBwcgQJuD2w/Okf06jsizz8ju29kjoDkQh1maLWOORSNm1HETu6/Bbl83AuWHz+VezwiUq+vAzCj9mKGZCv2YEbKNQjcl3TwcMUi3mBONKdRZ2zT4gPbP4jgqexM6xnUjD79+E1Ij2KsSg4pqJ01vtOgxvGVU/qKl+hVXL1zj8689rvV4K1wlRkc3EKOPOWJ01BGjjysxmsQoNgRVE8Izkw4HVRX0JloegbbgEcGqXV3tztTxJjYkZB9UJ9gEiAWDk/5uHO9TJntudApvRlCbgt/MYCAmk8Ovoq4GVUCwZL+qnFQkknmKhJ8TgxMzXI/pnmShGd1Nzu7y99HsmbWLcI1tFkXwHX/fkFhVPl9Qlm5RsoEp7YIkSmHFFpoTn/xLec84qk/kABlXtsGCLtEyzQu55PYLgLoYceljBFYVdZ6NdD0X2ML551b1nUHObUQ+EaVYZU1uh93P1hU+WlK+leYZKj1z0rGV6qPbWj0rtEdXGWZnJojTowVsJZaBTcultSwARvT9sb3FLUXYJ+iKg+ftq0jVrS3JsQmuAIjlmwUMp6jM319z+1pSKOWLtg9baBHK/F5lv7xVdnN1cAl5TnjW8kLLwVZWelVHfFgzMFb4bbV7OZ4JRWWjxogBEpPJBw3KR5JIIAH8iRR/rFb5sgVEPV/m6ubtjnSeehw07cbb/nwRA04903z+bOXbogc6jLSoRGG0dsUnrbWLWmkBv1xJvZR5a1hl4ZOqWQAaLZhLeYot9mZBFw3uCubI3gkA8vdyvTpx4CVUWqCzYwHN0Csf8kmxdaLP+oawkdixoheC3xMIUaHeu7QfVOjOtcixY83djrUBmGqPMp0EPjq/VVqLbSyaBqzeWqFhYlveU/hRQ8Df5FC9ulttyuY1z8zOtk6Z3nhsqkmNHbSDmrpbrVFP78mZeV/UV/DOmLGCqD1KGgQ2VLcb1urUTGkGbzM0rW+wzSUH5FMw4tPBUHUoQI9IVNmb2jGr6aW9rKPbETcvk+bJ6huhkcSBptGeskY05WwRmFTK+Jvsy9ZPRowL+SbJl2OlK89VbTZIxn/6oDGeZg6c1DKeiTbndRecYzdI3y/8Px9xW6vNAKeKlMXEEzdfQF80esLW6D0wJ0nnYxnWIRAKqrKroi7miOAudgCVvUhbdZu93gYlJGRLKEFG5L6ZmjfLF6XS4voFevOiLgoLZsFibAB81JCxtN2YFs1+Cn2rSNfTH6u4tPDNVBMA6VQTxTTjXzhW/8LG+3AInbIaBaJ6hmN+tc7teA2YJxfr5NmfXy89ElcsXvZr1xpvGP+PN+lyZECe3uLDtuj8Wo9Dvl7H00t4cxLqyeG1HJzCpd8d6Fb1ZtwDdWYz6qwXFsifqWa3O7L0q0afKRgeLqpO7OrO2kX3zH3f/y/516U/WZG4THBgV6Ze0cPrkBr4b5C9XozPDaihIUk7XGYeiu/htaLpHA0ih62TCxvmPHr7Hnz7l/7oWT982YXDigc/OQtmBNAiZWfUdtfsIGLjSTYlYZ4joEvgDx3NElrUEWt1OQcY4ZBfV9ayCWfvvcJ9+9Lr2l/9x/zGp1JK7uXynpi4ylJcgoRRX/Qon+FzgFu/cO2Ru1779bd8A/i4icvHZOQQdVZW/n744nzONTQBeZYEAB4MeZhdD87H7JsTkvlPAoc1/FLCnHRr30W/9KFbvvwnr3/q8wtZzz1cn8k+9jplVs3rb+K1tCU3hcdysSCyDwWIhkFeADAGkAFaEcsdiimKOYIDJQQXrOZXUzz4F12M6JR8gbzcMme2FLIQtL0L02ZyEIFHpjITyrfoOTiwu6FOvyECjO3nrLA8JNw32gK5Cg67uAXrToWZ/+FmEu69FUuMgWvwDkuxQ3ZOjkExIOJInneVcPn+89r20FL0AKf/9sxrb/6Za59C7Mk6ARJ89Gdf+pEjuw4+tWrlPaF5FuVi5wPMX+KKHJa64OWMzDE2WnNQYpymWWTewiPmMjdGMk9TxCpUVqkIZplBxtr96LvlDldZlMsFFn63nfn/hRUr9DjKHk7ZyeEbV+0YWxAAnGzyUXl2k9WqC3PfHnP67phTTd0aT+nPdDduKcj++VXll3q06nPZ6n9QWVtrYF4tLJr9ED5FcelnQ68zbiFRFFU9aTl50g99a2F4Rk+U1WpwiAN/cAFmnZIjT93cqBTXCLojnVLVLeQPt8UfPKfJOSi+9Ftookce6OpnrnMHd6af5IlWN7Ko5TUQZ982o4hkfVdAK9gTHrfUdMGW++dSLnLlmitPUkr07DZv2H400Q/eSvIfvAal1ECfqksqOt7um8a1CpZcAgooSSYwbmjplsWnjljKjSkFr6FuyjceriUCB3CRsVP3TEExcENZ72BTU2e6rUT4KmeUvWY8WqsCWLxiqjjVxziOVQFuXrqvANOj64ZZq6mR3ayYyRBzuZBHwLOafUWhSB4gC7iqkl3VpOYXfT/mc4FymXUGZaXCPDSzXq0Lyu5UxyPGQ87MneZWDUpVevyNF/bf7KdGHkKRcmQUyJgEcphjX0iSOQbNhlqqim99+MgK5dR5VVkf0a/M45LfAnS1djfkRaQKkQAnEA5QNKOsyF63b5HOXx23KhcEBA5JC1FdTKhUwUFLlieIFxWUjONVrYG87C/QMuAMZqW0VSkPh8l5JDkY+tEI71m3Mg29uwKRjfJM/DDHL0n2exjGtIxoSez+fuuFcuYPQQrY+0t62V9dr2UhHeO9ykmAS0MUevmGirpY9/ezHdgivURWvyajy/5Rk+Pqv9YTKxgwIctlqUIUpiz/Nxg6I1oQ6KyrxlV2L6qHp606Ktn8A3/kA2odVnuyrxSXL1R3PG618Wh6qldPU+zZGhQbc9YeuqPKr8BBcEYq7a2uRYGYPElVt9xe/WRU1bvJ0lawydbzTGBTmAsK7Hl6A1NeGOe685HrrRctt/SSDd9xwZBavBCHNw+xwaouwBTwNaK+qk+o2geOy7NbMJcxzDrQrImIiMJ3SoW60qhEJnmYmkXBRM2ioKpZFJyIZpFvNYv8jZpFHkc+MKpZdOvBcc2i4N9cs+hnD07ULAomaBbpoIy7BCpqo2N34FUSLaWoJmX6PB7gydytkaZ5Sr3QDiHhbshBbNJqq1ry4gvOokulwmj65Ikujl42wcWRUg6rlgNW5e2+Vx/nLgz5KMq7eEUg2CNUMrI4gCp1EUAeLMxFAJSA4z7+K1EisCiB9juUiFBDQLFd9oQNEm0+1OqqjrnY/XloWSrICgLFANQKf33CIONLhHAsfY5+K9t2JdsRiHILlSCfPEI8JM1gg0DK3AmYMP6vgY398TXSN7MMxQtKhoiCSr8o9s7xw++3sBPVNVSNAwc4OPQFEUS3Aouhol12WHffWH8CywZWVpB0tTT1T7zOhzwF+9d6F6FMPc9grdT+kQNA1FsPCJx5soYg9mFVVR2y8eznUVWnjMO5hsYBJlLZO08cP8IR/PA2wY9gI36g//eP4sdwBD9KOEWA1L8RhqwdE0PehtRHON1/bmy6h9XpHp7gdL/yhKb7MWiYN0rDQkvDbvYDnMWE45crLFc4Ffh+Tbj3K1cKKItLG57dFgd3YA+BxA7bqY4nwwDfsoT9e9rW1/gvMCiQAHYBCJvszxvWbndzJZcPKNL8PLYwtJ3dLugKMg6+IYQ7uEgjwVACo9V+uQjt3m4qcN9TJAjvSnAxNi4xse9A7MgNhz/yvNiBBcsbOiI7R84EjU3D+5PRDJWj7lg0EvGoCSVAaBkjLLRwDgKRCOxtIOI0LgYSz9DCDwWggjzGeszFAOgx1VawxKoKFT7AbjqmRG8bBfA46IcIyfWIVmolyHXZYWhbVaXzT9WTiBvboOaBgaeabUFHa0B3dcg9N+SCwG6oRz9yb1Xy11E8SCwawB/JO0u6VFNMiIACsVzPpagyRnVLuJgCqBPTwKQgrW6Ke5eMXHqnp7NQx0i9oRA0WTUmsM7jyRdsWbEtxAtgxNEAUitUXUryR/vtm/yaO/db3mifa4i1w8MJBuJogzSnWoTNpPWSUbf9l9BrOnxzZ6HizUf37VR/Zhud1gdv1KEU0efy9udN3aylklG2jitFS3DGowaqaxg3Vq6L/Rq8TzK2fC/ICdRbX1i0xdmGQqAlfdCiGvkUtVQpCO/8hvWJGlgYcp5LqDujlhEu8ryWJUno2zQwPKNpNKaYhsAM4AnZVu0KTfdEe5UaeYd/aEqKy5R6NPvXoPrENECBF/ALecISJhpS6QglpwaI0xDiWqEQAnQqQzvQaqNvo/3y8pQrwpvU2lD122nECwgb6EINn+okTXX/O31xEYoggmroArrCkj3dtZii2pi6HfIozd4t6KqnwkUD2gkRtfdDXsBRzRVe1/SmvOJug6Z5SDAcLepgduA7KEQpeaI09xx9kz11JREyo1YOJSKP2jg/gvOoSA1oAh/dJ9kvKrFLHLH7AKw7OgrnO8weo3a+ULu4kPhYiF5YnStx5VtflgcfRUZ5LdCcKJ0nO4hLYpaSOiWuPiQIVvjmEppNsnQtrNK0//Mn/qv9kcuNoVt/SeWFhk3Uh66trou+pniaol+h+Eg+dRQ7UBGEv986TrEOplAJWhPq0U9ZgViw0CICDIlvy0EphKtfLFQw5AkRFNniqiUp3mW/pFfo0g3+oCh0KPjqQDbMQCfLBuBU1pwOxxRh+KLq8Klesg5fKjnyul4zdKCLmThyAngm2U3q/rJjACX2Fs1Q19yqJRC0cy3cMHqpGXK9HqnTS8W+1aZ61aZ6ZVP9sqlAAwYrvlBuX0ENiZpx0hMRxFpmFeYpUel5jIoDg7AhMgBrNWtd+4PVQr/QBNOfqIrQQiGkEajZmC31vcYo26OjHWILEJXbkhiE5KJeX/YmIvhUPSUduhiX55JAYtQnccIrkOlXwK9YiUp8aqq+lK9knV99JevAHCXrGpK4RNFbZ5kWXCdpDWPkM0UCKT1lCgu+Akwmp4OMa4MUXxMsB2nZoHRjg5ITb1DDNGgFDdKCE4rBtCgwYJJXpd94EYxaSZ+02W0co8UYZO+ZcCPnbU0+2G6UGlMhz+WqxtT6u0uNqbuNhtTHxE+inCbdIamTT+MGSFPdKhSi8hcQkl2rOLvAIbiK10PdmUSruO9rVIF0U5IgjyfLZQPm6ZriICcXx1MEZfD1vA2bnlMWJ2IIihQ7+vwmgqKpihQxPXxzMUXpzVCjhQIztSuJTUlslokZn7HiYJB8PWQueLt3O+hUYqSp1/v4PaCX673VIlS5y7vgPOb2YAXyOFF76a8LgVA5732eltAt4r5MTrwsP6On336RU6HJim9x/F1+G1T16grR1w42OQQNYBuWgIGwtyJS8Xs8ESrco1YLpHXkZ7+st8jU8XcGVcchAyATwPin80e3OctGl4Mgy6igR6XosmyTOY3XLHxEn70W73mmWKNVatfM0HIemkLVu92ZLWXmMPvUvUNuTotPYKfLGmi6ep5HrbXb9r187he/+7M/9jY+NJ82Z4tXPYVckE/PpwHdi8gzBzJ9L/ug6kGYdqG72SB7rywlGfkmerriWe59ut3m9mTS3KHCa5q/nRY0+RX5eIoCguEiUUxHjitwVMTNtJd9MWzUQWxAOn7EhWbvx9f70h/7Hy2Pewb/VjIdxJjFLTlqmeITcKUqZkLr8ZudK0nFyyQ1YZt1nfG8wHesLn5bkbn0jjssLqLe4VsdRgHnYZOokuXy3oNBEQux1rOR0XqywVs2+yjAvvEScckeEnrQApZnv2r22ME6TzXEajeC/TjzQlc0hx5OqLxZT1YgjTrqYXZgfftiaE9xEf/xWjV+/aCNPzIS/4Ey/uzJxewai+ZqmRpaRuKI58OdopWW+Oozkx+ZHpfqMa+et3mgUVH1aCQeVV2H2BIZmdk3jLFBTxhvGaqWOvRPJueJKZajbzlipXhwGwWSkWrsMU1SB0Uk+IUlJKBQ6fwtQQyDy776pnJ+Ui1vqDQ1ohBnw3PykLszcn86lDM1brbwKzyLbgRAsRxSVFFdiUt6QS7ISgrx2lsYLer7Yb/BZa+6XA36fs57yVw3pbFeQkzXi2hIPisce1j8Kt5K0E4wWV21x4ZUwCP7IJo1hOpS4tqsx0KiRCGm4N13RYSXub5x8J5yeq9IDaAPwyXrAG1hsIIYcTA1wcNr/MAhVYs1VgLchb8Ch5ZNnHs1ze24/mdrRmENTdGTivKEj8LqAd/rgwCGLwLHI7nbrSO+AVH0OT6pUa67vfM2VYXJ9PS6vxPS1RoWkVS+ucvLY3ztqKqffUgmBxAH2Km5RrVKaupYkOo2N/jVs/Wy6C6IAfS6EQNOzf+IJ3zCD5vJbZ7j7xSGKFw31H0LU/fm+lrhq38/DFaDAneAF3A1r7cpSTXFHLpGQPgmiMNIX8pA9mE08th9iamu2VJMFHeZ/1eCCPNDnada3Yh9hXE8gPPoyryWjRvOp+73XqhMyzM3OhOOA9mF61FUgzOurhj9QpEG8IqIiKxIKR3kLRm2KG/LJGgRUMblGZqlJOaOwVAckPRmXiNTN5ppdY0c8Fi3ocUI+6tVY+9Wkb4ub8Ji+2vZm9QABgWio++bZflPoSemksXsI7JWfeLj+Mee3/BlDW1vktM5AyLdNlyDITkpB9/daQ2u6GpXpNAM8vd93/q2V3/hP/C4aYlf5eaX7QA8ynheYtIyN3TEUszFobRV7SqlPxvWLXELxJr8iNGxZC338ezmwcMbUtzGHFVziyiRQSxCcEhyc0gWa369D5MrVA41ghQGgAM7BidhnpoWZA6rOopcl4xi0eFxzFybsxFex5drchDbDKWw+4x3aAZyZ22gLlDkPh6y4eg5lFEPK5aP4VQBqnlqg15HXpQKeSkpp6VcAVxfQzHOtfcw7xDssKA8j/yhcBYmedfeNWbxQu2nXoyxX9aeMhR6h7jmvu+/N7vqR077m6dyg2UJUViA19Q2JuvoWYvJK+P1QLuUUGsV0cw3oYNA6IH2Tn2fqWXpfkO64pN/mzaNgqFiZQBGC8shH5w/FCa+8dIYg9I6T+EHfHc8oU40BQpF3VGrNTX+ctTLG6hnyJPXv9n4XAzVHXjfwx9Tu6l+Rvx3Me70xHJ1mZsgetLwK+zu1wEtxDTj9Mr6oJihmeGAZ40q0CVlzSbQsIGvY4rM3FzM8mP28h5+icOXF3O98n7PYK2YRfRQHrgS9NED/+Pe3/uBn2JLMd/9kj/4tWf83q/cyaoVO2/+1JM/M/XbcP31Az9/03WDHZ9C7JYLnvkvn//GP3BsMXuYP57r6XOmeq9o5jDNkF+JGRYuvZJVb11l/cRes4IXVAzatFGtj9S5cj5vHPDItprmsIlbEBSZYbZhiiOnLgZkcX9F7kxNrR/OZ2VeK4xJcy8O866brDP9XfkUF9pl2IILXSkywy3McpvIzKCcS+PoYgrtmeeCaBH/DYc0c8xeGR89HelHG/KONrXAcDFKCNeKlpWe/s/3fGf2Aj/W0XD269AZ1QRNHTWEkR7j09843qdv9H2v4ve7artSuDuQajlB30cehz5WW8mOmIUzZtgadeUD15/VV0ouDp7xhRHAfVSIuVaKupUNlsOWXy8p/m+oNrx2oWXOGa1Vs9gZD6Wgk/aT7I2iq+WJGTuqZ3+JXaS2rX/9G/gcUhKyW5BLm2LSXstp2Vsk2pOE7LPWMlz243p0+UbPBw2wgt3snYBfoWa1DBirS4HKtjhFtc0q8Ub666muEne4yoEoi4pz2It7zIlCvQSYv8GlLHnpLyb+3DVhlQyFpaZmpIz3bmXDd1EIu0ykb109lYn1LZE9DfGb03Sr6/6nz7dxle/jLtr8NcmI/CZz4tS8waTo0UETEfvyFI89egv+jLyNB+VTeCR5B485cXM8bQR1mZozEfVE2HIUFaY8AhglNAvVYqu9CLMn4E+IH/PUwmOBUjxgPDgSrZVFdUQxLSLQRYKCRAyQs5Yy3KdriAmnRiyUSXOjSSCtFK3zStnlqQvsQM3zePCMx2OB5vCYQwcguZzBmjSDqT2bR6nxiwH+zRj3mAVLp/erqxuaJVElFRCuwPVKLBiSb3G40xVusKvd6HGDaIk5GGrksy0RZMPjSbFFW4kCUJdqkEFZ1WwnZoEZdTlZ0nFq6Dg1dZxSHaeWjlO7NJ6a0WJleMRhBrXdcMSABk9JQKOJxxw18IhoWk9npNEKdvGIsGBCgLJEzJVJUSVJH1CTmwhyp72KM2gHeYY6EqatEdRZKxfXmeGE7UWs7nPifAGYNjoeMcajbsdjftPx8KVfQ4rX19ywoMiNwzIv5fCwLBjVZjssdVowmrO6GVKDQruLeWJUu6QnuzZIK4R7yd4ttDvU8/bQ7gmpPrZLdGvI+6ebLWZbZoznJH/03v2hxO3k1ZDDS9XptGp/PlNYXmF4hbO1u4oiRlProlEAXc8G1G2a7BckexAUWlj8Olv0BBNJTb3KKgezepVVLyt1MEKd9QKiNPwMcyeqw8rPW6Ikn5HrZBlgmOA6K4dpGkfuq+vMTqyvDTnnDEZ8xthV6T8ek83yDR2jIa1ULOOefbW+AgX9VQ5mlvLNUuj2y5rtPmSr5plzRXxmY9o8v9wUW8qpMoMYstq6CA96qgEf4YosDgLgFgo3Brv6mXgC3kIhZJ1qIEmvyBqxXWgsH0EsTT1c6drKZcAR1TZF5Tm9J1iXCboddWEGQ4+eFOg5bsKDjWSbz7S8glbhpDNX+z5iNWeHVMOjRDqtMUhU4Kab9U3PcO6WtpLalKyA+1S/85go1FmhqarreS68BYm8cetBhuMhVCL+j3b0uzpSeJmi7TpOi7R1FdJ52rYKZIFvGFFl31LWiJJfgGoEZ/jlyvJlwG8vq76VwdtMk8g1icEu9S/jRuJ2mhVzvrgduIPqwLSC5gE8ojkLQ8AEYKKO3NJVp3gAOCrq3pJneCYsfe1nMPOTz4gFU0FOpGSaocbp3TwxZrIosodSSNkpHcxPIuJm5mK9aop28OeF7hdk807TRo9YizPOhwxsTjJpOytp2gbtd57Y6dLGo83gv0bZWDMf+y1Wjperl/mMQqCuV5fbCghpk9zQbSt01Tq9OqkptAPFSYoCCTcjAxd90vAw3rVm2xxtgG2VtkPOEl1T+NAV/rkXMCgFHgWDNMUs+JHyJvaGuWa06sVKw8mQUMiqyPT9P5zzySc+/eDfXIh9sS+bpkxInu7SAHBHBO68BixSlShA2wN3HWTKoPCKjnV+ChRa8MfSazzFE1vE5DDv6oQH1d8F+2bgdPIlt52rr5d7NYbg+pqKttbgDRae6Hr82AnH6EA7wOk0Y3skFAPJDcH104foymlKv1uWBJ9Bp26IOZPhxvw8KJSkFNLQZTpT0fwMPHKlGFtkOjCdioG2Z+FWe1UwfZIL4uACN2MqMbS9L+r+2zGxOgSfP9v1zKGg0+msW+gsTvKv6hXBsHjcLflu9+lOmfA5owjlbUO0GPftBVVl74QCUFen+S2U0eluj0VTrGT9I8WOHhaU3UOc72p23elN30LTxIlA147sx9r0OJpGvszGTOMdNANF7KSdMJuDhqkIBLpe0TN647NIiZgKF3felmepWpqSFTKvV0AHe3rkybqmc/VmM1M5SaeCnR+Op4EtAb0DDSfhfGyFhvaIX8/i9u5C42UlUUcULN9B+hbaimUlp2WxkYYHcX5/LQf8ubnbDQE+WZeyXzS8xZnn+DeAm7jBsRN0xlhcAzS0YTbkIc3jAiyKKT+ZG4uZHYtJN8YwP2L5lvvDTnC1Fb7gL5SnV/5VLqGuFTKlq7utUHeOzywiPC4tYtWA8SgCsPM67/KdE/mq4LUpvqoaENjpWpbjrb6WN+y6cZ8c+CvxBhuU4LFcpByL0jMxGoZQ5Xou6BylsiWcMpmwoPQ9mPJQcje9XsyU4lDIEXIIHLr4Y7IyN6mxylGOChvhd20e90FpHq74Li66PdzA7PbyeZhlQGCRk2dpYV02OYcZ/4x4z5I02jscMmPVgI9D4bjV1DqDBZRZpyCX1MZBBs1w3kGBIucHBVeL66UCtAy7n4ym8w7EKPZMo0k4HuEMITwiQYubYiNOVrnqgkpZuzJepbwwb/RhTFko34KODLRo9WqPlNZwp5JuqO7x1BYD5JpcMvBdNdD0KmtAYXkbJ0tv6KWBwbeQnynCL/evSUpeOapcWCNPxdq6hAR6Xr6H/P71AYwYnoo7ZHssfxi64YlUx0JSibNWjqfcSmDinrbXrAcOj1xuuSRY6bNeayiC/kBEBTiT5sGLx2uOj1ft3COqdpf13EyVJU3XmYB3R5EWmdcJPlXMCy5incFg0AUKVy0tFjQFC3ROoQyZU5Vlc99VP/i111/xw1+8cLiGUwpIKqbwECZNjbzhEoBeVxDLZX0OQLGjX1OxquWvUSMa2UIuGZVpi+LeWi4nfdjxZqug9k0w1i2Waq8WAQsm1JiLSCP35/NInSOOX9CWLMowHwpL+y54C8q3fpoHNJt3aUHWuSDv6ADpN1yOKjYJN9flV0VTLWRD8pRLtsNxQDG/S/PYZ0zhMaXuUwLqcIqpa0YLQjFlvfZEWWuqRAyKulSxqB/VS6kK1S/vjdc9wwEAbRFPmAWSJxMePGUjn0EW2lKOTeW9VtB7qhIcTKr7PL2V15GrmB0Z7GJKbdTF1JEqSd/lBB3RgCcBPoG0/XImgpwXuMcBi7KGKOFITHoCby73eJUJ40huvU/VxWUL1gh0m5oKHorknvt5aOzo7KgDi+obINMUesTkFG96a5ORKKrsnhUnFy1O8qQG5BbF6Y2i5CLHMU62DFIRIIoRlOCcsnFNIDswSpSuAvInWIRZgs4VJxEChwJq5YEaFNHSRNXdXh+nGaBPjL7EOuH7HqPtup/P854+yrtoLLLMVUU/sQjKcV7FYDjiC7wCRkjErCnavAwfTfEQdcHzdKkD4YgRmtjNQCT1hYK2sxQU2G0WHZTCpC3mbxckKUBxXAZq0fHXvUcXLVfRiy+l+6aDKAJZ/dO5+5yXf2UzghaZiUJN7U91Rsi2AgCJRylgE3jctE5cMrQ9K60M7fufF1/9wIf+819eOMRNQ0XllqL3/Ci9mrf0yhG9aA0yZFAdWhSK08Uo4wW70QWghXVMDcQR22iLynjPKGWbtXv5ujhtWwCxrC4QL8eEAhQxVYYCPKHw1AU01ICLHngI8JUGCQ3R08jIUYRIKQKmZ96x7LEBwyzeZvs78SY2o1qYvfM6KTVsdGGAJ5VZHIOJwSyOK7O4VS7qKoyD9hqWIbsoHwr1bvcilOhnuN067mZp7lUyJVi5vZcULRYNEH74+Gi6H45+sKxTE6CEA2URaulsA/2eh5gFJBYyybzLvYPEVMmRnUWyNQ1UcmkxHl1wMqtFwGweUJrvRwZKsj4ty6zWWjM9/dpsUodHsEdE4A4bGNgAekuSJ7B5bGAQ2DyBNl7OrNBVWYY7KhmYVZHAgqBRlndNz2cNXiiO0QJpaMvYwqaEYYtd14pouGFpUwSMRxc1a+aQEQlvMEfKkL64t58b0RWodg3UaMaS9jkxNgbSV2OIMInbTfpyB17IvAzwkpmXQ3ip2ZeAX/babHi51BaAl8vIFI2XK83xnpqcUoDNpoQ9N+Yei9KaKyrsVRzCrMCkp0AkB/PmvLyJRZCmEdevA/IAap7h0Hf/uriky7ey6LPYRtuG+XZqrRdENMxzxY4Zc+a8IEhZTIu5udnqPG9XFjKwSpXdu45VTHMyXlt04kUYim1rg5zf+5miro8xmtKVe4pmV0VkyOCeFd/QsUpK40k6Rhj3fb/uGWccuaf3e6pNSFwQ4p5Kw4FHk/O5oKq9F+OqphT0ih3K8HRLFgdo4/gb2r5W7LxtCO8hhdL3NqH3SCvEwWKshvD5NcEWwqMdtJMNH21c9Rdx4bBUlob9TszomLZy31/10otf8OsnXfCUoaiwe6CUQ3gaLAZaZY4K2wOtLYJ38IRfoB4kS5xaFwTiU2zIudXb27XCkV0gFXN8V5pEirD89WvW/lbMvBKYIXVMAPqqUgA9XbFijTnKwEUYSh0ZXQm+PSiE8lBFCbI3IS6dENeYEBfCeBdWJo1BamT3/7/07ag6qYqT0URNybuigI/cK04fq0crch6rj4T87O/kfDqE0UHyso/pRlLf5Yj8NxGTR2VcsO+J8u+vLsx+C0l8LATpg92wH4USJcUVp5QCnnWmoAK99aJe0ZauM68qcMt+G2Xhy0Fp+5v7zF5z/uzagzVkgUHPdbv7O2uvnOfr5vcu/RT21rSJ5mNs6CPh+oB2kzqVSpMw8eEP5wliGKT/0RYM9sJcKJx65h5BPLD9xef4z+EC7gWUKARxzH7HbrpbCp5T/SsAUlE/vcKK0yNrsH2X/4KiGsN1u+Ym9nbV/ux3D1rnTeAeOEdSavZV1AsS0fjlHzZh+aYboDnwVYxj/29w07nP7m4BtP6R1iWF11OlAj1lx1f96/BBGZtJC8B2ctZ11KSH7/aDjBcKlK2qyprW/8PXV4sIV7gqBqArQSBUfhG6IgBASezf9SpXRKIpqvGAYbUaD1+rh02xihu+3JmqqxuA1ClUKzUBhdnv6Wio4f4EKr/QCID8JW+a+2ti9hq+RTFz2zJzoYcFBa7Q3IPRz5ukAyKyNGrCslD2WlTJKfzekxSealDxgikovTbYwnqpjhWwkbMLb5dfkR9mHevWgBln3M8ebqixSnVA+J0oxDaTK9cLkOKUUE97tGEQ3UHsVbAuUKoce6u//UeL5EcIZm60xRm1XYvzxOhu6iDjzDLpSWGwHkMopL/9pS+2BsIzNTEwpa42pqm5ns+UR3Y4O7VrJNZTXWTsM5+Vi218YkztFbGkOjcpEzUBaShmsYVPfsBnRC/nV4lgQp/INXjrEhONxgBcrGeJO03ZBbLf75UV3GmfHCnKWAnNCks6xwvJLOeeFzhTQjPZz8AiM/qHBsD6aBd6Zg+1a0zmwyiu2yfK5xz8PVKTRjNttac69slJbKqUG64CS9NSANUIEaiN6GmaRSEJGm09h0yBZ5mihmbUPeXYyENAKxnUaEIo6Lxa2jnu13iP+GmmjfmMsROGB+O6uizt8gOWOPghLqzrcgaKWZHA2mZEyTr0MClYXVkfGnuKlzJBnlkrZipWsSuWF8v4Q3vJBfm2hF8kKO+iHvGTr3P1+F1w+uN6XR30Ea2Kx1vVJJP1E5rVGau7MlAlfzUE9fvW1aBar0Cc+hj1sj9QSi76kvjpDigqZccDXXL2id7t+udx3oY+wxTS+gb35v/V88aNCuHWlMrMQjmp6h/8W4Y43vQylFpuE1sn2VGrLwbdhz/caE30jjD0RCc7nHBvwaPAXAT6GK+eUfZH0qdYdaa6WH/AgYVCi1EjQl3rffxB7o7eElBPWtkfywKiniLji4ukBzEDQdQgrny1Ol2C3y7VfVI/UOZGv+qJtRC1J9nGF3H2KeSyTlJiPEK1fx2vV8XdoGH7dkc/fu9Z3zz99Mur/HyZa8SgZx6MmGkPqAHNapcZ7Noa1LP5KpDjvymtKDPeVrRcC6i5pt4Fi+Yt2ZsRwK10/tywLV+5EPfAXAtgCBKK2E648XzXZu7LmhovbVHz8FDLG7q2pWw1PlAFk1jsWpRi6yE4tOzTgNnAmLTBGOKGx58IID0FpLtGocijf5f0VuDctbQ/ciQsr1OIer2nXTTXNEMM/8H/zZhpziK4UISGiP57Ez0g7/Cw4kLggLCKEFEZZx53hOaFIIWzLxkkcfYFW6YDoUoNYJwYkig1RIc9hjrrrlGktRfGEBoULb3LJ3gviLQYqENenIdWpy1EkpSWw+Mo15f7/WS0DnGYaMoWL/J6j58D/mgdMMMUoA60hMuRsziUJC0VYD237ZlvOKu2K8eHDHM3LGIJKr3ZC4NrHFla1g0jgi3rdRollMgjRm9wI4h82QqqmzKdZDWKeZttL2uT1oxbN/1vwH7UVet5mIpfu7734nXdH4Y4G/ZxzXgdGpuWeu1ju6fpe6ebDd6hNMyZkc9kpvFy7xUVj6R+iT5cCJhAeGETr/VqyoSxMLsbmKlCKFLqdjY/IBKGuh7o3O6V7E+RSZecEA8xfgDvkljBdqk2lqfaWDVm1eDGL1GtiMZq9meC+01zi39UWTV1wZYLtkFiGgwIHKrI1p4fIWQQdZjEnEY/Dn6ZkRx1iC62no0YN+z78jk1JTuvx98LlZIn1pdWtm5q/B6yI2M8Ty0TyVVf3plBVAbijEqtuma+WOnGFhdcsg6Be/hwWT7s2Q+XaIk1/VKoJwxuyxdxAVJ3fw2k88cCbhg+Ws09wjW5HLziSPVcGwrggraSt86f1NbzbQLn5RGhyiLg6erm9tJWfLWdHyzDIZrlKuZyKHRGyjnqWfUWnc1LQ66kZi5FbBsO3r9HLvJPrUjdtIXLOKxxYKk9axQggmQxMt5Rtw6ggkfbBzmMJNMgb8FzBg4VdKtvLndba+kxlHR71oufju28XTG+kW8pESSiOsSDXcWTqfGc6lNCSupNMlxf5CLlQY27VB9lnuDrsJgWkQk0U+VW2oQvd+Q5Ds/F391O/jsJfDYJv8ZSuNwz48A9XEZHOWZCISflO1GEqGPUikBtJSgoH2rwJfzPew/d63HRAU0BqDsp0PRK4k5rUXdWeccdcNWXnyLTbY66DNZnT+z5KeKk8BSqbVLpKXQy1cZq4zhtiqk00Ep9btpJD33OK3bxV6cgUPAPC3Iv46RdVPCn/HKp5uOXYifyIXCS5ttrk/CyW28OT2j0TqFI5IlbPvmWv/mCRzn/5LkxQCBLgbN22pOX6gjbwd2TZzrG05Bm0074e4R+G83pKIa5h9HhhJP472Q7oqGM6ITWncz5kD9E6wG+TUf0ZDuiJ00Y0ZNGR5SrPoX/dsiIhscYUR51uJ3cdER3YLTHajtlkxGFt0oZUf5qBwKnVkf0VDeiyIeBRD4ETnYjiiQ3ooAjMB1NH/x69a84eWRcT6EcZXyBZ8yT37HnkupfsQPN5gJe+b3Vv2IX6nnAY6DvFPyzJRDyk0nFr8J3BE8Kwtydw5BX4FIYebrijzWR4VMO5xL8LPiZka9Lduuqovbi05j4nKb2YuTlg8qz0WkfhIoKzqUWWZtri7krbrxyzMAXxIzdGWLVzD08srz0JdOEglNI89zebCB7CxwXkqxVPqPvBiGTX/HzjGqTfrPUF3yAN0TtoawF64N9/6X+0WvfGLOnI2q5u1q4xby+hhXKyfeGQ0pLvQryRpKPIHkwKHeUg8Hhwi2DpEFl29O/GTXkGlS4YD/7WaiAGYlrxYuxzDjbN+/MWgQmBAY6sFiFLErgDFadYjRdUgHWh1EB5Kod2Jl4KzLrnIiolt2mr2r6I1IZjdpxUgORCbuEJeWIQpxCGENWoX7iq+SJBVwkl7klG+JC5Q1D5yZfvRh7+C4Tl/aZ2Ku8G80jXxhMyQ5u0ZiaFpsq3N/qpeD0NRFvP1WHrbKl8EtTvs6QbxFUvT+sgdO8DZfVA2dmJA9L9PdWAE3ZdgDOIqzF2/Cw89sVIeEvbUJZum4JlMzY3YhPvtuN6IvuRvRFdyPy4nYjvmwjYnWVYhsmOwVx8Bpr83BVFo8ENxZc1W7ax1oM1bEb8azeoyetMrsRX3YjvFkYqUOZeVO2nAuLOJM4EG6ow5fdiF6pUSDKbsSXlgoMsRvRb+xuJMZuBImVw3ds+/efHgCoDGmlK4eL0IHcBZnEmNHytSLbULkoVS3TDZIrU8FFIUpJR8dKPz30amB1WL5c0TN7boyL20HJBvK24TD9E4+n/Kh5Lqrp2bmf/b0eR/bnjFXyUGNwV01hJZHGRTSqCPCIkNa/plQVibRUVImpvYJ7It6K805ufUV7lQz8B2Y1UFUL5x0mtAI44ng9euUhVwGcSH0KXqgAjeP4Eb/9deNWi479xdsnfPFyvfxnryHqjtN3e6gn7+2k5UTW9u77+y8cOW/H756/d9+vrb8xvn9hjw2cu9fuMcJn9HC89IzeQNwxhKU7hnLKn7d3kP4nH/vKMaO41uGoYq0OKsrI3qEUEiaPfLWJ/btiTSeoGJHFScwgfa8XBHJWtdnxWqDjnvtj6lAIxpUjtbo9LqtvOC7TI7WJefRMOY/UNQOOOY05Egp0s559BnvWDQds/5mvtAIvMX99BWVbu1txQij3rnx8ha3zwc+b2ZV98Xop0CnRJcCjA6boFc+bZHFZrJjwA1qm1tIyJEqyTReSqMJBhFQ42EetIaSCzCncIxtvlEMVQxH1oC76y1SryvAC3/ZJCOfxpHlBVZoXjUjzIkhaRqR5IdYUjMrhwmmiU31Empe4tlBspXmxlebVob8yKs0bXbKoXnVT9HyXDnleuAYpSkLxBGlenaV5EXAlkv224M/zlDVQez64pFctKm/0PVHS9gpvHIDfAsBBDsRE2QEuGQFcWoFD3QKubgGX4ArCMQGXDKVsB7gGBQBXSvUJ4EocuAAmgqCrCZ2lJllo+bgiwwleakx3F02c5GwAIjQYmQjD/GXz3ysYYUpBAFn4PZB2fucAAGZvZwIHhRc4HoX4hceQQrw7wLHF5nxjHlRZQc+Jmy1bWGUK4Uxs8FgyfWDFoklMX2gYHfUton6eJjF9oRZDkTJ9eo93EtMXbGT6xFivKfvyIgTTh1o4EExk+pT9zIMJTF8wzvSFeZXBsv5ExrmsYITLCtL1INRrKhOHqyZdCjBsodmw+AT9g8qwBaTPWmXYQh02ZdRqj37YvHLYaiVIa7pM1gyvHihoQwybq9qC1NNidNhK50E1N2yB49VH6xC/HVI2eHUPo4VaOBBW6nDD5klLFFw6bNLSklfXb+yweXnghk37cELMcTg43py+/TGc09cHXjBuWNfaQs4+e3DCvtgJFdzGO3Ib72h84+3SJRUk7GFVAXa9o8o6f4nsOkO439lf6Su4xMgYmFVmV90cwD/kilzZ2I/f3WKmUyLOwM+elf39q69aMYtLpOXUxAwCduTg+CmSBiEu0h15hPYJxGsTduQ+t/ov1OGZrD+SHTSdm1fdkY/Y9f2U54fH0ClzxxpgRYw+Ux6Nq5rF1fOKugsmx1Q1E6eEieGLj62OJj6Q6lA1A1tszySGFKu3vA2M8bMYj413OeNrTr3YqKbWra8bdSgH2bok+s71TtWpXEs+g0oUtPCwd9QjPPIBnxsAnxJQBRu8arAFXjXy66Od6niMQuCNL4sRVIb0Kt2ko1D5Vqkkygi0DFT5MMrppNn/2uA853/r+9aaVd9iLP4LxFU1nZa1r58WNSOvf++n0DnsqTg2/bLPhshl1PUoKMBPyGdrwAnZBgdO/iVYS8GKRCuDxq/Tog7Efzp5cN2zwtxGYNc4pFvoPKjUJchfl7pCKVoOhuqmrhD5ItSlzGCIeTi5LgqwSoJDjCnQKg2HGOi3ETjEQDhEzGflCUfaEuInlrbUUbViQ6xt0cv/4YpEp2gH1bEmT2oNL9mFgIU4gFrH2ayDntgtsgd3oRH/qTV1lfWRL8DP7sVgCuQlr8joPqcDrB8jsypfhPIqfplge5sfkBEKxndSeSlKQZ5OoFR8ZvU/U1PnJDzs7/tHxioUB1VDlMRz2Dblr62aBoXOOHq610xLTLPs88gCJhNF8KMiblSBDB6hcbciTUvSV2DD64wgGQPs2lo1PLS/4q/P38/JyCpkoe91Ut3EqyXnZ1BNt9ayUiHiKsAfd/2xFzYCg0I/BnakL5CRIE+Mx+MhFSOsQqBCXc1rl6UFHI9wwFGoB/UmQq7BvnuSTSAz2sv0uwHpzAKa/Ir/LK0JBUhIvR9Z9zuBRPUN4QrTr6ZxzGqLasevXNkH3oiUO/vJg2U1LZ56Pknjl/XUvxANKRmGVVaZcojIX6q/fDET3c/E+L6yJgpO8RhSZ/UCxGQApFGahnXLBNYtcx8nGMY26k5Fo2UKVXFs0vEm+9Dm5TMkPC/Qz55JAR6XGvGcddICjVR1Z69q3aoeaXxjSstzA65L5RI7lwBtMFVsUFcuuDDj47GcC1n2kCdEHlPk3wFukqHwoel4jr9L5pVTGM6biJCq0MirKUAXXzJ2rpE6PWW116k+AKUNRaxcAUyiJIECn3yrBVAX7R3042U5ugrqAzrJHol+CFw01IUD4u59P97QgwBKEhYslPRZ4KkOljALCl/vHkuB+HmJXNBOwDOcwQCVlfo+fJf9E9aLoq3+NNtSqTuB8HVWKxWzJauRTFOxNqOd/QMqhwmN0SrFnOxq9nU1YyoDrcRuTqg97tRFuDftrocPKWVbsu54CPq0Dqx5B0agU8sa6rAIrXpmXlML34c8CtzI+DIyGO0XFXUYqz0vuIkzcMX8c8hbye5XeRxxwkFPSzjgaZpedci+pDlO55LzFgUc4iJcDWiCraRO/ur+grXSs6FeBC6aQyiSB7gdfgsHdxvdpz1w+a30BO2FnftdkHxKaDeUegMF7Tn+TZKudp1v9MT8axdNS2wPvoz2jbWn8NfX8ua4ITa08cqeOHDkDNOqc1SVaTQVdam5dtjBXW/+T+Ut62kEV2Iyg+Wciok1Ta3h+/egP5Fp2VcUcjI8xoftM3U6zF2sGrk67WKdITNCgmG+TpfjLnBQG6gYKR4H4KJSp43eo3NnhzUeA10wV/SOgI8B14EQvKhLu5xV3RbaPzHNl+ZKI4qaOT4F9sf2/lUgGtoyevrdV01fk0rcP5q4tk5YEBv1HGsG10W/WaOZppf7uHQeE69cnGvZnyE+3TYpFsu52jjcjZ3fuFwdmx8o/mZfOLjBc+1bwJdM8OJPHgZCHefZiy26ZuwpsEjpincBBe7kWJPPqCTvriZLmcsr1rOrggKRsuNE4xQKvmscl1Pp24fBto6d8DqHOhAJ5qFx79ACdigXaIjsmTXlaNH9q3kzHuiHYJvwHlozgkgt6rkI0Nx36q80FKXCvq/+cPW0SDcRnBjgjmukLhvt8+KecSnoj7oU9NqecyloS0mVIrR0lVJq4Cfi353EBR+xHEQ34dgFMejUx2DLT20fasBS6x9n1JDzp8IRR4SRBZ+y+tx2BNT1RKzMWB0k/HtMQh0OShKOKBrPRJSsbIm6r4EXNOvnKW+qTzTj4alJsXXLnIIdQ4zes9ZPZSMfA88aaISPI1YKcSkhXdmv+2qOSvcXxlh5rB6lYlv8hrL5oTm14JQLtlxVDMv6nvVrmAj80AW8A4L1SsXaCYwqqua0Z2snA2mM1ml1TFE1slxc6YyxHYR79KizqXWGxhuHJxXHiERfjK50qgsm4551DyooiAbEwLgmSqN66RQ0Lp2CeqTfVrzF1nUYTX/kWCF2HlaUL7btx63ylBuP8mWnDVBkB7C7xtm18e2pHu8sQXFOPW+LAjEoMj4zdceRHdOfoy/sNR6hGJ5W/k+xCQRLbZEFzo2Quhz2daoG+qHPd07Or4V4Jd9dYGmAQgbOEy54Qp1dMTXEebPpbpB9DX3RgchkSyJ+oX21C86Ag35t9k9O0NTilNYqQ7aQBsTaD/6qC2/STfX5HIqdcfbGUvrt8TEqDaTiuuWU3h3h5Vz7G5MW0JFK++/81Ds+xU6G0K2GSWlhu9tA89Gg/juQg1p9fpzGaNAxdBXNVE6FqxupR4gKwAF+T9ucALte8ELRK2lYtzENnGmV/j/FnAkJNNtSZhEjjM6IAejAeAZtUaIQbwiU8ZboA349vm6wqE34WnfXgJ+CaSIYdUbhoF0VY8RnfvbPindWeKU3CAA9SPf+BYlVuicOWJ3182tyX/c+IgW/uQjLhB/GwsCOh572Tfuvdp0N/9M3az9Y8kgPXKOaMjifVVa64udffAl++ETK4Nbm4hE6qnzu+DBOj6QeVDBaoLXd9s3a/69dG/2cwvI7BsY7BQKR5dJCjvpxE3WjRvkiGlWbQbAnl77G9/yrLXz8mydDZ3JDavb9wW/KKb6W2FFAqY+rkaYGm4Np88JQyjGgMToWWN/1uACfogzT/8CAxHTcACowUAEc3l9PrFFRFqzyX6n+fk/NSbnFcOZznDm9A0f4/VK5hAGhbnbUXYr0ybevFJrTjd0I800j/OwenGffu/jZw+977NVJ8IhiN0+LQPpFeYTHXmvH+KJRo357J228UaWVj1uPUmCc4oo2VqOv1lVSEC25UpXCcygrp7TV5xmKRv+0aZU+agvLbqJjav6f8inpVt7BY1eeVQvwNxbgipTc8qXCQsqScg2sMuocPg89h1l7Du017jeFvKk3DKVeer0opVBr0JrbzNj1DHoQiZszrBC87OKeErXUtyc1dVWariiJUJOJfz7jYnChscXFSZnfLQVME3+dgNRPw1xiC2CjSNeOGchVUIFYluwADSENoc6w6IgEmDpi58vqdChsBGoGNrHcDNWv80yBHFtsyhgURFNcnIX4lEUswGsXtbDktIxFIsUDHeaV0sVQoHcehNrPIdwSsllmaxVWZNsC54so5mS/S223gfqg3vfn8ynN4qiEiwipBSYFRWIZFy1oqsvvPFT8U7QmVeR0Q2FrNGPxDDTOjZVZIHhO2h3D9Y+xi3FWtd2j2jtVB+MPbuJg/Pjm7a8/no36Mz1v9NOafmrOizzkrtnc/2oe1a993bE7/KZgRPnWH3Fv7ZnWaKdCYa2iZ8lSabqvceElJi7i19U+DzpOsltX8hsHRTBaOdgJ9GAHK6jX/zSzQh7L/yFdAI/EicjAPNKnkEKh8krMJEXKJb8KHRJBeh6caJ2h1on2KkupP3DdXnj9l7yQC1DZmnwXIbfyUOijCtGxnTNfyd2byMiC9R4mNn36cHLi7Dq0dEm9fEZypIQ01KXIJCPkHKm/GnGP0JH6G/HtiCP17qpzpI6XDY7U905ypF7wZ1cyRq88Am/qp1a28zJhrC/M/86j2n/qj/T5rqJ0Or3R9xon5la/wH7dudUPK271nVN9b6NTfYhoHtT9ldighhzjNlQBLVYcUcaWNJCrLOLK9ptyhZsOdeMZUWi4aZx+qgiEy0c5VcVsZZw9YEWijxAPSct+77XOf34w5j//40itpa+P2Xml90pn3KCyy9ep3n/lypQPh+Tl1VvZWmn9aEbLFyZLhSg6c0fEIFQzSO8OsG0Zeg6iZVTjbKYa7z+fRq87Fy9yocuwtzKfWM6Ap706LHsEZDIOilT6ps6ypVXnVEux7YVo3SxUMcpqbGh5o/xKveRrhFL3lGJXCdqPElwtkBAyhUlVNC7aJVTnH9tWbSJHBhcbw/wB/GI3gQcOoOgdNdXtQJFC0pSMiaf4E/QCzZHusvA1SOH0QD2LxeL7FJ+2xPRfwvv3kTK09a0VzgKRfwSywyJ+2GmJqK0WI2RHJzt6I1FqlSCsAy5NRmO0W0UgY01MFX4eIJNIfxgSAlYrVWOcRoNjc8teodPIAahgpCz0jBtaqzaUtKGJoQExlHJsQ9EjSMBblFKSfUN9f8vVFiTsLiUU6VFINjfx79zZzL2zdVose079UG+lbnDsHG5w7Bw5p9H8qRYcYIx8+VrdOQt18A1ZQIQlCzrJnSfnb0725HwYNM/6Cg4gEwqFPiIkPv2dr+DYzIOIMLHUOnfdueaNYUQ/UVU3fvFMOxsgUHhrGqxu6gSpK0BUqqgfC1EjEDzxBxxaf8CQdO4HgqJOVZowHQaqOn/A6Uil9QmVJqbSlYoTYlS6v5BOAWE2+PwNVtK3gyHS+8SB2epg1MLSeYBvYY6kPLSj72kqMoM84014JkPV/f2qKIJiwMb7lYU9AupUF3a5Mq8ENTImHaRIW5OPtAByifqJrWDwBR26FcyrrGBeZQ0LNq5hQMH7jYwwVOHQa2SJh2oTljDn9F0YPrQyQr2u8pgL1r4H2vfYCFB1jROptIp/NJTgDFa/hd6cwiHCAtBCJcgnjxAPScte+zq3sNXHFraDj4Kfef0YP9Oq8jOtMX5md8nPhNkb8PHx+JcfnHR4UmF59cIB1nrY6isPOm5A2RRYMb3W7/i4Eb7okXf/dWPdD1/iuo+XDd1/8iR2jg/49z8CTq4QMCi+8oKYHXiVREsjVCNCsyjvXs0iw6RZjg3f5IThq4jn4Pswd1naUBXIjja0axv63thNZirZLviD4bkph0qXyg2w/mVYMMVVfEOve9j/Sq/vzak4jsVqEJZEj1d3nTUe91Enjnqr15lV01t8qtzVlVDIoTlYGVuhSJf4NzE8uIcRkq0Ddku1FAH0ZAAUS32vawhxrUhRKluResnPDumOJCzjuctl4k8gsRWMpjErWmZ4MzIok9nsL+rpkmUrdI/8k64IvN7oPoj7GFHDYOAhGX5K2+OnpC55GGOVbUQN1wK1SKTSZdO1ZQGg2KSkGk2IzuQ4x0U3oRbgXkdhGJQwDAwMAwtDDSFOec1apQmp6XXRVA3RcpRr5SjXuH0Y40mDq+M+PsZttYaYxyAGBn4/jQTh14BPGvcziIPpxP25KLrqzadImDKFcMy5bkIuPRUAUBh9baTwELkHgw4BAx5PnI9hmPRbsJC6VZNvc6VO0gQnNXg+r9V9D0MlTJY9CtJQxOOmDIwY0OuksiafWZM8GkIeFBwgl5r0Utt3vj4vBlMfpL8T+nVWn7LWC6vyW9UGssp4YpRPuY4YqjZGi7sOtQU9WoUpuIsQho9AOUZr6EFP05yj/kVFXPuxmhuVkBpaelML9rXeSIuOtVSPS4UblM3KkZND4F4ujGK5evuU4qnloRK03nXOtL/S9L537EpqppJaRSLkaSVA5RPuzOYgAb64Wsa6ggaipmM05MRbceze1o4F0lSNKhp0aaT3+77vUAkeJKMRhffQEYlAJu0eCWHSno0QVCIiQRysy2dIWLFtF8KsPif67xeKJy/87HTt1NbldUwuJ6ejOp6YAFpZrDX5WpPHJeKBCgOtULc2qHCzejytZxQeZT2B1hNqPZ7WU9N6MF20FkyWY9VR0zo2DGxdYR45L5jpZwMHcT18iasQB43VNce4fMSwI4Tq91GMdopnCDPBL5BwKJN6D8LcDaFvf1Bbwa1t+T3bNVRArde0QttQzCU8scfR6upaV6B1+QBNbEcZVeooR6hy85p8rWl0eMuaQq0p0pp8rcnTmnR4tSYd3mPX5GlNowNc1hQYEGpNntZU05owwFoPBvjYtdS0lg1DnOgQxxWZ/ScrG6Hd43o9qnYaahjjmOuUkkWuTlyF2uCy5/2JHnRLaA5rqYQSoKOE0O6dCKmt2YAziUIWVUedGuUaX8f2x6rsJ2L20fYH9E2220nLFxVxrSOWCgBIQj2yti8jJGt7V0JXyjoe8jOHDbTHrUgL0Jpy0UilSrEAmlKiNtMUenVE1qnB0G0ocKzCj7N5+Ku+F50oVGtoRqTAjRW4dQPU0ChRlECtlUCtlUCtlUCtHROoYQnUSCVFnC4NqSB8rEXWHQzLqpbLqrpa1Zy2vLY5ACXKAQ6cEg5O+ZNwM8D9XOBHhuIo6MINoKvw6lHfV6WvV+Liv+gHCQNIcXYz2mAdM1yjtXh5rAIpBTokGtIhzEV8rOsW4aGwRUhhWzrDFH0KXcfRErnXpOepDtKxTL0GpqmFLLhP8wxgWFPblypnF5NvXRVpj3SH4qNFJbdLKsfUArJb8HlRF+UvPdC23EF9hKqEpwZ0rg3tUk65LtwkBlnBmL1F2+JLpWjC9+R1sfIFK1wqc4I0LHTiPT99bzQJvyko24twYGhwV8Lhi0GD5xStMn5gc6XoppurnRLC1NTOKlrpZoEcM6cqO0IU4gKOGSE0xmFlQKau0Wowpuitwez+1ahKJ3E8sY6nS59RshrFrOl0nFx6XaamljxnOqEQRrWbFi+SXYiSqiWfGHgKb7OSxwuum9HIEGn2SnW334S+cxdxEso47rHu6GPcPTTeKC8Dk5FdSahb5VLyHM2pUBaqp9eOIm1lH1IibagrXMjYqiscJiF4Iyw+XaF9oVnZ5iSUcShTxlfoRYlbdX4LhZygK6pEUO2KFKr+rvEB90Kq8gUsXQm9xNTio5/+eD3HqODpegoiXm6hy/iYlgzw+1pyUed3WVDN1RUAxSIdcijSaahmSZEiHUIW6ULaDLxF8rCapzj3mPYWjQfSmW6m5SKCh0M7yLK1fxb7gKLQjHSUM/1qGAS8vDlrsDVnDdYDqzMukpqKo0gFUuWsScpZE9pZEymnAGfUeOj2R0K6/Qn6O5Un2F32TBcXPYWMKsLoGM9WuIngKTiG4Mk/nuDJG8lQRGWxkreoV9hMPaLFMYlqRSk9017WpXuJhEIDhUh7HpU9j5CE/cWkvksp5axvVJlMs1+ilSqf2b9MDwMjZTV9rSIRyFJgqwYGnyGhOdA2CWWgbSWriQ0Z2oE2bWA1OVYvGjvqpQpV/UTWeRmKZ6jWIvjOvEF1rNDCSYHcKDcFNEpF899dZvil0EvGCR/4CeU3fOWgYLwWr4Hc6+R7a9D/tV5Z/O8VQQoaAtm1ugpX1l4ZIx0JyRLbLGSy6GSz3H8MpgU8aliZaT0cfbryYy0/LsuPK+UHmmUCl4bFfrxsPTsZJfINJfJNHXgtsqw9rUyH+kVMPuui1wKQqJEimAJSkJxAf12TE0vXlKFGyDLUsaU/hJ+5EipxWqki0CqCsoqgrKKhBTaV6IWoqA6TCHl9YsHK5KSOWKVVMvUXnkMYKimU4on/QthQ0HuBDlFAQ6SJwHgsaw5zBMXqep3ezpJuOUvmdB5lErELJyQS2qkTXCYi9pahYE3Q316yBaHpSdGE1y4oTXMgwVxKytFL5PK3HpIGznBCkr7Nn8QK6NCiuTpkZlZY0NdK0CcIWYQsWZmwZGVCx8qMYSNAP85zxIqOdVW3p6BwnYggFESDwJNrg46DC7HiQr2CC0nuTcQDdSA3GQ3ksnJ5kAQZr9V0oZpe+PedYo7njvFVOAQw4eJ1ULl4rQZV9LqvPZvP/QDpKjXW+63oDNbrbKAKe/oxcmjpvrxyhTgTlnsH1YvXeMH1sdGL1xfiOvAX7cVrvvhlb3EFyBCK8QRpUzZEpblfOf4fu3Z9+HUP+9r1/3kXn28LfRghH1dwdKPc91/K46lXYa6SHvOrmEHN/hBXRLM/wi8UUHhC68nun0gMcu4eiYHU8oKRGE/H7jmbHL1eJP739AN1cKlSv2pMXV6gS6R3HrJ3Od+sYZEYvQRUVVdliEiRMsRDvwPnAbpaNds4cHczi1Rc11J6G54eNTSfSZU4TG9OwIMrMBsMPELr1RGjat2kKC40RIWgrudy/U/WVgQ+d/GzNNjprl42cPVynZtib1vKEbO9TEmp6ttrO220mqq1lXkvsbaB64JqpSutuLwwqDFV6zN6R/LopDuSY7GYeXqeO6Un5NnP60ncpzzPn3RnUnstChzIrbV7CoPRWB3NC1Q3qKbCWd9dfNTk3ZXks8eTd1aSd1WTpcrupHa0XOQDGlm99oLCXJ9/9bR0RkxvgfMPXx7wX+ua4OW240UgrOEBvgC/96pysVX1lr5x0GFxuUiMJySkNhHVQiL3o187s3b3u687WBMltL44BTsq7xPnT3hE02DXRz5TowJ5S1G0rfev+8mLYX0d931rAVZ0+YrnmBrO5IgWGLGuMUoQs01/tBhZi4xaL86nSRo8A9su8i287Ihe+3o+r3XkMRwr9K2PvTbScZ4x/WLcn4vEzuIR2FlEwgUkEUOah49X/jAidFh8RtbE1+uCOracY9qknm5nKROLO7PgrMMDXt6lGXRoCz+4w0s0B+lhjwtYDozSHe5FR3h0i9p3TzTJvTXfRlthaT8nEbuBwnSwjCdCieFPd5kf4I1yilRNLI+Q+v15gcdF+Y4JxRIXSVw05VsFGEviIYkKVZZYoHyVZq4EWKZXjNcjmKgnfQOLq3EnSTcWVPFyO+2EJyVuK52EwFY0mDSSaJtGbkuNZiZXugX9qJj5D+BPgB0kFTtpO+cl4jBMf3MCYr6EmPsRQ5qVXwpNsFkzzaofS9YaBfD7xxH8pB5PpgcR7DHUrvmRIub3B/A+Rwh+lYMijqmpk174OVblT3HDGVGXYrEvvpN71brurt954e7/du+F9skAsZDe8132iTaeVEb/hn1K0xG9F/f577RPFMFNlZTLlp77vqMftk+X8iNXBme9fsvaB+1TUwrSf/zGBX+Zc+p/+OLqT/3Bfz7/Tz/3FPuUhn7h1tNf//nP/eeP2CfAhfhXfOM9P/hXW3/7qfZp4z/13I9uGXin3WmfNv7nH8imp6evvdA+bfzFP4B/v3mnfWq8thT906XrTvtE2pjnL+kxbezOJ/cc/Mjf/PPtH7ZP+fRj73nfh9/69/lT7dM2493fd+uBZ7/yzR+xTxt/aP73uBv//FT7tPH/33/46MLqR//jnfZp458p3fi5C+3TdWc77NF7ZmJ55bx96HsneR946NNese2h7ytOnpDI/hKAylyab6Lsk7N/L+Hbh74PlULyBFzkKUwojOgUIvmUtj70+x5tzG20M2KjvNzPhIouY2Vetk6NO8jRoazvc0Z+xFioHTGNVRIHfngXHllxqljpwTzOT8NET6Cde7quF2eIpxj58EylvSi9RwEebf5qCl9yL87MT6OY8+zC2nKW6oAbLaEzQFcfhy3JFNvUynfTmTRFj1vFbpxpbAevPCmLWY5byTN+jfsHAg62ePo+ngt+Ap2WP5FOhxt7s1K04Qx8kX8K9eQG4tBDHJjJMkaPStREs3EvK74dOnlBWb6DWkzPn8DE/Img4v1X5jkV4sEjoi35Ai3l07QstUHmpi7tdtJ0GT6JFsowUVSGmbDQNEKMTjV5bgVubaNIXk6mBXmegsizrU84PY9lzxKIfRJ1iRA4p0ymWXYMUOb5kvGZgQBIMReKdSrjQnl+MdVGAlCqy4Fx9MQXUn5XPjvkcQsxAbSuGa4d5XAFiEYJEu2a8CQ6BxXo1yQf0zY6G3HbJG7ALaqWyKmSqUsnTywR3j60U/h6N/dJukGII4m7g6sbKZEImfjDrivRuZuRQ8MFPBZoGo9pO29yCBhynRNUCC9R0A557qAt8txCS/JcomV5LlvnD1NmftGszC88Mmrh0aIn4PEEeiLtXmFcXezzY5Eej+8eT4/7bhWtGyHtWf1X8JUOr+an5czw/73OjO/MjO/MjCDFRAhelJ+Lx8VYJoDlXMJpHEpw8yZvIYyp0EFZZ3JN566iOJ4REno8o+8enhCP4wmx+5FPCNo4IR6X5zwZCp4IO3hCbKHHc993m0kxQ3keT5gYs2DDN5kYUWVizCrzzdgSmUkxXZkUdkBnDRoQKT6beJ1iFrmB2YLQ73jmc+77sfd/4UL7LLaDi9zK3yubIjIG+yzO5kTBLi0ZeCjoqrHd8flBJOhIKLWcYmTnCmLL5oGR0bmCaIeH2putDqmpIK35JClRp8koUsM1Eo0jtSLuMXF7Fo9ZuPHChFLczgV380eI44/Dnu1x1KIMWPlEvD2RcTwDXj4eb4+n3XjbzahOQPU9+HwPnSuLAFAd8tgngC8CcudZBbOXBLOfsMq1Mva1GJ/nGJ8XGZ+3BHsNWtIWRtokJzxBUznjDprjPi5h/8jdWswLoCc6z8CZYcjkDJYiXwCrWUHLuEqvKTYoGCkKOixz1LcygFSSUh06S3qrY8bRSMW28UTHDKM0bUZpFtDH0MlzZnzUANYddlTmAPk5WqJMRg5vzA/jbZHHNcOwtvABkyP94HQ6g856UcE/2HK/ckX9H59OZ9HUaj6FfSNDPqZdYLPZwxU+otNKJvoZuZFdFPBHqJ6TEQo51EJIzLM8gZ/RS+BGmceXsaSJ1b6HMEQPOMBsrZoCi8V8rupoGQ6+ehjt02gH95aT4DVuhpMLmpUdrIoNUCITMuxo7bBSTXiEIueIvTy2iMAHNXknHelczo8QgzGX51ZdpWpmLc7lKQvp2bojv5ICDLtulJQc4SN1/RVQ1y7RWH5BTzQJZ7CgKbKF322LsDt8zu02912DRZjtmy7PoBLieSzA2qgfk4zXjAqRcIIt4AhrjoEQTHNRtKBISGLRXO+PWkSbBZ7MUs8qWKUYhkUMQ1skax0eiozztfKcl4SC59sOXh62qKhB/B3TEtfPq94EY3613kNz3MEdyLIsECaR7FAsa5Gu78tosS4NIv2hWCxHzPOnlvCyXIbaxJVyibakbfKtjOXJNH8L5z7F5Ab07f4xohkQ4C6hKkxku5WHgzblV/CZgrr6WW5Woc1GxuUskPNsEIgycpamZTLjwXMZj5wKPEbo7zWYqNbMlZomrul8XerLzJ7Dg2kxE4k85ocP/+2xXGg0B1DDJGmz4DS6xn+5JwLTwB5H3N/dPyIpLXCuZST35LMMSU7KYjWTmteNiV/1/alGSfS+bUOlqk0IKfV2sQgA1YZADZkpAU2AUVC1fQCJZ025bYtQUneLGhC2rzKVgPg0xcwPyYdwcgoPMFP+unidnKZUpv8M2siAAXAu6cFgvdJktls3i7JpGt7Sizl1lbk7n8djZ95QxSTIwTJY8QghJaWGHFLzKEA8aFBugRYme1bXaao6hZMcwKtv0Xkyi8rCpBzkyyRZpAVGDH7UxPs7v0oELwE16R5GHE1NVohbuYh68Vpzr2g4lD9mrT++Ljo3QRKzYGgFnpea517z3K3nwl3KxOCWWrEF5AJ4hQckxv2+M34ifsxbPMi5LMg9uRDSzufRIGlzA9BeXim2gv5wH+fzmo6GqnXUQSyEXBH334hjDbRFyyO3CpjOrTEgwyXWpMRF4i8l91ZakBFGohTYA5iXdHLC/5/SA8k7j5k0rwbTGoCjMvBdRoiV9WLbLfl2dMQ2skFTP8LdkFKrXnSp77nemFYQBWIfnJHqxbCIk5OMsxxMcACaouiFmmRz04W6+C0gfN5GU9S4qkc0pJq1qaMNVUeJEN7yEozGruRdUpWrdv+AHELMCBlhSgOyUvC8udiiU9ceUv8uD9oxrO+Pm9mPqmb2Yxesq5n9Y5vQ39zMvnNRRZ5cBI7V+1TpjynZOzShLvt5HhTRuMn9z6Iv3tUTLl3idOe+0dMd/zPuBEeTxFj/vXqYU8NJQ6C9D9URdNLHF/Z0PbgEtjX0cO/dasmevHKVA3ckubN36VVcDN5dXhE59zpyYobLIujvEDfhbhlWP9tgHkUrT/8uCTKY076mco0nrPbygQ29/KLr5QOul1+VwvSLm35x5IvgkLxPPvU6gDQtTT5LzS1zsRj2JrSiHKPhwAR37R08GMB1hHrTB2PLOudXweAyKJy4KG72PVk/WqpPZI6R0ZqMWv0WpEBSNZgXH2uTaBoq4HHOLIl5pKoS+370xgtX/vpxv0twk4TrfZ41acnTjpqyDqUijw0oqhoeEyO9AjDYA3xx9hU12I1RuR+xCEhyEYs5qDh7J2glqsDEj8t0EvfbWDpbItRuiauENTv4R2xADfb35KC7BSLUsifcDeN7T2m6xwmppRspRYgsnYWQXJxn0LYVpWhFl+Ukn8JjTs4UM6rn0+CoIQvHggcQg8hpaIYyLp4BbUE5O9H4+ZysGCHhuds8yTxxo/NlVzEZnVY/g3qmKArV2X6N4rbOEP9xWxP4NgAvNM8n+EIMjWd4nJ3BfRbFWIhbuoDOyXBL78HX2jViDmASqpkK1dTcbsmweyo9ZlWmg2qCgJQ8S/VbUEsk32N/FFAmDEiTID5awN/Fvf3ghCnipmqncFCB9lBaLgNzjg56fa9sqEJGbW7E1WXAE1cwIrvkAPe5pfxQjcTsWoNSux4sogMzPP4LUqInDjYpEo8bzlGT4RN1Xycda2qfoCRKHpMXXTusqTKzdkzjmsI0ZYjLqK0LX+husMEkhe+UbUdMLOOoXz3j69tufTvDGvDiqAsUDQNNycRy1wVQskLoVH8n01QNsdXwbpm6pwwRwe2y+PNRQvtLoIqqwXSBWh04Ujb1jY+lOTEIxDjsZeul8TCcmuZeaVXsA2VC7lWsIJBtzq94ofdKj0l16dvSOIQ4Fc6v8GEXTWGEhRUOD22M8SPkeVl0ilMYkRH1f34EYkoZFJ0UAMuajcsjxPn6naxUYDJ2Mcj4p39E7HjJzvc+0U0i8dovC7uJwv1kP7tDVpwjflBHo195QsY9+PsXWuseP/NPfwP7e9l71OjFmJEPySu6sc7Qx0/zNxT0f+9f3hc6Mx+/jAKKAHVF4vgZANCdekIx67xDD0gBwXQSKwTPZt1uKQzkKwL6SGi5jNsp6rPIRPpYxgOREeAVV+AVUKTAkTuN2Xt1tLVLQfa+itkPNX+1ufmL//5IzF/8ykbzF9yYqvkPvG0wgPFCRn/FW2XkDN4Laon5n/5Nr3yhfhhk70f5Zj5MMgGjRroo3MQEzKi1kV89EWsjaodCscSZodCOGTsUX/ZCX3BvglOuyq0B1Z0FPmCtAD7U1YgSUAnqrsANY86+C/5bXRLEeq2qv4y7KKJc1VD1WGuGO6EIiQ1ryUeLaWjeAAgSVREE6JEbNCmMfyu97sKlAG5hReNJMnmaacT51Q+dsJGQ971SSvVdqQGP6EpxDEshrxDmRQYPnWmZySgRILstxPmawzc58DYn+YOu5p+TCBCaronjtUTdtUpe3+RlWAoB7B9V04F/BC3oEyMj9zsy8ubhxwRBfm2UjPgqh6g7eoKPlJ4kIABCT36CP2awHPyJodKTevbBEZtBhpxHqgNjDP9kH3KTG68frkxu/1sxuT8yNrnvr05uvD38yX2IJ7d8GGR3PpaT+8jDmNw6dtXJfX85uS/lMquTODTXTUMdEx2RnN/xLEI7n9D+7KOSA6W5SZQ+mWeOmygoFfAtvVMzQFYK33zquzmC7qbf43mb+I2YWxlR2dTIZOPM809wAocnPIEnm1Kq9jG0fUyO20cUk74vZHOKUSnwq1WumWLCvoAfeM3ODS7TmOeQ4lOB6/oSVq3qSzWcUIhND66WPFNgrv7g1DPOPikCLjWUGEDrk3i6rsLjS7lBnmjVeRfU40OKwBQwO7qK48lk9UV5w1IK7Nwg8sDfJT3cDMb+r46faHVlXdjxAMrP8KRETQrhb6FB/CfbzWsk4YoXreLxTLGas5q9S+FPiV7Mlmsf4iI1024319fU4U2qLnBSlLu6LsaJRSqgs0N6R37FAy8zptnXZNsobneSolVJhJCjfXhYTKGm3UWHOjR1eQ8VYcPZhrHxLidODYfDooU8u4o2R7eQh1sB5V2pgWFRN7DBoyuNA7fPgeZq38t+SzAipAZmkmY0kh+BFHor4/INTFQKnJmQY2DNd7AG8oBvHdb89uv+rbHmoVedGNYo8apizUV2We/Hq3jK58ur2ElZSycYq5jq2V3oZicdi/8dxKe/GzjKfA8PSd3ePiYW9x0JqT4RGe4KBQh5pLdifLltzVKqddg+5pfb/RXUxgCIJClbRw+gv59dK5rRXvYBxAD3+kfVShWCR0JocGPnWldVfo0UMo5yyEMHAFesF79v9y2kXr1EhMhdw3r7GVzAQrs+E65kf4CMiO8/6K1ImsYf0TYAsiPx6lqoptKwGi5eco/VvAd5GF6MTN2NDGIvmBS520V+tIzcOSmyO+nz1oTIMkYbWedRs0hxQ+SWxkPwv2Ovj+GrGzx+Mpk4gGcMv3QJ4HQQr0xJrsfT2PILMBmBT0XM01FlXtySl6EAsDFI5hSOegkK6QcrfBJ8jn8lKuoH7DFwVXMybsq1rxcQS3IxJyhe1Ysulmosq4Ol3asUiTwoFit5uaduda3ADWlqlBNbBfKkccJUymxydlFj8ZoMtjaQ0nUySb+6hadfeb3CgyUo2ZJ8PyWgh8+kBC7TpHj+tCGVonxQ0uxvQIQ0/0WSHxqs6s+AvMrkKwJpTZD9rX6wy78yB1QbENxwI4DECX95d02s4iRaCMQvidYPyQ6CX0RwtwTvQ/AMCV4PFN0pwQcRSxI8gNhlCX5V8RLBBxCck+ANyJBJ8CCCCYKgJIb9XKW63OrMfheTxLUq1FhdsLSB47GNMkbxM2G8s9j45XAyNjq0m4yVo9gYV7AxstjoKTZixBUbI4eNjIfAHh2vVWRyCOhRNBEBedxEXd9zOBeKmLLEucDgHINMcS5SnAuAc4G5nTSOc2YNCnpFcEyc8xTnQpR/bJzD0lDFOU9a41VxLvj2xrmggnO/9xjj3OO9UvgHJDCeH9XHc5B93Cz4SiF0U3PsLz4x4Ys/OivYxs5eQmPzB9egiqB6IHT76PGOf6s7wtEkkTi+DcFUv1jf8MW73Bfr7ov3lec/id5o1o/v2vDxh9zHd7mPP4agWi7CeUVchlTVQDUMSC8VArMQUq4FIalVPXsglCHULi9zTSG00zBbZwCfO0YtyTdWkRE3/aJihqZX9+M0ZFZdOc69KJ8XZNbLQrP780W87kahXYR2IbRFpExY4kWtDtpLssHLaAtFNPviokc9mnsRP+ZW968Wy6ibY+b3MwdZ9PhtP7bf09TFxZ391IHCAdw4I7ZHS7QISUa+RNP9ELJ5Hw+fIpWOiNhecUJcuOdb8Tg734YH5dv1wIf6AnV19bC0kv295G/QLIhF3hO+dAZhqJG0OUgJza+uUAuOTfI5WuyHF0PtDva+Rc8LpRXTCErBcP2MLkRyLWtaTmQwWDyV0IsITY44XT1RGqUV6uFEeormcEzNNdByL2/1BbfkY65afK2q3AReYYp89LR0O3IxecVgvYiL7kPYsO/WH60dvODec1+ZF/wZ6ckyEtBaKT2fcX1ouD4squlxMIXYIWDo0ftlsWeabxlnNPMdDJGO0QLo80wT7rJDW/AnnhbyjJvQoEVAp0uZmt+YEysyizQHTFta0Z6uFOy9x8/ynYQnqx3qoZFYreqRv4JI2vHQF7x8h54UsQ4nnMsBrOp00Zdm5JE7DlMNDh814OJbw4fq2kkPfd576F53GlZM07RkPpl2VpNU/Ue95OpNGqvrOa/jN4P+2CZGUjlBRRHdYGlXRtyyitmHZS2OUJxRKuvg7nqHxLmROy4rzM3FgHaobgt4r6sYRC9mHxUfLKAZVVB+eS8vRuaAug3KUyQ+D8jB8/UZbY+2YYouqmfSfEZQReCWqkah4FCxDCzyX5RvUXzpCc1hplLX7nze3AbdQMk+7iiZJgkl+ySCqUM23ygbbPj4M+5jTVJlAyWDW0S9yZzfb/jwi+5DTdLze61VmoSTSeOmuC/VSK+ps2qnk3ZvCVBaApbCCicTgVWDn2i7FARtbWj9UA8bt1kOzIMgYCST3Kc5M9N94zzEhwUm3832JSBXzzAciEwsCi3pKfYXS6IkFEknOl7VSZV6yI3QHORUTPOB3dIBUOweKDa3Sm481kZpo5RUTEv9WrIwaX3QH5QJ0ICOd0AdPJBZDPe09rDugIDT6EyO/B3FkPYUyQaKMcsD9z/hNmKyutUOo26F56XmafEce/cMf0o3tgjdEH9mTdwfnTd0Y56SjXQjErpxMuEJHVelAuIzfTGfrlCDaUsEdozMdE3OaAedXMZmqmfXE7JSxzUIHtCeowFWJapLWwBoaKXv1Tkv4d1mzne0gTTj6ICElT5kmP4ZdYyHkcqQONiDfnb6HfalZIYJ6lRuLGbdWMxvGIuajkUixLaOP4WseoufFSo2aYzykyGaz2gOS+F8HjEQfWJknJyXSz+ZfIHqTlqiaISYKzh5aHaQIesmZoedI4qvcupeTBuIzgFiJxto7hCo1cVwcwVS+dxEGPQ2wKDOMLiKkecR4eM8zeFPoZYIzHrAx4wSBg3mJ4rFMk7TYrtkBCMZBUK5jIwX4pd77EvGL0fti1ycx9zzgZq6okZWry6CLxJfcHcHLDB5iMLrxiUsMsp/1glc3WJnYrHzMobjbtLwpRwm2gxr51DgHHWqPr3VmkGblmlKmSRdxpU2LoM2YlYq99Ql/rikITx15vKe6RRYOM4kfu2KAiIsZCtXtfyKHg7RDPHyV/lbrPxM43TTZuee4Z9S4E5KU4icopbFjVur/JNaFQCCSDSmk+WJ5vowQOMYoS2OEYo3oBFYFXOx/2olRckGpgfsIv4u7okwBEsXbaFY2R7ppXCPPf5smWICSlWw5b8wGvw3UDBGc31xZEyJvmNoyDI0YJxVLXwH6a2xcZ4GE0+TNuVpegBfz94OzqizCU8TMNqKYgHCxuorLY3zNAkKZ2www0FzunGbd4Be3BzQAGtG84JJy9TlECDX0x2FDN0iQQGswiyBWAlUlqwudlRJhaVRSmSmFqLxA4wSwCvescZQ4RZNKA5VadEy8ZCrOKEAZi4BVkuG3ZrHC9MHAZwyWzXaqsrgymx1DbPlLM4psxUbZiudzGzNGn7pJzfwS3hXtkeTlF9CMHUI7hueacPHX3Qfa5LyTPKxKEDli/rhwRtHP3zQfShJ+uH1CKZ9aRK2eKtmnkk1ymwtIm6c2QqwmwKz1VjVmbSMtktBeUcIyrIyWx0OyO4MYzKf+7Ssa7k7a6c5M2rjzNY8IufNzXfLbKErJ8ZsIefmzNbscZktHfdIz0U+5OFZ8lYBDHqte1K5Y8UEcPkWBwvADZtOaZuscAcA82KmbF8xN7ZdS/nucJ49osUuo1n8Xdyz1GuG5tQQakdJ15KQrrlymnE+vVZkWK/AsV78+JDHkOl7I+yXL9uwCtVS0jTOhNnYjKaFCePy1lGerCZ1y4jpZDSbMWw5K4xY4JY0JVSL2lzqOuIlYSVqs6BZs7R4sblvuvh04bMyB/ZZB/blUbADa7n2TE3LYM9M/OhVYLCka6Vhu5bHyZc/RrWYaFBnAtVStfBjEi2wLFWKBRXZCgBZmpLPqYq90XFcNJTaoWHHoWGmRFcZUMFHD71xgNniADM7xoACH8F8OVYK2LUsZW6h2eMwoMvgJmax1ToBBrQZVBjQQBnQIFNUsgyoU4WtMqDJKAMKwmMY0EAZUGDLHDBkrsQQ0K1JMBhjQOcoBRM++0jmJJAFfwq1ecDMMqDzkxjQkVlZZT+DKvsZVNnPwLCfCU2beXnCHCjgeAwOdM5eGZmvcKBBhQMNiDabrsvg9pcNYup0rAF1HcTnN5+OAHWHlsx01M3O/KRZl8k8HZ11EePbNPBNZp6vMy8anXmbY85clUugxUkMdExNWQLc0qdTbtYsfTGWPm6u8tKCAYv6wZxQv+XNeGme06aNRU45FZdvxkrH0iy7NCorbWzJWX/bLc0CA2JWbv+Pp8ddvkfiidGxupWsD7wNkvWDv7SBe3CiGk1S7gFBe9Viwxc3yLtep3Bf3IiglawbIf6GD291H2qSCvHLD0MhsqX0Orai8LxuheN5Ukq0G6XovFkK1lOVw7d0cW+XYvapUjDfKcXxWSmiV4fcCM1UhdSzKqSek29Vxj7HmvToRJVFoQwyY5p5UVFbLS8S+9DEX91fCGLkM5QSN2GVWrRIbWRcEZl1yq+Mcav785aKrAcou/CFVZRgTS8bqSWxtvL8uCzmxNbGgFd7RGzdYKF43qWMZnAds0kpaBGGTT+1IjYns+6NyqznJ8ms7Wor5eTLToS9lUtBscU2ySdGW7v2gCCfch3b7jqWokfuGiSPyzYIsOOJ5tFy4WsyivGn3oGZdZ+W5m+nlPtMlBf8twNEY4lqal+lMaGwIt8Bz/HEMEIxzXKHN2Mk23iqZLtmwD1jJds5JNu5XoVrq2QbkBdrGzRFTRVclSJqXIylUpad77A39To6RtNUyL5+WuUnVtK0bVTQvBV1yBKSG0FzrSpo7tFW/q/Hguat5rJtVdDcS5EoguYI8n2f5nQOYHyLqXKE8206fg2ZPgxbpNRelLcevkj5EciRt4n7tEcsR65Ra4IcOd4gR54BEGYw6SApTSvCO1B1oAOoesaBlspFasLgpXlbJpyTHjexoJSTbmalaFPDkGtELluv+jObSY/ddqbdUt/GG2XH6JM0mknFDMgDt4lmqtsZHWrdzrTtEpzo/Uuq45d3syDsOt+thEW5RolXrlGHPZZp66bpspumzQ3TtEUxpun0JrwScPSQZ5D1gA1caZ6XEUjjNP5YBlOTZk7JktoEmVsimYkYHFyU1vO+ihAG9M9OShUn1FZA91COSmQwQ0AHFUQZZoPheBo0UzJPuZ1ScIhENcc95abUjczTaFEzgP0MtXQWTxnTKcI46csBvJB5uZLDmYSVu6rZA6XYDlusnFPTwX/Kwb+1kUyK8KUpoNPzgilpSYVgKAlsCsRmNhASamHTIji9lRrlHVaa2Shw2VrFNGA6OKi2MR++FWyL4UP0qp+SF49m9XRbyEvqyMviZPIy/fCFKI9AcrKIHkw9YslJjaYnSE6mEDdGXvRO6MjmbEHIS0fJywJQX5mEGmXlUNSsvMSRl2ScvGSI5AkEuHdo5kTkJW2Vl9SUEz8WgZk+JoFx8hIsQC3VI22RsAhtIy7pqsFAIy3Jpx3fXJEebQPCisREZx9knU23ZdiuDZ2E+BktYqMaG+uxS4+QAMU0jT/dri0I+9AC7dkGeyIdc1++g5vt1c1aTUQoBeHJmy9te67XckR8oKNYcyKURilCyWlHhZRopgzcf0WE0gZHMQM1VRUAtKkJayhCuJRnyHSaLdMChsURlpojLBye0tbSUilB0XCGvFDNwK5vykpQplSCsuDgn20Kf1B81K5mJsCtET9mHASM8FSQIJtAklSAUo0UWjRtaFGtQoWUJo0SoWQDEeooDVRS1AD4ag58DZrCngDgWwD4FmjKHUp1HGIuOMSMlZaqDGXKyFCqqLnkQDO9ATTLipqZkmb8lRI6X/aAk2UouW5xY+pgWzdtiDPvWibn1d2uSuVAui1uzlRkKAUxttFMRYaSW1ZFd8IVEIIYAVcKg0e54EsTONIscWRi/2c29L/J/f+fj5wnmFaeQGGWCcRmMCVjgrsTzAYUjBWc2hsn5W4jk0GYVC4j4QyyGQmr+ISgcv4YMQCYrSDLTXuogLQqF1CrcgETJ6vjAixiWnt1jYmTsTNhMi5Qw0zGppl0nfFJF8ssrURSJ69h0gHXZOL5OvFqoxNvc6xpmimnZGnKLQ2Fr+SkpfPLnRW0KMXaB/NdwpcKedUjSkwwacuMGZEGtZ3AZCtXZhsl6mlbVWCiaxMEJm2QDDBjqbbDGAjzK9Y6tW3lsrTkDvCXSfher7ISUceuaUA0t0sYOc6P3FF2tmFcFmgbZsJ2s0gtPsIZsZ2W8KeH2lgyI8owI+q0TVX3YJ5hGmQWW9iG8sc6I3yzTPmVZUq0LDojaxQzFdis6uqE7en46jSqZYER0u2QW5oMtBfs0rStsjT5FWz3UXCsLaTFUstCw5nkXcJsWKLYkem0MlBuGLBix0qkMXiOSOvQTG8+NEs6NIBci5r4U/ACSQSYxyTSC5QCczPueofBsHQcIt3wHZF2wgUFqSXSTtOiSqTDDdNtmVIl0grRXD1EAVpNB61J/R8n0tugZZE94o1bij+FWQsQUyK9QK1JRLrwR5CyQqb9Cpn2K2TaVzLdUR2LE6bRAODxafQytao02q/SaJ9oM6xN1S99PErkasBOIzSYUsqWKmXDaFGstEMpW3oMyoZspQynd8VmpE1JrJUq+NZ36qBU116t+GYJz9HunBd01cgCvNzo/qJ7XpBVfL7t5Lr2rJAH8Ja3tnAf6TlFQMEw+3O5YVQTo/te9mvX6uXi9P/xvAkuogLyrKtY7xnn13oc8tWnUyC3yuckhAPZDG0VY0rZp/QCrbM98be+F066lIr/youpeqNXb+dFbAxFk/TGXhFy7CUmLuIsL9GrvwHc96gdNzSVmyH+1NTDETtKhIJ1iOkSoG3E00UcsXgUqpObi3vG0Xb2h3oHWsyDbF5LqLWgTXrHAD96Z7zw9kPlnOSLCPn0CoRaHMEIVq89exgw48IH8AwB50Qfzr1P9kfqpM9L0SC5vYY03ZaFVWtMnTT7Y72g/rxHcgP8k+4GeFmFuwCOlw33v58stdgbUTqE+9nczn7OdezL2eN31vWytg5Z9bY2GmEua/+A50+6hqA+FuWm/Jk1fuMpZB1P5QCPyv7lUvenJ1xV+MN2w+cjlUCPVl7Jvy8vjXUNAjcJBOcPBjoZbsATJxXSviIUHsYdHz+3iM+vvVbyYIbBneoRjwxyw7A/Ql8VqNyPuywvJc9ssz/m6REfLtUnwrisA4XcRVcK9O5JTfNRkB05aKYRLmW+oGhIKw5cf1YfgmHbTG1h47zgEFoVU2Pfn77iz/7x6Jc/cv7lHP4Jf9cZp72Bnn7Fi1/MzMD5tTu5abi/2aDGmH+kuz40HGgl8u954LA42y0349+fXjikBlUA0YNFtDtM33cqqoTGPONqkZT9fpenHaPmuyl8t6EC+ELg21xhUofZtpskmP0JBjIP7T1XuEQuUkpfidAuCV39a7cN0d/LtKymrDNNpn/Za0H6clCvkWGpH3dY7mJw10fGhFoUmZ5/4MLhUIckuxuNW0PHn6NiqUPvKcVSd5hzsY+BlKhls4OSOvlC8QN3WAGWFmJdArkCpYjbNyuiaHMhNyEVhXB3NVg1L7auUcQ5/Y8hrNVpFSIvu0NqxrTH2JKvncj+FN0ER/I+vK6LypoHleESG25mmCCD5F8vWnxbeJ/gzCc+0RcraFMlfmV7hwDmcEDJ+tDE7dw7vDwX/4Lcnh/sSzco1BH3KXI23focdQCpQ4x/gp/aKz9g0i+Azbczv2v5C395ztKFkvXQp689yOPjUJtc8IpeGX9oL7ng5b0HfVh5IO+intzarX1PL/szXeKIJ/t/pABQ+wEsE3LNvArii3T27tXHHn3sVh9w9wEBIf/EM+i/NoBrHA3v4eD9GsQd2S9q8F1Yeu6RsF4I+4yG70D83RLW27ef1PCnED6q4T9B+OMaPoSa7tLwnZ7BcdWak2kBApA3tHG61B/EF2dI8B5k2uXq2lm2ksqmL7smdhHU+3XKK9yAojJXX+KaGkrw00rjGiWV+3PAWg6F0QQ+pQz0+iEnNoS1AnFATtxGRwzo4ZlMhHVBUFq9UhlyuJpKNdOdnmYS33FKLs2+FADgOxTqQAXNqWEHLfWpzMp5eQPTFpQLcT/J3oiFLa8pqKmR/eX1yhBd/wZe9jQ2uwV5lPIh5bVYEN8icSY2+6zmYAj8uC6U/UxLtuT4guxT12/I8lee578Sq7aYL6BAb2j75waydp8bKAcRPu3C1xbRqyl6BdQT+PWaV18Na5eIjl9N8SvUOuJ/7J0b7CIpv/qBR8HmH6hne+T4gTYTKApekQctncmvKDhWUnpP867Og1QbuBtbeclO+CB8BeYJw1F5j1cUnCbp+EiS0ps93+MrhhPczIlZTPLURIo6sOSNl66TYIGT3N8002deV2YKqt7fArcO3maC4d4hbJK6hMInfr+8l37Cc5zuAWYhYlNIPMIOxJuyAz/K607RKFeeeCJDEGP5wiPBJdp6H9hZx8vyM3r6qXraxUag/CjSwvAVL4WEBotxa0/xHdzmB9V6JTfcMu6v9Lxx01cAmOFZs/+lbBUM0P1vDWKthnE95XjDc33YSlQflTiXEfQrrVH9hX4DHhiI5sMwRcUY1UWex4ZgLbfH1d2jJg0IvAe6kH0WEW03NSjQOYHhtXOCgvTPvo2NykpMaYCzYmejH6KIHsgQdo/rw7WJRmb/zA+8axqvnGD1h2oK+JoC3juV6WOAx55CbMb+/3pPy67BpsWakP0BRDwtfI3m2lWEeBA3kPHpB3pFHXM04vQ8kRUtuxqeC6WAhCQTyiyaXBj//f96nJ3zodq8KdWqSVXsn9WyIWfAC8xL/iCK5hKp+QN5O5XkGNU1qFkmpT+Qt5DUZk+E6r4KzIAabQyUtvnZ5wWl0Pxcmw9g4/MimtTGH1StmjzAHNIX3yHgOYz/1e2M3QDpxlR3NWOATtMzq58JGpitkCE3+Lam33Luj4Whjy2Is4ZOjqQpvurxCZZq57U0D7QKbH0UhRNgbsAQ0oSW3RMZ/skz3NsXZRL5yDLHX+DZxdqGwDIHsr9TFhvvGYXn19B0H6s6LMllf49ULVIZaBI9BBeb3S/fR+btS/IWmLcvy1ssx5enKwMsfKJTjzpwB4Ih1qVLeuulzV47Rb537wBfCnsMKxRDR4XxavcqgwuGQ4mQ3Yf2XBd41+avKDW5DfN2MMCsVB7DwIGjA2wVLi98xn3lK3zDJ+wWIpE6TSkMRv02ig4XUWnuVxSuYkIj1zBLROtMBgU0IdKFMSrbL3yxdsHEcHFrWCe9UpSCFo3vyy4YDtJf9mGSDcOOWwgW+wIgh90n16r75Jruk+Ef20uVhRU6pXp1I8ghAMm+CmjJu4knfl6BjwFhGGdAPORR5K0V3r4H3/6lP3rWD196IbngFb19z5d/n79wCFbq+O1CM0zRbrdVePztaFt3oW7PahVWtimuQGbsbE29i3JxifwUzx+dp77OUz/7K/0UcZpqJzx8yR7WeXs8Y2hHXgFjaPdONIY29Dx/E4tvt/sbzLKpt+1b/SKQ1mGxHPgUOK+2muFgNcMNEzLs1vQgu+VVLnKXEdNoZJX4PUwq9prH0txtQJ496FazBkFp5/avnZ1b5SA32Ll9p+/VT9DKY/ij1sgj8nioeKOR2CKAONIZiIX0UExN8bPuTMTeN2LV0d1ykMZjZYhQr6s85oL3C+5jSGRVClRciHphXhJftPClhBIwjvqtWC8O1bd4DKhyJVKDQgIPpGV/46xGKrvoVYWFf/sohIVfGBMWhlVhYXiCwsIrH62w0BsVFoZWWHi9x2xjdUkGuQJjf7eH36PWKv6le0tKywRUhejOYn4ZyP4J/UWtYjHf32Axnzyxme/jv1uGmhkNf57vs0yRm3EGrJfJppqke0UEPiym+JXEoT0SuhpBKiN3mUjfyPCyf9QVFcDWiK+p3dD0/E0p2C+9YTIFKyfsL1cn7AZh5xxmII4aRF1aWQXDEOA+yySEUfYL5tMwsVYpyB6wNHSXlpBpCXMogdSILTQ7ShnA3IoicIgChLv/+uhBAg4pAtddR3cFt8mEunoDHlYzSAY8ka07K9J6hj5bD1eBOXRBpm9l2Un6XwLwd/7VFavstipDIGvGLif4jgBfc2kcvg2LH/Mm4MhB2aUm0EF8ZypIPx7Enr0e4PbFu/cXkSV+ivdF7ERuaqkVKLO6PlDUQDtWi7oK4ei/DfynXVFVO0jUkY56FLFbMlyAUuTOSrbHWvVrvKhovhtHVdkrPiCbHKrDnOHqfonscmRK6ZA3QC1qORcJPRYWQld3jWL+yf4ZKGDn4jXQ5qEIBgnTm8vI57arGZCcFa2RZEJFxNWwBkSspzgx+A9shrF1Yagm1oe/Oq+pQERP6SIWcVkLXSMyngh292IR8eBl50r/7TcwvUK8CnkUSJr0E9c6MY/Gq5QH1NFuV/8yDgNYneaxdGcRdiidf4iDR+AaIwCDq+b5Bh7CsrocS579NlzVuR2CgKpIIaJIxYKXcWDAqRFSs998g7b/4EFfiSvsZl6PSmPEMaBwIMIvNbw+mKKgOs5KtBSVdiMWVPgBn6IJcmqYSr/PV1vpL9OcVxoL6miMB2too24xDniaDvNokv9SfhCErfLYq489+tjNj49ynl3mSfrJc7SHcinboMr/BGoxSPXsw0Qxy6rBAfOdjb6nkl+ViO/7xJOvef5bB1+70O5B9u4dQqdCO6/sp1ajKKDRuv3y9p1/w+6//PH/+fSn6nmLT34Zc7m7s6F7sSWKsJbeCrDeGugWzJTs9gqx7MEQfYNnVIfAOlxWxHhcUdRF9QrETEMgZvzIvWMStNQStFTNGlAguWTyjJBDnuCVr2P92rNfe1Q3qjuYe1oAJmJs1GMjGC8lGY3sL7UbFKlJNBP7F2XsPZXYz2msAPZOPcpGlusDnRCSoFw0wqVc6y3tOGRKWQfVfKW1LlskeQPm23j92XtV0dSs1OzfH4Dr+RdZgqEmFe37xMfx74sXDjn1Y0jFavWB24ZCydzu7Kc+ffJ96VnTTx0OVMyKHLCEGl3e42c9e1AwYQoabNlDEo4ARqQzdVoPqMnlr6Mr7wtAdfntLkwqhgsmVfNpt37h2iN3vfbrb/kGDoICmgJJ558aBIl5go/9Fc4M/depPOuvP8DUR1TMUPA3peHT2TdQsxYNf1czehYHOjKLNXoGtu+KOXXKMoeE0FmjZxRT/WjdPkhqUY1JUQXN0hSlhAa9j7H3m6jQNA9VSoUdaXgxY/xNJdqZGfTkGT3xsAc0yeAfJKM6IxwuF3LgJpGvTfdfsCK2Luo0Ty1sSlNT/JwAgFocj5SebuOzfuuSNjp9R8BadHLHu42JoB+pTLToAIMTYTfbqETEKzHNikOtGcBqGlc3ORbjdnkxjVUEI8iB2BhNMZcQE5X8tYn/Lu9Rh18P7+ueue/7/yVvoPzuKh9jfY1HZ81REhEHdHBweXsgs2UWvZ4lD+cOHmWXoGxlc1v8mMoOvF7X+qzf5jRglRQRQti+gJ6hr2BTh/miagma7mZ6mmK7m410d+5hdJfHxXhmtH2OgO7ckKLe4/77ci7ti/iHasoNJ31PNw96X2+KfIp1NuRdmobpQ38V18MzBhJnFijxB8A1nhZoI99l5rXVYDBP92sBB9ze9B2IEwvfYsmCePfeASTgBxG9XnqBrIqTeocfDPrhS7FZnYVfYqp+O5A0afwydW8zgo0v8yrRpS3UpS5zNgO48sQ2r+yqETbXTL/6h16OQ+08TPHNGrpCIQSaC3no/BZGQ1pce8uDMbJJesYP/sJIRN7OdMjHBY2dvJBkr0LvsS4TNamOaNSdXYdogmuJPDSTF2m787oU6Z9hq6s78YDM5pFIqQXqz6bcRO6k4eUMHPdxYR2Jr8lb0rfUZhoYm6iPz9Cw1PXyNcEakVAdjzrPZYKn2YEaNFEXy031coF3kkYQ+dRBd69Hv5hYMgAgOUHaMn66+7EhFAPZqU53j+aA4XNy8z7PxDYJpqNe5hKmFn02dFDOZ9D1xHQdRAcYfrV1Q82NUOBMUR3HoHUnb+EeT/VbiqW6+iBm9DXV11fLuDR0sQGJel761tD5qTjiDJ47M+WkZsq7+janby214i2D/RqlBPLCLdQ7y8YqsOAdWEQUF2M4RcwJFbgE3eAQyeFvDOcjTdhCDdDBs/XQerdqwZxR7t0ukNBOHArrtNcLMYn4mKrLQpK9VmdkwLVxThUnwIFJdhAJEg/clgqW0ah3+fi93Qf512aekddRPIKsBZFBVihHVVhBKMxeh4JQbNy/0US9HlGpfiKFdp+hwgwRz0V6iB1KV3istD1vkPaIUCh03+03WwBERwJURKDZGX5a2kphjRRANQcgBRxqQIUh+VrRDajIJWjkG8vIrov8cY2sOJb6Bd+LLX7sdqdyIQWQYYQ4RUtKFTKxCs7wxQ/t52u72Z9cZ2QJfTRTTuU4Ged/wzeU9552FrERTKEhcVWUKDfyK8nL1WTdzNb7qzKBMKdfIKGGwChW/NC9NKmpI48aykRiULDyXmU9jXnw/vyyq1Y2nLvHak5YyANmJXMLDWzisrU36ODtLl1eQSTu1AhrpdhPNQnRVDJiQMFWD/ajuF8qv90ggBQTMoXxdIfsrKJYej0RmYWYPPA2+/hK/dhIxToIoEEqPTMx2R1mBLyKRNI13kgjGUqA1Lg0MnsPPi8b9XBblP0yPj+eleD3vmFcke6rXgjpBv6MSqefvVO3OWorXA9WOfPkQ1VMXM6kbGslHoTLnXf5Ez/Gta4QPA1WO3WOAoShBtgqCQ4GeZ1ipJUJmU2IFRE9QGgIVwPDw7mPk0EODXI4ZArFOZ9SgBrVMbcYB8GQ/WUUNPnMrj5Zs1X7bH1RcNdhUdVYOVLrXrJShqo5wXrcau/LnOsqtckj1BllbwINyOuTi6093GJfgmL9stjEFtrQQuXGbkP8UaQsSslbeCRFW91pyrXeFNkjZO4wkrgtaJumhmu49nFzPqXmzjJKlK+DEDufwYP94Wtj1SSP2GcrAsx4bhr8C2vX0SkNecSfixfEOZohyZnPm/7OiTXaIhapcyC+KeBSEntTs8qJU0+aX3HKmpADkchI3PtANm9wA0p80r4mngmluITaSNZh1xVA4OgBiJG98Z8CxKkopbuRaJiRCDAqMhINZGtoNoqEsdIWovUhT8g8Fnhpd/uXif8hKKS08FBVfOwi0M2BTGQEirbuxhNscwJ+mNSuprYkVQsPtExHysinpDxtUl7EnQBRPX1L3UsmuHbVk+5ss6MDgMBiVaxYBZlDCZlYIaOOsgQyMSATq4hBcF6dDNopv2/vWvZ3FW+uT9jr+PSSES9kMYK/UVSxCv7vzw6C8dCl7pm61O3Tt736tsc2M3LN5CKWlWyGHMCR9L2HXnVQxXXQW5UFMDtkWIWP1VYkX/YTiNDVk3R5jA3riKiLmHtUyyehfI+mhiIklBeSl536spOE+ciUYwCmykJtfAfu5ur2mDrfLI1ImE8oIgs8JMgxLQww/iQyZDfKRG9ILFb+ER+z6jqUY7OfB2uqNleWrbtbPfUpUkFSCtUHTpmDmqLYo0bnQxXqh9I+czLFX/yUY0YzYZ5KTECf18sRXcveaUZYR1zXfC7gNqlS554rBYuFtfGjBM+I7llWKmd2/YCTMVorjPtyNC0HNhEPhDrmBSpqTv9ZbU/NH8TyQZ6YbJRUvvVbipvIiIsGnrxwKIVwTPcaChJ+KJ8P0DB0NQYW+jUmNDEPmDwKsGUd059WxBLUcrE/o7HOFSrV0nVPFEfwh/6M3qOoLrZKTAPr+ghClLqRd6vGQFDJar3mi6dcHEvowb73fL4FKMAWzs/C5XmIFYKE2Yz5zNK/iGNQemAric39F2NSgA/evWv6u41IOezfDcGUgARzMlSMxAHQb6DXensCGKau4tL3R3GDF97A6O5bJxrOPU+/pttJMRAairq1XmOmyHl1xjqGu1jUzKdafqqbIHMVOcVq0ZHVIaPMiCMyoVuIm6asuuHP5Mpehg3/GiwC9TtX5bMCwAZgNdvvPEOrwShAUEIhzbjNu9bbUXi6LXyLPLdxr2OUpvCAkLIOMCXWiXRTyYzkKaox6FPKtJF8agg4sptkTyRhmjVLaiDrqUWfpqIPzGkanLjyqaVKDXln1mZ6cJNPHXgnbhJbndv9wrxLc1iepvWAuol1GVI/XZ9uBggHKlHcwsdQHSM7YLXwzJRMLIpZGA4ZqsQ57u44HR6a1fWMFsGwFUsmZY4F7UtcakksBia493nsi521vl/10otf8OsnXfAUOGafBiGZhW3EWblgx2jQxSB3gYx6oZw8gVFrZFjmzZjMZTfLGMyYIf/7C4egJIzHehmNWRiYbswTEQuIRMDJDA6F5bFR+qsP6xrUEf+FY/egJDJ0F6GwmRc9E488Dl+JiJXjXI36xM3vjc3NKDBc7mbUxzmB4z7/8ZsDdy/qlte7e1EPp1J3UwqE7i1KvbJb8Ry/zwSRhKrcbLjT9LPIX0ufCQUCT1xp6XodanWehPvSOeNLsdTl1F2NVdny7YjU0vd4gdKNff/5h//kT7p//ZL/N0e20XP9fV996JMv+5uTv34h5KXK+TJni0pkQwM2Cgy27spqbMwXhsx4J6mkU+4ac7SPLtY7kEqoV2zMEr9kxnTLEQlmJ+DEoEI8cEHynteWJr+4qiw0elKvl7LBn+QhYnjRB5vik8chXFvA0BZ+fzfx3yU9ZQjMsAiR1it7b1Upg1P+eZHoUKhlh0cCp4DM1rYQiik95VAyVM0+6akLPkxdox+b7ONyfKu/84U8geCT7K++tOfZbQ8oYiYaSari+D8JjnvZA3iSl31dsHQDKv6zouJ18EcYjJ+xWyXbyRwxlkaImvTsMVHHgqEeACvXFRvEVm40LL2H1tXctdyZllFumD2eHpQgc1OO00hKowZkpR240MP+i3/OQEUJ+xDjVU1kcbp/17oP4kVFOi11IRbqRFFEV55VqsS3QBsJdZW7S8WDdaZbnV2QRCKEuK6Gzgb7UteqhFXVqs4oWqgqtctA2y0DE9YcH2vOMJ8ilVmi3L3cpPZtYjJJdQNlp3ozDtcG1MB7Z0hNWWumRhcDLAXKk1iriy1MVXVRn4CaJ9VhwOo2dv5fSz/nec3NdMzmRnXMdpaOhIGDXJZFJNWIiZX/Un2DPFHi1XD6Z/hefAo3cUQqKmi/zeXwTP2rL60vOwU0QeEc/FeEDxvidCAuZa+Qz6oumSK5cy6suD7ZufAFqrcFUKARfBBiBD8vRtyRDqsViKpXKNMIUwubLphPesQfq2m39PrHWJlQPWqD3lVVCf/l9cdWJXyTH+BeaDxJGuYul65w4XxJhQ7+gm4rBLZICX+hiFXaXhdhqBVb69iiWuSK+ztXxcmoyLKj7EEjyeaC+IvpY35xo3zxkPlCI/LGaMY8lq/zphY4owU2xZRjg7/+hv3aRX0TUSULr2sZJsHDpNKb66YdPp5u2rO4olGlenuzGvT5NrTPrPOIh6BTEv0Kz+OTZQvSf/Cr64Wj2NbjZ7bmtqi1UjQ8uocH6xthewhFaQg3Yr2BYPFhNF1SAbKHWQnIcmfFfPA2fCACTXCF2c/pKyh1THDjrBs1zPIEDNoc8U+2n2AYRI9KNLNZS3heqQlPZJO4WMYEj7AIdQOvFADf4aRd7+nF2Zd04yrHtsjOIX6SCn/hoZ17DApZEo43fGumr/c0N4u9chYP3Sz2BN4bZvGhx7wxGURfHLIGTyBrq9KVnz8OXbmKtwH9TCRMXuFDIOuhbiw0QAvhyvuP59f+7tzrBzixUqH6s1VHUB1r8o6DQ8jMKcaQBS/zucePYDUPwddrtJ/+QhAmRkNwwi0h3XQDcpsyMJAQhkqsQ6Cjz4/sz82xgC8SxKddz6XtlpIYCKift565Z0Q9vnxCERgKCOp0BxNfaU9bss/oLDL60S8qkIhdVmpk8H0xy2injVExTOx5ugKT6vpxHin6qzWZa0ATvXUx3BHwu3+xOluWoyfwXakF67pRGNjC28vmWtHKbnwjN+r9ezA3tMu/oENLrez1E5MAdEZOqbWI0XzrcDUyfAQn1tGhOiU6fyry1uOdvdyOKtzZy2NKk3/99cehyX8cQNr0cnC/Tny3Ukyy61sXo1gx4al+T6BjH+oAgnt9sIPfBzpFohIpkUyK9lPEZ3CQmogMSGWRRBGYgxh2m/DZ9ZneIRPXSm1jahxaVPzoUFMkWDEnQoRnzwQ6+EkpVrssmTKCkVr3n8KPjVIfLTFGKLYmZ1LRZihNzzQQqRrnhn8rIn6ro30qn4zkJKtjeYS8rWPphGzTgp8dUJQUWr75dKr6NjPUBtuaZ9idrRSyXTA6ptNwebfvifLvK3x/ZqjtzeB+J5NOmBjxOsSNsDGxWOGlVNX5AoxGYEYjvTWql4rD/AyvBri6eWKbXjTw2tS9lWVH8IaBuKdTpHje2ykqZgGPXCDWKcsbjeLmbmrf33/hyHk7fvf8vft+bf2N8f0Le2zgXHOc1OmHz+gRs4XP6A14NFOMQKq2WGmqLKxyvStvi9zxQIeSMrLcPqCxWa9g7p9B2ZBcTcIbHI3Y9n/MtP+ukfYfeurE9s//4nd/9sfmaO++H3rTr//jrh+at4HpR9B+tBDt36zd/H2jf4jlIuqynksu0h5kUYI4qUhaWFPVyzNuKIJHgjxL0U+C5UY8ZqH9g/02RIqZyBXdiQlFqrFt8RFah+XL5b2x+xF3PHVYJqsMcMB7qQFXwfv5WJiVv1YxJXCO2nhmQ86CQJdLn6IZJqil8G5As5SssaCOpgXfOCNGCYF9L/zNb/zyy7/MOrV8p+2/P5LrKfe93l1PceIldz8FbxsuqLyQOQTdhlRV8gX4IlTZz+KuF+qHQfY3KN+wDCiiatbH19WeY/WSs9ybTPQR4oFWPbG8DhNmf4vCJt+B0Ztmm1yD+ZzvBZNvZovc/IsTec0I5UcjDG3kGNponKF16ZIKgnHiVSj4DTub/V3JzAK82d/rq9JO3zGz2L1id8jU3jGykWYMSkYW7I6KQULEqUIKHsLPiXr/GCOLze4/oVkU6HEIsushrj/KyFYuoPd5qEbvGw3s7l3xxcsOC7rJ+OoOGg+r1ZE8kvtLd5z4DbZg5Aabv8kNNn/jDTaYtHlg9Abb219fvcFmGO5YGe4ILPeka2x84hLvF7lwLDQJZ5SVa2zhsa6xxeSbq2o6VeQ2W6KPUB/ApHe8/ljX2N6po/GLnh/aQzDFKcW0WE6v1M1EgAe3Q017RMpUq61k4RAaP4weAGbJxRpqUV03THJxPPtFnfdaAb7TsQ7lFW1m+RkgEJYi6U4qL0VobWnb++EX4fhrjw43j90X/9Ecf0XKiWNRl4aiFdqB7A7ULvQlcqiW7jX7ZOx7s19SMSahqPJWqsBbOXtL7gSPpIVJ+uETx7VuKcl656fe8anaBFxDHpVWOXR7B/Iy/vDjNIdt7x/BNrePolh3V4Jy3c1Qrv+CF0K941uLeL96TMRbR+pjL6dSXwQw/VDdT/7acfaTf3RSE5z50jU+3xoKXj51TfDy6JrSAftR5yZGemNduNzwy86S1AQePuIRedAYiEL4i5XwZ5yxKClFuco87itKGHkXELcLzT8xJ5/wprTvv5Tdg0Dhhpp8KtFkKg+zo6rHdlU+RQlyNKlB/McbgRYygHNr7dfMmcs8TQkY8BalSEhVjjpjb3uLjpHeTZHGogWt0m/ENJAmw09Tj177/Aq5kT3Aa5dpKdLaSFNFCJbci5LPV1GqLbJ/AFCgGe47fmqYCNkHdYF0scblS7/OzdUvRDUKjqDl3Ebk2bBRDdUl6Y56k2cQTUOfeLVoCoMyxw2WC+2lf3JbGk6mm/JtWGTIqnWKU5T2KrZTHMvjwWBDVRCRYwtrXc3Y09EWNk4qElf3ntU+oG9W76Ihk09umMwZr4vzcogEbFgQrzKe2MrNMEbQosdVAziuSSjbj7glztCDM6Zgrw6YfE4Yr8k4GcIQN55oNGE81POlAXRR02ZuVe95W9HafJuD9vbSxGdGWylVUOMD6LorScP0NNaoGVMzHCDxA1jMUmwAGDkynK61Jc8UwfJ6TzXBF6kl2VoEn6hwfrOdUqvQypu4ZZSsbokSauKnbcYS7nR0UysuzHOSZy3PVWFTHEk4O7/OKU1E+QZbqZhfkiciqiZhUKwdcON+dApFcwcYiGiVbnCdUpsYJt3mrnRk0GZgnFHTuVs45O5N5Jx1mYX63FmdciiweP9Ds+LSrKm9aPFwTwWqIyXkgfxVylawt1fQoHkwfT1p8LVXBT30OY+IHfZQRAvGWmyRIzLnSO4t/I/b+J2I36mZ52zkSYg8STIrdHhspnWAgHlwtkaczimf10TE5ISyNIYACwz4tPq2F58cahNXc5bfEtnS7LdgKhkcU2LZXuZ+jHmuzmAlLlFntRq3CPHVovUWqKIHpSEnw5CYtwKwngLoSmiXizy1jDzNRZ5eRp4hwrL8TG7NWVzd43hUHsdjt0uJu+G865hSu/FIiseLdY58QU4aQJae0McdU8m9FX2Cs0VYHs8XiGNIHH09UYppGms9Z4K8b2GNIdoCEeWsdPMJeayTn05huOwyhpxjjMQUMFyQFwALV9yrCodaglPgxEvCDCvzqKpHS6tMlNSjFMLzHDW7gtA2/iB4MULbOeRLaJFDnoRwG6wrVti7tF0wM2/Ly6K+ZPIyoy8deZnXl5S28ss2ffHlZU5flgU8St981AkUL1oyvyNa1q7ihSjFyzThlYqcWvIUfAIyTRNRZFG2QyiEcooYuYqTxLwxFbD6TTQ+fwR9i7Px8yTJOvCKczivLbpFTyL59iSS6M9pJZmpRD/fqX4Ci5OkEq14h8TdwcWOlLaDJNNOQrQtra3zK5dOWIehRa6lnY04krgjXFWltBqnSqaIdrrSBK2YpIRKHAkrFnUxUbrG6axeUY2tl+Utzno8sPKJ7NthyvdqfqqIeS6r+NG5QMw9/OBF8jwu9nzGz+0GP0/lSk4z+Ln9UeLn+Yp155f4OcNRewQ/exw6T0JbOHSuhGZLnE1KnG2UOPtkbt42wdltlFjMxEvDYiZenqwvPl4sAi/TVn7p6UtXXrboSywvs/oyhxc7A+Yr2ByPYfN8FZu7eLHr2Bxe2vKyU5E+M3h+ksHzHcCAswl5iLF0Wp7nIPICiwqZmQHFUxi1cgSeaueDr6h6Eu2Q+YB0BCTTzpHZoYgb0Tn0JA6MzxVBRPwce6bsHJkpqVZ/Nl1QnSmS8Sn0VJl8k2YKvtgxPlM6OlNOMn0wM2WnTgLS5puZQiMzRacI5UTHmSnbMCm22ZmyHTNlO52PSEY6zJQgxcQI2CU2HvCnMItZgVt9W3hWzJlZcToXeIaZFXMPf1Zk1VmxRSk1VgedFYyOjNFKq7cI/VZa7UtoBjNA54yR+S9QbFE7w4tF7Y68bHOEOrbE3ZeXRTcdYkvPuxU8747huV/F8+UqnqeC55Z007RB8akKitvhwuXYnBTVNpB1xddzJBk4+ifv/S8XVv8w7ECMnXS2IPCF1b/iAk4UNNTqBGueRDZ2ghkGM20s1ij6n2TRf8cIwp6jpF3xdmShqJWTTtF/AsLe8YgRNhYdf4uwc8CiOdqCSPVm3PKBsOC+txuv9/QEkEWLXNsYEcM8x1NI0DwQZxme5A0J5pWcsQKhuCStcPzqC2L5djVvy0vXYtlWfoktluFl2WBZBX06Y+iTVtEnE/QZJ4bji75bQS0RU9KhozcKWY6OTgyy6mDUQnYbdoHbrIf97Rr5BDqTnviign9wK++VK+oL4Qn0RABpSYpayGu0G7uL3fR4fGQYzFREZHTyCj1OFxZdbdt8pXeVIdaW/TC1OU1cPIFX6hr98/Ykzx0qvV0wW6kM6tzjmYoL5YQyoxbqLGoG0NjPF00zT3mq6RBQjvuPPmYwXhjrqaZDQMhLlmuSCc5TckqeQuafwj/Wr8YO5WCY8SGddkhTD9NkliqeOhcgcA6S1HPGk+gpukPbq0XoC/EL59aXTEuQAcZYc4AuRDG5FnOlpmvm3Rv30bppEhwQCuzedbME16dRdTPtHMC0DRclHpHdHjSwG3AONSs+SyuXNNWHoPFY2tV9TSj7mi72NZgbj6Oz7B7oLImDBMH4vniElsne9fqH6cZgd+Uo5t34+Fvgu6BfMROYiEkpIUl+/2rs/Edt8pEP0UvFWKAPIe0LbAk4AcFDhMoIhwjz1rgUZ1rFRTLnICFSxHwozFWrpS30HaUgaUQYnH435NKZvZZBfsUXhdaEAiSkwk1rvy6goKKHHaZ/HHntiljUnU75BvqCKTzevAZfdpWRk5o7H9ACLO8o4yaWtDD7J9WS1ctbXb0okulbS99CI7U2AkJdAoz6LCVj94xyz55zuRtHauNbNGgysYejGs3O3PzABM/ay7fOCh9rTcNc/PH57mDehOsukLMEui8tqvNVEES0sdHve6qxir2zrzjszF5xcyFO8/R8VxU+UogdOZY6/Wt+BBZvYfR45O4WsD9kkgtx0ItNQzzUoA5K9IiIguydr0aKiOsQr+4ERb0PQjrsSlVNwrNntLUjNsBElGuGQRp7ddj6DmsYqYTgqrVxEQAmSPNFgpuhykju1aCRLR7fFdGU8BUOQVm3lp9o+Qd85MDRXZGhdIiNqMPtkCWiQ77wAyi2pVIjrdzngH9xD/gKM1553aj0IhXSYqMlBZC5m1X2olYoF7U00Ub2yanmzPOPO6qpZX8ms3vrpNj+HqEYSl8mmCnHoajYzH4faE5V5fb7NzULuuysgj7grIJmFZufc87k56ghz1aNtEmPmLB+YIywdqtH6t2xE/W9k0w+FvzZlUxOVx6x3Uc9eqoSWrTEENq3n/hZlj9ybhpucm7qbTw3hWmGB0fPTf/puupJlpzf6IFp+G9k9/OB6451bvV5pLJmc/BwbiK1JlxEao3cQ4LQ9yV6Iah1Jb8d7w7Sp/lY0Jt4CelTSKFQzw3dNaQPV68hbV7niTtr6r/khRDLP/Yumz4y8YoT6so+9PrxG0536kHic8ZtCft9kEnlFUpGAZqGOtLVuQ6GIQ/MFxRUDA0/sul+ZGy6tyrTHS/H4KM++sj5KMWL0endstP7uVVjHo8GREVogCQ+CHK/5LP61UF4mJyaQvsXfD8YscAZjFviDzbRsQ0yteDjZ7+jELSsnNrQkNZA4v5JuQaE+RLq3Uhn5crntzVeqRO1XUB2zSZPllYtP8h+F+WTJmW/hxfVh5vbYAu6ZlwsmXuclStBBWzhdkqjuXgpYjVkWMfFE7jz7IopFm5/ZD3b7R5dTN21X7eYjsUCjAZtnjR5MZWVVJStsDb+9sYVdXON188fR+MV66ar/fvK+yxJYdV81vf9xNPfdHd+bVKaI7jnTvIwCE7XDsMBSJYx2R+DBjPk0r863r2ET/xr3Ev4xMO9l/D7o/cS/mDsXsKBDDvQiXcQjtQe4R2Ez026g4CqsNv8trmL8PHN7yL826l2Hf02Ve36w2Nq2PyRLozvVRsH3ubqXacHx1fvOtIp9btqonevpl3qiLP6XZ967PS7cH2pfyTD8nOb0fH66gMbdLw4cUTJi0PZnxxfyevTj0DJ6xHxAH/8aGQpn3ysZCnfkaX8nO9Xru3QJHtvWhK4gbFFpks1Scg+o2qqEL0c6aAXcN6kthPvkndMkuzT+Aq3kcCn3M3xFQey7DXtaKdiwLxPImf0ShWQgWFEvn7hsGIzOdKbMnlgK6FIr9UMTW2RJHBt6PqAojX38eA8RHtuMc09dx2xujv3laH46kaGIp8UqzPT6FYzemfIVI17rkwjtluu3tOcKwpMwP+tQOvKy1/oC5EYvISDKqFpePXw+ln7eiDE61+a1/TnvUAd/jh4+n3PmWFRK4UiyxkD6gv2rlkA/tXrLQCD9Un5FPRFbJzQsEo95C4VcIbmKlH/ozJLMBID9/lt6eO4z2WbdLwqEVp/hdVJH/KMJfpALpSYjVOlk3oRxhIdqX2k15yO1RT90ahDrFkUaStH4uLqR07Oh6nrTbDmeie8Sx4uGoPsXoFZk0IC6bcRsMoFpUMYXaA6+9oCbOqMak6GpLTMipBk68qmbtTPigIvPeTHulhtctWuL9NAtwKYYkqv+1Gfy8s+KZKE8Lzg0vIWMXTjJ1jOq5rLq1fi1YoiDlfEohgFKptnzBPzPND0w8Kp99PgqMECSvlXDTGgboaZfKpXrplRXLm3EuuCEA+4qYDDqLea0ftsb35kEEn6SRUiB/xHCZIAIIkEJPXNQVJ/9CBBW48Hk5/xIweTE4VI2s9GIJI+QoiEBiIhIFIHRFREbSACw4YWIGG/uSlAYgAkHAVIWLmbhc0gN1IspoC7AmDS4wHmG5Oo4hGGR0lipPk+YO1uaoIbPJx9znBvkYYGEygdFo5AJioalxiDYetFOMR7tlaM+t6yVTRsx+lSVFb1OAa6uiZRh4toWNn03cbxQ6zJQ1fIxuJqXNzaAIOrhHUtvdTzql3391ZWX/IG2ty1gsNcnzfmh0bXfO0LpBo+1NPF6aFneuo7wjgUZ/ACCIS4wNA5dtYCTbs6aQUm1T7yG7fiB+Tfpy4kF7xc3MQbqA4fA7HKHZ7vM1pQTe6M+njyDVJfNkliJxZ/rFDOVcCIKwbah1lIteMuxskwFlVjojFaxIpU/L1/SdscbXiVdCg3uWt7Yu3HMwUxOjP287t8I9ooKOZZesGXYl44T1JeFraWKqys3kUrtwUYcIWMupexk5PC7AvW6q8vVtTwBBMJqChjYPyKeZLiaYpzSeb4Y7Dzx3NJppzx533Pe6VuLukcnxDio+IM588aVmvdCIu1l10SgrWXnRo6AwZuJLQbVgqFhu3Sx059nIEH0jzd/eDXWPaGS5gDfh7oxvoGH0z1uf4BfuKLg74WfIhbekjDnAduziTM6ciD0pGOJ9L0ifhT/Rul7Il7oLdpZZxFK7+Vn/jkXf65/CdhjrPxuzj/Ofyn4ds5fLsPQi15ff1eK36bPpHugcNd92GnPL0VLmLdXjbUvWyEsQrM7llvLIXKKlEgY4lbcWLiUZIpRigiEfxn/1Ddugbl1jXAq25esHXl/6pb18DYJp1wNenAtNu6hv1DX99gnU8HD61Ag7MvlbvWcLNd6/2PYNf6f96pty9OZie71EIbRgWG73wH/v2tdTR234WQ1lyMg9YMRW+2mwsquzmx9OSpec8l/vwz8vpH1+mreJjPyJ/sXr4D2IJXrKnQ/HrYbODnA2zZDzz0iIFmkA+3CvhUd8svk7siMSsYRJ0qUYLRTu05JbpNQFpYTatXVud6xcoMBWP7OsXA6r5uUqxBW93DPf4YJ6/A3+wfNwqK3+Z53uSzV8CmyrdoLCA1IfaLE2PvqcQ+UMYedbFqHVRiPzae17Uyq5Hr6CM+zz3who3CnZ3VA56dYwc8+497Q/qHXiifBdm1b3iU96OrgqRXveERCJLe/m8hZf3ZN4xLWXUy/BsdBL/1DccSr96mtt5//IIpOBub4b1IS64PRi9P+d3jK4S+7tekV3kMgWVLHCPVtQy9RHjk2JcI4aTrDslSI4QHlfAhDeNcQkpJ4UGDtdfpxXnDBZsuiAxHE6gOi62svM1PY98VgOnmU3iQ2t04I8+QLVpBFpwH4y20b2hDhhW1mKbOfkEAmjYXFGf2F7M0i6GWHVI+R5G9czhP08gRUYf4j9VbZpFhAfY/92vmRZe5S9O4oDhLM0jYQhmY13zJGsHuS//Z3xLNisU04GcXuLCInxmM2sJKn1/NvcR5RM+VaVuQNoc0LqoFBNZ7ibejVFskwYWR3cDdwduyHhfUQRn1/qDB6s4ACj+3WiCz3ie3b4GmKFwptuNOIvW9PIf+KzpR0BIH2ODKlpV8B03Twn7E7uRPTgr2ase0JIq4Y5PxIcxohvB0hmGED7X6LOay/8lysZ9Olgt8p0B9SnihBTrZXJCMxF2U3toTs/JEsp2YpQVc2eOHvbLXpRkkL0ADd07yzOPSjl7Zm6ecZiXbLIdhxnVRZh5+Mtq+ikHANvkk0YDsyjxGeQlJURAqiDH6OSiJs6Awy3fJs5afqqAQczQzGHGKmIdGjTMrDzXFXvKpD33Ze+h+zwAjWwHiSZ6EdlWT1CjNDPjEmT4BWvT/Z+8r4ttYvqy/5ItsOdFfjtWgliy41bIslhwG5yVWHg8vZ790MpTfbIY9PMvshme8G2Zmym4YdsPMzDx1bt3qro46tuL8H8YP3HVL3dXqqnMK7umrCpAXUMRMiMgHhn2qvulGbfbSyL1QP2od2sgQ40AnG7k3vEBdE7knoFQ+Df/bVyM0qTxFRePA00/BKKYaP4Eaw/ySi9ackA9oxvu8ywB1H8XBfAXOhbiKmJwRVfBwcZ8aVDCbU7A9wHPqp4WHFWe1SD6YUtMmZ//993LOnqE1BSgXMDOl0iQPbtTX1+k//3qGijRFeqrT+n7aRJE0Mx8NkB7wR/gvLqa1b/oNANo2YJHG6ceoW+CIn3xrn6o4b0RTmiVPtUfI6eMmkgMhQxXI0x0ng8cjhC4HaNfuvPS2/qiLgNwuFZCl4IZUFKJRQxuceQ59yw5tOpOoIdeMAM58bW6yVQ24OMDYPUx/FCiYX4TtWduDz8ejAg6AGgFq5keCgIBVjhnsGjAgGUsS8NuiVXVpfgYBgeqKvuEVA6a+6eJVASj5rXV11cSQ8u8GXdNH/G7QdV7GqBsalcj5q3V1E+84cC+mbukyKxIxekvd0OfdomsYAW9zSRWJKryKPpkQVVhGdxTow9pnKkW3qEz0cH6gXzlUTf3VerqQFt1Q23RTNZL+KiYNpgYBSQAxN3kXeaCb5Ag7C/Mdu/mTebu0RC1V5YDHbVXTJX6+0hRUFQqVRzWUbrav4u6gT5UkjcG6glQ8II+PU6AFBDC6IIBrMyjQ5EGuQDie8dZZv1KMRxpNNFjEPaM+HuPPxJy7Gu8ayArJJsTXzoiz/16y3TtxEX2++veK8YzvZG4/Mpmr8SRT5Ij4pD5NnlXklJnFV/9dMe6bIsfIHJjM1XiaKXJAOAlXOkVWgL4KeTh4aBfg1YcLxp/D14KQWUQzVynkY0g1PtbsS+1liXKgAFEOTRyatE1qXwOjMd/BqNjDmT2ibLzg7TRekCG3gXhBxtodxtrGw1jTR48HpE1AMfZ13j4jsWBgiPDzdQ3DjoZhXcOwl4Vh72Qw3CZSNVIajm3VoI5qUl21AEc8vKpQSXnUUIEGakQt3C0DxciBaJCkBw50p1QwY1o8E9iO0Gpjwe6EAj7uIvOVLJD7VETuXZrSAIl7Kaz9/bhqzwGuijShXSQAfQvcIoALoI4Y+YLBRcgzivBnagE/cqBUpSkjXXBvoVRNv8Nduqdz5erfE2qN6RUmUh7gqzQ2HJrSJL9I4VAW8DMeBfIBX10G8AEOAUU4RBb+IeAfCvxTuONYogYfG9TkY5NafGzRNkC+belA5AO4CgdFbRza1MGhQ3W6s6/h2gM5erSO69Zpw4YIXkWI4B4Ob6MLBtCVohs6VcQArdpIgw2Esm4R0Z5mQh2k4NS6RvBcc2JDc+LOyTlBT3NiQ4WaDzXNhRJ1VIPWVZPuCC+qFKpCDjd8DNbP4IbncMOngum2yRNeRA4vbIP6goMBGUhLvmFZgm+AmzH9rR/3yX/22T/4l/fsEb0uutsi5jZ2tmaPmmgMkbhoimYkjsnmTnNGhQEDklBqQrOBpQvn2u9HuzQwdJm5QJTHGRlYC1P4xGlmvMjCuoKpzwKsBbpHoltC/KpAd1XQLZ36CVG+QYSfpWiTAi7rsOrUgdWhdVjrdAfWHQ12AtjnuHxOeza88CpWCh0NMYa3Ug62m4ztzkOzhmprRG9rRPfMZEOASQ0N26Ia4IiOlecQ2wivVlUNv5B6Zh6Bh1cFZy4RYC7hzh/cTlvAOBMwjlycSRfstuAg6U6l6aT/zbTZlGTMLy7bZmilSFrJ59r3lxyKt4kw+DZJccvBalEPVo8aKL1BbVzQpo654CZdpdufGus/NhgRi7ObdJvKD1WZp783VIGuIRjxGl3HRXYOyn7vojI/Hodp8jNWqd8NtReJQ5t4bBMHKzz+qx5mcXSFdh491BAwzd7gmcJVCM5kvNTNN0x/pBvwBm3ziaH5MkaoR3dZowLQVCb2IZRkyRXpy9DuoVnrVHQvZ1ufynqtKM1foJqe+2hjTw20UdJcYWMKfxVSDAwcR2Y0q8qo7fORh1yMc3hozWqAAz3DzA7ZuAqPj88wpmE4x1CNxMR8doDPxmTGfj2s2VJg/QosfYGxfhqWHRmfOZrHPFXESWiA5Mawfo9/KX1FjwH80Od0b8ztHRmvilmr4EMPH8biaMAyhfHKmX3OnDqLwylTgIpIYxmo/1MDQ7J0NSSxkT4NcL3tpAINeVXQh7NgAS/YMKvchtvAuAaqSXueUaHxkKxq4hinAS+xI3YQeDy0IRTKUlVVAIxkdNO3RDHkoW/yZM0vMZZbVDUeChSLW6yYxV+U+B88XStUkOLl0cSncGzxqW9nVXw7BogBIXWRX14PqIhOwtw7/6RPkpP2KDByimcqKesJohDrYu0hUFV2Rl1QkalX6cstsR7EDe5sELSPy/UWvxeYZY18lpUyLKuBXbZllmFZyWVZ7aVjmUXS+4plDWEZYbxoPKAm23MyPAileTWSVS1DvKoQz1+SeLJztDCjChxWE+KFTDwfxTrE85cnXn7xJyeel5zkLRDPFhA5BURSgGc/c66L5LooJWxc4RahyiJza5a5If9IyBqc50xRPFJDeMtk/fjENVkwn/UQGODBq7Vdeql4fMpjUJexIew9HTaPGTYrywyb51WUIV+PT6oww7i2VfMCNY34eQYs1BuxNtCrJpPZpr4jz2XM/LokMkeJfPQCBZ7IU+EBZtzcQmXpCgOqUaid1nj9FHYVflyqiQfb5kZSOwHEgEfgrLdPkTbYr28q/OyekbwCtHGVPJONx8Czap+1OLs9fn5pU9FCGjDMAzbnRTYuzSMNDrlvRaiBG84//TNYtMA3e5RAiQySUENSwGVTxUV1RRdymT6iLpkqPmccz1AhtXKmq9iKbjs/fajupy9SDI1rnu/PQlfE16A+6Bz+yr0haELLwmGL5Uz8IfMWEd2n4WEa9Odx0B8VzC6FatO8lkQBeE2bzqYGQ1crsBAW7KzI6wV/tbu8HnxwflEP/qfj9eA/cjTg33DST1I9+J+sHnwAscHowZI8nyaTEz40kvCTd0QS/q1lJeHfKxpJGL1uE5XzUZOED04lYSsJH3zQJOEneZLwwakk/JJLwgciCaedcGySmrxHSMJPTioJ/9YHRRJmV+4RknAlV1MoYsQQSbhyQkn48XNIwo9fSBI+zJOED19IEv7uPEn4u99VSVi0YFGGTyXh96Uk/PiEkvDjF5KED/Mk4cMXkoS/O08S/u5TSfgll4Qfvz8k4ccnlYQP8yThw1NJ+FQSfskk4ZWPsiSMJVeQbk7wLknCcE/nO7nhrM53clvXderk/u60FFRbxsl98PxO7t9Lb4zmyJGED77A+haxaPmSM/tmxQLTA+DE3a3OcAR4BVmkzf8n5pewA/yxnNd3ztMf9OW8pXzicGe4fnAsukAN4wcHQ1SUUY1XHNX4IHV/wzrC/S0/PGh9lkC5Zqa4p8/hHqBmnvf77BLebyndOh1QeuXY0hP3rq35ZJuvwNwqzaJUD+bHNwM4OrR3Vw+OLM0sxZbXkU4p9gGhWEMolkrGsAFfKxkfpJIxrAXJeCnW+eCFD17kKsZn8xTj5VmXX3ou6+JKDu8AY2FeROkJEbn5lpGO4OtS8x0TfE+JekrUVBMWer7Eg2JlmUHx5GrvyqLae/YptXflWWrv2azaCztH7T27qPaeTdTesyib63JR7eXsd0ztPVV7/8NE/xb1/xf0z3WVtMqrf2bxc9b1cUX/n1V71xbV3m/+vmPV3q/6vlTh/Qon/W+p2otSRFKwaq9Nnk+TcsLzqb05X2oDHTl+uQiJ37OJX7GJn7aJ77aJQ5t4bBMH5xKtuJJoxRXRirXs65MvWvEKcJLIvyFVsloxmAVxkfwH5uQoPblmyOuThw/qohVvJloxVyDkQT/Z1rQG8rBg7EF6qkIPjkQrDplYyWd1fBYsasWP0Ra2yPnXwWINlhXYdFtTVoNVw4jJqqnLT04yv2TSAEXqpgB0Phi0zZYtqspsCK1iW1I+C6vSj5QeomNg8bb69C6ntjTs98PXnosjguhr7ulTnYKH6HF1Lu9y6vOtPLvLKUYAVbC6lo9fGvIxK5Guyn2GZJdTagqPDvTPfLUcrVyPO215J4kMNME7pZ8THWCs71xFw3Vok18xiusQxSpUfYDcrj5lG/qTq5HLkMwQu0g4HqeI940i3mdFfJDW9jARx6vUd8VxzxXHG7LLKURi6OP6IPo4KphbAL1zwOeEaB2jj4cUk8+n+Trta308oiGV7S6nnX3qoWS4MCCKe/gTJLuchvJWe413OR3xEbIxKsAIlZ6jjIfkmW1OobBiw5pUGQfNRHwdZT4ibmSMx56Mx6E+PXU12Z2NoowyPkiV8Sr2j4Qy3oQGuZVRxjGM9oyYKRSEpxjbnE7w1eUxfJmfMGk12bgwUcaNNaVAKsszundco4l5oHhEbStyj51dSHGCStRvIpvcSfclBSDPoUi810A9HmcL6TsEU/09czXxkS5C//lLFsGRnvHuqDBROu2Yj8ZIj5ONU+Oirfd8TRzVkp6BigV8+Lm7++QDJHEBHmXacTZMRc6IxtkNUz0730E3UrKrjG07QPfgTjN5MaTxWNZEGWn8ErWcMbHJdSWIE2ncBxHRt4SQxps8x/sxaOFAEDJ8myErsLRLIaAtFcdXeKC6nI5ZV9Lcq2nutTT3epp7Q5JA6zatav37jNmLUn+921ZIZ/CpghmH1K4V0p+sx3dw1D/I/ooR0pUI6b+yru5CSOcuXvVRqfr/ri6zr5Q+r0930Hfc45I8EdJ3MWBtQkjf1OMbCzNbdFeVZLZ9WXl0havNpxIaP0w2+0OLOXv/2bkwDr59PdPuiNnFrbaoi13+thizSJPOWt9HaoBp2yOkGpgxcmqIuRqnYv1VOvorKOqkq3sYQ2NEbMTGqLJBxqhTXxsDY5TZaBujh+qRrrlsZ6mxz31V0QhQIRsjqhOTFybFY/L5OLO7sNVoREVjQM5DITSmIvby2rFCy0QDnUaLxGQqxnv4MzfnrsT3nR3efJoTX7tD950d3iK5i7l8ZgWYHb6LufXEZK7E80xxE+KTZjR3igsMqfGlQXkrU45NcXvIHJnMlXjmFFcAi7WNLsUpDshSmj1CPAzA1AFZO9Q1ZC1h3l6iLWRu0WZWcb+XKu6MzVehuL8KbL6mD3rMf10X+4aGaEMgelV5dE0g2nhBiL5hgPdGAtFYZ73GEN3Sqdc5talTr3JqPYFtJYHtmwls39Jfb8CwHVDFghPGmxacMN6y4IQRCzghn9GWMTpsbBqjxMa6MdowLAnIAXRpAdDkAroDww7LbRgBGzOD+0igviNQnwABexSwMacaH+8j820LhUhIEH8MzWiMxMdaSpQNWHdowpTA50jwSTOXIBa6RbpP82fu2jrCn6PJMsuQpW7uv0dvZ8jCZ34MfSwTMJ8sezRZJEvVkGVHnsKSZWZ4MDIPIGQZuWQRluAVgmPIMgAvBpYsDZClQW8gU+POKvC7UODXcYACvw5iYCW8qYnRFmJc1wXeEGK0n58YF11ibJr+GmOEIYZGpAa16bE3pRcfAnacikECQxvInUyCkkV3BMOiu8rGIO2uS9QQRsCw6O6xQcIIB+qdBaiXXaj3XKgzFALbgVNNUB46KLfNFWAyRAZs2c7dQvY+Ps/duBXtDmjMaC9n49a39YeMRHM/hs2cbG5xEfVCHYGNMGDHMmCSgex97t8FuZnhopAQTxiQA9nDE0NWtF2BbBs4attNudetjr6LFUXDvKpBdBd9o4XXgHduHePI/RABOj0iDWsDtw4RNRhQpaR/bZtFECkq21E9YKNjcdbXRsniDEZPcOYAqLoAoLoLoIgBtNgjLg7+6ThqOzLuPaT5sjWrs4vL1awsXqRmB1jZDoiQSdQwmXdpl+59aqz/uDu33qV7qKQuF6VUge5gwXSHXsFFdlKZVcY96xkpSOKwwGOwIiyy6TZdEtUbNd/j0XoXqnffyAAlo3rLTE2aADcSTz+2g0Vtw3FA7A0pQ4SRdhBXIdb90g4FqttGGWmjahqF1Nj4/wM2ZvDyZxvHdOk8pMVzCvl4H5kYAeAcgqiPVgGP7Hg1MZ/9Cj4DKXgsmxMPc3Pz2U/jsz3CoIdKSkuxLwroC4x1AMtSS+Zpi8Q2XcDIFP576Y35BQTxF3j7rFgdFpCMA3b4j6XGQvYmiNsT+HVCvNjvzx06Z444c5YuAwFApItIY8Gn/1PjrC+CAhrjOqMBeYLLmvHOtqlkeRaKXoN1sT4V/h/zpVgAC2Q0qhkJjPAk4lmXgKqM376mDVWToUgW8uII3qYIyE4DAgtmQVczfOHSvQW/vfgJjivd1qmtztRvH5pbpVlEofHb++bxn/LbV63fPmI94wLcJM4c2JLlQdxjMbtHJeqnYraiXj5zyhnmVPF9wZ5lmFN2mVN975lzypyeMEcbRL0HVBIRzIC7KmTS+FT1DJkiIVOwHJkCwD2wcI8AwMiSSUSwAKU6ZAqWJlN+6flkir1FOglCZRxNT6iRk58SLfbA3JC8RcbVXaWsTmsSeCqvdAvfqL+oUfeIoFH7cB5R6SXh3yn/QDlXen6JhzBvmSHsvKplCEV8ksesMdJzSZYAqfTcQT9nJ4tYAcImMnPTnkgEPQpEeq5Tz0rPqPuy9E4h1anqSM8Re4rr4vy1ubUUViI9+/tUW5CeIY4x9Cgi30rPdtJddCfd8qqN1RE6zpb5ohzfxKrcLiE8wTluKNKzu2e+RUlWe75lXdu3dSm3tPZ809Gew2doz61Ue27i6y6vPfv52nOLmo727Ge156lozyEoTFNHe25m/OzQ22Lvae3523Y/YiONP/IF57Tu/P+17nyGdecl4ox/63jl+RcctfnHnfS3I22UZy4lDSM+Ls740bsaZ7xyXJzxShpnjHR+nPFKXpwxqkDijKGtfpTijJ+gVC7yyDhjkY5Zx2waHbMFAdPpHdryjclIZkpJcHIswcmdNDh5C4qQ6BghnnZbApLRbfQ4IBm5fSOXnedQDSVJq5O+eJhyk1pmdVuTkOQW1fJDkll1PVlUcveIqORGEpVcXjoqeSRRyePjo5LHz45KHr1IVHINVo3aOVHJE8hWvaz2OoHDQ/QvxrDmQ5+FZtqGD2eiI5SneAp5IghcATtxKog+Lj9CNMJncPWCdlPaogrU14pMJqhDkhybwFz7WtwWFewrcUS40BMRNrYX7KAO0gvOpRcw/TGqPBWdPMxDWSYEeYT0KIlOHsMcm492kN5ZOjp5sBidXCOpgxECLo982Blul/90Rp2tUGDV2YDWMJSxb8rELZcxIymbrC7E2W5e3PKlTNzy5Ni45Ukmbhn288UtX057/Stp7tU091qaez3NveHEONfzpVlAc0lptv2UNMs9qGpIjDPiQxqqrc9ruNJsxZVmNyDNYvhQxHGkd1UnkWYrdIUrzTOKTpD489FcqXt/IXw2o3tt41brtA2Fa51nTEi3ODQKqS5rXEj1WeNCqoluHCmeycU8uYupbxa1PhtNY1RhpMtdGC1j1Kihja4xyjCsJLCG6lmQZj1ZW62letWIakavCkSa9bLSbOR6Z2XNkZVmi/H0SGl2gD9D6/Lfc1y4Hg1paqTZvaflIe8pabaYkWan1gE/zBQ3tdLs0CnOz5Nmi1aaHTjS7Ooy0mzFXQ7Ja5YxqBrTtqFqB/PaThrveaQ0O4c0Owc2tWIHBepVXexrGqL9RJqt0DWBaP8FIfqaAd5rCUR7Ous+Q3Rdp17l1IZOzTlFCWxVAtvXE9i+gZ8vYdh2SVlwwnjdghPGGxacMHoCTmpoQwTYmI0Nq9PCIGNswbAkaDmA7iwAuuUCOmZAi161RYkqMTO4rwrUdwTqUyBgIO6DIUV8ZMX+TQuFqpVm37IOg7cz0qxHOzTNl2aFIK40u0fDo6TZ48gyc8li2OtBEM+Qhc98y+i1g3yyDGi6SJYwT5ot5kmzq0voXLlk6YIXXUuWPsjSp9eQqXGXkWbJSrMEYihdxIYmxpaVZhGtKMTYen5iXHSJsWH6a4wRhhgakaSYBH2dIk41ATtO9UACQxsRa9rUseiuwrDoDtnopt11h/qWETCalhEwWsIIB+rxAtTLLtTXXKgzFHzbgVMkKA8clKcqZyLNDrOdu4Xs3hLS7CBHmn3TlWYHBjZDevNIaXb6LGkWAdEuZPe4fwdy3eEiT5rNg+zhiSErsoNAdgs42qINZG4QZaTZvpFmW3QXfaOFV1ek2a5Isy1AZ41aLM0iHeusPgOqk/SvWyLNtqlsR3WfjdjirJHqtCEba4IzB0DhAoBqLoCqDKCFHjFv8PefJc1Ol5Rm82pWpFmp2S5mo11qIVNXyDHSLCppm4tqLyXNLhe0zGJtCyHKjliLtlhLxVqJ2eqY5azM3aRRnnJ5hxKPlYq1UVY0r7gu75ptppE2QjSTI9b6Cy5vaS7TyfMgFw/F9b2HTIwJNiQL7eS6vHFVGpI1MqPbkPaQwPgkIVkYWcTlnZZiQ7L0BcY6WH1+l3dy4zQkq4gADXbqHrrRWeLyluAs5y3w1OUtEVnei7m8fXF5R0BqRZAaUcVEPHUofncjj+sfyMjjEvwqzqzYkuVBvMZi7Rp1qJGKtW1ay2dOOcOcUMSiaBnmlF3mhO89c06ZsybM0UaL1h5Q510PKK5/eAOKz9tX/dfwldaEb9RYFGvXqJUEFLdKLwn/TvkHyrli7Us8hFWW//GMlFCtNE64ZcTajiwKUjkmRj9nJ4tYE8KmlpmtrommsObECa+9f+OEYxiy6rFibTZOGDg/Qqz9P/auArCNXGl7wY4TJ82mmDaF2b2+/nXb2G64mDjFUPHl6Gf+f+cxQ9rm7jEzUy59zMzMzMzMzHQwn0byrh03l6bp4fbO0WqklUaj0ejTrHYlWjLfh7VzvCg8HD6sbV+UF4WHqX0hLwq3V/jda78o7EPmVvHD3/tNHxtZbwpnVXMyjo2Wc9MzY5Ylp7Xb6rR23+Wm4Pxv13uQOg/aKW4s+RzlAGeso3SVw/IerNItJFiSkMnsNGe/y4nNKBInV+NAfC7TLv5TKbD1jTZZ6h4IB8e5P8VKnOOc/7Qc5e/12h4OR0dgIeD8OKafJNYquYQOoaW5VLlqlCOrIXLOLvlacYctxdgoJi1BowQkaa2Zfzrn4eKtOD+ec7vR88IbmZiWg6Wf+khNLB8K/pBHVR4KbsQlh2Tjjy0nZdveQ5FVEiRVSTQ8PTtTjEjaVZLG2p4Lnywhvxx07z3zamQmG6/MhgIHS27mb7ZlR5pWp5um6ocC4Jhq75GRc7yb9IUbpFF62pRutSeSPvOGJ/NJzpLGgw7w470GX66uTFepYGMBFeERWXMpctOjtArCe0YJ79GIypNpnv9lJcxsUBrKmMKo4z+bJyhRwrgAp5I5JXrKnVgYQn3I5oKWhihdBG6QQm+n5ABvC/d5bBN7bA9OG+9nYJBSfpoBjMrupzmkpAic1ZRbnqG6sOcfZVmOET5F9Eqa7UBl5CR2kHqgqui05RxAk7ha8A85HEU/k2UUXxTagdPCAi9QNu8RonfcVN8y3c8pZJh59c1x7vpjap27nhqc+/h1dyJITfgOs5aCZkAPUpHj1925jl9PMUmOWJcz7FmBOJ8ErgSc5j12zuPXHyfHrz/TwvDjLhAFqhMdTJtRWMc1w7gzhyjGxVUSVyn+4z0RZYB9UT8O6rwnyXjXxSnjhWgdR6UJdQeaHKoDAfJnSnNGRbjutB7WkB1fnGSLVfx2Qux7UFd8+V/4iH0UV4cMrtLCczP3FDDi26gb1SbkaP8BLpOw+QaG/8nIAouEQo0B4syio6oVcivURzGbzvy3KqCmeU+IHNVodaGzMmdwRY9XFWHEgeiShSkVXYeIjUhgceHlCjMF1CIa6T0BN5eNK4tbWG0MbSjf0Jwo/vkqFo933VWqXwPcYYluRydM1CwCrTC86fM0vDLTPQAdxPoI5iB86z+aRFZqFgXNI0fTiNwhudro84j1wV+y6DMNEczE7OLlRwQcOncJUgx4iDuSCRNtAXfrEOqFCTnopxgVZP7PMO+o2V7wp4trV5ZoyfIAYXGDwHRcO2L4bDXOYPgw1EXsloyqiu7OHEIbPREZcAMyushvauJcuDLWjpkSyYGkNZxxWOZ7LXXLeKeZzT/nTPqBaW2mgpRfx82cctUOs3R56nJ2OJ4WMweWwl4YmfVlrOR9DnOS71ACCK1UnLw7LDvJva0sVDsqYdtBz4qEbUjYhYRtckXCtpawVLmR62KPeYrsO+HrF19SFTUwsaukutL701WgcG7G+Jr096tBQvMRVUaBV7rYqMZhQvYrAJA3888zMyqn9fH9xPLVozWD8esBiIudbOmxkev3Tgmz0e5gKfawpHRty7T55CIZ6wDxwYx6z1ZlOfKdEbsEeXCImcTGvAer74oep4s/5oJbaOmddCOXM+nrTFpaTJp2r2DSp0HS8ZUcf38kvgqjHovBMpqWCauFOcUq8c3+6kgKNoDzrw1PD8BeG9qD71uJiuKdxaILuJ0O1oJtJsEzb90jWCcwHA3DEy0MuBnvi4qFtbTKNJWcaU5cPXM2QKuZsZbyQQBr0H7U46+HsGidQvs2nu/qorVs3nwWNa+jJGZHHoSYUobaJvykEWILaflZXJ1v0Rri9csa8z7dUqSRpRs9vXtGzdWKc3QU9MEu6c5qZqYjSxJyZlSjUQ2PNZRnlx8mLuWWyLkl61V74cBB0EYrEWyAaLH6pTUiU+Z3A3GwrnjaT5laqU2GAjtLGlAT3AK0DtfYXURE1zY+6MMfuXPhX7/fb0JOMOa+b58JseXJL5PfZ0KQCeQBXgP95V0mlM1PpFL+bc2/v/7T7zBhmHLPuzm5R64++zYTSkoQUKA4M3V9+10mLPMFa2BCVRgRp5H+h7I/3/fwd/7kry9+hwnVre9/zevf8dxf+ntNyLcq+itOPHvq6OknvtOEhv74FR9bPW39da8JDf2+x9+z8k7vufRdJjT00XH8e0G/CYWONl1C3KpZTE5+4VNX7vzKD/aYUBXys2dvfeQPf3DlO01oCj913Wsu+966D+01oaF/4d/fw8xteZcJDf2Ff/ZaWlqu6jehoQ8p5j7wLhOCbgTP/WvpgWvCYOO1R2p4sOjaL1rBHa49EWyqkfgPtAl75XzaeO0nuUZb0+1IkYQCrj2hD+LAmCxpBQ3oEkLBvEeJAimmRn64b2xyEbjEc2eJJ9AlMOjUpgxvG63BWFojYzMDs1AeTJupQdlcNTXLObJZZTD8LTK+thbF19buDOBshGI958jRFmqH1fDzRQtDD75LsfTYZWzz3lwzYnHKCG9E5SGYp1bcUjaAbDH4LAJFWi/3Ki/oOk7GGF1PtmySJU1IMiFw9ZglTE/qa9ORjYcQRGAb38E6OEVYKGpyWEdNPsMB0FNKJqkKe5WhHLWi8YFdnrCAx4lLs7GnVaJw0tIGlIsy2bygvG1cDjsN2+FYa6eWIS3iVeV1cBqT6ocdsrlgbxozPNJXVqZ/vjp9RWX6t6vTl1em/7winWnLemzpErOsb1T9DHmTBYOMiIXfSBs8QzPaDi8fmFFz7ZunhTDw3wPTyiw3Q7+ayYPYlLqQYIbygjuzgv+EMD3hfVXxsr4WFcBe0Cuw7qw1G1lYIDOl5D1DFsPhkrNk2bU9GWir8VqErgxGLWXHxZ9BlMXOZkG4CvRtIycUXdSvwRkinL7KcawzqUmG5hZmKIaNECJPU/hpIfru/mffO/Hw3d/vPe0n9z/zGfj3kn5gZGdA8qe8x8qCZiZI7//Ex/EvPfCfvI2SU16GFL+eHErL3O499jGgpLFimi5jP0o903siEq7Zf/V9hv7vvXfYvWfmrGQll+q5/66ZptRZs3b9zzZW/ZRm5jf9M0FKl/Tn/v/UqC/5d4cRJDTYhnA2Bg1kU8MQI0OFlt8ccdGl59nAmaCusnlpSs2Qa1o5w42sizbyGtO+fQPMPKWmz4v/cJM2t8QqyTJqwgbeJgsPXmzOpX53CRjyBokJQxkK7LY3a7flatZ9681nfRegjhMdHupqUeE9mVmUZR1HHikRviT3mZzJHmpb2MJw+nwXhrvKC8N0YOk160Txfnef4FwXYY24s9o5J8uQud2g4pV79GI6hlApX1ve88seoGIh6hl6wY14hv5kMzcoT1UqcmLB2fceaUoYshskCX4Zpo4pKkdldZnCZiKH5wwFWi3zOT8XT09cMQYWOVgiO2qCYR5CV3RSY12r6iuA4d3idzaaDJdI5HZXnPLVtZpSqm93cTtfeK/UbgNHdbBIMWz8BLxf9+YGO8Q/7dyCd/zv4tzynv0Ivl1cYm6ZmdrNr8mB9/GHKW16mGXz6Y2nycZU7bPOZB0PN9UaKFEPuNvreBw4ADhVLm8HLm+52txrb5bUjVi2RjzeTqsEm4W4MfMpy0rP0zdYuLPxDX7xpV/YgqHxQvGWaRehrIPYIhtfodzjQEvgh+MfS/QLfC9L/6VfeOkK5Sys815U4SkUXYb4WZW1o897sdFj10f0JREfnl3pw6sezgszQC+dZYAKdwoNECJVBmiCx5EajjKGzHAmiwOYhInisTur2xzvZSjbDPIEXLtpdtuBIH45R9xurn6owdVI4EpQ6QV7+Ty8YOYpEXqt0qAVbvwpkfQG+sLnKAdVT4legXQUdR5PiY7BPL6i5lOiQc0I5lqAOGnz5kqMh+TWSPLaaHJmO4qISMR0kmXygBv4p4xHdQ5zPge/Ys57zlVZ+DynVo1F3GZmGQud8lozlFA1VPD1IAR26KRFQBbcIBBUtZq/282wJT9tnbH4h9DhX/K0eWWTvxPOjns92Tgor7HoFo3Fx5tqNkoOklmHnW/EAbvWj7cxwnLholbx+hfBd9MweHeqO+VnOEid8huVzKC6TYR7/SUIPL8ZQavvYQO1kmKq13m4xWGm15lC2Njr3A9Qp9e5mwT/J8R/kzyXyy3HJHZY0gYkZ5+kFYS4WbKQEFslC8+Sg9Baj91Y8npXFkh9Mlh6KljGKfwb51c1aQkxYfmgR/w72RYsv6Ipoe77dKJEco83Gaw4Faxk6krcQ/Wkoh5H+Q7OT020gqn8VHvy9CQkVNIzUwNfcEXWJL4FfBJKo/fvikNfXK5ooKMm9jsqjYE/aBVTXoKOwrzvCDc88cNoCjUdUl0CUFglTXXwrPJN0BvVa/wHd/EVurY49Xq8Bqq7y3uzjGvWC2M4I7jHqjQTrsE9mxJhKQkUrktD+RiK3vseNa9s71fZnvJlq2UDH2bccMaGA/iBSaW9Lh9qXP/AFMftU/bp5JmKV47fnZ/9yvGjX//g8ivHGF5TiMt7xJKkxt7DcZmRodonnwqe2lLy0xy+m8N6xLPhG8aWecPYfNdaJzaFiUsksTlM9MLEFklcGiYuCxOXS+KKMHFlmLhKElvDxNVh4hpJbAsT14aJ6yRxPZq0VVzLG3DdLteE66xc+zoPnAuBzoPrSxiQLPcZMeDDuXfgJZ6/SfU/XhiT14PwOhwkzCJ9MAKZbdDL/DICwm1BljazV5Hnui1sNYj/KLnUl7y3yGRVLiLYypdSTLANVhf6ojqIrDspZdmMv367Kd/P6VeatqhnGbBM+eK9Sksc20pYGVBb/SyCbWozdh7LefILlMSw2o6EKdvvQPhg2++suTe7C5u3soxhcDFtLh5vLqaylDAGUZm4oHvwzEMmgx5EEvjjBb2K0kc91HeyjVO6qRc/vu4mjp1s83dQJ3xMOynHNw02T/q7qMOsJde+e5q7YDcVwi0j28+eZdIeyofrMRD2Gg8xO6CwyL6mooT+QQVw/b7BhN9jnixo8W0Fm90vCgYwELoHAXKbH+T3gp54S1DY3/Grvz/j/ld/tX+GyymCmva7qcCRQSpQAdR9+iOZdbSP25Z9xeRbrl1eJU1xuwZd1FV2RU3Vh69018PCBjnKcd88D36U6Esyop6Uhe3OMZX6aQ9eqOASpLBgf41z9g5wwmyfdHAQ+Q/Ji9CEjoNk8O/7bz8z2eukhZqopCZkVFCuRPvp0GyXdnAYlf2GGaH9uJrlcg6GjPuti4qckQZZEI1GsibUommcfu/Prhs5/PodJgTxd8w1HeIcPjf20299z/K/vPxZ/Sb0u7CdSs5AhA9J+QRpP4QNtvwuI8+ni9dvAyk57qa9dEgyNYoufaXfhKGTt4sgSjoogkYbaouotjgJQutiXrSIoAIoriyQLFyxWRpQrtge3dcDmDp5rcjVyDgZb/M5Leu8eyvH+4h/PHL61OgOhtWbx52IbFRzTCIYUaRRVrCxsoKNqTNeO3RXjkGbjojzdD+N+Dmtw6OiZ3nlNmW5TiUhWC1LylFSJTDzSqhTsjuiWU6ioDw3VTUqB9ub46KW4OVqNBGfR1aZcA9zQWQqR8U07OdwAPNFrnwMkGOMBvSoAifDXP1RrkPkflTwESBcjrVErpKQ7MNtLkRsZZ4zm49mZPHmufKIUxJ//REt7aNK2ke49FFnAP0gE47xfLPEceL0EdUPEMQU2oQszKw+kjqpJLKTRpkPdo7nNSmrTQUbAAynvJFK1ccPzNZULiwph4Sgizuo3mee0f5O1f5OLZTiEmRmhkbBkNQf4SfPFXdQUphF3xjbVckMeMPlnMzkDTP5kJlReQ1/FJ3F7Q03lw5zibRR14OitQ2lHOboCEEGLKqs2ls6jIz+MB1FO4/qzt9FOy5rYkcC3qAXjVS9lBMsAYlhNMh8jokAf9LUPUk57608cYN3Vi221sF2SiIo0HYq/FcbFSjfZgw4tI8DtBF158ontoChDuoGHOa58IS8czn34IddkX9n/D6wP95kQUZZ4R8dJLxTFrcHHRCNz+rBTAwAKhDmN87EIwdJOO6IL+WJCvN3hvlTsLxDj6I8RlGeS0tVjaIMoDQLRCpGxG15OBAomGM67xUM+M1t1dR2fkjtF8J5Lot5TjnEzwYsL2KpseO2AGlFeqydCjtY2j0vCngMl6jvRUFurMmmLWpvaE5WFRh5E5zq51BJwi9wBfK5hbDgoBD2hGmiiDrZnvD8DnuAW9nAVarxweK5bYCm5RcMmpbPDZpi0BSDphg0xaApBk0NNzNoSsegKQZNs0FTw5ygqWFhoMkeuG3BJO9iw6QYJsUwKYZJMUyKYVL6dgOTYpgUwyT8x018wPk8inuyhktPPxdcOmTA0aFFBUepOcHRntngaG81OOqvCY5MCccWCRwNRsHRPgOOdpfB0e6bBBwdo703Do4O1gZHh5H/wIWAowM1wNHQjYGjYgiOBgGO9i0AHB3gqhcVHO1hmHlgHuAIoqTDFwiOhirBUXExwBEr0BFRHxm2vPOiBTPPsCOqPQyVjmCmnIZR0ptHoFCjEYhyQfBEZtIaEKXauAqiM6wQLR4H/nxqlwk/iZkQEz40gVP0RlHOSSUpVigR2+piejOf+YtIlev/tsVTOpSPwzE9no+wUauS9QgKxS4OtDWpIceofK8jC3bHKMutsw32kFb/0LTa5k+DSquppCpFoyEv3WiDOlzVuryBQAQuIPNZjBLdDByF4OAIEMMRQSucPFKGqCPnhKjPBkSV+SmvJ6GCDkmHng7LwDUF4Iq//rDumhHEagJXQbzDBriyGPD5ULog3Gonqg/jBgqohVvTZdzKGWriVnsO3Cq83jhunYOZKG5Nh7g1VYVbBRaxGJMhO3yX5WeFFT5cELUb6CoKwxHSEXOANfoIFTIOg4Jwhet97jLUMIKWjywqkt3CQ/U4JRGcoON04l/a6AQj2XCbO4BDDSRLiwNkNbMGzJrBlhUQWxvA/swMrkr8mq0cXWjfOs6xlguXDE4UvTrnjV7x+Z7Z8NWFrtAs9Jo26NWphV7TC0CvLtCrfEmiQ/XCrRG5JhYLuQKxGvQaI9cYucbINUauMXKNkeutArm6txvk2hoj14Uh11WcY+VtC7m2J5beXkFrOgatMWiNQWsMWmPQGoPWGLQuCLS6NxloXRGD1oWB1uV4jfxmAa2pOUFraqGglQWfugV7Wk9Wg9Y7VoBWmNRq1ApaBWwFZS7cimQA1z4NXHcY4Aowa4Brrwau0PvXByf2fWLZ5/c+mW8sI9UTHNnHmn4CVCDVvKiunysj1vwrJl9/7TIjuCmgtgH+HwdXhCO2JmLNqmH1BDOGqhBrHtNIRymKV1EUYNTsA9oOcgLIAyPRH+PV7wteNRi0o4xBBz4W/cnRhz8QDIqi0JLoLyhqu6cbkdMNwDcHWL4vfGCpp7oZAKs/0GAVgo3+tFQa/21wpin6A/FHCqxyDoDV3/z6bnuiPzbQ2zRY/fZfAVZhtWVeBf9+l+Hh47IzJ0CTNVRFlsavNX9kb/Qn5lQ6C1IkyExD1UtwM+Cnlg76E1nKsnj3PITxaWFEY6o8iHkNWOu67Hdv9Xsy1GcMIuYh/gxyF5vZXeP+UdpBPSf9ccBRbd+oN1xjRWBJp4Ylo7Oh1ZhOwow9XFa/4WIqsrdyGLo2AlkCSlrlKXksAmaOLADMdMwNr2R6YDGbqiM4qjNS9ejiVz2MaWq4JnyyQ/gU3H7gUwyfltaET3ekk7cw+ASWLj4mauEcXhkTAYgd5TUzDBIxSttxU6GkPo2Sdiw6StJDuUODoE6ErVAyVZIApe0hdEqq7ZcO8zZ/lJSHKuQjKAkRlvJ8UVKHoKQsjvgfoC1qYB6NgKZOA5r+/C4NmpJVAGkvbQ9hVOFsNWgajYKmxPxB0/gtHzT1XyhoikHT3lsYaBqvDZrGK0HTpQKaLtOgabwSNHFPdJbVqVMmEWa5s3zIln9C97rEjhetsruLeS5DkqNlSAJzTkk2nEG+Db6geUCUqWqIwtgkh/tk/unEHNBJ4xqbXF7GJpdfJGxiXgG5nOURXAF0YvnD50QoI1UIxTsnQuGJ+x4XH6E4NytCGQaNi/dHga+jEOWKRcYnzQafXI52X07jt258Mq7wyfhC8ckSztFUgU8uNfjkspsan7hz4hN3QfgE0nUx+99UaGMeMOPXMcyIYUYMM2KYcWEukCjMGCnDjGQlzOC0MXmbUj8KPELJ+QEO5FpkzCH0MUMfA+3mgxwjUcgxcjEhR2MMOSIdkOEcDbc0yGEvEuSAGG+Nm5zSt9ud+fEmp3iTU7zJKd7kFG9yip/SpW43O/Pb4k1OC0OvazjH6pt3Z761WDvz7cxt5CiC1gv+XFxr/Lm4+HNx8efi4s/FxZ+Lm/tzcY038+fiGuLPxc0e/PHn4hoNOErUAkeN5w2OwP8mdeT8phtYO2sAu40njIuetCu9e1rD3ekPSUYKM2PlZ3YVpr4IU38UZijTJVWYmakJUxWGMqW7MHzf7J7sZ4fJ9ixpdmZ3drSHP9mHu7KP4p48MDkPILKn7YAou3wxX8iW8V+ZkkGXVij+KwxUgF3MfSooTGdO7Oz/SE7lnCXE0stYX+7TUJJ2ip9UkGE34rxDD1DNlScHYUiQU9FIDrSdme9qIuZYLuY7R85cLhAOAj3Gi2+cb93q/MNfOa/yy9D+YRj+Xmh/za3FpOOX3LkyZLLLGGYS4Q40163AlOitFU1XszEStLm1TpzS6Zyn0+XSP9VMAu3YZLpVE0w7PCMp6XSyQuqeUJfJKhbaaUWXTrOh5nmoxZ0cON3W/+JjHFK3tm5XSNlaqdoZXUS3dnQa9Fo8tqKtZWZZD/afe55x/VHVozENzYvQfMIGKobaa9BoZQUaoXVGqzPiMDtdPUkHJTIaVzBzVkYHRs99jzuFRw+zeh+rY+YzmZUMRkrunmVS0BhofUS0heTtLJGeHNFlmFtyjv9fO4twmEFvI1OtRdr5BrqlUQ+mxWJtgxPTdGJaMuJr8Y8ejUY9asSqtLB+a7ylzSAdnch8GEsRAsOEQDAMBN/+kuvDi1HTx1cIHRdCpWaoePlUaH8oaLoraLo9tN8axt0S2q8J45aUgUiqO4Jt9FeDjWHDaArBukPE9cM09tgA4VTX6tMRM7XU860TcA/nW4NQk9V3EiuMgLPEHtKYGa4jtvMxv52XcAP8jBqnsnKuLWRWnNQy/b87+XIPIWA0SIh51FCWLDDoudmW+9z0PTJzrlj2VeIYbi4Eee9uAT8K+sGgn4yfSqa4cu2UlCpLqVRW4sGZhWi26TK9OQ5C6no7Iwq9pxaO3wNROPTBdE6wFhDKXPKFkLiWq3OSwAZ9pRcLaEnPnIplQEMP6QzJl1o+prNMV1repyuZlLQsXcVkRSq4PRP/lKdfcly0t9YN6xXre0kiOT4e7Myce07foqV3GbPJcltnJKdNlqqkwA5bMWJx3bWSS8nlM4wvvBRNeH8NIQ/BQkGA0Ifs2tawdyhDjxINw3FHX7vY5v4Mh/NrZcqPgW7MkGPNJcdAqRkQDgqP8er38er3ovqIrP0pRTkOuCI5xT6dORUKUVrTWYpDulIb1i76RSrFSEk7/DrplHQLS1vt4AccGDHLeeNM8ONkauP5gts0EtbRtXmsCN4ZY/IM/cvOPa9wSxnRh3rSBxg/klqvv7r/WOmT0VlACaJ9qOljQLBnCKdP49TDXEM4LQHimklMdGomCWGpKs4QNjIF4xgm892AUFWW4/kuJ1k1U5YqBHo2e3GMbzzEa9jHaxDf2PghzjcaPySC8UWCObhYkvIMp9tlBdzmuEQxq4bZI5O+2012RyfzeBXV+0lsF3fG0xLGPK71zpK0OWdV1HChLy6DupVU828pg7ZCH/eWzHl7rsT/Y6bg91CU48wf2kWeWct3vh1n4VO1laStwZOmtaiVKAWdUvJjDqk4V3gPWL4HrOrryvApAcNPaWFSaq16raXkrfW6pEQHPi5w4HQ7NLAcoUx1NJ36hPr8xZxZGubmUpAJZiFQK8SyK+FcCcJiztPRdUBgjHPABMP1iDheION0bcS7wiKJ58/c9kOuTPx4QaJT759nmcfYN5x+/1x1y7+JpE8Z2LwnsdR7neJa2qY9lv6FbVj6tBJ074Clfz6Jiz8JJW96KPm9IItHNCHQyLdByJsAIS94ghVCfg/HSqowcqWQJzy5L06AyHvjUQ4uDeiIQskHwYZgiPLxz75g3JwPN2FnvoFLwdPkXz9JWD8+NwxQc05THBU0kJ7uyd8DJX9D5BynIlPBPvfSduTzYpJ8Xlfu5ev/PvL8lZ2Q5832yPNmJ+T5mh5DbhhMLGAZ8NjFwF5zkf4ISz6JsO4BxLqPkwDiZplTflmsqG4umfO3OoQRswyz6fza7CrWzByrZt5fdZe/7yxqE5RiZhWGpn6SmOc70de6krXhYfgEseK/GSBC7PlAA0wyTze//N+zgSlmwgRDE16KJm34hb3vgI7jONKenpmdmd1ZAAMRICGB//965l2ATw743+MjQToAY8MU5EjnbEum0gPhIB/lCAnimbZgi/bBcubxPy0WDnTONhwJvd+BzjxHSZegTGflp6y/vqrunV3sglS6TEpAd1en6qoO1VU1jSWnHYmvK9eb8aYtibGUMs+gtNWsAbTI9Kdu0L11caTJVkRDLF3qCQWdfAZ1Xe3I/oeLVVinzZrLVDuXgfhSx9mteHUFtYu1xwW1M7VYr2UljNCDTsCzyD9HCOg8kaehZzXCuYKIx6vKighIRFgefowoxopllXyPNxCKgyietHp5V+TOqGm6Ok7zX0F/U+Nvn9e8FX/7fNbTHqbxHoTU6JBWIiBjPKUGcU7Ngi3OBVyGBP1JrNYlhRTGFxHJEbuZZ/b1isTb1+LPFns4f75NxWCkhHUhypedyXyRhVTtPd7BgexR9mEHB5WU016yNGuU4to70TsrKzMW5+9+ZH46pphBUzAsb/bmqAVIMOOXnXv5LYdu/NaW7RR/lzv08L+6UD/xtNe8BreeaItzQMHuMJCVKddqg2sUO1/RDyvtPcd59eN0NJhV6vPSKf87vYtGQJX2fhD/Lhut67JuIswg2PpZQ4s/kz3Al/Minsoi0MEFHT6pZKA6/pT2PyWE81GD6R2zgEDpYc3R5Ndvg1jqo9kTIX5AsiVB8jzEhjg2/bWL6xj/KdJWDNrq+ETv+ckFu0Wk9XQLm8KjsukgkT9s4ZEmycKM/Kuj9bqwKLkUyC1g4M+XPzx+/Zcaf3h8zvyh8W+zc6ADJh/m3I67sHep5OVqizQSS4OLX7YNShOzSHdqIuuiRm6zjWx0a1LQaqluG6VroYA0lXQ/JHF0J13wX0SfQxR7vQJvtSuDSA5iaeVEq/cguciGTQV9gMwG/COaoACXX6SJk3WP85z58Y/z7Zis3Y3ZlozVQcx6TUeLdQP7s7H69lTF2tOEz/NyHob2heNuY5INjNVzAi0jtw7+R/jlnPdVk/+YsXpt/BFPWP+7KzeeMMpF5361a5b4U0x0XURPG2zA58Z0Ed0+eJebKQg0E4Oawtx50mBy+dtko6DF/1ztgWrPocDhP9bfTOIJWc1jEoxIMCx/1/+wopCqXI3Qyy/waLbdLPERil4v0WGK/l6in1QUX5b4kkPxf5L4ZwG/VOIHAf+FxH+J+CGJ/xrxH0l8Dj0dlPgBhTku8UMosyTbQVoW5KqcM4saD+foMgoNFX39WQNL3UB9fYHiAEcvRbSPo3vQVFL0FxWo+hz9lex55cau932+iJb5D8fj3NjjZaweoExa5Q7gwxolT6QrHSDYHx9Bm7IcD7J3TzaxfIHKxFLogJJC0RNtSd+cWSDAEG1OKW7cQMeBNFBnfxkHojVVgsIyEms0HSANGSuPknfsAs6OEFuXkytp50Fq94UkzAg02Ysysvch5wKIOX/HMANNrpASRIN3iviTJ9KyriS/3L0i78dK+Y1LoLfDakB10HIyBaueTOfQlpeVG5te0PFsCrBzIqAGBrIwB2FCJNZvHZSqvg5Qy8lHGpVK0hhq0S4MuQY1JrQypNZ+8nWMAVccS8V4QikSXey5r1XyAxY+PY1zB20kPwSgq4koniGK0soSRXvx5b6PM1+RKFRcYJT0YiQjlhtyhXnXmCYsozsiZ8jciDArPJo4klG1AojZnpTZHH+PrSFzUaSPaiAcoLCOyHqKJH+QEwzpRPtbHCDsYtGofP1k8kfkSpNyPmnCLfnRhQ1ocj3XL5nUDZzyTOpGTgUktWO7k/PFbsOZi+gyR3HP8J88aK34Q2N1E3vaWA01+fTJSrQtFzIBkjWTrD2mXmcAH+4yclk/Bc4/FoZdDAmxVoP8J0vY0IHAHk7i7Zk7mIWybF2zDIdZHI3H953jzD7m6k3nMTPCi3VpnkSvc94zOnndo36gTxONLZBcSEvClA3MFEifJblLlhr487FjhiAQam6BGGq5nIKH9n4J3I4oDjmD9Vr8eZeuxTwZUtfOCxoyTxkRVW3jjb0owlRzJ+Atw+eGuUQnBG6ZMkym5CegIacNXFN4GiqD7sRGH3CXNmytFjI1ftfHbvjZU1++bVQX0dMGx8/gf9fSmUxkPjpeQMM0XYg4maK6rbgOoW/FTEXlQjYoGqTd1PY0OAEJ3Y8/36pKaBG6cURQPzz4kVTWkFkpaUl7HQUlvltBG0Ve4+dMaS+5DWuA8UMLqOpLQyU50tCXvaMj1jcp12cfDfDO8lMeg1coG37sBYr2EPzQtcTuI8MtitsTvUMqC5qEGkXjxi+649SYIEyJqSwUMUe/rOY+/rQup7hnRZjkcuEJzcYn+kKtWPRpzHwdijhdfmVW+RSuksm5X+U7FvS6ujy1g4EDBIx1XK9dDLG4UZmsbtW6jnV1QQf0K7kD5LJTndWvMNJFWfzBBvDUruYCyE6yaku2RkdQ6NZrWOc+RCM+K7HpQwlKRsTIqqTCHMdRE0nEtgfVqpkMUcshWiJm6YDPUCT+bDL/2B4co4DzKSpUkqx37SrOUYGbY5T+s6fClYHvzag3gZnF9U94ibasADe75GzCLaokJyjJ0ApxLPHgSFeGD1GxfD8OvOLo5K1HJK9TKFJThC5yk19fKPjPzrqiwMhIjbMbnQaA8bm9x6OEg+RdMauYcT2VVuRCASgky9tcXepwFYhomRymLAior5eSr6ZmAAYyipojlJvl1vOV5Lt7lJTfRoGGPMvBmAQjEgxTcAmVGTKhlirPlxHSb22lrzfw3JrzzGVTQLRBSbRGu0w5VyJcy6Vj/MePnjnj72u3jtpzaIwWlpsrGbxsNtKNTAEByxGsxrfsGb7ynW944uPkgutqtwHZbvt0zHl8gi7htr8PZN3nmWNYWi7OiyD5kwHvgW4ZOz50dKdkAYLTshAHT0B6DC0xaDQpYG2OQ0ZCrbBNREDHoQWhRH8TU5CgYKxD1up4XGqzZ1uwtWmFN9UOpLaytRXXhmchFp80gJUYiAYJBg7I6OBGcqUMgxLXO5MN6L82oMtN0GsYKoQ9sEtIRcndniwIyZhDBuIN+e3/KNVJgUPMg6B2qINyZsmPYdNnxQyHHv2UzlPT7fp/OS3EymYVBgk17ZNfRUnsRRREWfgM3nasC2RW/ijpHNIKG1TTmILg3JTXMRVxYD+CXa8bQZL2IBhIE8K+Fxc4WD1mFYUxlgeFVdhYPB1iMXFwlgBPkTLPlyrbJDUheWNSckTyhgU4JEW0AAekiJhmPUymXvF5giKkp9WaT4b87hZTftbHDgByudJSh0wr/edmawm6FnV0WXMyoaSx4nbBrA0HABj/oZURVz1doQh1pKapnz42+uteMKxXs5+MXGMxQI+V/M9uSMnrCPIJMEqOdHPVS3CHFWhUQH0NYXSdDNWjEyL5Ck8OcA2/qBbFwNp8CeoIy67k5yjWYtr4C6cogoPfFkVlCNnJL1Hl6MV+xcX+pfAxKa3wMSnfRx8TX3xMlvS/sYtJJNDrI+NiEhkXEwO/1JQ7ZOAHI3Exif4DXUxc62LiPuQuJnRRh+RhpI1+KCLaXUy+7TS7mCDZ0cWkcj9cTH7xIFxMHrPCw0TGQMj74mEyPZnRL/EwwYDgYYLwyB4mZj4sS4h5wPClqNnDJGr2MJEZIzMFHiYmXDTwz5qW9puWagb+AVNuzsBnTbnzI+thEj1ID5PoIfIwwXxbi52LIhmdrse3eJiUV/UwKZOHSdDJwwQzOSMW3e24wyQwDWuJa4prE08onpg4W9gwJdZiNhxvGtDE/Um99sE4okTGESUyjijR0RxRPgbbeuGEknqrWtXdJqv6krOaVT04ulWd4B5qUgyUjlGTm6TIEOqiKzP1qRJqijU9zhO0VkFrlUZrZVpAFcbDowaEuNyKIEmVqQVKWPu5u6r9PDmi/Tzedf/see6RbYoYnQsGtZsU/VVNirsfOhTksz/BoZNN0f9valP8aFDC7T2kn8bF77PlJk1pvi+Y1NA1vku+PtF0zasF+L0vyMIdeflkoGC+arl9tE4L0LNDGqthOub7AyhNsUKgFIoRRPDtMfIlyNMNthgXqID1ww5cDuy4PEr0ZIlNulZftUy3o15wcL4JcNz4b+L0urvv/RPFvXnC/CJgblSwtIl5NQuzeDYiPLo5GhfCWS8rbR2Emg3UxM/JtK2K7N4HPLW32dsfUCgY95GslIU0MQhF6Y0SISXmP0hGP5SDDkETJAJkMRDS0LhlV6mgfI+GRqaHR7k96xlMSzxBKUI0wJwMzepHLwTrw1Ts02sAgx9YF4FxWOqIJIvjajRYIkK9wZK3jS3c5aFKuLhQu4sGmLu5z45cNLbSa3NcwXfqcGox82qYLLbeIWIsFswajBtY627dC9mFTE04J+o1XaWehawySfaXsxBLMsSLRyUgFhG+Mbjdg4CIKE3x4LtwfeERYgBMtfHfP2Pxf7/ld/9ARlTSAF7fz1SpFeawGs1obzMoiq0Ks+XVRHymwxpQao3ZQaAmSzDmnpVz1zvHeFDLNN/o7hee2LtbQEvBytFvd13cwSALNzxcXNyJeKkPpL5WdMF3tVa4AAxQ4EEkVbnDamyU1ZyN4usBc6EQ0NrlElL74VJ+iMu7DweAyw8B5koJl0ugvRHpe8z2PSF9j0nfI9LWuPQ9wdkoPg4Y9z0hbY1L7WdL+W3S97MB4PLbAHOlhMsl4p8pFd1HP6Nlp9nRqB/+Kf8s3jbG30i8zkMdFo5HqCSeRxE0LtbzqF8cjyrseBQm/9LidZRcJmoPscYZV6HkXxnooiMkl5u8gNxWL6D4topfmlbsBFHsyFj72LexHP0mI7+jYeEV7Xbe8+RmhaVHEPfkLtXYUlKvsJ8Esm3QHt2sSSf8S6fzcZy88x2ES6Glly2tpkuSUSft/PiXvnXawRvO/AMp4J/D/7402mhJ9P6ZN75u6pK1U5ecMVpo7Mf2Li2Mn1BT9P+TRmv1+fq8Li3UUi+W7OW30C1BOoF940+b77jn8Y+8lnr25jNpQwqdNphchEJcVOjja78G3cJ2a3oIFpLf8cUwTPi+a5u7lZqjVUo9h3ullb3JHhSYp+oe6LJ9sAWhTh3D2IQcKJL5VCTCgQuYYsRz3ByBEGQVgyPJRyyYRalqZWwrQ5VlqGpjqPovytDK/WVlWbiIUJctF4N2LgbMxeDBczFkykPNh9Uea8tEl+hFqTRCsUiTNzh40IG3HvilXqudyf9M3D3GXa10xPzN4sGMnR81RZiP6sk4c3nFpkTEYzvvsZ332No8tvP+e3P32M7b7kl+5gNxgL+izQF+2WnygKdUmwv8K9hDBDdk0ZiIB6xsLbgH7shrM6+Qil5yJdq3X1JAteNGm9AKbpBUU7z/lXj/s9NQJIGPAFgNNxzu/eQqNHY0B/vCob6/xZ8eGBmH+m1syUMPW3kd+awV9LQv9xC5haSURgjPItxEuYxKbkd7WnGOkpw4frRypUG5QqFV0BdGQlCECDKZuaaqqxVX0g4PN36R8mfEnoibH3WHy5p8TpqxfZsZgZzgYS5nlVg/AQsh5wa2AqegXsq8fID7+Iqrogf+ScnqV7yBthte27clYXJd6xXvaiSP+DFJ2PwxSWg/JgmP/DFJ0PiYJGz7mCREOQ58BJyXHG66RgZtH5P8Rq63T1IemOKyVYaKMEdFCSgTHd5E2oMSIvnmbswpYTjxFEp3Ik5KyMAy88C+S/nt/f0upXmZ/A6VH/LvUGThF5PJFZoV094jIpEifCcvJxe8Y4zdvGo1Mn6+E0afF2NuYrLnZ1lTOZYfM7W40n9CKWW7W3IKZxbViZRQMLG7wwAF7mb4cfDXh/DmRUy8eRETb15FDoH9qQsIKdkHqIEI02YzPD6gGBzGZAeH5+vicfNHnr3o3aG+oD9ivZtF9s1uqWRcqbwZIb0W0juw5qYuHG4qk2yRkN3Gp5V2mPZIgHOHouzyghXoL2LR0XT2U3aNONyflXFi85Fe2iHmQ12B3qtWhwUjjXWYVnUESyzclkSJWKWgPg81YJyL5QRBVXehjy6tngomcPNpGUq0CPBokftYXMDZHcJlN2UHrHoKy4jU8RiMbQ0hqKRkF7xOeWraJzLI9xFKG+lg6W+s3tIhzSSc+hpqyYbfO7S6fwtSjv/4R/h382idNJyTOf0/fXbyQ/ab8o33RSEIeAvAA3rpkmwQgaiLQtkR3EJeEVuBz7pJdiDJcM4q4i4A0XwW1WsEiOoEj5I/id2zkF3YKWWGBsAD/b+VyBduv0nNKPqJ39Tk0RE077LaqlG9nSRs5Ycrxu5k3noMdXlHs1hVoV2gKaUj4S0jX6kza2tsino9cRRMBlJVWUIBzXfN7s66ArZHfIpFxmClQy4lOw5cnaOujt9YpN2EguCLBidJLZv2SNshOgsb77EkWoHyvQiIwNqnZ6mO0x79XoMRdmi8m2doLyOZxfLiTp9O0n6735OJHRJP0+MyZNnsERqgHNVeq/spR8dAAfn9lhhCCqNI79P9VK765oPff8Xwy64etSHabHufilrJ1rY/MAXwOoDHYBo5YENBS3POKSec+sVD37RhkfPXr/Ye+fbjF75uQ+SgNc3/USrjMfTjP0F0+pc/feGWy655rA0Z0d/tO/Ht117zwm/ZkNpg+Ln3fO55V/2v7z3Ohhb+y1MvOb6m/uqADS38I7clvb29u0ZtaOEns2D9nQM2FLhg2t943uuADZHX9soWRtyvVw7nFyOz3/rNHfu/aUOu+u3PffGbf//H9HE2tGh86pn7zn/6eRd9y4YWPtf/QxrGHY+zoYW/7hmQ+p97wIYW/hQexodHbVgMZ0ATf5WZhTbMjr/7ae1zlDjzK5WdcPczs8EOmev1IF4So9ZcA7IhFX+aRt27n2kmbpfupmk4QBxHa+v0er2O6+rj7/6J0m3Fu2lVuFinEawazZsAPt3OFW8Cge7mxzIr4pNH4LNpKb3G7ApVtvdTcYpgd+ANXpewcTgwwdQ206/VGu6ihuVUuV+t3kat0i8dNDkt7VWumgmmZavBqvSatzi/iJaw1SjZGrGIcea6tRajahGNGM2orsN5mEzkg5aINn4lVSOcmLpcy3BsetKt+Lz4uFBqB+OJ31pIFfB2Du1XE6s4Yof80TcFDpy9QogWmgKSGx9OQZg/nKUJxDTFBhBj7wjUVSIEQfJMbuQDJWz4A8efDAJruUW4uu32mO32mO22X8bdYrvtewC2W7wi0mq07W812mL4c2szF+Hs2mwt7Vbu9kHzycT3R+tWXttwJPNtH4jV95Cab7fSCv1KIY0lN8pNoB1EwB1t0PpCcuE70Exu7v05WlW45dxirZmi0FDJrQBkrIAQKyMCrYiSuLSudmuS9opbE1cwt6afYjf0pptuMr5Z4T62k2EKFC4sPiY12YPRHX8I5PO7ExT4cpFBTC4yHJOLjMMXmRLC5f40QE7jQqOS97BaKZQxzPMEd5O3A9gkQzeipw7W63B20169XquzBiK5Td518ZvuOlf9FxHzrYQfrJDweQEntx9ZxP+u53k4wzrcQI0ALdtR4HGqStPVwx6EvSHCxgGooxlAS6UsrMgq2mcc6vU0bnSNY0u4Us+q87pa4FS/OI34GPUbsJfTzGhcC+epwTKPjWYM4a+r/OJPnNyB0eF0pYK81Rd1anI7LlO5rnpWoeSwJOf59ov2KKa5SpliuFFXOJYgd28mRaNGUZChmx9C1bQ58cYLR76QT2jZYXkjxx4rm01mHiaiD3e6dI8AykCBABXMfYwE+NmRxLzNZKHZVLqR6OYENhBMuYB5IjtK88V8WakGD5cLHuoSFt3zKaA1pkVnsE2u/hMU4LP0fvz+aj8eFcCLCCex9uB78E7Y0FAkDHPsIIAP5+ghRIfMqlRGvTDE7+Eg+1LHaiQe5mo4O/OKnM/cQu0+1vRxBq1HMItXr9FD3Fl8H2JG+BWXlmMw4/67LkdWBfbJckxkOVZlOYL1vDjLbYvTM4uzzAtS2K60V89iuZZXaDrXCSWIloqXbV1u4pg+8tGqrb7X1j9a1bjZApF6zUt8o5wGhZbMKNNEndVQllEVh1VtULNSvZdDywanmry8c5KlV/KcB2hiCsnwbPZUhLuVI9pfDU2xcZL0sEYU/Wqk/UlghRmbOfn5/kkPWGX45j33U2W446h6fFHHZl6ye89DqMV/y577oJ7c0qRR961GPSo06mdBoX7BnhaFuozsgWg2n7qqQeCt6EJecqIkBa3mAEEBTTVZA7asbg1YHXcxBvy1I+5cFPCsE3cuAfDqAsyVEq4pgVRVyvdJqSr4wLEE1xZZrMjlKlUJEgn64pOUalfrAjPCmbvDvnOPtV1Yla5AmhW2fY6wEXzKneRtewB8glBWVOieMTx45EOn6dfQJH4P4NefTe7IX3+2dmnlCMsdSxk3DvFn4pac+LlKtRszMHAeLkV8xtfGfMaEE8keICPRd0i0wPu9ysUXWjK9XaAqdLYz2SEGpB7gDU54FPBCRB3eORwWFVMYYBl/AcgCoTEgiY1USXkFOprA74llyQGEmJnGL1ZWkyxPOTC3hTaqsV7NY2WyYKVJRwiNJmU0yTcuYE7x9dphoq7k1d/+Z+LVRQWv3v0/jlc/Oyqv3vufiVcfKHj1wf9xvLqinVe3KuV2oqV28AIi0xN7598VR+DOzGU00M3r8WWdk9SYfJJ9VlP2VHM2t/lPjrRZ7MeAHuoIfUwn4HABpDPTAHWnkn1tJRucLo5rUM5QUc51N9mFoUqG5LZKVw9Q2Lm4TdjxdxbCDhIrhJ1Hd3q3L3/12Tse6JN9R77036GUelPHR6ygV9z/rr/hZ6oQ/0BTfLYpftsc4p/imYR1iv7fj9QJ8kzWpVK2+RP3QwBJ7kGJYm4vFdFvFNFFjn56tebd5aLoYY5+plPRz3YAsqyHd1mWbqUvUlPFjUgCZMO1GQksoDpvZfG9qpMEIoVFEPmFajUlC/RgE/SnZvf5tsIe+SGTWipSXOOLRY1Cosn3d4Tu6wid6wjd3RF6m7MSqvKrlZlXzZJT4uTfBkksrvGJmK2yyckUbjwl4yZLKEEUsetn1i2od0g1aZewUkDlj6BCiq5lcopiOlfJRznDLXjl5dRBwSuv4JVneKV9S8UfKerhR8qODPD9q8D3rQKfWwW+uzMc9GyH05gbHgM9gYJJ9ryIjLIVIiBqZDSo/CBb191805PzS3iq7sdoYMx3ktTnUMOS8DBnOA20ZNAiJKijg03OMAUlSmoKfQoT5k3+ow986fP+1vzyNxctYlvJ1db8k60wvKuV+yfnf3hrC7jaGZzku3QbcD3Kum3g4c7gKvc6lRN6K3L68vMm8562Cn1piGAAzbV3PpBGCDRyh9tydVqWR5NeN5lfEbZl/1laQTCEyklb7lAqjyh17vjhKY9kQ/7YtqwN/HGod3auWsfo5rMz0A6NndzG6xHD64m0xOHz0x7D7LOIq2dRvIfC5xtuTxhukwIGUz5NKNxPYS+F+yg8zvh2rKFwN4V9+Qgs2Xwx7McF/xvZ2hx/2ik8G8Gd4ZO6lO7Pb3ZOStfZz6DXsShmi2EfvSucaB5O7qBNPNW2jQ3WL6U1idSLOXWKSZ3SkneWpNL+WBZNOqD7W0jUnbuvZX8Psjfo8lTW//RmUsEskHxylyHz6/GxONUnQSVqKQZ3FHS4Tg/oiH20crLWExSVsn4E08YnSPdjucgYs3VmlGTZX1fQBfSgSuINhBbxHfPaVqx1tCPrB+pxK759Oi7w3a1AXR0D4YGVCA8IwsfrgQbCuYKdSWoK1rMqi4+AttcB7ZjRRrv4tt5biTaBd2QeMK+wNwbRnJxv2+i+ppnuczC2ekL4/pXj6Mc4Yk0D5XFoBQGf05N4tlLqy2jeox4oE1qpT53soGoYQ15qQ/24ZtT3KTRL5fqmVkF9rVYW9Sr8WSOkGXVBfp9BvqYyIAM+kfj3EI4hwszvahtGb/Mw9sswwIGjD6MV//0G/0/+W+FPW18b8kkz8l9sQr6yEvmKRb7CyAvWqCNYLz6kWKObSR1vzT/SBCO1deCFdEyXilf+C+W8w/sWcJMzXLax5BDLK4FstyInGFgoW7HIFAYWyTYt8oeBlWULF1nFwCqyvYtcY2AxwZwtzrLSnUT4Kl1NDlGWRmRJyfUzIX9YXBbxQxbdLsCirPuVWQ9caSmxPkvE8ap3SlvYMH49nGaiSfelsEKT0m6cgt6NbDbp2eg+Rp60GuFXqNwX6xJ2+ZERdwKxh7mP2eQ+hWIB+wM/m2LUkt7oPh8xVgaeRrFusVt4uvuVYrdwEYPZgp/rDM3Iu6WrneJEOy1NJLiacuzPxJU24q7YBMSxKhAhS8eLiSCJoDc14mpB79WbSDT4hRU+S+QzwX+XMvkid9hFCbnTQ1rXXSIBAygxd4wt1zIvoUoFfjIUMw4ehHzhKu+BoXkMmvF4yoi7TfAY38QEU/xpLihbYdxfLCPbQM+YtWKZOwZFVaD4bUyUlShithykjJ7kHziDpHOk8mAn1PrJTbDMCwd8oGZEV/lrcmbGF2+s0kLju+Zn+fRf/OWuWZraKGOfens4Kw66HFteq9XLxhc0X61arF/CNHCxIf9nim1MOd8PxIK5pHCdn8gcJHZOaWcKkddPZQpWDpSBZ0jycUbAtqP95BNCoeKK890wILXLuXCX9Kfdcw1KuuGBk/OClUUnu9GPFH4fVFmZuP4E596Zk0ismXmCdslGCMY+P4th6nzJoDxExH+CIoIDlRK/eJR5Nr+Z0TfZ+TFpfpLjzya1jSaTujKCGG5OscSiScwzebtDNEFRvoEPLAhwio+vrNqK7458wyvEEgmKKF1GSFPrkyCKxDMlVTLPVKqiUsY2pTQqTGbd4ivKQkQZptMaO4phnMZYxKJhWimq9JgqPVrZKj2tVcxfrqhiNfUUZr1u3d1IkCE2WWAKfn1eV76e9da53UgeOmnCj3FTq+BGWUUrvXXds5B1N+yc9MK7K93zv9OQ7G44E52BZBXEJqtar+5eoPc9+qB0YaqLr7KxtwiV8QCKrrI3FjalEfHGKjNfyiDxjtw9JzPeXGUsRXhtredHvBAbwF2dY31W26lDLNZPCdd4LZSTT3OqnHxG9iYLxxpBP1gjagoRrBErj6fHITgtXYOMDylmj0+z+fxR9ngt013hPRdllffSlAN0Jo1xSBcy/XE8/VCKZnzlPe9NYeSWGRqA4siyE7d458X8feQAQSCOeMp+QoRlBqe1thee83/efcTd5/95Kmx6YqdQ1ggtvk0zmkf9COoAj7qrouXrIIPkH0H7UnRw9W60K+tio/sUinrMzwnEmJ9eg58+HZUAs55Fu/mP5IVuRA8i2sfRbyOawDdGlDHCUsYh9eSKWjJCU2A4yjefEImJ1EewM40Eqc8apHwdTQlSofb/P3vfGd/GseQ5M5jBjAhIgkRaCRRR3SRBiqAEkIBEKtgSJIsy1/lysN9eDiDOZ2tfDpYvpxcp6tKXyzmfNu8Ll3POOacvl/Odee/qX9UNDEBQfnGz9CO6p2emuyt0dXVVdU9f+oFpBy7uIqbsiBJM2eIy60zoeoDpK9d1mGJXJdeRGALkEGOwgJxYbwk5PYR8VuGaCK3goEIMoEL7R3RZnP/C0qkjpx+En8CJoWIw+QSOk1YCVvBT7tsCdLvaW/ILOVFgyYTBh4N69MjD+N2SN1L/NJtIqTzVUxz21XqdCqwZr9NlgGbdd1WNlHORZOnP4wLjPHzOHOUk3obMg7DRcwr1m1SIeeFBlEowwjG+mtIrjCON7M3/iTiPEZcW00mcM3YSsugIv1Likoymtpgt+Q7W8KgBCgVeiPWFB/yC222nkpLbw4GFlLzBU7qZLofabTvDQRK8hk9pRoA5xf09Lbu4TkNq2TPwe/CScCUqm3PEV4GpokL8x2V8LArCqEQzEHVn6UTfzHINZ+X2DCPCnueGqzTLveSSlLMzPb56WQTCqW3AcG5/2swBEfSUqQEUPZCL5ujk/muMiF8V7v+ecP//hPvP7r80AU8vCaZOAvCTHmE1IKzGwHOVZxFHD2RxenbH1Cils+6Yuyqd5b44BNI5OsnxGY/fJ5/pfCuPTUEyV/pAKy0B8FVbBcicawHqswz1GYZQwT07Au7ZPLgTAFUwy+HYv/35/V8R7v+u8GuC+oxCXQDUZxTqMwOoz3CXPNQn9Wju9wIaH1oFkUN4MYbUnRVwK3S2j4efRMk4DN6bhtkh0MSehq4xsPv7AQKXxwpdrNB5SjbDyZSMDqFkeICSsz+4KBl9wygZKSWDSZQ8nqMkTQIQv3aOaP8OzU1QSM3+vwnJ7HcZqifBWnlvOktXhKr27Cilz3oyn1zhvljRMPbk96cq7CzXLZ17vTqCg/gQwgc/2AkffoMID6BPQ+U8rRYOinITgp3umXmdx6qMhgWud54WZCKcpZBzmAu4fkxgaMbUBpNAPJwEagjq7vdwiqZg83z+lLlFfrbKNOUjue1J5NCXp+RyBshN6TzbE93Uyt0HNaCpoylpU82eJ3sMramVPJA1mCvPCKyWmWRbjuL8brNYolk6i3WdP41/USLSz1O1Z85jWsBnYu85wVajinT81Ht1/Mxox0/7jgMmR5tT6AvnTiLefRwACCb0flwgMY8ZpjJq5s02AsTMVwNEJEAcBxAaaA9ADgIxI72uISecoDApEGeH2Lcn5YRW4uSkDCxjC7c0cy4Py0rEBaXRMYaht2ss1dAAE0dgsd+nsMwchOUsYDlLpxn804AFbLqAdxe8Ia5I0w4oKpvqJMDKDJiNlbHK46ApAeSpuMeFdHLHzrLEwyjH5Vk8GO9ADfLziEBDs1xkzzNIB+WcmcPA07lt/w+GZu7g+J3D//2j2ZGpUvnoseM8Pgr446etuxUnxRRFuVv7Ve4s4+m8DPuUHE8VFOdU6/FdxbZneOAXtP8uIPipSQiuEq+nmGuRjOCZjqOm41QBD1b8EdKJIP09zgn/7k8ePCf810VRzMaRiR9z2cNO8jBvYBCNuoA1AApUA7+BQhZWGoeqJ9j58B1Z2s5IbtZ/qUgDOb4TfRlYrGOkv13dBbq5vfwLsON+RZdHWPloSCvDTgEmkOKmC9EoUvKtsl9fSvHKrLimJEvfCorIR6T+H0fM/LEvs6kufypnWUIrIWljIUg4/ErFf0jjhBFT5cUKOvD50ISD7kb57ka+u2pFjZBkJvFDr6hJGmnvmSHGHHPadZPKotwUsbxOGTis5SRBXyO3oj7Y5YEdICOmTvIBe0ROXemGbtt2CJ8JMxcMmbYsvpvuT8PhtiWOBTXHOGFWPc7JzwI3ySGLJ7qRiMFpDF6p5AT4KeL1xlHUgqOn+W+7ak7RCR7D5jSVAPkZJJlI4nMYzu+3VX6uiq2FzjT9siwzzvPf3AT0YAavSAM4VrhG52iaCv0eLmK4o/C3XSUe2+Reojm0IpWPtGJc3VQ1VgAwMDdhLErI8zGXi4hAJyoq88zv8hspzVMkRhGTuhDpIQke+H1GLDIwmi0GkqVT3gV3mubQXVvoYaPeI+kFKYTvs1EV5DxDhZ5QWm9q4TmM5XM8Ib0tEwSunqI5VD5HJ7TyaRROu5nHbwAr6z09yJeOyBV8o0xTBpGhkEZewxKWqc1FOqo5w6A8xs2be9w+3jkC4ObkrBn0AvHCcybSIyHtnLBQDbQ5hkdqcgoFCANLX4S72NAmEzEJwmWpTjw3GYOnZ4zlWxGdMgW5bRkLue7hkYyLKEEqp3MY+aAhRUxgFuh4GB31FIlxgwnufD50HGd1E4qIjmnhHAPET84pTsQboX6Rwo5GiIlUAceII6o0K76fyt/B4GcT828Xw1DWkwC895CrX5ogV391FIYTN390I4hPf2BEV6yCye1fxDcriKUW30emLobY3fhjLLU21WLeUXfDKl9FghNC7kIUs6NDXQXP4QlxMoi3TE8lkRh/5mARIxx+8xg91tZ/HD8fshcn74CIDzggfpJGCeUcEH8vwEPuiiJxZiAoEB6GsW0ifzsME6BPzHNA2N/7JT5gxa1lNH6dYjmXSUoiFmeYlVngbeMOLiuagzcbmE683lPEmEtB7ZA44aEHazHecadYa8SgCf18n6HmTDZUUpEXabIX2KRov6RflRjdI5FyYtOBzVdow2dOpMMTblrDr2lIUGlrI2oh588u17w7uzwYdgx5sTBuSpgkhfzj3GGx3sMpqlqnnMQaKBMnwLfkY1tk8mg+sCkIGgCsPsp/luTTPr6TE4izrVj5I78coXL+hUTat8U34HhzFTIC38DbHyZshaz1uj/tLTX9fVxjSbvsZUJUE1/9enjQdXit2qLQF19QFK/ob+f0iFQRcrsIO0C33wmlGbB6H9e/NOR+KefJyat/23laVf9I8P4VzoGhtfq9sMeP/Snv/fq8fJjcxV9IxT1uDx/h0UJVwqCjiIJimemf5yfez9/j1O9wJn0K1MEEy3nl7whHp+5hdytxd9XJzXXK3aLe1ac+LCjv21TmXz12HLw6w0gQnkrk+4+ABh8oTyu/AoNAzjDx+ZSmZIKv/F30QT+susolqxhUWhKNleDUFkEsFTWnXVATIhUGcqUbK4rdsU7anRkkYG3Oz2rRmYkPUu7BZS1aGO8rAB7vLsAfLwTXmURjmVPnvgS5KVVOk080hYiSENcocC+uzP8NzAvCQUICGavKva9Yt097eMMkoizuRYOww6Dy99BR0KCoHf/7uEYWcuzP4GI4w1Nh+Pksll+FYWT1Z/NhjhC0+Mjlv/mXv/z/psBJrNLdb5+dGFnc0uOybunrz1Ls5fQqxaAv6f0Zvo8bzBl/jANsxVUqMthww7IdSPAkmvOmsHs8rqnr8NLevICX8KUlCAtkfyWyPw5ZDXqEpzpBfGPgnBQjDepnrTRFlZDP+NuuYkQr3B+GbIYYQZ0z2j1kM0iOCb3jV97Md06+ntSX7H9D9uchq5GXP0uy7yL705DViPbXtPcTYfqkwhRRpDA5V0ScOyvi90ZRxtr9hHmdi/RgMJUBnLxfxhWro7gR4172Bg620Tl/qk/ZG3KOJcsBVXEwSvgNrThTnQhrBkoRgVXu9yjD7wo+4Pz5AyuCEpX2KIZX2X+Qu/Jd6P/u50yJ0CuTuLZwCT0m4WqpoEpThl/10TlvpXYGi04BxhQ9GCbzX5XgGhiMIiDZVq3SFGjKby74W8WpIq+GEsZXyH9HJS18ggpuJRSrCFShyXKwWwa6QgYzQhaO2ZUog773x3b599atR1adjN7XWMU1vJKavF61Jb3xflOGkrVjjmKs9s0xckJZDhTgpCLP8aol8GaPaUeAsiyusCDnr8q9y74/7hry/03yATo20+sbLCwqEPEzO31zCnJH8XW6x9QGhH17pgdimbMqlug063MM2jG+tcN6+1FOxXbDBj4zS6dhiOIrYSOagRJffEn4ADb15H43eE6vEGHjbsD87fTvuS7+ZKU4GptZNeo/1/9S+ayrHBWHdJ51dK0dViX5+iRjPcbJTj5HMVsgLfEtLMKI275nauLZNYZLLJ4k7gBxB2RN9PnRPti5qrGjr8noIel6AHZGKc3TPK+gplASmHkiJAswZsnRr+fx8Az6d4IWaP6hrkTsIi3uKf2/yD7pReUPJOCPXXOiRAY3b/FDu8bgzV1xYKPJ3YcAk/EDjV9e4dZrd9EG7Mq1qkVX5HF+koz2VbtpSgKK1v7H4A6naf4/xfEd05QwtU1CszBYzhKb7sAG5+k0Vmpi4Z2hc3QKy7cCVXFUYrVH5RcwaOAZgT+P9KMrdy689pmn92h6j07c+cyf+MDTe7ulv/abw2Pn3ZA6zh7RyIWp8ED7WPlB6q0yvznNaZcqlzAL6hqoCNVERVL6hsmIi/vEucRZR1L/SVKTqg34CGiMApvyJWV9nMEWQypTBMGBmqZuP9jA5xinSERgJP7mT0Z8HVHC2V8Z4cYZKy/OWIxw5F6wRcqoyPPvUZLKE4zXQDZo64DAU6ugPqe4UOsRGt7eweVmn5lc3oUftosQVnj6ETHG032FjupFhZs4IeDwJVO1ZwPizHZVrP9TIhGnJAYy2uGBHmJIBN57HKj3WI4yOdqz0y+LuvbHeNET3zcznK1g+T3V/W8hryo5/W5OT3P6ryScmfsADjiB5ByXZjDTxawQ99S4QSdg3AAfSv+4cvTkN6M/HFtKc0h/ffimSGpvY45tJstqw+SQRXemlk7xXUdUw4JFlzn6HRqscKDh1ChF2eQNTO6jPPgQjyo1IA0slIgSV+XO2cEiqD2RLpS1QxX8lPt+JFFZhup5scUYmlPTwa4lol1Z2c+r9wFvvcbDeI7DDJ33oQ5GK/ah2zLF7RKSBbtMC4IAXHVAxQtdcLRczyqOlrlYsGRXepjuTYMW0Pwq1aFaX+SE3dOXqA5eEXb8SaaJ/o/+x33v6IiwOmzl7i0y4MeiMOB7TV4FZpzcPeo5tYmVJzINiqjZ43dByxYtUZMu9KT3Kz1aptW+9G9bZSo/ClrJ0RN4U55rUdQbdYqXhpa9FPRJQZ8mNvoVJN0xkbwfuPeDHpzc+rn0ME8zOELQ66KqGfxoBpytwSAT66jTw0QPMglF+7MByQqrn+sebN3rxP8nm8Hl1qFm8Mj3L0X/BKoGrfUo+qM5baSpvg+gq80zZWjWuNttcb90pMOKvQ7hDEEpCAUdKWWKCGZrLnIHniaCdWHwNVxHfL1GRdzW5tuCw1R60EYP2ugBczvE/Ze9MfEyGhriHNPKFSLiv/dVDXmwLtMVPA7z4GVqAsYmGrmsjkwTlBNhM4GlfTinJUKz2HOajPbDmKdNEaqDK/6r55w2BXi5GT6ReQqOedqQOO//KlnHd+4bzzfg5MNZpyUdboHbN8A4zEZ55hHAJ/CPogMslGMfcNOTWGjD808L3Wh9E/knUv6JPP8czkOxkm5EWtHSQCYRS1MDfX6xT1FvR+w2lUPZDLK3za/ALvVVsZhN8WIKeJ/AYIJQ0IvxG4MqijNy31TLxGAlQCvbxdICUTpA5q6h8cpL7nNq+gU7yBnhF0I/1nBnLc8uHWm+I/y95psPTebItqYtmSTHL0RJvv2hyEkFiYKWzPNLlueXzrAnHfSk803kmLCEjrmaS37OWxVKF4mozkFgP60bfhsFCImkWarTHNUq36N2Npmy2QuJxyq0yNzyeM9c0Voq34tnnLb2k6CjhHhsRugWDNUU4rCTdbrCv5uCmOyAELMJrVMC5qLN/X8dcrjJZCbLwGSRpHkm47tEYpSlKw/3JvAZaKydxIpbOkkWBT/u8SNg5ku7llBKJMny3i7QCRSyVHj8yFxF6Rm9ucC3rimAUKG8DnARs/8lWqL0sNlfMHCdLvPvDbrGv0/TVf59hur7R6JZc1PFaOhO7iyABdaVkRRfSQ5fGWWCreuMLbpBz9A6ZD8quJn/2/9XgssyQMz/cbndpKdpk27ivj6FX8E7V1aO+fX8H/zh644gQ5URAxAqY44SEUVKB+bMqxT8UVUF9wZYvqZYnAWKhVSpEMuqIYHYRpyU4x9l2R9l2R86LMuTbeFHOfZHOfaHkpAVJmwwC34f2IuZd94HaOXW9zD05oIR5lmXqRrCvRiG4ZrTwMnFCCB8hGvaQGwAbVCpbwMmScRXMNI0BvaOBpVpY0fu9wg6J+Cikz1nCyFUw2U7Zqn7NpJlaoDTFjlhn/0KbSACYZUTvqqppi9mAxMhuQWm0f+4jPW74UvIz1isvLhKW6QVbjT9liqqfq4qBgWmd03XxuL4fNO0mbUWqcitccL2VbTPv3xnQQ4+bA1tFLZD8pqOEzFTcBsNflaesXUxUSS48YJtysWaGIeYK5kDaYrTstnULp8RsZGWCyB922m+8g7Mywv5gqIYh9dkmEYY3l7pBuMypzHzZaRXVHQZz4nKhvo5ZjH12EBahyNABvM4kIqewMNpUkEbSYHCNmsy6MaK6ybj2tTVdGaKnP61IkPN9zsFpU6DxPr2AGZ4Tr4NyioabcIcV5ci+Z5QEezLqKTMA46wC2fibvS+giq6EXdqbWI11IGGDgvfH460m7+ZUywVO4TDGAXBVUFwgUGlCBTDgeQYp4q5CrrQwtBS+raFNB2sJ3MssCClda4PlWeO1OoAalJhnyWA2eRWNrnfTUW0I6JZd0iMHBJTKuBgbKzJVaTHFXFIkb5CqebzxEYlshYpOkgjB2mKzhDO6S0CgA5gXBfOaIIlmsoSevI7ZRhyjDId+LIu1sX0GiMaRXif1vAHd2vuA+ORW31Brumj7kbqF9mpGHoSh8UFZjxlpFnHZyYQJjSJDvKi0H9DRrfMIX7ZdAUcUHTGkYRWB0NaClKRNXKtdDEL4jMwpJVcKckDG3hLn4LRlVeouSrztQXDsdjU2ZdIZqC2HLyRcPpuAL5S8rdBfkfsG4y5G8Ad2sqGxBaOK5qIiZIKgVM8TpGQNplA1wifUo/8cdc6kl0waJOyHl2ndRUFdRo0A1vOoKJ/DVGge2LBB0iKtIZ61oT827pSV2oUlRqZUqMzKnnR4ppQ9uMYb8L4a1zVx4d8ALo+kXb8kLLSOO0gULMR2tUP0i4boV1G0EVyVeZry3Jy1OkNJHpDU2gXkErtSE1GEENKKabaOgUM00DI8tWH5YqCEeLg5nVKcmiPxnDuxS8SNcnr9OEigNWehALSgg0UbFD5RblSnwpi4ML7piX+nDnYL89hUm3DGxIMZt3AeRaMFMV27e6Y6yFwU5UwJOilJgQRUA0qinIgBtimd1mDoQ48CzcC2uUMu2QiWmDobU4ooC/iezGIQpNieGZAD/zxI0EPx6ksQu3DzQ7++AEubuDwX5PSBjUJVNwR/ZMWobvVeiKkHQkm7Mz4g4pxRXVO312kmgRmbyiTiM1FHWkM8ogbJJQgOSGE6iKw5Iiob+KRprdCrmmkpdgf2W/riEGt3jeaHq2vgR6tQ+nRfiI9Np5Aj/YoPTZAj4Uxenx57N+h9NigBaFH+yA9Hnyd9Jijs4BBFNjEeRttB7HBIiaSbo0fd+FsRqa+T6rZuDFYh1Bz/4TZnLSMoALAAOgNB/na/gla58XWd4TdaP/3hQJx7CB+0gIAqIhU828IKjqss3YxWQt9u+88YH87XzJk1IBMiqjZR5UFihTrcvrkUEWhbMR2DqWGkQH5sCZeVdt9w96mbl+q6OgSA0qdkRqQgzuWee0e3ZYIke237B3Hr++GKPmVod75LLsukX58KFtvlbibR1424Jtj26YB/toRBegOJVzlW6qhr1Fxm4osoHWE3M97GJw9FkSAk5af1Aj+HoF95a6sU5SRVSOtGioRtFOizUOZhjr3zbPCJuYuZdhDO89J/H5zgZPk/eYSaGhuyHLIXOTObBX82mKLLqLbz+Jeh9fl949GyDLDFJFCf4wxwE06ulAvgn+ow7/XJ3PRcPGeCCVT5iKewpmL6AYzyEF+0jnkcH4ariTPmIXB8r4gI9azSwrNrQ/s6+oizz2ycmRJ4GrAHM3EFzH1k2irO8ust4DRtYB1k4uVWlE8UUAr0PFBMK4o3eKbRbPqVN8Qr5Txk/UteoMdDLQi3VqEBo7X0R2zxJ1UHzzOYmEHvTaX2Ro3h1yFlkTLAp0a/OqGyMOG41FdH+JuTBs91OiG96ypqzrTVnWm5TxdTYjJkdUOsRyGu2yofbiBwuKNuZ5Jisw7obnu9TffZX7Hpk6Ju67rB7uu+gHIB71t+MAm5W8xoyoFqGcBOOSYPzXBybbGvbxeUJMrDBptW4TnIkXotetvio7GLgRAZJG7rEg7RuluI/1OJ7+UwT/h1cBIt5SoRzL+Oin5zo9USr7z/UvJyjgl8Tlm1B4OCBg4cqF6oVhDqCJk6DvS1UAJT67WxG/0rZtNiAe8Zdt4Z0NJWtOVb3PCK5tmXSjcnkDhpqNwUSncGVkIRtRmLquLbr6J2cDTFxNNMCRuQ415QlxKhWjX3dqJaUSZEJt80brOFEO7KJI0F/pbpw0Ghhc6oBNzl1Jt0TXDdFcCuEV0A0hv5DT6FVrt2RUnK6UIMwnLRRdZYzuMB53MOmwUvTJASceDB1TQ2kgMjGg+tNU3TdVtioJDQXkiyJXQ+wb3PfE4VXuS8FeR4TMmcNRN8lE9GqBHnIrnMVOVTPY/jU2qJhrqF97zSh1BjvQfOMZcYZd4gSLAd9/eGka/6kfBJdSKMs+HDfTA0LLMWVXTKBG/mQ1DdHCJrW4ufqeljmTulDJbQR6oyFMwmfZJGsZeMNaXKOv14WymC1j0NvKGM7Mu3YnQnXVuPh0uzhk0pax2paPCsAe9mpdkmEQx3RWeF3pG1BnozXXOq7KsNjoNaldN+b7Xc8DFT4jYUpacoCpjMYr3fd0+fCscqjxCljoqqDvWBbzcY13cC/ZCrDd5nAN5zq7aYoe4WaBlziT8ON5uECcdwarZQAIPBhBtFp1tiRserJqBk3SIWrsOcSjoLQK9QHB9iGDcLIkTXYNMnMErGMbwFMR68ocjfvKPxe7qrxX56q/FXlCKZWtonYLUPdMT+ei+KbL/Gjf2E5hp8BPhp6DyW9rl1z8buWU/zfjAj0VG9kafimCe1pB5LoHN0YffHAmJ9OKzuKgoixQhMdFsDQxSpKYyCPJjVLOp0A3TyCgFmyPb2VoobHnzXFFnZaFfQC2RueJ0Wta1IaZAKLQtJViiBEuVYHUNMVCyYXaLQN1xQqUgVETr4O5RQjnb5x8L7g1J889Amv80IA2u/pm/+mOREGqUiGNznFCcItCqhR9S0h1ONS+E0JfI96WuO3fSsbE+78n1TipbLfTiPxX5gnCB/uOiIhfKWX6s1yMMB+7JBghZx6o6UkLWQchUCBnpLKDkAwQ+Rz7nieulZhFsx7RX4jYYAJHmSGUhK5bFIohdpLpOGE5hcGI06mnpXepyHXRLl2MsFmUdZtWMYDbkBjZnbPXIlS1oGSRz35fdc7J6iZkLUEdO1Da9qGUC8AhlUStMK0zWUoVfn9IlAN2jlg+YEYGyCFmANeyqVGWWkFTMRQ1dAnh1CoDYRZNB7F+kVVY7aLFHS31aAvWAlhoiAvXNVOoB60zSQzwPriv7aeavaUYkR0o6I1BLutV3mkaGsSOetiKa1NmAMkignB4YDdW8dbVv5FQ9jIeDDJnxlcnUbMNVo8wNvmSgXKJCJ0U6jLmx4dVGDW2qcy11mXJMnSKHcTEHDufQDJQpMg6XgL0aw7jqAUwd/vDjZsXiGA6igwhVq7Rao72XIXIZrziNddfPk6rkepB8nF5O/anhgRot4s4iaaFGWU3qbKDvRuz6pch1On7PTvu+TuiohG0t0IZIfxtVlW+18zIFiCVmBeNwhVpAfIswMnTelKEQ/uhQOGwovBO911Co/LAdCoD+h8hQQEe/vqEQ6VAIdCiA1Rtg9QNDoaF4dUPFs7AgHaGo7Z4CmPYpVWjq1OaWW6JHtdFmhwKedD3vZ8r76dfI+/Cop6B7Y5T3qQ4cKdomLf95IPDlOLvnmdS9GR1kabUFjD7tvW4dhqQDKHltQdkYS6fK0ikwnKFu7aViMPMgOAwGfkp3nTyIHh8CkIHrMt8t1UbybCmkNi0XHD/KlhAE4JgIHJNWlbzjjKpsKt5zJTMYVTt2aK8GYdfqo3EBIMBMQ3lOl87o0paYZ+1FoCm6BT1oi+68ZdW/qNrQXb/5MhjGi/y10EZu58gtUZVcrAO2iQgXK8tycxQMDyNHLbonD6J5ZJsSR3nUiP+2q/BFtCkSN2KRU7iA13Sp6+LWbUfAl3fZ8HTELS/hw9EN4qrVwsQhvuA15wuWRymVd70v8VDLxcdHLBfwzXbcaB44eZGsUSYcJ7DZIO95VOxpyYYYaPg6spJ+EutjOUchqHxeds/efv5oyDQzNOWeu6Nb7SPxGeBMEauOXrrjtgjp/rFLj+21Ryjg4KUrLp759SqyiHW29t3Q3FPyPasdMndBAF3nwSRPp6Ui3trtWwK70b3Bvi+78ZZs6IRZQe0HdMotumApog1wSku4YRV05ZIrSp29EIdkXqaYNqTuyhcAqrmqHGQW9C27qh2zawO9uwFmskUWlRHv9lSzXm3IMDYSlknVNVd7vsppShs9v584o0Scb52XnTlIHTVY1bBZiBDOruYemCzr6ohRV5U61znKAitvquFvu9rjkauGiGD/xEG/gzoKmN3EfQUmIomd24D3Ay4vRNCJ40JX+KlKNRhOhKlTelpWiDf2vyeU5LvC/T8Ssp2tWnBhH5yNhtlwmBUqTFrb6SKTErhgEHzHj9Im/7zJl3wR4iJ8c382xFWEq4ivIlwVcFXgq0LOVwLPC1wm5XcY4Pyf86P4+AeNozjcnTI8HaSt7jlQd8e0aQN+rVQxpH65DPWp/OcsEJXRGuQJ1Z1xsjiIQ0qI4IcRyzT4b7vqTW0aJvNAB7MgXSW2hsU1vIOmM3SEwnwD2xRfwNOFi26SD3JCl6Q/HR79fDdvZ+FSda5B1Ph5LWdNnsF85SShOntSZ8Fbm2QTNusYUCuYtbwSWRprbl0N2ZSpeVsetcm4RjXeB1SaeHmmkRPSJ79GnhElE0mRGHygqCEzKdypfje+Q0KiFkhAozq3EjGRWUAQAdbXiRxddNahlaHV9HDQAw90AGcwRUOwDo8AQdd80FWiLu3E7RHBPURauoiiZRVAssVySTlxQUa/uaijV1f46CjN6zSnZoAlp+pcUDVNFx/Ait7V2MImAGBNlHXnHvgKZqVmSQTaN1CWibzEFh9TVDHKN0xjgmxrSy87dLGXk2y29RUIthYEW3so2BpPEGntH0IijVv6Rks1VvQg1UbFWftwcdbIizP8jku0ha9corXB6+0xidbGk7xu09qFEepYDHjZVj9EttVNh/ju1yHbiBcf96h5975p5MRc5/CxvvZNEHMQ4+KIaFKSd0SsfcXSr67Sry3SDzANpF9R0JQJWEXdrTCUftmI9MuopajoHBCELJqYkmsDYZi9tzAcFYUAXRGLVXUORr7OC0llYo8kPXJIZWVxaBk1dekrrlWkOWmqc1VAF7iiFa5lWeMrxMEFJZYyp9tdoUSj3rN/fWNOdzxcJqKrdGXvkVdgyR87sWeJSJ58vYqvJIz7DZW9laFHxLou8lU66xKPllC0JALeewZXeSDJMugSr2bIYLu/uie2GBajC/Jn6VLfdEWKgjgcQhaZ56JbeIWrpa7YI+chRv9RaC7wDVVVV+4OUCNfnuda8MoH7TIU1UtcbbbDHerT8o69CPG5xbE8dIEugS140PMN5EyPV2a5EJxrj+xlPbADtb1VtVclpvISnF9NWnaHspklsnTv8UNjuUYDUzSgkOCmCMbqy5DSWKsBns9GZpUuiLHgOWpRp6+MaYvYE0lkaZX4ag2EoofDnSOCAmBbNoKsU9vwPKYyQNnKM9Iw4GqJr5ZpCfKPU+x/gT6WC0O7tjn5XATKdNl2gfs3r7LQqM87VauKMFvK9V0zREUKbKpA6LZOS2skebrCANhrDIe54iCIt5Rx9cLv9dmUiNXJIUQQh00H6CZdpxv0NAP8f91Ccah7fBWRaE2wIDUlcijJRw6JX/gqXabgMXab5EbAJcf1/iTjOnGZoAYAoPvS+Wf4zB/+I95L89NuDvuGZho6cWn4kR/QNepCfNXkIIyLihCl7xY3umiCJ9H3Fj9ykbYmxBdeOxgk1nUDlTZge1hAskBtJG2/PF6RXjFvPkfzpoPudTGqnqMO3WXuUA1rm6nHRgm6g4OdzLdQ1zzPTT7fDfH3fFUWZmbDnf/0LWjkOboL7ljEtDcF/oekndeRuxfaJb7sFnp8zqGYKLDNAWcgDzYXNMZjbGieV/qpM23w28siDZHriHkUuWeB7tTtuIZnDMPMT2VSXX4ODZwVLHVzqRJuwoxKwBA/hm0LPixAaUlNrRVdnAoQKkE9iQ6sbxndoY21yV2nAsS0UTVbTIW7jES4qbZpEfJovvsm67CccKMI0Fum+UHw2S2VUJkMsqsilH7aUfcdG1z+sQfmiiYvYG4CWq2BsnGJDOPXBoxhU2PkSQ24/4pdlROCLqsySoHKl1W07r3ebbrIoF42hAGP9wK84vduv26TqiGCXOFM22NLZzbs5sY+7tqIw3eJdwUaGlI0AkUvqUoWYGq/s22e7QLxHwPbRmwfrZoNpfSqXXCUbmlcFgtuuIMXUbRJGxpGL0HBpimsIWo+GMkxEbpVN8kgnKoIpe++DagIw4rnkiM5Y2lKgfTDsUjyZEPpcKDzNRpTu7jbtV8Hlet+M8KCjsirRHvmRUbBHXq2ym+uChzg3lsj7mxUODTdRriUPsHsJznuD3FxOCiOfDHupFqFdv5f53susRcikTcogQfY76nZQHC6R4LoFq4zWJg57ff1qo6OnLE1Ec1M588XH429YlGNfWkXsxxI3hR2fvmRPL5rXhjlZ1KJQJe2JNnQJOFE4zGBKkbvtk1xg/MAAP3J9MiLD4MUEJiiFwGE2Fwrh6rLemymVbzQ/TBn/MaOl9D+Ld62euBl124GqU16QBd2Ll7T7C6/Mba7Ca35B68NXsCD+kDk+bJEEV2RMfYQXdDSxFdTkjvW+q5RgstXfNUPd33lqFryfHgo4T5yuG8fcvZW95F5VR/l2+TSVx5Ktf/pj+/t5p67SpaIaBe3r9G13Ye77ugyq6l5xZ8sUTARvscLViYLuaAPYAq11/zntUIiepVIHnoFD+0JJI928RgrWvzkb/wNZ79Emryvqtc3SZPXqw8tyZZQkgQPkPKYJsyINFRiJnXFXCuNcdc1B9Crw0+AvahF9ILWrQm39coja4ll2eNH9NJD+2P2RC2sdHH6Ohe/SC+7dj4nB/7tSfkFSPr32zqIvEp1VvEg3lOYwQVdiW6ATtVsHSFpCJlZaEZIrlGqb0RIIt2xljAxLj+kBobjGrjlp6m3TT0aEcTt81XdP7BC0nZbXgPnarMYJ7WXueVivi3MZ37HlE1h6UdmzUTSijKmNP3TnArU4Idrfga6jPmCed1fBXpuiJu7IpKZJYJsUPuZzEGrmj60XC2qZhpeLvnZIz9toKoSMQEY+co2gmBiPW0XqiW9wv+XcB5XgMkOThtZmhMuI39JrypRX5Hi2BezkPrcniUw5E+7/VuP0o+R2+W+r4T57C//pb/0DJOcLsuPPPZ61cksXiHsOR6ky9B3iZmNOQIV8hJL2wRvudGiyWVgxZcBXRH/6aXMtUQ81BlRgSJK04cPdeIPSBIWvnuVh5/CAbZXcWQMU/Ixy5ZfI+PDjzzSBOOJUXx1D9vU87s9TZD7+grD9gtP/pJr6LtkGEiLUcvjlmnzaole/Zy5WqJ7tAz8MLL5q58ZcXc2o5iTKxBcK6h7hS4guUAXkVykZZBymbZATHoevpzn6S6mwbtOMR31xWjReTDkeX82/LQUwk2S+kNN/1xU0EM6wWR6zF8sy4uEORGJOv3BjO7YZlUVM+RbFIuTvNeHeIU6ihri/t18HCde08czKsoL/Hjli1hZ2yMEb8rr/Dy8mXKafO5DP69hZFOGE7y6X2Z34hSGOrpoYpxhz8cLITiU4jdkVhRpfsS9GAnLmCM8ysaqDFwNuIO3BWStwiS6b/AIVJAjm7LQTnx0lYdNUaixChQPLLJvlS7qzqYzEzyYt/d/LBtgofct6z6st0r/vRAX5fTG+GOK99gWFG2xqNyj53Ym6jqSMymlj4AjkdjRAqRQCHU6Qwnzfe6hgl/BOHNaIRdbRgW8fzTUAXMEl5qdwkZzlWTIoW7mNsEu3wsHJcQNVrmY382QTKlLWtSHVPgH3xB/SLHiL+2xbXdKH9mxJVmoaccZlMNMtTjgvgRbAz/GNNmfxpf0+fcYZWyqPe5Obg/oKB2j41SGjfP/TljQlicvaMs5KyfT9N6w4+gjEEo4/h41hEKDHigD5qApWd8OT70Y2i0faIWoiQcQ6olBJuGU0o9zHwaQUzLBwpDoIQfZohmKOPOGgVXMOy2H5yaPfj+lh7vOl1n6PWEc6hj+hA431DV43AZ4waIDOigQ7YDGZB4Bs6Ak52ROYKCY8L2NUDz9ojVhtEsBV/OyLyuWPBJirO92d1HvyDkTcekWw49eBYM4wiB/3mIoxxYel6w7eM1fqa5c+oszJ2YehG8fw9j52BGGOsKfnIRa5BzGkx7RLB8GwQ8kDi4JF8kbVmSQ2LH4AqGsuDmLLmXIzSB3RLqF3BRyZbxact+sqeCijFPcyzCOHe3ZY1TA+D1Ox3ZsBcx6omdOYmH2Nh3HDsJpt0fPzuzQDNYU9il6is/drf4BvNixp0DMmT/wtj39u+yZHXy+5zb9yt+FM3PPUSF/0Cq3/u9CW6VptyXRztKpvj0vO/4g3yOsnWGsO6pFhmgOnxfr48NfhqrEiaXzPLtTVR+dJ35xQXh71GpXfvzI1p0iVxaz3RIPu2XOR9gMdwrJCs3qCrIMW94qnUJyEY9sm0t463nTpKPewNcC8s5owP3boq0hAMCsiwRGcRto6DzmubXOTV2hWR7hG1xpZdtsUttchWNOzzGTaFsXMbCncQKYmt2Ejixd5tn6+ruhveE8Bxgo5mnHc1fpBkZeSTatUYluqF3mGZa8N6lqbhUkHgDT0bo29wzdBEanwYLjLa2LXrBG17g1t1fWdtmQeZtrm+F6NkWqzwD76MlZZqLnKaAznG4rG9C5+5j5qMvU1AUercAsEpDFO9OcmWZ9NMbCHnn8cSPT/Mop6oK5Mp5St98SYcKPTFMiF7cZjc9OMAjepYtmWsTmXdpg75Hdci4qNcDbe/SsOxfoHpa5Ik3tvf2anthHW963xUXhoCjyRdGgqOCLCptDk71zP92dLJHv0jQk8jQE6EUzw/BdFNvcEVqhbp9mlK8hbwewxzySURRxwcyOmSaE1Mz0vagOlGS3dfF97eHYRpVY+kRPoU/TYEA0zXZB3LhFN8E9N6kk8+UN6G1sZqGnt9jcgcObwOI2um+eoae5OBLzDbOU8hWXlZSv7gj95ybw1R2a+Zr46qbylfIrnaeZHhr66rjLgLeeoTkk4PBAWWx6G3n+Q3vPTGQxPPLDhcVujrPYzfdgsZuexW5+Q1iM59pn/OeZlM2eNm1oIOAo8BeYqsnPgPsc98CCz4zwnGzIP648NkMF2Wt8h1NsMn4avMG9q9JNmnX+Eb+ApWdQSaK9fo7mYAzr+q6b6/iK8d2Bi6GsFs3rTOgtOXG65Sy+WxMt6nwb2lhLUHpUPSbzIx6T64d5TErQQdDstPOQYKU9ze9fx8qaAjs99JDc5n53SfJ0GyvG69x5c9vBVz6WRGEYYmMCUURlQRGcAnT7yU4GRrwHe+hIuCdcfncCl28R2xdp1SHkHvP6Ml2hrSd4VrYm8+RWDoGr0FdpVRB4a8SzAhZbovpBz0p5RMu69f/J+wr4uJFk7+mWBmJpZmTH2Xhj51LSHjMzaTH0fY+Z+T3buV+8v+X1xV4+ZsZsHjMzHjMzMzPTUv3/pR5pMpP1MQZGrcbq4u6WVHiDTTHHLGOqRCnXhosMd2fAk5KsjGu6ztpJyY3RdS737CSTWR76qOdwQqJyE2Wo3XNccPNQVSJ4+jRlx5grRjZm2AMZjjY5HhCW89xhnLfZc2vF7qgrFQ/gXdEp1m8e1ueq43wVVDhirtXrtq554x93daCWrA5l6BhlhkH2GXvwOY8Iuf/VyH3uKPfv6twQtIbhjOrc54XohZDNKpwYYrc8wzFKenaUa/FRDEUVgiqGka9jGPkQw8gxNFPd+b9fGYa87wQcZVaHpbm3TjZ4xg4/7Nxpxy9Ax1ZgpUgjQGD2LAJ2I01fsVXT2zk33rRlTXWGjFiF2q1R7cc7q+60Ei7YjwpjIZZLA1tW/OON4p+eLD69Ubx3sviejeL7NosFUaYCUHepYLJluj+TT7maZIxCAXlxIdqXQ7Sv29QLHctqBWr67EVogWBDVf9Pil08hQ1bPOg2btBUzQ2P8eCGF5MbDLXXNJlq0x83UVs21BU+7iYrvL1Z4d1TKry6WeH1YxXCLiXKEIHt+W6ZCy9UjyBJElu84hq9vjwH2Pt94Iys+1fuOIa2UY82R/2jKWA9olnhMc0K1u9mo9+X1FJ4TqPVBRON3tyQrpfWjQ42Gv34JCgPbBSfPtHnXesuv3xJENhbNjMnBPZu47LQlDsIzzi7plvL6su+eTF/+VZNf4lNmzJCGleM4dEmQmewWBIxUtgYOxy2wJm/zdOccVn6jvZ974m+cYZrAS3R6NeVTbNXThXx/c41pNaTbKzFYFY9HqGZHmZmj7T2tXL2I1p/g0ryVxRmaSEaWMuUAyPqEX7jkojTYKTZwunmTzOAojeOYqnwoD1hVchJrMnkoZGLJ+cF81zjKSKoiKd810MFDitDUU8sLz5Q5bX1drU8uFwgpu9dD+udJk0xtHT4hKNHNnrqwcgveObf3+LH+gzEhWitWoZyXZw8Xws0772vfLOufuEQAr+vBWksZnn09Q4Y24AAVifDGdl8iK6Dh7QD+sqGp3YDTxxGAY5v5Xv3qFrlTrQSFRyYL9WLY9/kElxYlr0OkO6y/dM2t51QhrGI+Jobhkn2etRtJb9DIzL95X8jh+0Yo1OwQrosLruMpxnQuElziJQ3HjcF4TMulla1J2cb4a6i8EoB5Kl8A02BM4kOlqe15GsHw1ap2ushrey6Swj2k3ttd2SnxiWKNvzFGIfb4olfqNI9TXP8WwHn5GJotFviUkb4hBjAv60xPg/YFb13BJ/8qT3lUnaXyy9zVwkRTlvlPZexU7uavfUhVSzI8vkt7NVpoQ+5/K6llrxaS6puq5JtJkS/bSL1y3r3dqvTQ4htqzyv+306CGTp3eb3cXOwssmMPORxUJmsIBYb9/aIM4W3iBXiIoVH2tc9vuhPi8FKPpQo7PFl0gVyZwkvojQxgpa2m7NlS6z4QCjfGb3m89yqy3eg8h2LLtInaRb4xq/lOyXlblu0li+YQjhZvPTtvbldFrihf+0sAxC9u7UvX9JOuwcEG9FrOKDoAJDdcjLiNnFHQX2cfXq7GzHRVmWGefvWpFsNWO4+7+yz8Y0EDTucz8nJeYcaecZWj20LriWdPJbdeVvmq1fi4xA0IoRXtfV64zMW83o3I/NcAs1gB70ruzlx1O5IX9rV2lvb2uMGIV56W/roqv7yCJZyNThLltIp9ewTFErhoaL4gPY00Os+o51k2DKZRZA10TpdTXS5O7IPKfxXBbSdGyA7+60pC8M9MqejLIQJy6LswSaIhA2LWDTp66QLyRM/K978Iuee6avIPQ0ULmi1VBaIwtRQ2JGEiItlbuwwIw4olMSoEY+jUOawdzEX3lbdjehlu8OpmB990QUIjXmEp1xkJium2qRcUdM84hsyLekU05KOmxZd2Z9jmj49rHdbmZY3/sUb/sJNtS1vQIlm6uUNrdq6vHXcumw55tbW5ZxDZfqdsC5vm25d0mnW5e1mXR7hXBSoIU0HhnTAYOGw1Vt8Ui+MPu3hxGi3GckWSYzhgC5MJXuH+UpqI/D4nkudDZ69c5TPAy4D39fx87/Uc4PJ6MiwbqhczlMjZ/hJV/FrsYfxQ1UHBY0rQsq1EVIu+yRpR9X+68aCPy+8W7e7c+zu983MZLAxq5a+awiFjH55XorIoy1EGeWpd9GrItBIV0el6LbNLFiXD3E2wqZeEViUkNZxkXmKznFUny5X9mkXgWf84vHagOUZZILmXLvS5lHrIroA6E/BWEd1LJ1+6NKWVexvFMUZ0elAhXX8PMQ1qj5/vAD8bK9QLtZ1Xl3VqXPe7oyZWZdniF5T+LmAcXir3vI4gaap233YALvrcbNdLaMaJODwGuDSggtOd4QuxwL5GoSONihSWyNvWphnRBXPE1vS5Vhp3Ra6zdlpOIN898Wp/5APRux129VA91VGrAcLVl8+iFByS4npTvEmUy6AOEahDbiaKuyXwTW3RerX80yzUguF3K+iI0OeEO8Yfd2UKawPlpiCcM0zdduRmHUlg5gl0mUFabOF9NlF9imLTazAl0vVA3MRhO7To3zGTpYuguBGFvu6gg/kIYAzBtnAoOgZgO0TQQLuYzhI/Az0J/sMNdAUID47CQRDAg9pzW1Dzo1ecdhmHIPfx7hVctuqBXO2td4THBVumVqoZjKR+jeVLxfb9kgRokbbzkPbHNc290yOj9b86G+nGuS4ULwWDJvDg0RNTfiuLTThN+X1v+cRx3v9adPrT79urz/9Zr3+s507Il5desTVh+hqdaF3T2youKE0tXyvwyLPW0VvNdhswerPW/0FZqD+PJFuNTxrJK90rje5cRaeY/KwD94sb9k+t4jBavSV/w8PMmTvNTNoy+JOeOK1W0GHtbMS7lx7WRGqFn75A5SY79YrHEAEYn8f0d7GcJF0zPhRNgUoZID69xu5MQhuP0AxwaBc9DS3fJJ/8a77dc7HN+ezSd6zeYyB786tLYUtKxS0awL8tkPxEQCUt+n85zoJY11OqSMR03T9MJ82QKjhUIbprOSRfU+Q7C4d82V8JTFokRIT7BE6x9oC4VXvEJIUg6AeLzEuLMs+2kBXt4kuejIfMxK+wbn2BoTQ9t+i7BkPHe13xCYydFQlziOVGuZ4ZWZ4y5EFwotxm1kqwhKTuCWqGEkViwUwtuila48doU1YypgtcWFFUz9W1EYMVU+/LO9i/IR2pGs+t6mGKLyv58P+UgSnLSlA+sprBcNuXsrZUrap/SaF8JvSHR+c0B3tc2rdgZsx3YFRog3z+KghgqqkLeeuk6I1+xB6rVQnmjadWm9zbFFBm0LAALzEuACWO440VJx9GJ1tpZEMXybgTXxhPhW+/l/YyudOn8tjpQYZ10SXgpvrrV6K2OjBGq7aA3QocBWhxjYPe2HzMN1q8xBT/eYI9fEJQvkmofwEoZoo/AQaf6NKvUbpZjyOUh9Q2jwd6W19OsLZv9C3Ebca/5sLwo4JtolV3qWDlffMEbyptRXMFVaYDDQ/DYXFNkUido9wva9e1dJkeunawaY0nesY3k4LAf9r57StmzbcKrqruZC3NA/ypupAlp6+YGSPaPLVl5hcb7Y2kQ62d9/G3dYZSbO3M0UC3FR/MBYcyAjnI2qR+/T9ythYboOrbyoe9GmvgLboRPfFV06QdJonBA8CfT0lyqzmgtnQTCLT5jEudNXoltgOT9tELjaR65rIRUG5wrHhpkW0ulrYxoSz1U3yBefSE9mnhXH7tHQo2KeX/tHjXkJx/Fxtb+exSQfidi3ad8/0xDZT2TNmixNJamOGDiOs2WEpUtqzl6BjRZ9ebkpzlmSfb5rjGdnGzzl1zD2mWV4ameUvjJvlL96IWd7fqlSyCVa1tf6gAqyMdDlcLuPzcJvy3Bzri3NUUSgG8c/XK5rk/c5tOxEGsy0x+LUag6lhsGcYjPPeFFRtw5Oq01FFy39NZfnbtM3mynfx0xn58w2EXTuOsOumI+zbZ5W+NKHslpoe7dKER7tyY1YpEr9S/vYhNouyL387bdNXvgHbRFKOK9KlYMsf4SIoxGjCQMVUh2DfeV0r2blPJG1gjyus8J3YjsSo0buVZ5WuxCgEMVHas4bm31EUqHWWRoYuETvr+ypl/bdd1FTr3/yhWxHXx24Swzz6kR04tWmO2TG4KPSNbZ/JvoGy2gZ/e3jt+u8gr20+8tvIa5c88oeL1y595A8Sr+VELE8ox/F614DX27bKF4AP8fT3JrjyycjeVb5wSmZyC522sqIzD3OZNtwpy+Q6oD4HjzlE6hUk9yfk1VkTKmuhOP3RJV5/FAnd4eIajz7BUdEekpflnZkNvx5vuPX+RrReWZ+/08VbO2yycvn7YH7N8DnlwiEl8sLqynPK4XnSXX4OSC76f/9i0St/X+2Z7bXF6hroHs21OqFihoAWCX2+vXw9KFnJ0wpk0WKUuLW8z4MXifRnpfwztLV3846s5QOC0cYBHQh/ehDcfFgnMxznSGe5mC03DvYZXQcU/Nc8UzaQ7F4RCKRle1HGgmFCWydDLZMul/jhMdEBP95ddEBbPPHo2HWeJgaElkbgQWI+LVv/v99qAAL1kRIDRzGLBgS6hVX+Ps5LZkqdOdCms44w+e2aEelUV/JZibRzG2cZ7IvJp/WkOVMOnFgEdnswsYtn98T2IjPp3CZqcXJ6PXZUOpYSz9s8M7nw4ct+szr7I+HVn+06WxB1BfKR2bnrOWxtU08lWYYSYyZ7A1IeE2kJ8jhPGQCbA63bx4cWUrBfSnonp27any8/oFyQbSv6bsOpd73ywf87ml0o78l8+bQLUMPLvPi9iwW4968fcqpbP9U9RIG625l/ferGFZf9r6L0A+fvXdTLUy/Yv1j18+kNmUPH9WjrqPjk3n5UXNi7mO/AnkeEHydzpdOQAScZJXaWd9BR84XyjricXNPFYuPskhmejy1aeKWjxqc9Qw7eiF6SNpC725CC5E1kBvyuhKnxVHhgL8/qM8huxUxQUJKSrLiDXKSUAbmJjD413yadO5JJVs348P2PXeP/tRiG2/LY1dfARHB/JrCCDI8WE02yiSYeVbMxPumBTwbSZfyrplQYn7TtW0Y3As9zjh21zokDMhXQRaDIQ5nMZQ+Bym9A+H8POPaMKin/d4ywX+OLPf96NRBnf0HO/YXYeVkKILi8pGXARU4+t9Cfc3QFabZp4dw8F48oI3u43yNzzaYM/LJTq5hU5SNQ3v2A38V3zPeAlfeUXkvSvgvc9gDJFCTk4jAxL93evquqUjb1/yCQFxaMdC2MrtsrgnpUisykWcTK6r1H8Gg37xqwHWRAPJhROl7EYymzovNDXwltYdGv+2FPzY7Qjau6UUqOWjuC2qk0it52qCLBAttlANoPSPuCj+y2kXWOWfbcT4VYfD2QBWf1HMgG4QDaZjr15KQ1rQp0wsQ2UQ0+kB1XS2fRkI4+spEG+c1+i6ZgBlZAL/z0/prNTFIjBFbgusVnXzNYh4zttuFzb9VGpCAy7dqrrimvnbP1j1Y1EVFUrEPj9QF/HzjqEke7tIDdhu461mb9uCAonXEUsH6qxXkqczQZbF03Rf001oaLemPQDsBvgyn1EsGpTbpMm9XXmpUih+XdjkzpUUUXGJ02k8ayaWPGrVvjjszb//ZYnp1bWJ7tW5qdvo4GfSkDPmA+yFOFltwh86ZcGtrudw3lnDk3yMZ1F/VFIAkm9q8TqswrdbblczpGXY8lto08R3+Hieu7/69m4Q1Fok8mDRRxqwiYUwRUHVxygbKoXl9xvr7K2ySCbxhS8WZD2b62n7689ALtq8BueufE9lMRScVksDLp1oCalDI6jmSbpzHJMWCcPNppYq7qDz10wJFdOkvWDQ0kiO81g3wOpvHN5sVQOqF3c88ymrA6LzDQBRh42ByYzGQC1QRbTXcKgQqCL77YvlLA9WwBLdPcN8+jR6oNtAIn/tg0SYDOLhmdRT2E/rhcQITB7x9+3CUPaZGNZwU+pQmGLz8d8oOQMPfLjdxslLv5+Dp3YbmWJQEq+lA+QTV3TYgGFCII0HQ4Gn30JuIxfRrvCNdSNQtUz+L9JBoCdVtRb2RZ4kHsWi3vkhN6w1ag2Cyjs8bKAo9BBolsDh7I5sdr0uOp2I36xMC/YBx8tN03znvW6TLUaMAFcQjEZiHRs0Td76+PhU/CdmP2NG2bLwIl7dtEn3Zm9F3uTWhUfjhJGF3KhQGShpdcZw2OUuowwRjn9wMEh0PiguNBQQuqythUpdlvvXdaEAgGWocJ1k1BXGKt6Bw/i17qf4RINma2TqkpVkNvopkPR0pQS4eYBn3xUBFQE9VYEGv9YgedajCFaiPZoUxxVG+IINus8Ji+b0zqsE3KE/LippxJwb5upl53od3tMEWXQfndTIbsUbra/U1lB2+CFtyRQzsega7ykMqGg4lRm5PrVmjnsqMefgeHbCjbHWE8oxNRYAxU+gM2hPU9neyn8NvBRhO9Wh/N9okJD5c+OTepiDwnp9wrysSh9MsO3OmMgFXh0xqlmu6BIH8Xh+OOPWV3LXm199ERX32tROAHSuu/C3/qKIxw67KR0by+9YsgDu/5Z+OyPCoTzXFXFvGFf7oi8al3e0gR/6nEP75oTzHRQjJx3VDaKwcbBl1afzKE1WsLzAYUJM+1/vpKiS7/XyupMkunTf/6ygBT9zLpwHhfbhXF4Ub8uqZLnfZK3sG42mR/33Hog5pWYZVIa4xM/akt9r8ovu73cogTEKaBpJ1oN3sXQQRXewAXaXc3cHcV0G0cTVh3eyfJOmMbzg+rKzNzHRmUMjO3YX6vdvjFiR1mdMgunS5YZq4tQ5mZmZm5dvR/syutTvpV5vZeor2F2dmZ2YGdzTVSdfmx0g3AEsJ0QggkwC/pUFivbk65ONDUqNHUBbzMy5l4iMriyjKSEgmZFTfLv328qS55HZNqI1Xl37VvSaGtLzr97ntG7Xr26xE3Sb99K51Uqd2x/R162BAc9KO27ITvwt/EXccO4HW3Af179bvu4VLXDsbsvGiPnaJofSc+gHyNZI7Mn+JJ3LE9A8LBLHiITgyLKxiRgX0LGGBoGTAiPwqDSd52XDM/tVhWUXuyPHpVPR3bl4LSBIhSoAEqlq6FQMOQGPmm5R0Z8YwszTmyVIysxUjDoqlPLNA8APLK0gBezgngZQlgCgDQUtRDi7ptwScisctNsO71uQYux/405v081mm/gHWmpbBs+u4pD5Z1xsF/HSz9lhCN++rwVVZDiIbveCUau9bWPLNZC/Hn3uX1G5YWvpMlGqqW+MPAn5DlHVnmGVmac6Tk7GSMzMsSdOMXCLphZS+AGnu2pAXs45yyjVpCwwAaQcs7sswzsjTnSLmAGowM/HY7Ffc/cMFJLoL7YrYPc6CMH5n58ZP6Y0qNKoNxVatvRtz20ZGWn4boElV1cqaairObELT0IPcF+IIMIYYQhCQpxA2yxKS4JtBS0j5WPxhJaYzJ8wPOXcaVvzt+OIZpxbMphg0bZF95OKluTpSrkYaSWrZtJMIB8gi5IDSm29CE7fNTtfDP08NAJINP2i/gk2b9/J1GSwxw4ELrFPbIY+cVC+dEyORTTxp9TnIFPqwAFaPPZTvP67nmABfNeTFIRszOBa8O8JQ/ceAptGCJs8bzJMISCoGleVrx5dnG6ZP2c9EcyAArcEYF0CaWGP+ANbDsNZDo2iGaek/8e6ZEURWu0R3xC/HPBLP7Ub8d2rrlNZktHpPZlNNkSo2mU5r4b7lgUi7qjrNhrff7ycfTajTy8ibluIAipYfPqZAqER71d+1rE+ykpAPd8ik7gT6+Jx/XZi5n8nFRitY88dBp+z/zRqkbfe/8Hea9+cZpzY7oEJ286eqTX/v3XX3c6BP9Wns62vZxx42u/7q4pKRkasRB+dAT6b87UO2EffL4mxzceCJAU9PFu7lJdahRJEMT2oRB2KSKoOfw20CkWmj4NJ1ogX6EZiAFP+ISe9UxP5iBdxOVuVHHDD+KesyFvDgxYG1Y6YNrn5oDs4M5qgV8AccIcmcXupmD2TttcBkjlnS9D/C/xUzjj23tNrL1pLjT2QX1j+87p/mdbzc2udHbr76u6cIPw30cDOn8VOvMP0Isa13k8uPOrzt6yrLmzo+pHjffYGzwlybI73djDlGV/ZH0aMSE+l+ZIISgvPsB3lmZ/+L+Uk3XsUtkuKNhZ1YkimgvXBOENArR7JRyqQy5S5Ef9W+wU5W7KiO7a7tD/gdTJBgo7yc7QEpVxgeREfWlrafEj7qljaMI2xppP8A96y3erDdZAFsaWX36m7Z1OlLTVNh4ajqCTSQLX9d6HRFb702XJ4ACgaYfUgFYtsdfOabSJd0Q1srvGx/WSZnKS/5J+/JVwkdESQ/EkTZdZsAQgUlLgh3nPdlmiLt9qIFYUji8ofzV5q1wz01GkBe2NibY8Msr+CxuzIinKUC73itM0EExae7OnR63SZT5oIO7fkVSJlQ0jj9vtIOOnUfKG5rXEfqds5gHjK/MWQO4jKpoXMC1SRhDPECSGEK/i+6c8HBeY3vEJfnDe/S4Pi9t9kkbHKoX2X0rBx50V8RxSQTzr5yw6N93VN0fObXeXr7loY9GhPyh3vh2VUNDwzOReiGfbyTr7RDJZYjk0nGxtDT2hCX47n60c4f5VqnrOI6V8PLZ/AfwWTKHeHbORcdsHn1M8uzXsD9IBOw66b7nACrPAQOJ6yHB8+BP47kleW79jjy3iOdWmucKZSjivXf4pOSzTaeWuoSxE33i8sZ7911+q+C/Y8VNU5tCjCcB0MtysH9uWY1k0kVtmmSRShx5OUJcUF5mXW1Nqrykrva0Ap1gehOsSp5IxXlAJsBTHwcwJWdhXQlVLocW5WPRltaPrvJTX66pCWtC0L6H1Q7CLt3heowSxq7SmWC/Yxspb8R0bT9G3NdJJHgoDrMhKP9ExOFmNP+FFeDGPRFKVJKt4aZg3q4vRtdseWhbZObDV341beqNEcG5DX2HCG8kRQUATQy9qvK9hpsB9N4nt992RtVtEbI5YCk3AcsvYA0qrVgLnyX+QN9Hxm5+3PVxwEIHO0AM93P8aK6DRwidIaRSF3/F0ushTotsjpdHC8tq7GDFTuQf+qro8wJ5O7CrKEvEg8Jr7DKmvMvYG2096tv3200VO7+JNdomR6eNopOGbklIE6ZPjouGNWiIcYIjShB+h5KH0V2H3FV/8mc7CwE0yZA7krR6VEuhKFB2yTz3fS9J59N3PTZJZ502zt3+N8aCem60RPtky2tBc1o1BLhdN6UGoz8i3KQAWIkP5EsJNKfFyvNFvTzxUnyGIfP30C6vs6MzDSWNk4KHHhiFzt4MrGjW1WmAEjDuW1OkBO7+JS2wv6CViLG9OyX1clOFY7OmDeJzqTpd7P74v1W2AVJeCwKC3CaZ6lTfNifGDRCX2uCXEzWlNI85Yzare/pEisSNr+Zces30CHlPjvFUcMRlVBx7x7REU/xBKn60n2AmiiIBMlYmta3HdZ3VssnJeF1+yfo2Wyv/7zhKTnkfrqVIyMofevqWFYKErHz163d8wfDRXxSXXbq8A0VdnCjS1Y2OwOEFfnUALjuvEEdu4oNstctJLMtrDytg9Cq/GHzda/GVAE3HLhLI3QSdbh3KPiCMPLPU6VuZ+ogwExtdfvK9iEoHXHJTZDmnvPz2+sbHQLJlHRgtfJ9rbKPSV71bHJ/2w56pXNQcx4fjzfqwQa2GfJZDcv2VXY/b69bllYsv2b7PsuX1tn85TY6MVP0KbtYvk5MRuuRk4ad4KRGTZidQhuXqmlGbRVM9ST5JmKOl/NEmqiILSjfrjfIe42DIgtwYMoL+ty1GVu4AU1HugGaHEV4tJNGgvIGp8gZjOKtulg0qbYBRY2huVgVz2H1MtezCNZRhMWURq1eJgmHckIkCNBGGBrXKJIEEUy0SDLYJ0AAusgSmyhKMo+yeBls8lEOKqg7CF0CqmoGt8C4901oXMEbbl9Vk5Fy0isicDf8veukYEj0uuXP1DEMapLbnn97EThEm4po72hIoCumTfgOcaj8BT8r+rLKBfTM2MlqO3XWnJ4oPnd2Cc1qWbdBaPiHImZl7li195M9kudmMKjZN20G6XiJ/h71Lguh06MmrwzfaBsa8TDsSKpCEMTruwIl7fbTfu6Xkg2QIpEvqQD7Rh9c2Vw/bZzBimE9GPHpHedOtiKOiO7641ZXDTyqhXV7f1IzIZnAcxT4yJkNtDKZM+SncjK3hLOZ4UeapT4xJpUCUsUKoKF5Cr9bbMs5nULT6z43z1TQk5BXww0TIr2qTcb8nmjOArWoGsjBtnMknVwTnRlMxmjwbAABuiFKuuM6NpiI5YTmVZq4ThpL9wEmBP/ukwJAnBaaSUX/6pOAXBKrA+ncPVE03JlZpfE/kbmZF7savjdxNitwxIfsrE4QQ1P9IioSZOilgGScFzHrb8JNGpD8Mey2908xkF53kz09qF6g64vJwMPmRCmoJcZ1arJidz/P7iRvzQfxQc4NSfP3sAq57Xwur7aK0ZvQBkfVyw/VHcKf4k24uhCVYH9ZztBT05tr6sEbM6+cFaKwXdrEhnPysQYNdouYnNIsz3oqEIfI3ZFQGMl9Dma9W+rV/AbNyL0XVAn2u04NaXdUCda7Rg9rkErTMJYBvuXvnIIVnSb3F4Bx9Sjx9gGmYEU4ZhCM6W4LrgueOGkDJDGK5YHjMU53PzTCl7XiQzp999BPETz69mUrWLOuyJzVd3ge2Wv7HmVUD61MD8eDW0s/i7hXu7tKgN/tdNneZf5I9dnN378PpaKnpqegLpC/ooMX7GWiwjpfkKQ6f3rr9TvP5SY9/hKcNH3x5+/4SzHs/vf3ZOfr9Hv3r7d/RNee/ecUrt5zxwrk3XPz+27d88ukPr7xzxrRHv3uLySNBxk0gBUoWMjMQStgamPwOBQVccVu0hACFIDE4wUgKW8omcyDB1Bd+hkjZQMYTBx7ziLlYVbcBZaCbIJAq4IZEMHtOwAIIGjEEElh9srxWH3rA5ERqniNJftezknhSs1CfWUxLpYTY1y4xE5SqNmEWwGQr4XzIJHsZHdTcLB2L+S95OVpJzM2VOtBo3bqyBsSFBIeSAfcnFNiViLE0UY8GLgJMXHoLC4nWqA4Cx0ihah+0vBlVqV8ILE15NBu0HYrgtku0doHSUJnq+06z+DSYi66+YffHHR3yiEv1qCPKBD7iQHpTo259RmYyL89oBfMstN/dOGuGkYOF4IcxX1nSoJ2JdZb9GVvvHAlstq2NdQYIDsuQivr1rTEFJBsCN4cAtJBs14Kr3VbeTxwpi++vhHX0/QiBcCGtfgX7NpB5N/SICokTteJD4B5WLAGF1wQ+wVUu8VW009NUjBQiWzpa/8DACdDlChXyUmBv+jKpbqCcfaRL737k8bsf7h59/LHHn3n8sQfvvgwc+kDW/A43Fkv3rAFBCyUkNawFH30uVV93bX0VuYFH7zJtRB2JsPyLtGH1eYRIqgVM51+k5xuec8euE0wD/T8PutVM8T/m0LQv8mWIx90Jr2CyD7mKekqlr9Pc9jHc8QqYYe/w4bUCgBLPQ8kqsmzLzgdmgXmCzGB6DnNMYMAJx0MfviQj1HB1rMUGViqg1Cv/WiOxpb+TC1rvAdsu/Nd6e3u1Ai8H+3sVTCMqtc3D40dprNd20GtHCtw7drWgAePG4uWPNZnJgknLLuTmVOHeIBbRUtHfP/plkqh7zbI0/MaoXYBFsUYNALYJu/MSFgrSoAgDB7sJBWlYDOISdtdeUnoJg0bpxqIcmKUbWRZMwKVMmKEUi8u/3h2e+/0NTzHzTpxzdr6YOH2cvyvfx/6nOw00CvrU/4PY85sB3bEJGvHp49ZH+Vv9PvZ5CU0JwdBEP0oaeyA09oSKIXiYSUwTLIOOoQn/sdpHuBy3/p/1H3fsDjfbM0CUwFofmQl9IHh69xUmjP1V5g24bHhOMA9vWrf68Q9MMJtHXNiYKOA0ExLDvJfC8SsK/lnHQNx4x+IL55sJJ73s5rgjqwSujfg3Wc/0Zc1Es21WVJfbO1wwKiN+8cItq8Imgqe1Pth++ZQCwUrEGSuKfaybiFq3/bvlX84X5M378q8neXgoTGki1Ke79A5ubRHEz0Z8t73h/gQuwQjR9yh/ICHYPwZx5t2w1l1cIohZ1nTAZI3AmYhLtOd3fGgkXsrkhIpdWStwBuI32+abejUSkPUse0H1wvG5NuIXn/3csr6ROP/60LrVposE+Usgfte+6G4lh5hi8N4OzxSn64Pmn5pqbssh+pJclMvFxen6DCH5Z3z3mcohbEynjpQmrRXsz0acdaZjdWwDMWvy0HXSYYbAYxBveByyRruBuCE7FJW7sQ8flzMR17Z0WpL3jPDEQlOljWbS9UGc0VKT3ldPrM70iMhZK0PXB/E+aWchqXpizigY6MovpuuDOFvXQdK8jlhuV/00MF+SbheIx4RVDAfUEipu0Xa6l6TG57xBpD6yZz2Ka4iAHB/FLJ2lAmcjzmbqVA1WEzasOjiqk48Jjol4Voc4vqqa+FS0s+WY75qCcTkTcb2hCNODVURnU9GUVxxpgTMQb5A4HnOjkhD58eYGUTBWP8R5cyZ5pVYQxnsPnWa9GadLoMdf+n7283LCpuNh7J9dc+jrD61P4kmF0TJis96c6G1RYuNz3gCS/73O7rVlRICZEMunTULgbMSZNY4yB0oJ7KKqddGMxZrj8hjEWWISv06VEOoGUgc8LvbT/RvifeLfDt4qJoRLTy1W8FtN1xdxhnyzdE4RcTt27pI4ptz4XBs9f8PV6y/YxJDZh5u37UU1x+USiPPeKAb2EMSAcqy5wbk1dH0RnyDDbx+FBMZvKBtUpDXH5bx+5Po1CzCwxIlphVbGRjP+oOuPOG+vulNQPlGZYvZBdfMazXF5DOIxis93lOQSdoflD6y/On98zkSc0e3d2JdNvD6jXLXpzlq6/ohLTAOh5U8II8tya7NJ4prjcm00/uW3X2x5RLyd/732teWG8bkE4sxYcuPxB4RIbMB5y6sL6PqjPpetIJpJBPpvdI0ykR2f8/oQX3qqdWsqsf/k8+7LLivG52zE2Upfjc8mEuS9AZWdvzYUjMtjUP87zzMqlkj5e+2XnElfsHE5E/EJF2eFu0QTXSLXr65lri8YlzPQ/JqFlufdITYn/Ag28FtHty90/19ZSewAIiKB+/Wq2Ft8XC6B+hwHad4Nokv79UzoWFowLp9A+//4Nw5nU4h7nVs4hwkfZCJDHSrm0PVBnBlsfFiCBY3DHdPMWsbmV+j+VevW7LkLKjNMlfJjpOn4ENd+72WxJQYOveg3Z8+dSF8fJLK/XFOGTRysGyk4d2bRBvr8iLOjF6SEJMG1taYNty7R+Wuj3lp3piYNhNa93DVgt4yuH+rT2IqfMuCKRpWu1txZAuf1Iu17J0fjzgMIj5p52EJpbHxEnMdJ/FLwCF7ovIm3rKTbHwPxmDsHTD8+AbE/LLBp9nT82oizP4lyJ+SAUm9ksp9YDyZYibi2iYWlch683lWgbj53FV2fHiS+dL/KP59Ct92wDJM1n44PcW18ovFNHLhppuWcnWPzQ8QlRF03VxQCb8e7TDu2LB0f4rw3mwM/EDAiek/3ucpY/466lIv/4iIYEJKtv0hJ0u3/MzJ+rbouk1IEKqFq2/0T6frEIM70mGHNKYZ7j/+qcYycLHAm4qyFWb+Ol4DX6X2rkuTLMUF8iGcpu2oGlsLF7BGDS650/y6B+r2ubqkyqLhm3/1Bmc6f9+lfn+NbqGNUDhflsA0+z8bmT4ifPOczr68c2iUjuv3mjv3+iOttd/fzqoCp2wJPzrEZu/9AfMLmz5mFlcDZ8DHFQFOIri/qwy2mplVwYjTGeN2AEN3/Is7zxnqDq8Fe8rDettN0/8L7iMx/zIxeKtZASnuajp/qDIGzEedpqHk21ED2PAOT0n2ydPyIz+kr/3miFhplbped7unHBfEjzmrK0nxQB6pZC4elR6Xp+NH934/OOlQPCkNbGFLzijFB/RGf0NqV/qUe5vo/Pb5QshoXrEM865HjitBnoPB2RnVPzXK6/h/+deMDDLVTDRCo07voTcQ3un9HnGFtK1vaAB8/YYt8lkjR1w/iH35fnxxY0Rd/dJYk3f4YiH9LqzF34MBfi+KH68LG5p+I25keDSU4kFOwS783YWx8RTx3ltOOBY3wKX9nfpunqMB575H6tVztK2yEoSl6e39ESNP5Ic7gtvcv4EIuJsm93EH/vjGIzyk8b+vAhcoL/Vl1znPp/BBXUL5wsJgL5gXTsg00lgicgfiH5lWPlzZBJI/Vs7FLmM4P8cpTxX6nmuDcc1uReil5un9Ej784ilfVBHEvRZd7ScjR7R/xGDWhjJXNYFJx7K+ThXJ0/u+Q67Py0PCVZqC0LcjedHE6f8QZJm8Lmpuh5XicsPR00QLBa1VbbQGq8V+F/36ucJ5Q14jCw4ZnFBT887HOW8AMBC9xAmUWP/v9GmhxQ5zt77cwdFJbx76GWF0q+EDiydCMf76ZqNXb2fj7Mwo3dZ1w3gtD+K/jojNxc5muRjimqvwzWfMrBRYtLyPmM07h1swLWmE9FHBsPOdctmTh7jecPyzspGD+V1vVg42+2Fn3hdysVxT88P++ilnvg7d9bV3v0ECBdeU7a51hBlYZfm7JjgoKQrnKZl2xLMx1sLxaq5ACpyuuFglhd7DZXt8djZ9Q8IsaCVr2xB8b3nVaJiiNAk6E/EnNQi3sPoer1BNLwXRnlpfK5D/x5dy/M23CKZhVIC998PAtXN9sXsPEYAoMP+n4Ukw9vFbRkV3gTcGioea8VVWBOE82OSPMhYJMQ/OPnVwmpu8fX3n3MgW7g+M/LVzOxK/oX8NyT1OgqdRm2CcegH/y81X7/icFxKH54Ovlg52rOfHZ7CgFaz/PPR/x6jbeZD7FjWdGAUNeXWu4JwxLybNT9DSgIFLNo8blfQD+x6tfK/UOUOBXkrB9ywlv7LnvkZsaOym4NqUra+plJna75VrgHqAgJCmpc8T/NqZ25JzzZTW+7z47sMTSE4OEh7r1ihQMvBe/K7OLibVe7Ti+Q4YCS+FTcCX3Nv7X0S/tb1dToJgq4tQ+7IK1t4l/iRTj1584sSxcUhNnvXrdcGMJBY9FZ5x22eSDTZ/cleA+j4KAmnqvoAXO2GF5reTMGRRkp2YdOHfAFVuYoyj69zQK9p9N65i41QNTfLn/18mJFOz9xrXY3BqAjS469lD4FwlTzPw1mLEeeH90kFXZVxLs9PbV9u4NwmuS1Tcl9pPgL6u//JtQKG7zcqpTRg8JjRtDtD5wTuHD0d0qb96TsHB5/aOlS0Px7qT5JbKdJDjtl07cHe2OrVSZtz+hjQRv+3WXGfOC8RXMtCk7XpNg5rV4d0CiMS4tNywp+pyE5WF7bMM3XMXvJOm9+sIhYW5aMaP36DZM1suaIVxPAnVsmoaIzW3MaMIfvVuqSbg0+d7r9lpnrAErenK/nASFebPBfzQYa+O+6JMuISEr8/LTetZ5TEp6Y/NrgoQLPIPPBX8EYzNbR0If4vx8Yk9NUAkJwBM3RJ5/mEfCntjglto2T3yrzbP7r7NJsFKbXVDedhF30Y08LPOYhK/mV3p2zvPAZwdZVMc94O//YmTJVNVg7LXUk427MkmYGu4tn3P3CjZScadpXjoJIgYrOtqPsrD1BrtbhVJJ+FS+VM+9QgXL2WnivTaZBFX2MZl3SiHYbsn0hScSSYg+H2q9t8sXF2k5n9ceT0LSAUqjTNkXdzdUz7oeR0LGRxmvi4fccImSWpWdsSQYGx++2FofjK9Zaeiidp+EY0uvM1PmGGFnkvc3Gd4jYd1KS4J6FIzXadywiYohwSVPxTN93p848Xr6uXn8ZTLZKZeyPYrLLzuOPYwmQf8mz0CzhYm7heh/v8ZffqZlev2Y+EX8rFXPh3P85axrPuy9pAd+9q/43WH8Ze93hmJKSz3wKtuthz/zl7lNIpY1ESwMLNp07fnH/yP+QF6L0hXcc+LnMwv48TiwbQ1GekIwpSKFib38ZUPH56ntn49jR3SebRzkx7/12SP5sns38XnLtAyk+PmqbNLoz7YPxufX7w/14tdDbHSpupslE0+vWLVzGb9ezkanX+o1heC9QdvDXyWRMMF7lpltOgsLtfF+VZFCwuNPfUXyOX7Ymxjprd1pJIy+L4tgZB/Hfbc/WaSUScJ2q0ET169XsI0XFoZmPCDBVVMsUVwkGC8fDZxu9piE9WKOPrnJFnh3WV3WphwSTPJYV7+vcsRnH6ys2Z5PQsr3oZXbtgXhejpt0S4FJOzzt3nhWO2O5wtVn+xnkyBVHyjzK/MUxuqLdQksJeHpGdF21UYnbNWqzqVHK0k4uvLIyillnvjxbosrNrUkNCt2dHqs8MGUZff2hDeQsPApzuU8DcQt1mg9nNxMQqMiGaFYy8KMHynMj3pFwiPTM85u9m4YMXLJ0KGNn2+k/526ty745UEu4dBJgqdyTdCFZb5YOtc0NPoDCT9ecfYGXGHhNtl+64VIEvIzWg6/KjHEfy7Uzb0/SIL21wTNWXEsXN2k2+/0d379g9PVhp7b4bssfw6cHyVB1dvYoYMMxPdOu6eQNZWCulYr0RejZ7HGon0ssRkUpN0N+vGzIBAXEXthVjyPgkczMhUynM9gEQfdW8OXUhAyEm2u1OmPXW4YtUqV4G9vIsIJ4Llh+zhGcv1SFNgu01HLrDuKPXk/LcRJngK7pUGOGxxsMXsW1SKxiYLGJ7WuS7yZ+I8SC8PpQMGJH6NgkR6AX/US2iu7i4I9yefUMmay8AGvmcKeuhQkCmkmuMeexTzjfrYsMaZg9kptiahAF/yua9WiTgb//EFFzXqm/pi70pvJ7+wp2OcwMc1E3Q1jPJ44KHmGAnGtx0KSzS64VfgV5TtXKaiauUsjT9oLX3/vy4KdHhRwb6ozpmSfxb6Cz3s5FgWnTkfq95S5Yq77K37qh1HQF8gNmDccgL9mxd3PjKPg2tlVHXcz/PB+W3/Z3ZkUCEukbMFL/DEpU2tyeT4FSp+TS0Jk3LA7+Q6bZMooIN05isnHvDHtHc5m5xso6O3U6Mrf5I8vKIxIH3lDQWRd4AENrwvYS1bUX0XvKfCqZWwpmnoI6z8VIFM8+B/EWwV4GzkTTSlNmZkZLpd/wfi33lWobcrMrcOJy8zMzIxhKjPbm5SZmZmZuWNX47N1PiZ9fp7svNmZN1LcT/I2P51DOY7jOYETORWn5jScltNxep7jeV7gRV7Fq3kNr+V1vF7gBF4QBFFQCWpBI2gFnaAXOZEXBVEUVaJa1IhaUSfqVZyKVwkqUaVSqVUalValU+nVnJpXC2pRrVKr1Rq1Vq1T6zWchtcIGlGj0qg1Go1Wo9PotZyW1wpaUavSqrUarVar0+p1nI7XCTpRp9KpdRqdVqfT6fUgUQ/l9ZBaD7fpwdWkl75X/25hRlOX8K5u9XnOaAzp1y8o2NSH5zVGY89IU2ejnfdnArTwc6egnj1/MULgIIXp50FQ1P440Hphf+YKFwLn6vEzEDzfqWuEKeT7E0brtcbUpU9QJ5M1OKJ3Z3hCaHUKjs9CbQ7HR5tWh9ijdxfr01gaQgf+PwdqLSfKiPC30ekJtYqb8xj2PS4LoVZJhwwzjnz6CmOHfGToUPXiAVXJtHivsFNKf3JIiI8d7L+SXB5RaeeAB2ayvFPYFP/JbUmDSvXmXBq9nAzdtnvumGw3yLZCU9d6nnpLfsw2wJSnwBWCeQcfuH4hwn2Fwdct9YY1/80CIV0yaoqRx+kr+m/J14YEnGl8rOCPw8im7EO2bR49jBhCViU9iK1H0kW4F9N8nEI+bnRv4Xd/PSmwLX7z6jgzadS+awZu2Fx7/stLViSW+VRFGni8TJvXkH/Civb3tvfJRaocT1hca6o30Rb2rDd6Z3NyW0qaMrVmLbLIXRUdEOZNjInPM4vZe5Nyp7UNB7WZRu7zXrGDz0wkTR57Der8opU9/yu/Zm9O3R8kjczRx+wD+ZWVU99vepGehCZ3H6odVJncmDK0UNIannxJ7RUfUCc/ufTo9IQdXdXktOf7/DMbG8n5izGnz3l0JsmjCl8Y0LEdmdGo/qs1W0sTdv5fWvf/8lbL2/4RMdP9OaXPhltNjm0fqxTo9Y7cLb9X6bDoWNixhLvK7cNtriR4hpIio84dC55uJvPab1q9oIWbd5FFY3o0eVPBu+2KIn1PtCjvXTglPqfpfZ7UeVHRRX0/bNzxdGirg9b8dVZkOHCneGll9ZbETp1fhysNevKmPb1mK4sTP4+7GRmnrM3T+uvaRk2J/t3Au3yppaTKkdAcpXIdJ3OPb03p3OIeqaMZdDRjnYskY9TXT15d1yoN9k09mXxUbW76eGWjh5D/6/n0Ylq3vMqFgu3Suj+qqxhPF655cmwn5U2xtsYt4R2VWxEnD5U7XZNIT3jlYc7RZMGgKX71I1NIQtMSCVuXbSB1rp7KMWD7YlKKz1ql251A5UTFPX4Vn481515da/oUaavlQv1tplEZ3ZWh0yJTbySLSkrt3Fdiq/grjbsc1WuMauVr6Mp+E8YZyNbiIy5GLu1K3kYFHMm0fCypopyqVaHYWHLqnFS9/ZAQ0vFesbtjzuRT8HzkbN0I/bRRq6O2PaHf7RB6xqf25ndbsaC3jV5Vx2aTPEba7KdJ261WmSS8tdrK1eqqfCCqd9/MPaldB/bcoyfaV2B7Hnhk1vi6TYvktqQf6OvW2tu87rriW3rPhvvVKrv7dXrWKqhx3/p+bnTwAAEgAlQANYDlNA7AocVrJlYH0AP+74KrBqgOMLjgJIAMIC44b4APwNcF5wfwB9RwwdUE1AIEuOBqA+oA6rrg6gHqAxq44BoCGgEau+CaAJoCmrngmgNaAFq64FoBWgPauODaAtoB2rvgjIBAQJALLhgQAgj9re+5f+MaRxggHBABiASYnNjKRLSNcnT5SpMF862jCDl8yDryU5ub+rMQvDM3oAMgLwBHR0AnQGdaq4sD1xXQDdCdcj0cuJ6AXoDelOvjwPUF9AP0p9wAJ/3X5L9goyafe2q1gd5Ln9j863SPbNfDtt+TbU9l696yWtLuhys26z7rhC0usdAWq1XmBj+1xYUvfGDjq+29buM3v9uH1kL9FhpnofdZsC7WoXmxnoXqsVCdFqrLQnXY8nSc9tim48bgc2jRb7foxzjqx36xLvaNuux1UB/Vgfqwb+wT+8J+0eI8YRzeh/1gPntd1IP1qA7Ui3ps8Uui7sjUWhgr/xaPfWFe7BfrUh12Xdg36mb6szD9obUw84P3YT7sE/uy94t1sR7Vg3rZ9WR/H5BHP8ahH+tgP9g35kd9WBfnC+fDvp7M77d9PpjPh4X5fOA6ow6sh3Uc+0Y9WBfn6y8NvfczzyrjJan7B786cT0bm/eMaLNk1Je25rfHTMO9qjaXkksEtuxb3k+6tH9svkq3ZLO2dosPgVUbmfeMz/x6xuuG5nbjmgVueWKUJg12r+FborHkFVPvStsaAebDFdpkOqlqL1Frpn6Mw/vMWBfrYF5aT6J6JKoTdaEOaZ6x0aSiYe2lS628Fjdv1MpMLfrNaNFPLfoxP/aD+VGXhHVQH84Xzgf2jX1iX9gvtejHOJwHrIf5JKyLerAe1YHrg3rMFk8f4emnAIlaM2Ol3+KxL5oX62CfqAN1oU7UzfZnZvpDi36Mw/vs+XB9UQ/2i3WxHs4L6mXWEy367Rb9GIf3YR1cd+wb86M+rEv1oS57v9gP9k37ZD8fZubzgXlRB9bDOqjLrgfr4nyx+53/dvxXOp5ZGAf5b3R4KM7Xucl/M++lFeb6X9KRn6mjYnRw5N9Zf4GpU4vRQf4hHcWZOnWZOm0ZviH5Z9afMHVCmTrdGD7wb9JRlsnTnqkzkOFHMHw38vesfwCTp79znWHTGX4W8hjwJ3VUZOp0dM5DZjJ1EghzzfDTyJ9b/8bOecgEJs9yps42ht/M8FG/U0dV5zilj+J8zfQ7bCej8xhT5wCjYzX5Xes/rCVTZ55znsA0Zl0uMDpuMnUuMTqUX9Dhxaz/cOe4qE3OfOlLzjz3nLn/DVPnCaPjGGHXH88vuI/B8wfuQ/D8gPsIPBfh/gjPw7gvxvMM7mvwPIL7EjxH4n4Sz2+4j8PzDu578HyD+xw8h+F+DM9juC/D8xXus/C8hPsmt18Y+QADAQUY//vkPuE7Gm+WB4k+dw5kOiH3SPRdUKHhZXnzvdPhcbtvyh17xF3297wnj7yVX03WPZRXvy8Y/lr/RB7Sr15Fz+Sn8qd6Oe89kPfJuZRrfScZ98qferfe9jBht2ypfqDYmwo75Q66FT+sumuRW6Ytulu/7Wa5bcXUmDVXV8m50jatv3B4oYw6BgEGA4YAIgFDHZcdMBwwgnIjHbhRgNGAMZQb68CNA4wHTKDcRAduEmAyYArlpjpw0wDTATMoN9OBmwWYDZhDubkO3DzAfMACyi104BYBFgOWUG6pAxcFiAbEUC7WgYsDxAMSKJfowCUBkgEplFv2E0VywpsV6Zwf8JDs8AZg/B4kK7wD2Phf9Xu4yONB/W5MPPodB/rdf+Z+J/+aP6MLv/tv+FEQ+q2+DL/gT8/6YSwHrACspHO9yoFbDVgDWEu5dQ7cesAGwEbKbXLgNgO2ALZSbhvg2NbU/O+XL5RLnPKG12LZo9SgZ6mZl8qjcvt4lBkVJc8ZWDRoS2K0HPm/6B2j3sTIA/OvrHl9QJwcWiZbq30+CXLhMUHwSpIrr4rePuZFilzSNlbKeWxjjZy/2pp81dask2sUatfruP8mufje7vDaLs8oHwCvNPn797n75Wa2cVpm/z3dH3G5enTOB9VzS++qe5TJaDhoyGGouL6QIevZcgbfgoKBz+5r0MxqYXj+rJth/LhxhvPjFxsmeW016KfcNFQIyCsdPlRXWpaSIsGnWk5nnePvbzagsY7vOrbI4bZxhto7cneoFNvtsaXx5pKjHzY6hxb9MuSlWhnLfJ++HbADYHbBWQAKINUFlwbYCdjlwKWjwJ8R31g6q4AgDK0BfxZtS9lNSKPkpO1hAxYiXZJT2CQVRbGmhN3SYWLQjZO0pcGuKd0gv/+99/TT6fN8/vNRHhj5PxYAQnqvYbLanQE5cZ5ayFC/sBOb2lx+OxuF4QljbNf9JKMhiQfWRei4z+WZqRErBJoQ/qrE1PCnfJv2E7nbU/msF0fnon2YZChx4ct+Uud7YhhoxauT2mwI0eZChzZHrPYj25tFzwxdGoZOM/bMKMYrNyOy5QhuM9yoDNRAuFSGpWsecMlBH8WvVqTL7ObDt0cs9mulW1uQ8PWH6Xf9yozbVghZHkNlhDl+A0tpSXJlZmYlGh3neJcwje3WJxGa8pEDZ+25MsmKYwZOBFcNIfOHKQICqpSYi/M4/g/83u7A9Wgu0oXLKHcsQPhzHZtD5DniU0js1FOY3KxH2uIpMXqjGCU4hHqgPvlqnzmzpoGMADXmLy5gumszl3u2s2iGDkFtJbQenIb/iVm4zPXnpXsfKoq+iOsac29SMQXSF0kpzEfB1BAxLAkNWMo7L0XOF59D3QZSn/mTGncaTbOXvNbr4vo4KUx9BrC7KI/n6yRs/XvYc8sCSfFP5K4wR/dVNXH7tZg7p5RXh33ZsnEOzEijVWQK0hWNXFYdwmG6C2ctrEnuX0ZgUBWz7R+g9jmMjzk7aC4sZ6eGMJb6L5BoeM0m3QYazofzbLYssqGfebvJlOISNYTeSdAUUIpk7lrap8Uh1bQVpYkLCZlgQ8jyYXQe30rKrSCmf2lj+Upjxjk+J7G+ihtWRrhYVyAiG83zs6kIxLaxzTeI6/khWP92iMN//MnNo1vweJ2FYqwtHTmlHNvbzPw8R8xKllBSrYFs/DPyrY8x4bEvI+dPYsLS8xRuLuSfIhNM75wEyXZeGKcgt+IDgy/HQfYA0yPL8Kz4wUS9Tv5tDebupwIe9cgSMSqSPC89lITvIrqknUMTLpA00w+le5dZFp6Pn5oyYmZueMedwPXTDFRLT/GXxEoM/3pLR2MYnyNP8/bjfs6qnubQd1esrDTIGBzD8nOpOEbvxMvbiGOWalwWf0jmB2GOqc6je5c2KqOmMlpsGKuEnFD4sYlliSfY9Wk4Wa/m0h0Qi/tyby5LNHM8MpbUk1083bCOSpE2Zp5Rp3NVIHdsnajXs8LAcgQHwoIwWy+Hpl0ublXjUFuuxtbfd7Pa6wVLNrojKpyHfKczkxxeIiN4EcuRa0nVreWrTxEHeyVZ4RrANJl0TjnLUVyWTMqkjZx468Kh6jAUvNcyMjobX8FI2lU8YUCGr17xOOSvwK5pMafrQ7iufxrjyEFGhx5F1bCBcO2L1HseRfLBJ4QadRHXXMC24CtsCY5g3Phwxn6uYmfwTWqHVqF1YiybpXywiRHHujSDR2FpjDPI4lnbSFbsluHb/S5qZ2cgMimRsPnK2IX4IKyrzpjIyazTSWTa9Xxufr/BtvkTcMs3RXHPBXLNTzNCPwThli4WGBzFTfUs2qmCiM0Up6pgK53hhRSnrGJ1SQxxmuV8TNAgKTySeiMnpG0b8DnajNOR9QzUanLjahKN4qr8MhDrr8HO1IHvox4gZ6+ChXkOy4Z0cOlNY3d2O7IRjSQFq+BwtIuRpeL0zRag+v00Ft+NxmLK32iUC7Pa6AsTs6NRn3OPlsTJrLGP51leDKL6Y9n6Zzlzen3wOzKSMElvimM34OH+luZvcH7lJgprHpDokI5PZSVPh0/jdqsiR8/mUZDiS+jyGrotr1Ac3EFyizL1/55Df1smTxrcOPFoBvK197k+TwduniNlQwT3LUYip5jKquBAagTj8Ekcg9/mq0hMkKfugSJ9HwYJq/1JWPYg7312IpAwgF6wJwfcxRk8OISsniDWjurIS4VimvX11z3d5G83d6IctVHN2cr+18tRaZTgkaIx86wX8dizApXSh+TsHCSaa4za+Z4t9VeY5bEMmwnPSNu2H0/rFbiaN3F2/TDWmmky/eUD1FsLmehuhaXKew4oJTDtTgFX1TQQehDN19svkOiexd/O75EZ8kVsRDDHDBRZU36FmTFnuXvtOcqWIqT2GjG+ppSA7Cecr80jSTKLkmt7EXLZhpKZJDKYETSphTeCoUwSteOU4TEOZjdQMyiP67z7+IUtZFT7T9JyLuHksoaV8vGsKdyCYk8mr7ecoeNRFKNNjzFTJ5ZoCysm6d8mWCuKspnD8KoP5XHDfXJ2dGJqP55hgq4cvZXMndwnrDNbzvT+MUR5F3BdQJdcg0UI1PnRtKSM1XJ9vCr5h8/thvjbNXDerorqbFWiTxfgu+kFzu+KaKmZSLrObyyVWorZbiueZXXiHl5MspIlY0y+M1XPCOvCg8gNfuHTq3Zm+5fgcXIRQk1FDL0+hrvLW24NFhMhlIe/5S5cU+5Q7n4RPW8/ise70F2ZgNwfjdx7nM4D1vH2zmh2pc/lQ8AOdlUdZrS4AnulxAh0iGSYnASX9/gwOJiN+ZJmqgM1+Ld6IkfS0yg8PYBqvAyt7gVEFmlQFW9Oavw9KsvGMCFMEQ+LhSiYh3G24h2vZqbhuj0RPfkLjLcqY1B0JW86+jmu68bbUAW+vNjPQGoCzT+eorToMcra1mjNMmFK9T/sHRChf6ULylOr2JC6n9Vnj7JxdhnyZnXkFr9CVPoUkz0f4hxlx/wtO9Bf/4Og8WPpuDeegdJOFmYq/uIffLYso377DhyPnydcvZnHkg+x3nSeNxaZrAsppkpvHPVey1GcWs9NqavMUljK5vbXVO85w6WNuawJ7cNcYIAPf90gbLYGWimzcYyow+xzIvvma1Hy6TzrRkdzVv02Ca/H4DxqOfZ3Wgg6FMeh30/T+1SDWeF38du3kjOVszC4XEfdMjPe7NLB8ZsRPy82sv2FFX6O0aQn78Gs6xoLDs3BMN2Mze5CzJIPRXtZCGHvPvLh0gtW9BswZP6FqWNLKNp8mMi+BTzPK2JsUSW1W26wrCiUA8Y2zArVReGvSMZZH0T+dz+CFSZjnDOBQ/NP8OdvYcQXvudDrR+FOvnM7/hKt+OvHQjPwf76AhZH3CbLX5TodXXI1Nvi/Kaec5HSxMtF4VQhi/D3VEwuz2T1mRI899kS6D+HsWlqxHUeZ5L5J2a1CnHvojwegabESK/jXm8S+xpfcareGgmN4b9iXibk2lW8v7uhfWwP+x4m4Kq2jaUyW2Hhd57hy0CHGcM2m9L0f13cBzhV/x/A8XOtyB5RVreyE1ca1Dm+V1OT1K+p8mtQJJcWDa5RoeFqSoPSXjRR53SupLS4pLLdls21M+L8v6e+Pc/v+bfOefW5E/eZ5/MOEmLwF5/tKbEn42Zsd4EHYeKs33tL3ovehUxlHWXU6szejmu+24n16Mhvk9jbm3RsnphcJc1pnfATYKKa0PB3n+mR9bZ+IbrQmPrzlsDPdMqjPmXv9m6ASRfpftP9TO87rDvyaiF0iJXTqsxPdOHDXNU591gLRf+s/kQ/UbN3nJ0AjQ3fKZH7RI+ZNnp4chC0SHTgzfWPdKnplTPuntAe8kunu3+kX5jF31zqCM33z5ncXUzrVZz3f6DHzq8PXDtfTM/3eum5obsLYNdjnY/NLKbdbRMe+ZZAZ6Y7dzZ/oKtEq96ST6AF8TPyT32gQwxL2/89D51CGZjyP9AHl87SWSqEFs6Sfa0voj/41+afXg8t5TkZnSiij4df+2o+Gzqm7HCuSxEdNVNpGmMDLbK0/lJfSFdT98tHa0L3uI0NOFlIf66aMDu+oxM6K8nXtZDmW1UVTC+BTpSdkDRL6LzUELELBa1VPvxKkoSOM5fmhF+CzlzvWTNbArsKxWaKMdCtB2aObiygVceNMMoPgE432DF3dgG9ZLjzh9LF0DwtYsblfHpl9MMZllPYef0Mdbl8ur9nmOsjLnTrLutL3u/pe50uZZFDoEUnFTjid3T84LLV8S0d8Pljl1pz39H181VTSj+yjjhiEPGWHputJfamoCUf3r3++obOLNsx1uwKtEjHjj/zDS0nSX4/+gh0q8mmXddf08a7o3NX7YDmuW0OUHtNf510Z07+amjxzKvcoDyaX7wgMXQWO9d7GP/pFW32lsn3socWrMMz8Vf0HPWLO3YNh/aefDYp9SUtcnaZnMeBTslY4qD6knbtOfl0YWM7vL/Zzn3bcunCGyPkhn5k/Tx+T8UL2mYg43rvM2isaJHtrBf0LSO13cY3WEeRcek5NO+RnnfwcdZz/M8Y5dBdF5ct69sHzb8sWnLwOU1PNTn7YBN0SmhPVkc2TXXFR51fzNrWPM87m56q/Ppmhgs09+ey8Hwx/Zh/YyzHhp0PzqnAxfR413enQodBC+eR1DKaPvuryITLgebzTylPfkarui2Y09nUBt3rkmhA0Zs3xnt2lUCnlCz07X1K7w1bpj0mF9rbnhta8YSut3i7fe89aKFVbY44i35saKvGuQAtDn4w62omTQke70mPg8ZuP+AcyaAfkzLzuF2snWa2bYd7/w7zJx7ZAC08GKCx5hFdudZSlLUIWnqxysvtIT2/aPxlDQCd4reg1PEBXdarFXzIFto7tyeUe592eNRkxTOE5q5LnKVxj06bEF3WPwQaK/Lb0pdGP/BfqNnS1Qow/q65R8ru0PnJNquVvkNj+783kbfoUVds188oghbr8GMv3qANE7/uvSZmLee4POYaXTjpZZR9GrTwk++aoCu0s25KYvl51hvnxHml0tW1nmm3DkPzh234Nuci3W+10D55DztvjBQHX6BHxE88/MiPtadn2z9JtG1v05WWFawjCtYRp2iRbeH7OXOgsZuH+62O0TfutL586cS6l7vH4TB9Y3yo7kar3/PVE0dE027bGizNhrNuei6vE0KfvKenpKDM2ixURcGbNuyz+DlSKoMWRXfIAsH2hn+fG19kTUx0rTgI7M5EpGuthxY+f5Gafxy8v9OCd5uz81i97OSzoFY3QT6vvgVaO78k/SK4de9tiPAutJgjWRV3BZxVO3/JcDu0sIQf5XUDPDozNCphCutlMj/LO2BpkreKlAMtTvyRuCMdJD7d9YPzphnA9OG3rsX3gXzCXtX2Y9CY06FKu4cg36vf57YXtHjZwRVKj8H5qjU3bS3Zud/EnWUZ4L2tv8vW9iYAO0ELp9/KAnKh1y4FPGOt/vRVyFMQoDw5wOIQNLd2vO50CigsX02dWM7Oq4IchtLgcPJTx0cW0PyEscN8xQDUNrVEdTUCLP1Y5P7Z2SD7VPmOgRfQvDfvt1o8B1ZzD6iZnoT2yL36WT4H2LrIcr9uhNZyxHOqc8ChmNe+bpOhhbv9Jz15AebyTEbNU4FuLbRyPp4LwmTt++vKG6CHm733ewkuEd4OJmnQIp+mHv4rcG35B1ATyc4Nu8TD8sChbSoy/jJoYfcS6/o8YDnvlsjGFprfIzfp6WtQ2H5cN4UDjdkaNx96A4zwcrPkz/UAk3C8Fq16C0T3Xima34UWk+98rd8B+/zT7Xb7ob3dPk7sfgd2zLvc8sSLnc+aQGW/B05utedfToCWFmRyDueDGk9fe3d1aJGBWOWfAnD+M3PUs6YOYJkjdbZoSMBe7F1yPg0tOa6RGSQBGjnPysRnoAUHLvgXS0C/wZibltvZ+TzHg5MKgXLSg9uYO7TbGF/1xELwj8vGujk20MJ3UqanEHjLdZ7kKEFvWv957YoiYJ0qXW/+tRZg1/VUeFlF4M6jil0PnkF7T9cKHv4BPDc/7XvzLPTwpgCLXR/AMiWD9iGh0Ly0fvePH4Ca7qfyN0uhpfbfWsYXA//H7hxMqwbgq6YlbJELw08+XCCP8WqA62rMrYE+gocUn1DHPGpAxpVPB66FH8XvBC4cgglqwHzzJf4Nv/7F72pWDzLxNWBAY8V8y7C9JJm7fgiWXgM4ZRVum7LjyO5sL1NMUgO0j885bwyicJduxUZGVgMWj/tqqCAMI4WnD2hgWrXAM1QlyIfZg+vU+/5i7GuB2UHK4it2GPfTjqhm3GtBEadta4LcVlJ0zlcTE9SC7eeWvA/65UtOzAvrY+JrQZRC14XsZxF4zXPuIJNWCzZueGdtECYgsdegmSmoBcaH9igHC4XkTkOLekZWC+72ng+wEh/B61LPKWBadcBx/o9FReGxeLztcQOMVwciOniP6wfjyHPbHJUwjzpATtzoT9Ox+MvYaVxMUAd27NHu2EgfIhVCuxqZ+Dqw7C1xaSsWS1YrkKOx9DowdJ7UqRrbR8YZqf1gCuqAYjIzKwiLIacfTfjFyOqAk2C3ZE9EFP5qbZ8pplUP5B9W70xwicWz9szSxXj1YKdc4ryFwnA8cEhLDeNeD+zWMaWtYfFkoQ5exQTWgydOFqduRgpI9biZnUx8PZBd35BgJDxIutglVjJp9WDy8ZVxUv5B0qd/Dnz/7M/v2WzlfIAvOtfGxVrrwdBVMZY3QRyplD5TG9NqAEvLlp9xY7bjfd1Ph2C8BjA8YGzcrWeH8VCT01qYRwPghYZUvhmMwd3sukwwQQMov1VC7HSNJz0dVxhjogags/N5tBx9lJzn4m6DpTeAtYDBFQY2k4Wmdz8zBQ3goUCkU+sSSYYoLGphZA0gtUpD6qLkh69S31jOaDaCrKEjnfKUVuLL3twcZOwbgQk+ZrspJ5SseHKylHFvBMk2BzZpMaHkuY0XzDBBI3BxPyCZycThfP2DvUx8I+jNeX5q1+Be3P2tQhGT1ghejG1vsWTWkzO9XIuYgkYwqmFqSwazhaxWWd/DyBqBl6rdaXnXCHLxzkdfGM0mMMIv48SG7EP4t2V9bYx9E2h+yTsiG9xAmn2nKxj3JrBjdhO5CUSTP7OWNDOBTaBJurg1NSwa/xh/Bn7/m0Dbsd4jSlHb8KRR5qOw9CagoDF8w9GBTeS5WScqmYImENzwyvhZ2FF854uBBkbWBAZjku84PzuKj+1J0se0mkHQyqzrCft24CY/NdUxXjMoeyXYLMqOxV9ohjYw7s1AbXB57mSN5eSPgxV2mKAZzNDMXvBJGE7ejKwYhYmagZfXwIn4vdvJKDn/EiatGYT9OyrXJPww7jx7izUmaQaL7zH3L3Bi8C7RjB+MrBnupXm+LMK24ie6b71nNFtA0eZxXH5UOFmZ51nO2LeADcpGb7KxPbhMf1o7494CFt06kX6dCca118TVMYFw7/KZ7N627mWkOnNBGxO1AE6e6pojwmhyhsGVaiatBTziTv+ohIXgF8N1DDFJCzjmtdS7R86DfAE3MbHWFqBdM3H1DP5+Uu7I7i5GUwYUE2TODv3u5Ku4H6YYD+6Va29rvx0Rh5+YENnFuMvA9Fefi11BHO4//8YvJlAGdoQkGnfKrSNdX/R+YeJlYF7trs7CfbvwsG9S+P2XAYfUvUkjOIHkhe+7jDGJDNy7nT+vJSIId8iR/mRkMrDyoIAzWXErudV7Yyej2QrKhhrPuRMWRy7ffaCDsW8F0vu/cjaHnyYN1H8NMO6tYNWJtxMG6dN45IL38pigFbxd+l0chUXidW/b4c9fKzDcMflZNRNAbixT42DpraDRouZuOEggnT5c5mCSVvAz2S20b58QHxgo62NkrUDs/0mgqLCLPDXwRBXTagPrVAOii4VH8dWdP/oY+zYgmzSwoY8+j5cmfVTHPNrAXQ8dwS4sCU/6Z5QmJmgDLVXfvvYOHMEtllj+YuLbwLbgqRU8LAFfgRM6WHobiOHIC0PDz+AZF6x7mII24Hs4+db43o0kVhzXycjaQOOqa+fp8OP45QOH1DCtdjB61UCCvzAZl5++Xx7jtQNHOrnxOXMcj+4mGca9HQTb2YXVcnbipaOsu5jAdvCvWvjOp7/CcXzKcT1M1A7Gusrhb+SCSd31/+hh6e1AbmS7Y6TwGDnVc7CRKWgH7RXuTmFMDHnqTqYq1toOcl15HouY/WTa1939jGYHOG+1JiYIiyDD196Gn/8OMCwjA6xmEsilvlfVMI8OQEUeGh0ZfhIf9bNfGxN0gHcf1V88wYR4lv0K+PXvAIuu3R93HpwgpxVVKmDpHeCL006Bf/h+fNnr+11MQQdw0KG1psjtxoc/TIefvw6Q7nnPJyA8Ee9MGz8M0+oEZvtHrJ3c44tbH5ptgPE6wfRFFcE1nCh8/cOTtYx7J1gZez9zMxOLS3cowJ//TrCk/fnZe+KTZG12oIyJ7wTBNlPaVfhncYVrz34waZ1g5j51OoM5QVZZahlgkk5A+FUEbRCfIb+6tGpirZ3AePF+1djw03jhvAodTKsLTLrsE7RRwRvfbamoj/G6gMr4Mfn59ClyvqC8iXHvAp8vKioGy8WSN5aslTGBXUBnw2uNGvosrqNVY4CJuoBIlhaRGxaDH3N5LY+ldwGxGj1U2TWZJEfMMcEkXcB6tnm/TUQiGbs7s5aRdQGFzc3CjLAT5GqC3UNHfYwYZ2KGwY4+z3RkrAQfLIV76WLkECuK3llcWVGALDYlrNk99WpkrIT8NmVF4jHZX5PkgeNwb51BLrGnUsd1+mzXrEXPZ0vlsHvsI5HFuoRiQcOBSHtknhPlye61A2QxRv1693ki5Y4cY0+0sXvua5Gl8oRbwK17ZgJkiSXlxO69C5GxShIzue2UJfrrb3jI7z34v24mvSU7VfbcQ+ZzCUd2Lz4bGUvBJx1g1vkVIYssqKnsnvxXZKkcVZeTEH2wA3m5GbXQCO7NK9Sh+zsShkMK7xTp/bUmEfYe7tGbI4tHUZJpWabzJyFLrIlHb+Be/WxkrdkEuSrZoHMZsvdoIi0B7tlvQn4xnjqZ6lD6JhQZG0NlboR793HIQhsKWx5yWXIWGr3fMZfYPXxkK0eib8SnJ4rPkB9OI6Kmw738AmSJHTXfR3mNnxTZg0sNCYF7+m3IVlaEhq2VZFCu/o/TjalT7N6+HrJUkeq1v7k4xxyZ34XPfQn3+Ccjcw2Iu4lrx2a6IWMq1Ft2r38l8iZzYlTgzqRKf2TJJMqG3fPfh4xxqNQxu787xv/1OEJBCe79pyBfdqJimcULnt5H9ppIrGpjOwDImRZEbua8Eds/IWNN5FG2C1CHLDEg5DqGHFnTh8zXJxawnQC1BnT7LrI782jzblNkqQphaQe7ATzkEhti9dBZwtfTkFsNqbNsR+AfZG9VQnddZ9xcX+QYJ+Ia2xUIReZqE0fsshcPHkIWKxFFv2Bn4AJypjWVGThx1I90ZMFYIoLtDuQgY6W40BKfwnz86+94ahHbIUAW2VK+HaNr5vcje+gTogzYJdBo/ONie+JGbNKWfC6yQIeYZwg7BY7IsxcQtbMzhkXPQnZyon53C1YgY4m4X26b9dYtyJKhhAfbMQhHFlbh9+dYth8+hixWoOTZrsEVZIE65ROYlCHNRBapEwzbOXiHnCJHBF7syNlcjRwykso0gd2DduQULar+vuu/VkpNf8zXpqS/OwjIUlWiZUNfqfE4ZL4KZc92EfjIEg1q2EBfyOwlyD7OxFsJ7CT4ImsZUo+zY2Kv7/lj4czllCPbTYhHczdDqvrFomX8VGTsLX6C7ShkIPM5RKx+gJ3mW2RuK67zAnYVqpG9O/Cpt1atGtaBLFKiSLazMKQZvT8Voi9PeexiI2TpMGp/HOwu2CNbmRDyl9405E1HTuEQCb87DMhYNX6xZl3dzi3IKfLUQrbLIEQuUaNE3kzQ6pPI4k78LttpuIEsYnDzqCmf9j5DFtbjM9luwwdkbhdJKxpv+FiLLDChmpJgx+EXsp4+tWbfCH9f7ZY/dlMlalNh18ECOZ9PeLXoT3WcirxJjXjIdh48kHkq1KYAXzPnjcjYD3IG233YjdwzhLLIeL8rNB5Z0EHW/e5AIEt+4N/f7D3QmYVsqE+ob4JdiAJkjy5cb//wSze/I/Nf4rpsJ6IPWdhCKrk+Nj6nKUOf3z5yfRbsRpgjw8/XjuBKt9dTkLGbuBnbkfBAbu0kB2bEhI73QRa+wZ3YrsQeZLIPj8TN5EoSkL2LyaNsZ+Iaspoqpf3x2KQnFLJUTJ5guxMf/lhYpUW1jLHxL61H8+kt+P9fV/SMXNlnqIrMf0DKs10qfWQDHSpSbqreplHI/Cf4FrZTZYucKMPfPNW2K56MzH9FxrLdqunIvBLcd0l38NqFyMCQWsl2rFYgR8tRJ0fiGkM3Inu34YY/YddKgGw2jBh3PXhs8R7klHpSwnauDiLza/C8IT7d1DHkEIz63b26gIwlkjznkWdf3UBOYfBfMWwHCzmvj4zb8n1mmxhZXIrru8Eu1jtkriJRstp5zNQSZEkf2cF2sr4h3zYirt6oXntFhlynQLUWwW5WPzJPnZo35rMVb0gb+nlqw1exHS1dZKwJ77VZc6vcFJnUJz6yXS0bZH4dvk+hXe/6JGSJBlXPdramIUvrcCcH9+MnFyLzG/Egtru1EpmnSFTnBC257IPsJE9oe7IdLuRiKyL56ckDxWHIEkXqONvlikOOMaZ8Vk9ebnEauVWbuMZ2ulKR3bSIbwd1e86kITvPppasht2up8jfzYjpxlYn7fOQuUOp+2zHqxhZ+A134D9cUytFFjfgTmzXqxlZxCF+vneKzu5FDjGi4o/AzpdS+x+fGEeYXg+Z+EwHGSvBXSth92sk8oSxxBjd0EuVY5F7RhC1/7IdMOS8EZSlXmT/yJnIPDlCju2CLUJ206XS802D9q9BFugQ+vtgJ8wfWaJNaEpNJmiEILc4EC5sNywaWaxH8Z4m7HiSgFyiS6lUw47YBeR0ZeKsRqFP3C3kvaOpKWWwK5aJDHvFvYa7nMNykYVaVKkc7IwVIcOfh9BhG0aeqkbmdpIFdrA71oScaEaNjqHmFvUi8/Qp88dsh6zjjyeNp1SvtDSP1/tjYbWAyvwMu2Sj0NxtNHWp/vrUTDvkRHPKxwB2ynBkiSlh2ffNZ90cZKyC1GS7ZUuRS3hUVkzVJYcNyHmjCeebsGMWhOzNJQa3m46xCP9rfcqJ7ZodRpYOpXJcgoz4ScjBMyhuCuycXUPmKhMntzbR4Y+QhS5EO9s9y/lrGT76S/OMHxLkFAPq6e8OGjLPgni30Lha0IR81Y06HAa7aH3IFTj1NMU3Z7Ry5x9nmhMn2U6aPrLYlJg1S8Wyfwyyty7FvQG7aQ7IiWOIxqxo0AeQsT58BNtRW4gs7iY5Rdemcb3+WpXSZ7tqfshCHcrC8ZBPQAiylEdgbGftADJ/HKWQduzLlxPIXDUimO2upSJ7mFKczICGffeQhUOIL9Zsh+2vdanx2QaZrvl/jRHlbJetAllgS5y6VRIxrhFZakzJjYOdtl5k7ggi22FmuKtyF3r9ypQN223TR8b6yIZFoG6fObLyXKJsIey4TUAusaAMb3d3fp2GPGM8VX4Cdt0WIeNuhL92faXAGzndjKiyhp23QOSVroTGi6/llmHIUmsqkO2+HUFWHkPNV2Uslc8hNy0gLH934JCxF2Tn7uv92k+QlXmEKtuFe42cZ0GBo2dEM0uQk2YRX7iwE1eLzDei3jRWcFO7kQUGRCbbjVPs/uMeC2LYz/c1NsOQMQ7hwHbkzJAlw6hH1iNMKh3/WofSZbty05GFDWTfUXIwyxPZ24o67Qg7c+uQB4OIo+OVX2UHIXMnU2Fsdy4CWViDB524cK9ThBxiTaE8CP1//QUacxV/iFBWLZGr24xx6kZiHC0/jNMFj2Jo9lyfi3Hy4Dl782J45KALtv9eaKuILrQd8p8Lznl+f26n8t/boQvbVdEF8exjO8HHLkaPvQFaHV1Erwn/sq9nNZyzt/ODRw+/P+e74Plyvz/3SWT/Dx61/xPAUPDHOLrwqIeWL9j7iND92Xkmuo8+ug87T4HzRDQvQXOD/8wf/Wfeg+bD/zN/iebs+ef/PBeGreD/DwTAA/g=";
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
