// The point spread function as a figure for papers and slides: panels with scale bars, the bar of colours, title and settings.

import { compose, RAYS_SAID, rulerOf } from "./stage.js";
import { placesOfRays, RAYS } from "./draw.js";
import { FIELDS } from "./fields.js";
import { inLanguage } from "./language.js";
import { DEFAULTS } from "./state.js";
import { numbersSaid, withMinus } from "./sentences.js";
import { short } from "./plots.js";
import { wavesUnit, withUnit } from "./units.js";

const PANEL = 1024;
const PADDING = 48;
const FONT = '"Helvetica Neue", Arial, "Liberation Sans", system-ui, sans-serif';
const STRETCHED = { linear: "linear scale", sqrt: "square-root scale", log: "logarithmic scale" };
// Keys of how numbers look, which say nothing of the lens.
const UNSAID = ["stretch", "map", "waves_unit", "length_unit", "picture", "view", "side", "rays", "light", "focus"];

// The settings in words, those that differ from a lens without aberration.
export function settingsSaid(state) {
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

// Two settings: what differs, and what both have.
function bothSaid(...states) {
  const [a, b] = states.map((state) => settingsSaid(state).split(", "));
  const own = (these, others) => these.filter((one) => !others.includes(one)).join(", ") || "no other";
  return `A: ${own(a, b)}. B: ${own(b, a)}. Both: ${a.filter((one) => b.includes(one)).join(", ")}.`;
}

// given: what compose takes, with the name of the lens.
export function figureOf(given) {
  const { state, shown, held, mode, name } = given;
  const canvases = { now: document.createElement("canvas"), held: document.createElement("canvas"), bar: document.createElement("canvas") };
  // In turn on the page is side by side on paper.
  const drawn = compose(canvases, { ...given, mode: mode === "flicker" ? "beside" : mode });
  const { panels } = drawn;
  const whole = document.createElement("canvas");
  whole.width = 2 * PADDING + panels.length * PANEL + (panels.length - 1) * PADDING;
  const context = whole.getContext("2d");
  const width = whole.width - 2 * PADDING;
  const wrapped = (text, size, wide, weight = "") => {
    context.font = `${weight} ${size}px ${FONT}`;
    const lines = [""];
    for (const word of inLanguage(text).split(" ")) {
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
    label(context, inLanguage(text), left + 18, bottom - 54);
    context.strokeStyle = "#888";
    context.lineWidth = 1;
    context.strokeRect(left - 0.5, top - 0.5, PANEL + 1, PANEL + 1);
  });

  // The bar, with its ticks and what they are of.
  const y = top + PANEL + 28;
  context.imageSmoothingEnabled = true;
  context.drawImage(canvases.bar, PADDING, y, width, 26);
  context.strokeStyle = "#888";
  context.strokeRect(PADDING - 0.5, y - 0.5, width + 1, 27);
  context.font = `22px ${FONT}`;
  context.fillStyle = "#111";
  for (const [at, tick] of drawn.ticks) {
    const word = inLanguage(tick);
    const x = PADDING + at * width;
    context.fillRect(Math.min(x, PADDING + width - 1), y + 26, 2, 7);
    const wide = context.measureText(word).width;
    context.fillText(word, Math.min(PADDING + width - wide, Math.max(PADDING, x - wide / 2)), y + 36);
  }
  const rays = state.rays === "on" && !drawn.signed && panels.some((panel) => panel.shown.rays);
  context.fillText(inLanguage(`${drawn.label}, ${STRETCHED[state.stretch]}`), PADDING, y + 70);
  context.textAlign = "right";
  const made = "lommel";
  context.fillStyle = "#666";
  context.fillText(made, PADDING + width, y + 70);
  if (rays) {
    const right = PADDING + width - context.measureText(made).width - 40;
    context.fillStyle = "#111";
    const said = inLanguage(RAYS_SAID);
    context.fillText(said, right, y + 70);
    dot(context, right - context.measureText(said).width - 16, y + 82, 7);
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
