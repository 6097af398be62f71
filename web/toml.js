// A subset of TOML: tables, bare, quoted and dotted keys, strings, decimal numbers, booleans, arrays, inline tables, comments.
// What it does not read, dates and arrays of tables above all, it refuses with the number of the line.

const DEEPEST = 20;
const ESCAPES = { b: "\b", t: "\t", n: "\n", f: "\f", r: "\r", '"': '"', "\\": "\\" };
const DECIMAL = /[+-]?(?:inf|nan|(?:0|[1-9](?:_?\d)*)(?:\.\d(?:_?\d)*)?(?:[eE][+-]?\d(?:_?\d)*)?)(?![\w.:-])/y;
const BARE = /[\w-]+/y;

// {root, lines}: nested objects without prototypes, and the line of each key by its path, "lens.f_number".
export function parseToml(text) {
  const root = Object.create(null);
  const lines = new Map();
  const closed = new Set(); // tables that nothing may add to: inline ones, and those that had their header
  let at = 0;

  let counted = { place: 0, line: 1 }; // lines up to a place, so that a long file is gone through once
  const lineAt = (place) => {
    if (place < counted.place) counted = { place: 0, line: 1 };
    const line = counted.line + text.slice(counted.place, place).split("\n").length - 1;
    counted = { place, line };
    return line;
  };
  const fail = (what, place = at) => {
    throw new Error(`line ${lineAt(place)}: ${what}`);
  };
  const brief = (place) => JSON.stringify(text.slice(place, place + 30).split("\n")[0]);
  const match = (pattern) => {
    pattern.lastIndex = at;
    const found = pattern.exec(text);
    if (found) at += found[0].length;
    return found?.[0];
  };
  const take = (word) => text.startsWith(word, at) && Boolean((at += word.length));
  const blank = () => match(/[ \t]*(?:#[^\n]*)?/y);
  const blanks = () => match(/(?:\s|#[^\n]*)*/y);
  const expect = (word) => take(word) || fail(`${JSON.stringify(word)} is missing before ${brief(at)}`);

  function string() {
    const begin = at;
    const mark = text[at];
    const long = text.startsWith(mark.repeat(3), at);
    const end = mark.repeat(long ? 3 : 1);
    at += end.length;
    if (long) match(/\n/y);
    let made = "";
    for (;;) {
      if (at >= text.length || (!long && text[at] === "\n")) fail("a text has no closing quote", begin);
      if (take(end)) {
        while (long && text[at] === mark) made += text[at++];
        return made;
      }
      if (mark === "'" || text[at] !== "\\") made += text[at++];
      else {
        at++;
        if (long && match(/[ \t]*\n\s*/y)) continue;
        const kind = text[at++];
        const size = { u: 4, U: 8 }[kind];
        const code = size && match(size === 4 ? /[\da-fA-F]{4}/y : /[\da-fA-F]{8}/y);
        if (code && parseInt(code, 16) <= 0x10ffff) made += String.fromCodePoint(parseInt(code, 16));
        else made += ESCAPES[kind] ?? fail(`\\${kind} is not an escape of TOML`);
      }
    }
  }

  function keys() {
    const found = [];
    do {
      match(/[ \t]*/y);
      found.push(/["']/.test(text[at] ?? "") ? string() : match(BARE) ?? fail(`a key is missing before ${brief(at)}`));
      match(/[ \t]*/y);
    } while (take("."));
    return found;
  }

  // The table at some keys below another, made where there is none.
  function inside(table, path, place) {
    for (const [index, key] of path.entries()) {
      table[key] ??= Object.create(null);
      if (table[key] === null || typeof table[key] !== "object" || Array.isArray(table[key]))
        fail(`${path.slice(0, index + 1).join(".")} has a value and is no table`, place);
      table = table[key];
    }
    return table;
  }

  function assign(table, above, depth) {
    const place = at;
    const path = keys();
    expect("=");
    match(/[ \t]*/y);
    const last = path.at(-1);
    const home = inside(table, path.slice(0, -1), place);
    if (closed.has(home) && home !== table) fail(`${path.join(".")} adds to a table that is complete`, place);
    if (last in home) fail(`${last} is given twice`, place);
    const whole = [...above, ...path];
    for (let count = above.length + 1; count <= whole.length; count++) {
      const name = whole.slice(0, count).join(".");
      if (!lines.has(name)) lines.set(name, lineAt(place));
    }
    home[last] = value(whole, depth);
  }

  function value(path, depth) {
    if (depth > DEEPEST) fail("brackets are nested too deeply");
    if (/["']/.test(text[at] ?? "")) return string();
    if (take("[")) {
      const list = [];
      for (blanks(); !take("]"); blanks()) {
        list.push(value(path, depth + 1));
        blanks();
        if (!take(",") && text[at] !== "]") fail(`a comma or "]" is missing before ${brief(at)}`);
      }
      return list;
    }
    if (take("{")) {
      const table = Object.create(null);
      for (match(/[ \t]*/y); !take("}"); match(/[ \t]*/y)) {
        assign(table, path, depth + 1);
        match(/[ \t]*/y);
        if (!take(",") && text[at] !== "}") fail(`a comma or "}" is missing before ${brief(at)}`);
      }
      closed.add(table);
      return table;
    }
    const plain = match(/(?:true|false)(?![\w-])/y);
    if (plain) return plain === "true";
    const number = match(DECIMAL) ?? fail(`${brief(at)} is not a text in quotes, a decimal number, true, false, a list or a table`);
    const bare = number.replace(/_/g, "").replace("inf", "Infinity");
    return Number(bare);
  }

  const grown = new Set(); // arrays of tables
  function newTables() {
    const tables = [];
    grown.add(tables);
    return tables;
  }

  text = text.replace(/^\ufeff/, "").replace(/\r\n?/g, "\n");
  let here = root;
  let above = [];
  for (blanks(); at < text.length; blanks()) {
    const place = at;
    if (take("[[")) {
      above = keys();
      expect("]");
      expect("]");
      const home = inside(root, above.slice(0, -1), place);
      const tables = (home[above.at(-1)] ??= newTables());
      if (!grown.has(tables)) fail(`${above.join(".")} has a value and is no array of tables`, place);
      tables.push((here = Object.create(null)));
      lines.set(above.join("."), lineAt(place));
    } else if (take("[")) {
      above = keys();
      expect("]");
      here = inside(root, above, place);
      if (closed.has(here)) fail(`the table [${above.join(".")}] is given twice`, place);
      closed.add(here);
      lines.set(above.join("."), lineAt(place));
    } else assign(here, above, 0);
    blank();
    if (at < text.length && text[at] !== "\n") fail(`only one entry may stand in a line, got ${brief(at)} behind it`);
  }
  return { root, lines };
}
