// Pictures to look at through the lens: planes of linear light, 0 to 1, stars above. Own ones stay in the browser.

const WIDTH = 384;
const HEIGHT = 288;

export const PICTURES = {
  star: "Siemens star",
  bars: "Bars",
  text: "Text",
  points: "Stars at night",
  own: "Own picture …",
};

const drawn = new Map();

export function testPicture(name) {
  if (!drawn.has(name)) {
    const draw = { star, bars, text, points }[name] ?? star;
    drawn.set(name, { planes: draw(), width: WIDTH, height: HEIGHT, count: 1 });
  }
  return drawn.get(name);
}

// The mean over the area of each pixel, by its middle third; at(x, y) is the light at a point.
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

export const STAR = { spokes: 36, radius: 136, middle: [WIDTH / 2, HEIGHT / 2] };

function star() {
  return sampled((x, y) => {
    const dx = x - WIDTH / 2;
    const dy = y - HEIGHT / 2;
    const r = Math.hypot(dx, dy);
    if (r > STAR.radius) return 0.75;
    return r < 3 ? 0.4 : Math.sin(STAR.spokes * Math.atan2(dy, dx)) > 0 ? 0.92 : 0.03;
  });
}

// Groups of upright and lying bars, each narrower than the one before by the root of 2; an edge leans below them.
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

// Stars as bright as their rank is low, at places that are the same each time.
function points() {
  const plane = new Float32Array(WIDTH * HEIGHT).fill(0.0015);
  let seed = 20;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (let k = 1; k <= 90; k++) plane[Math.floor(random() * HEIGHT) * WIDTH + Math.floor(random() * WIDTH)] += 120 / k ** 1.2;
  return plane;
}

export function scratch(width, height) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  return canvas.getContext("2d", { willReadFrequently: true });
}

// sRGB, IEC 61966-2-1, to linear light.
const LINEAR = Float32Array.from({ length: 256 }, (_, i) => (i <= 10 ? i / 255 / 12.92 : ((i / 255 + 0.055) / 1.055) ** 2.4));

export function linear(data, count) {
  const size = data.length / 4;
  const planes = new Float32Array(size * count);
  for (let plane = 0; plane < count; plane++)
    for (let i = 0; i < size; i++) planes[plane * size + i] = LINEAR[data[4 * i + plane]];
  return planes;
}

const MOST = 480_000; // pixels that are blurred and drawn while something is dragged

// A file of the user, with at most so many pixels, each of which stands for `reduced` of them in a row; grey ones keep one plane.
export async function ownPicture(file) {
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
