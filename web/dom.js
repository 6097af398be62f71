// Elements in one line each.

// Keys starting with "on" listen, true is an empty attribute, false or undefined none.
export function el(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (value === true) node.setAttribute(key, "");
    else if (value !== false && value !== undefined) node.setAttribute(key, value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  // JupyterLab binds arrow keys of what it takes for no text field, unless the very target says this.
  if (/^(input|select|button|summary)$/.test(name)) node.setAttribute("data-lm-suppress-shortcuts", "true");
  return node;
}

let given = 0;
export const unique = (name) => `lommel-${name}-${++given}`;

export function menu(label, choices, value, onpick, attributes = {}) {
  const options = Object.entries(choices).map(([key, text]) => el("option", { value: key }, text));
  const node = el("select", { "aria-label": label, title: label, onchange: () => onpick(node.value), ...attributes }, ...options);
  node.value = value;
  return node;
}
