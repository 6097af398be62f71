// The engine behind promises: in a Worker, or on the page itself where Workers are refused.

import { compiledCore, Core, unpacked } from "./core.js";
import { Engine } from "./engine.js";
import { workerText } from "./workertext.js";

let told = false;

// Once for all pages of a document: the compiled core, and the address of the Worker's text.
const shared = {};
const once = (name, make) => (shared[name] ??= make());

async function startedWorker(core) {
  const text = await once("text", async () => new Blob([await unpacked(workerText)], { type: "text/javascript" }));
  const url = URL.createObjectURL(text);
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

export class Client {
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
      this.engine = new Engine(new Core(core));
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
