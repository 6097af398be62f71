// A setting that is held as A, beside or in turn with the one at hand, B.

import { drawAtScale, colour } from "./draw.js";

const ALTERNATE = 800; // ms, slower than what may harm anybody

export class Compare {
  constructor(page) {
    this.page = page;
    this.mode = "beside";
    this.held = null;
    this.still = matchMedia("(prefers-reduced-motion: reduce)");
  }

  // shown: {state, psf, measures}, with a copy of what is on the canvas.
  hold(shown) {
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [this.page.psf.width, this.page.psf.height];
    copy.getContext("2d").drawImage(this.page.psf, 0, 0);
    this.held = { ...shown, copy };
    this.arrange();
  }

  release() {
    this.held = null;
    this.arrange();
  }

  show(mode) {
    this.mode = mode;
    this.arrange();
  }

  arrange() {
    const { page, held } = this;
    clearInterval(this.timer);
    page.compare.hidden = !held;
    page.hold.hidden = Boolean(held);
    page.node.dataset.compare = page.stage.dataset.mode = held ? this.mode : "one";
    page.stage.dataset.turn = "b";
    for (const tag of page.stage.querySelectorAll(".tag")) tag.hidden = !held;
    page.held.parentNode.hidden = !held;
    if (held && this.mode === "flicker" && !this.still.matches) {
      this.timer = setInterval(() => (page.stage.dataset.turn = page.stage.dataset.turn === "a" ? "b" : "a"), ALTERNATE);
    }
  }

  // A over the field of B, so that both have one scale.
  draw(field, map) {
    if (!this.held) return;
    const { page, held } = this;
    drawAtScale(page.held, held.copy, held.field / field, Math.max(256, page.psf.width), `rgb(${colour(map, 0).join()})`);
    page.held.setAttribute("aria-label", `A. ${held.sentence}`);
  }

  destroy() {
    clearInterval(this.timer);
  }
}
