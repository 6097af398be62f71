// What buttons and menus of a page do, beyond a change of its state.

import { saveCsv, savePng, saveTiff } from "./downloads.js";
import { english } from "./language.js";
import { ownPicture } from "./pictures.js";
import { decodedText, MOST_BYTES, readFile, SUFFIXES } from "./lensfiles.js";
import { PRESETS } from "./presets.js";
import { psfSaid } from "./sentences.js";
import { sayBeside } from "./words.js";

const PICTURE = /\.(png|jpe?g|webp|gif|bmp|avif|svg)$/i; // of files that say no type

const LONG = 2000; // characters of an address that all programs take

export function actions(view) {
  const done = (button, text) => {
    const { page } = view;
    const before = (button.dataset.text ??= english(button));
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
    // Lens files and tables by their suffix, others as pictures.
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

// A lens file or a table of Zernike coefficients; true where the page shows it, else the page says why not.
export async function openFile(view, file) {
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

// Where the clipboard is refused, the text to copy by hand.
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

// Files may be dropped anywhere on the page.
export function acceptDrops(node, take) {
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
