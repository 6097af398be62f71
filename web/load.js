// The compiled core, loaded from the text of the page.
import { Core } from "./core.js";
import { wasmText } from "./packed.js";

// base64 of what is deflated.
export async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function compiledCore() {
  return WebAssembly.compile(await unpacked(wasmText));
}

export async function createCore(module = null) {
  return new Core(module ?? (await compiledCore()));
}
