// The compiled core: called through named blocks of its memory, and made anew after a failure.

const BLOCKS = ["terms", "edge", "lines", "values", "numbers", "points", "planes", "blurred", "weights", "colours", "tables", "first", "second", "found", "sharp"];

export class Core {
  constructor(module) {
    this.module = module;
    this.renew();
  }

  // A new instance, with empty tables; one takes a fraction of a millisecond.
  renew() {
    const fail = (at, length) => {
      const text = new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, at, length).slice());
      throw new RangeError(text);
    };
    // As "%.3g" of C: powers of two digits, from 3 on and below -4, without zeros at the end.
    const shorten = (number, at, room) => {
      const rounded = Number(number.toPrecision(3));
      const whole = rounded && Math.abs(rounded) < 1e-4 ? rounded.toExponential(2) : rounded.toPrecision(3);
      const text = (whole.includes(".") ? whole.replace(/^([^e]*?)\.?0+(?=e|$)/, "$1") : whole).replace(/e([+-])(\d)$/, "e$10$2");
      const { written } = new TextEncoder().encodeInto(text, new Uint8Array(this.exports.memory.buffer, at, room - 1));
      new Uint8Array(this.exports.memory.buffer)[at + written] = 0;
      return written;
    };
    const given = { fail, shorten };
    const imports = {};
    for (const { module, name } of WebAssembly.Module.imports(this.module)) {
      imports[module] ??= {};
      imports[module][name] = (module === "lommel" && given[name]) || (() => 52); // ENOSYS: there is no system
    }
    this.exports = new WebAssembly.Instance(this.module, imports).exports;
    this.exports._initialize?.();
  }

  // Where a block of at least so many numbers of a kind begins.
  room(name, kind, length) {
    return this.call("room", BLOCKS.indexOf(name), Math.max(1, length) * kind.BYTES_PER_ELEMENT) >>> 0; // above 2 GB, too
  }

  // The address of a block that holds these numbers.
  put(name, numbers) {
    const at = this.room(name, numbers.constructor, numbers.length);
    this.view(at, numbers.constructor, numbers.length).set(numbers);
    return at;
  }

  // Numbers in memory, until the next call: memory that grows takes views away.
  view(at, kind, length) {
    return new kind(this.exports.memory.buffer, at, length);
  }

  call(name, ...numbers) {
    try {
      return this.exports[name](...numbers);
    } catch (error) {
      this.renew();
      if (error instanceof WebAssembly.RuntimeError) {
        throw new RangeError(`the computation stopped for want of memory (${error.message})`);
      }
      throw error;
    }
  }
}
