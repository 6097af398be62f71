// The engine behind promises: in two Workers, so that two cores compute at a time, or on the page itself where Workers are refused.

import { Core } from "./core.js";
import { completed, Engine } from "./engine.js";
import { compiledCore } from "./load.js";
import { workerText } from "./workertext.js";

let told = false;

// Once for all pages of a document: the compiled core.
const shared = {};
const once = (name, make) => (shared[name] ??= make());

async function startedWorker(core) {
  const url = URL.createObjectURL(new Blob([workerText], { type: "text/javascript" }));
  const worker = new Worker(url);
  return new Promise((resolve, reject) => {
    worker.onerror = (event) => {
      event.preventDefault?.();
      worker.terminate();
      reject(new Error(event.message || "it does not start"));
    };
    worker.onmessage = ({ data: { error } }) => (error === undefined ? resolve(worker) : reject(new Error(error)));
    worker.postMessage({ id: 0, method: "start", arguments: [core] });
  }).finally(() => URL.revokeObjectURL(url));
}

const SECOND = new Set(["measures", "curves", "blur"]); // computed beside the others
const THIRD = new Set(["openDepth", "depth", "sharpen"]); // of a lesson alone, in a Worker of its own

export class Client {
  constructor() {
    this.lanes = [new Lane(), new Lane()];
  }

  // Whether computing can be stopped.
  get worker() {
    return this.lanes.some(({ worker }) => worker);
  }

  async call(method, ...given) {
    if (THIRD.has(method)) return (this.lanes[2] ??= new Lane()).call(method, ...given);
    const lane = this.lanes[SECOND.has(method) ? 1 : 0];
    const asked = JSON.stringify(given);
    if (method === "measures" && this.last?.asked === asked) {
      // The curves do not wait for the images of the same state, which the other worker makes.
      const [curves, extents, psf] = await Promise.all([lane.call("curves", ...given), this.last.psf.then(() => this.lanes[0].call("extents", ...given)), this.last.psf]);
      return completed({ ...curves, ...extents }, psf);
    }
    const answer = lane.call(method, ...given);
    if (method === "psf") this.last = { asked, psf: answer };
    return answer;
  }

  // What is being computed is given up: its promises are rejected with this message.
  stop(message = "the computation was stopped") {
    for (const lane of this.lanes.slice(0, 2)) if (lane.waiting.size) lane.renew({ message });
  }

  destroy() {
    for (const lane of this.lanes) lane.destroy();
  }
}

class Lane {
  constructor() {
    this.waiting = new Map();
    this.count = 0;
    this.ready = this.start();
  }

  async start() {
    const core = await once("core", compiledCore);
    try {
      this.worker = await startedWorker(core);
      this.worker.onmessage = ({ data }) => this.answer(data);
      this.worker.onerror = (event) => this.renew(event);
      if (this.gone) this.destroy();
    } catch (error) {
      if (!told) console.info(`lommel: no Worker here (${error.message}), so the page computes by itself.`);
      told = true;
      this.engine = once("engine", () => new Engine(new Core(core)));
    }
  }

  async call(method, ...given) {
    await this.ready;
    if (this.engine) return this.engine[method](...given);
    return new Promise((resolve, reject) => {
      const id = ++this.count;
      this.waiting.set(id, { resolve, reject });
      this.worker?.postMessage({ id, method, arguments: given });
    });
  }

  // After what no answer can come from: all that waits is told, and the next questions go to a new Worker.
  renew(event) {
    event.preventDefault?.();
    this.worker?.terminate();
    this.ready = this.start();
    for (const id of [...this.waiting.keys()]) this.answer({ id, error: event.message || "the computation stopped" });
  }

  answer({ id, result, error }) {
    const asked = this.waiting.get(id);
    this.waiting.delete(id);
    if (error === undefined) asked?.resolve(result);
    else asked?.reject(new Error(error));
  }

  destroy() {
    this.gone = true;
    this.worker?.terminate();
    this.worker = null;
    this.waiting.clear();
  }
}
