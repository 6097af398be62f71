// Numbers as pictures: colour tables, the PSF, maps over the pupil, and what the sensor records.

// Every 24th part of inferno and viridis (S. van der Walt and N. Smith, CC0) and of cividis (J. R. Nunez, C. R. Anderton and
// R. S. Renslow, PLoS ONE 13, e0199239 (2018)); straight lines between them stay within 6/255 of the tables of 256 colours.
const ANCHORS = {
  inferno: "000004050417110a30210c4a320a5e450a6957106e67166e781c6d8a226a9a2865ab2f5ebc3754ca404ad84c3ee45a31ed6925f57b17f98e09fca108fbb61af9cb35f4df53f2f27dfcffa4",
  viridis: "440154471063481f70472d7b4439834046883b528b365d8d31688e2c728e287c8e24868e21918c1f9a8a20a48628ae8035b77948c16e5ec96275d05490d743addc30c8e020e5e419fde725",
  cividis: "00224e002a5f0031701a386f2a3f6d38476c434e6c4d556c575d6d61656f6a6c717374757d7c78868379918b789b9476a59c74b0a571bcae6cc6b667d2c060dec958e9d34ef6dd3ffee838",
  gray: "000000ffffff", // of sRGB, whose steps look even by themselves
  // Blue over white to red, for what has a sign.
  signed: "2a4a8c3f6fb36d9bd0a5c4e3dbe6f0f5f3efefd9ccdfa893ca7460a9443f7c2230",
};

export function colour(map, t) {
  const text = ANCHORS[map];
  const last = text.length / 6 - 1;
  const place = Math.min(1, Math.max(0, t)) * last;
  const low = Math.min(Math.floor(place), last - 1);
  return [0, 2, 4].map((at) => {
    const [a, b] = [low, low + 1].map((k) => parseInt(text.slice(6 * k + at, 6 * k + at + 2), 16));
    return Math.round(a + (b - a) * (place - low));
  });
}

export const DECADES = 5; // that the logarithmic stretch shows
export const RAYS = "#5ee0ff";
export const TRUE_COLOUR = "colour";

// The table of colours of a state: "auto" is true colour where there is one.
export const mapOf = ({ map, light }) => (map !== "auto" ? map : light === "white" ? TRUE_COLOUR : "inferno");

const STRETCHES = {
  linear: (share) => share,
  sqrt: Math.sqrt,
  log: (share) => 1 + Math.log10(Math.max(share, 1e-30)) / DECADES,
};

const pack = ([r, g, b], alpha = 255) => ((alpha << 24) | (b << 16) | (g << 8) | r) >>> 0;

// Colours by the fourth root of a value, so that one table of 4096 holds every stretch.
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

export function largest(values) {
  let top = 0;
  for (let i = 0; i < values.length; i++) if (values[i] > top) top = values[i];
  return top;
}

// The middle `crop` pixels of a square of values, with `top` as the top of the stretch. Planes of linear colour, scaled as the
// values are, keep their hue: their brightest component is as bright as the grey of the value.
export function drawPsf(canvas, { values, side, colour: planes }, { map, stretch, crop = side, top = largest(values) }) {
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

// The colours from nothing to the brightest value, and [place, label] of its ticks; `top` is in electrons where counts are drawn.
export function drawBar(canvas, { map, stretch }, top = 1) {
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
  // Labels have room, on a bar of 200 pixels too.
  return ticks.filter(([at, word], k) => k === 0 || at - ticks[k - 1][0] > (6 * word.length + 6) / 200);
}

const integers = (first, last) => Array.from({ length: last - first + 1 }, (_, i) => first + i);
const tickStep = (top) => {
  const power = 10 ** Math.floor(Math.log10(top / 4));
  return power * [1, 2, 2.5, 5, 10].find((step) => step * power >= (top / 4) * (1 - 1e-9));
};

// As Python and files of tables have it, so that it reads alike in pictures, sentences and CSV.
export const powerOfTen = (power) => (power === 0 ? "1" : `1e${power}`);

// B minus A on the grid of the middle `crop` pixels of B, as light per area over `top`; A is interpolated where grids differ.
export function difference(b, a, crop, top) {
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

// Values with a sign, -1 to 1 over `reach`; the colour in the middle of the table is nothing.
export function drawSigned(canvas, values, side, reach, stretch) {
  const { context, image, out } = pixels(canvas, side, side);
  const colours = ramp("signed");
  const scale = reach > 0 ? 1 / reach : 0;
  for (let i = 0; i < out.length; i++) out[i] = colours[Math.round(255.5 + 255.5 * signedPlace(values[i] * scale, stretch))];
  context.putImageData(image, 0, 0);
}

const signedPlace = (value, stretch) => Math.sign(value) * Math.max(0, STRETCHES[stretch](Math.abs(value)));

export function drawSignedBar(canvas, stretch, reach) {
  const { context, image, out } = pixels(canvas, 256, 1);
  for (let x = 0; x < 256; x++) out[x] = pack(colour("signed", x / 255));
  context.putImageData(image, 0, 0);
  const shares = stretch === "log" ? [1e-4, 1e-2, 1] : stretch === "sqrt" ? [0.25, 1] : [0.5, 1];
  const word = (share) => String(Number((share * reach).toPrecision(2)));
  const [low, high] = [-1, 1].map((sign) => shares.map((share) => [0.5 + 0.5 * signedPlace(sign * share, stretch), `${sign < 0 ? "−" : "+"}${word(share)}`]));
  return [...low.reverse(), [0.5, "0"], ...high];
}

// Where rays arrive, micrometres from the axis, as [across, down] over a picture of a field with the axis at `middle` of its side.
export function placesOfRays({ x, y }, { middle, field }) {
  const places = Array.from(x, (at, i) => [middle + at / field, middle + y[i] / field]);
  return places.filter((place) => place.every((at) => at >= 0 && at <= 1));
}

const ramps = new Map();
function ramp(map) {
  if (!ramps.has(map)) ramps.set(map, Uint32Array.from({ length: 512 }, (_, i) => pack(colour(map, i / 511))));
  return ramps.get(map);
}

// The wavefront in signed colours, and the pupil as it looks in an interferometer: a fringe for each wave.
export function drawWavefront(canvas, wavefront, side) {
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

// Grey where fringes are finer than the pixels resolve; returns whether none is.
export function drawFringes(canvas, wavefront, side) {
  const { context, image, out } = pixels(canvas, side, side);
  const colours = ramp("gray");
  let resolved = true;
  for (let i = 0; i < out.length; i++) {
    const waves = wavefront[i];
    // A neighbour within the row or column that is outside of the pupil does not count.
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

// About the mean over the clear part: piston is nobody's concern.
export function statistics(wavefront) {
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

export function drawPicture(canvas, { planes, width, height, count }) {
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

// Where the axis is in a square of so many pixels, over its side: the middle of a pixel.
export const axisOf = (count) => (Math.floor(count / 2) + 0.5) / count;

// What is drawn of a field, redrawn over another: `ratio` times as large, with the axis from one share of the side to another.
export function drawAtScale(canvas, source, { ratio, side, from, to, ground, smooth }) {
  const context = fit(canvas, side, side);
  context.fillStyle = ground;
  context.fillRect(0, 0, side, side);
  const size = side * ratio;
  const corner = side * to - size * from;
  context.imageSmoothingEnabled = smooth;
  context.drawImage(source, corner, corner, size, size);
}
