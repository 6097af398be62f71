// Files to keep, made in the browser: what is seen as PNG, curves as CSV, values as OME-TIFF as the package writes it.

import { crc32 } from "./checksum.js";
import { describedPsf } from "./description.js";
import { FIELDS } from "./fields.js";
import { figureOf } from "./figures.js";
import { short } from "./plots.js";
import { errorsOf, numbersSaid, stated } from "./sentences.js";
import { DEFAULTS, toText } from "./state.js";

function saveBlob(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const ascii = (text) => new TextEncoder().encode(text);

// A PNG with the state as text, before its first piece of picture.
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

// A figure of what is seen; given as of figureOf.
export function savePng(given) {
  figureOf(given).toBlob(async (blob) => saveBlob(await withText(blob, "Description", toText(given.state) || "defaults"), "lommel-psf.png"));
}

const MTF_PLACES = 6;

const HEADS = {
  profile: ["radius (um)", "profile", "profile unaberrated"],
  energy: ["radius (um)", "encircled energy", "encircled energy unaberrated"],
  mtf: ["frequency (cycles/mm)", "MTF x", "MTF y", "MTF diffraction limit", "MTF x with pixel", "MTF y with pixel"],
};

export function csvText(state, { psf, measures }) {
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

export function saveCsv({ state, shown }) {
  saveBlob(new Blob([csvText(state, shown)], { type: "text/csv" }), "lommel-curves.csv");
}

const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

// The fields of one uncompressed page of float32, little-endian, that tifffile writes, with the same OME description.
export function tiffBytes(state, psf) {
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

export function saveTiff({ state, shown }) {
  saveBlob(new Blob([tiffBytes(state, shown.psf)], { type: "image/tiff" }), "lommel-psf.tif");
}
