// A setting that is held as A, beside the present one, B, in turn with it, or subtracted from it.

const ALTERNATE = 800; // ms, slower than what may harm anybody

export const MODES = { beside: "side by side", flicker: "in turn", difference: "difference, B − A" };
export const SCALES = { one: "one scale", own: "each its own scale" };

export class Compare {
  constructor(page) {
    this.page = page;
    this.mode = "beside";
    this.shared = true;
    this.held = null;
    this.still = matchMedia("(prefers-reduced-motion: reduce)");
  }

  // held: {state, psf, measures, rays, sentence, quality}.
  hold(held) {
    this.held = held;
    this.page.held.setAttribute("aria-label", `A. ${held.sentence}`);
    this.arrange();
  }

  // The same lens by another sampling.
  renew(parts) {
    Object.assign(this.held, parts);
    this.page.held.setAttribute("aria-label", `A. ${this.held.sentence}`);
  }

  release() {
    this.held = null;
    this.arrange();
  }

  show(mode) {
    this.mode = mode;
    this.arrange();
  }

  // "beside", "flicker", "difference", or "one" where nothing is held.
  get shown() {
    return this.held ? this.mode : "one";
  }

  // Which of both is seen where one is seen at a time; the sensor shows the same.
  get turn() {
    return this.page.stage.dataset.turn;
  }

  arrange() {
    const { page, held, shown } = this;
    clearInterval(this.timer);
    page.compare.hidden = !held;
    page.hold.hidden = Boolean(held);
    page.node.dataset.compare = page.stage.dataset.mode = shown;
    page.scale.hidden = shown === "difference";
    page.turn.hidden = shown !== "flicker";
    page.heldPicture.parentNode.hidden = !held;
    for (const tag of page.stage.querySelectorAll(".tag")) tag.hidden = !held;
    page.held.parentNode.hidden = !held || shown === "difference";
    this.see("b");
    if (shown === "flicker" && !this.still.matches) this.timer = setInterval(() => this.see(this.turn === "a" ? "b" : "a"), ALTERNATE);
  }

  see(turn) {
    this.page.stage.dataset.turn = turn;
    this.page.turn.textContent = turn === "a" ? "Show B" : "Show A";
  }

  // By hand, which ends the change by itself.
  swap() {
    clearInterval(this.timer);
    this.see(this.turn === "a" ? "b" : "a");
  }

  destroy() {
    clearInterval(this.timer);
  }
}
