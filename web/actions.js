// What buttons and menus of a page do, beyond a change of its state.

import { saveCsv, savePng, saveTiff } from "./downloads.js";
import { ownPicture } from "./pictures.js";
import { PRESETS } from "./presets.js";
import { changed, DEFAULTS, toText } from "./state.js";
import { psfSaid } from "./sentences.js";

export function actions(view) {
  const done = (button, text) => {
    const { page } = view;
    const before = (button.dataset.text ??= button.textContent);
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
      make(view.settled);
    } catch (error) {
      view.tell(`This cannot be saved: ${error.message}`);
    }
  };
  const hold = () => {
    const { shown, state, field } = view;
    if (!shown?.psf || !shown.measures) return;
    view.compare.hold({ ...shown, state, field, sentence: psfSaid(state, shown.psf, shown.measures) });
    view.draw();
  };
  return {
    pick(change) {
      if (change.picture !== "own" || view.own) return view.set(change);
      view.page.selects.picture.value = view.state.picture;
      return view.page.file.click();
    },
    async own(files) {
      const file = files?.[0];
      if (!file) return;
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
      view.page.file.value = "";
    },
    before: () => view.draw({ recorded: view.shown?.recorded }),
    preset(index) {
      const preset = PRESETS[Number(index)];
      if (index === "" || !preset) return;
      view.take(preset);
    },
    reset() {
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
      view.draw();
    },
    mode: (mode) => view.compare.show(mode),
    link: () => {
      const text = toText(changed(DEFAULTS, view.state));
      return copy(view.page.link, location.href.split("#")[0] + (text ? `#${text}` : ""));
    },
    python: () => (view.shown?.psf ? copy(view.page.python, (view.settled ?? view.shown).psf.python) : undefined),
    png: () => save((settled) => savePng(view.page, view.state, settled)),
    csv: () => save((settled) => saveCsv(view.state, settled)),
    tiff: () => save((settled) => saveTiff(view.state, settled)),
  };
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

// A picture may be dropped on its figure.
export function acceptDrops(figure, take) {
  for (const name of ["dragenter", "dragover"])
    figure.addEventListener(name, (event) => {
      if (![...event.dataTransfer.types].includes("Files")) return;
      event.preventDefault();
      figure.classList.add("over");
    });
  for (const name of ["dragleave", "drop"]) figure.addEventListener(name, () => figure.classList.remove("over"));
  figure.addEventListener("drop", (event) => {
    event.preventDefault();
    take(event.dataTransfer.files);
  });
}
