// Zernike coefficients from files of others, as lommel.load_zernike reads them: OpticStudio's listings of Standard and Fringe
// coefficients, Code V's ZRN and ZFR, tables in CSV or columns, TOML and JSON.

const POWERS = { m: 0, metres: 0, km: 3, cm: -2, mm: -3, um: -6, µm: -6, μm: -6, nm: -9, pm: -12, angstrom: -10 };
const INCHES = { in: 25.4e-3, inch: 25.4e-3 };
const QUANTITY = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?inf(?:inity)?)\s*(\S*)\s*$/;
const shownValue = (value) => String(JSON.stringify(value) ?? value).slice(0, 60);

// Metres of a text such as "550 nm"; 0 and infinity need no unit.
export function metresOf(value) {
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

export const ORDERS = ["nm", "noll", "ansi", "fringe"];
const FRINGE = [];
for (let group = 0; group < 6; group++)
  for (let m = group; m >= 0; m--) FRINGE.push([2 * group - m, m], ...(m ? [[2 * group - m, -m]] : []));
FRINGE.push([12, 0]);
const MOST_DEGREE = 60;

// [n, m] of the text of an index, "4" or "3,1".
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

// {terms: [[n, m, value at the edge]], unit, wavelength (metres or null)} of settings and [index, value, place]; faults are added.
export function builtTable(settings, terms, where, faults) {
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

export function checkedWavelength(metres) {
  if (!(metres >= 1e-12 && metres <= 1e-2)) throw new Error(`must be a wavelength from 1e-12 m to 1e-2 m, got ${metres} m`);
  return metres;
}

// Terms in waves at a wavelength in metres: the same path differences.
export function wavesOf({ terms, unit, wavelength }, at) {
  const one = { waves: (wavelength ?? at) / at, radians: (wavelength ?? at) / at / (2 * Math.PI) };
  const length = Object.hasOwn(INCHES, unit) ? INCHES[unit] : Number(`1e${POWERS[unit]}`);
  const factor = one[unit] ?? length / at;
  return terms.map(([n, m, value]) => [n, m, value * factor]);
}

// Of a section of TOML or JSON.
export function sectionTable(section, where, faults) {
  const { terms = {}, ...settings } = section;
  const entries = terms !== null && typeof terms === "object" && !Array.isArray(terms) ? Object.entries(terms) : [];
  return builtTable(settings, entries.map(([index, value]) => [index, value, where(`terms.${index}`)]), where, faults);
}

const numberOf = (text) => {
  const plain = text.trim().split(",").length === 2 && !text.includes(".") ? text.trim().replace(",", ".") : text.trim();
  return /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(plain) ? Number(plain) : plain;
};

export function csvTable(text, faults) {
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
  const names = head.map((name) => name.toLowerCase());
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

// A listing of OpticStudio, saved as text.
export function listingTable(text, faults) {
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
  let [last, formulas] = [0, false];
  text.split("\n").forEach((line, index) => {
    const entry = /^\s*Z\s*(\d{1,4})\s*[:=]?\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(:.*)?$/.exec(line);
    if (entry) {
      const number = Number(entry[1]);
      if (number > last + 1) faults.push(`line ${index + 1}: the term ${last + 1} is missing, got ${number}; a listing has all terms from 1`);
      if (formulas && !entry[3]) faults.push(`line ${index + 1}: the term ${number} is cut off, without the formula that the others have`);
      [last, formulas] = [number, Boolean(entry[3])];
      terms.push([entry[1], numberOf(entry[2]), `line ${index + 1}`]);
    } else if (/^\s*Z\s*\d/.test(line)) faults.push(`line ${index + 1}: a term must have a number and a value, got ${shownValue(line.trim())}`);
  });
  return builtTable(settings, terms, (key) => key, faults);
}

// Code V's: a title, a line such as "ZFR 37 WFR WVL 0.6328 SSZ 1000", and values of which SSZ are a wave.
export function codeVTable(text, faults) {
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
