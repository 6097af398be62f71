// The entry: a page in an element, after a script, in a notebook by anywidget; and the engine for scripts.

import { openFile } from "./actions.js";
import { Engine } from "./engine.js";
import { FIELDS } from "./fields.js";
import { createCore } from "./load.js";
import { changed, DEFAULTS, fromText } from "./state.js";
import { View } from "./view.js";

export { createCore, DEFAULTS, Engine };

// The answer of the engine to a state, which need say no more than what differs from the defaults.
export function psf(core, state = {}, quality = "settled") {
  return new Engine(core).psf(changed(DEFAULTS, state), quality);
}

// A page in an element. With `url` it keeps its state in the fragment of the address; `controls` lists what to show.
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

// A widget of anywidget, whose traits are named as the state is. What is dragged reaches them 20 times a second at most.
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
  // A change that is under way from here must not be undone by an older one from there.
  const heard = () => timer || hear();
  for (const key of keys) model.on(`change:${key}`, heard);
  return () => {
    clearTimeout(timer);
    for (const key of keys) model.off(`change:${key}`, heard);
    page.destroy();
  };
}

export default { render };

// <script type="module" src="lommel-live.js" data-lommel="defocus=1&coma=.5" data-lommel-controls="defocus,coma">
// The first of a page has the address: its fragment, and ?controls=.
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
      language: script.dataset.lommelLanguage,
    });
  });
}

if (typeof document !== "undefined") mountScripts();
