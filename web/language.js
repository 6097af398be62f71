// The page in German: texts are written in English, and what is shown of them is looked up in one table. Keys may hold {0}, {1}, … for
// parts that differ, which are looked up in turn, or kept where the German has {0!}; those of long texts end in {0} after as many words
// as tell them apart.

import { GERMAN } from "./german.js";

const ATTRIBUTES = ["title", "aria-label", "aria-valuetext"];
const SEPARATORS = [/(?<=[^.]\.) (?=\p{Lu})/u, "; ", " — ", ": ", ", "];

// Of all pages of a document.
let german = isIt(globalThis.navigator?.language);
const known = new Map(); // what was looked up
const written = new WeakMap(); // node -> {attribute or "data": [English, as shown]}
const followed = new Map(); // root -> what to call when the language changes

const plain = (text) => text.replace(/\s+/g, " ").trim();
// Those with more text of their own come first.
const own = (key) => key.replace(/\{\d\}/g, "").length;
const patterns = Object.keys(GERMAN)
  .filter((key) => key.includes("{0}"))
  .sort((a, b) => own(b) - own(a))
  .map((key) => {
    const number = /^\{0\} [^\s{]+$/.test(key) && "([-−\\d.e∞<> ]*[\\d∞])"; // before a unit
    // What begins with a part, or is a word and a value, is within one of several sentences or errors.
    const any = /^\{|^[^\p{Lu}:.,;]+ \{0\}$/u.test(key) ? "(?!; )." : ".";
    const part = (name) => number || `((?:${name === "{0}" && any !== "." ? "(?![;:] )." : any})*?[^\\s,;:])`;
    return [new RegExp(`^${key.replace(/[.*+?^$()|[\]\\]/g, "\\$&").replace(/\{\d\}/g, part)}$`, "u"), GERMAN[key]];
  });

// Decimal commas; not in references.
const numbers = (text) => (/doi:/.test(text) ? text : text.replace(/(\d)\.(?=\d)/g, "$1,"));

function translated(text) {
  if (Object.hasOwn(GERMAN, text)) return GERMAN[text];
  for (const [pattern, to] of patterns) {
    const parts = pattern.exec(text);
    if (parts) return to.replace(/\{(\d)(!?)\}/g, (_, k, kept) => (kept ? parts[Number(k) + 1] : translated(parts[Number(k) + 1])));
  }
  if (/[^.]\.$/.test(text)) return `${translated(text.slice(0, -1))}.`;
  const between = /\p{L}{2}/u.test(text) && SEPARATORS.find((separator) => text.split(separator).length > 1);
  const sign = typeof between === "string" ? between : " ";
  return between ? text.split(between).map(translated).join(sign) : numbers(text);
}

// A text as it is shown.
export function inLanguage(text) {
  if (!german) return text;
  const key = plain(text);
  if (!key) return text;
  if (known.size > 5000) known.clear();
  if (!known.has(key)) known.set(key, translated(key));
  return text.replace(/\S.*\S|\S/s, () => known.get(key));
}

function write(node, name) {
  const now = name === "data" ? node.data : node.getAttribute(name);
  if (now === null || (node.parentElement ?? node).closest?.("[translate=no]")) return;
  const of = written.get(node) ?? {};
  const text = of[name]?.[1] === now ? of[name][0] : now;
  const said = inLanguage(text);
  written.set(node, { ...of, [name]: [text, said] });
  if (said === now) return;
  if (name === "data") node.data = said;
  else node.setAttribute(name, said);
}

function writeAll(node) {
  if (node.nodeType === 3) write(node, "data");
  if (node.nodeType !== 1 || node.localName === "style") return;
  for (const name of ATTRIBUTES) write(node, name);
  node.childNodes.forEach(writeAll);
}

// Keeps what is under a node in the language; changed() is called when that is another.
export function follow(node, changed) {
  const watch = new MutationObserver((changes) => {
    for (const { type, target, attributeName, addedNodes } of german ? changes : []) {
      if (type === "childList") addedNodes.forEach(writeAll);
      else write(target, attributeName ?? "data");
    }
  });
  watch.observe(node, { subtree: true, childList: true, characterData: true, attributeFilter: ATTRIBUTES });
  followed.set(node, changed);
  if (german) writeAll(node);
  return () => {
    watch.disconnect();
    followed.delete(node);
  };
}

// What a node says in English.
export const english = (node) => written.get(node.firstChild)?.data?.[0] ?? node.textContent;

// The text of a node, which is left alone where it says this already.
export function tell(node, text) {
  if (english(node) !== text) node.textContent = text;
}

function isIt(language) {
  return /^de\b/i.test(language ?? "");
}

export const isGerman = () => german;

export function speak(language) {
  german = isIt(language);
  known.clear();
  followed.forEach((changed, node) => {
    writeAll(node);
    changed();
  });
}
