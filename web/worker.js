// The loop of a Worker: one question after the other. The first message brings the compiled core.
import { Core } from "./core.js";
import { Engine } from "./engine.js";

let engine = null;

self.onmessage = ({ data: { id, method, arguments: given } }) => {
  try {
    if (method === "start") {
      engine = new Engine(new Core(given[0]));
      self.postMessage({ id, result: true });
      return;
    }
    const result = engine[method](...given);
    self.postMessage({ id, result }, buffersOf(result));
  } catch (error) {
    self.postMessage({ id, error: error instanceof Error ? error.message : String(error) });
  }
};

// What can be handed over without a copy: arrays, alone or in objects.
function buffersOf(result, found = new Set()) {
  if (ArrayBuffer.isView(result)) found.add(result.buffer);
  else if (result?.constructor === Object) for (const part of Object.values(result)) buffersOf(part, found);
  return [...found];
}
