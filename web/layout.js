// The skeleton of the page: what is where. What it shows is drawn by view.js.

import { MODES, SCALES } from "./compare.js";
import { el, menu } from "./dom.js";
import { SUFFIXES } from "./lensfiles.js";
import { PICTURES } from "./pictures.js";
import { Plot, svg } from "./plots.js";
import { explainOnClick, help, NUMBERS } from "./words.js";

export const UNNAMED = "Point spread function, live";

const VIEWS = { fine: "finely sampled", sampled: "at the pixels’ centres", averaged: "averaged by pixels" };
const STRETCH_NAMES = { linear: "linear", sqrt: "square root", log: "logarithm" };
const MAPS = { auto: "automatic", inferno: "inferno", viridis: "viridis", cividis: "cividis", gray: "grey" };

// A box that scrolls shows where more is below: scrollbars may be hidden until one scrolls.
function cueMore(box) {
  const look = () => box.classList.toggle("more", box.scrollHeight - box.scrollTop - box.clientHeight > 3);
  const watch = new ResizeObserver(look);
  const follow = () => [box, ...box.children].forEach((node) => watch.observe(node));
  new MutationObserver(follow).observe(box, { childList: true });
  follow();
  for (const name of ["scroll", "toggle"]) box.addEventListener(name, look, true);
}

// level: of the heading; docs: address of the documentation, if there is one.
export function layout({ state, set, controls, lessons, presets, actions, only, level, docs }) {
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
  // One line high, so that nothing moves as it comes and goes; unfolded it lies over what is below.
  page.source = el("details", { class: "source note", hidden: true }, el("summary"));
  page.hint = el("p", { class: "note" }, "Drag a slider or type a number; double-click for the default. Click any word, or “?”, for its meaning.");

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
    shows("presets") ? button("open", "Open …", opened, () => choose(SUFFIXES.join())) : null,
    page.file,
    shows("lessons") ? lessons.menu : null,
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
    button("language", "DE", "Deutsch / English", actions.language, { translate: "no", "aria-label": "Deutsch / English" }),
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

  page.code = el("pre", { translate: "no", tabindex: 0, "aria-label": "The call of lommel that makes the same array" });
  const code = el("details", { class: "code", open: true }, el("summary", {}, "As Python"), page.code);

  // Where some of these are named among what to show, the others are not shown.
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
