// Light or dark, as the page around is: JupyterLab, VS Code and documentation say so by attributes, others by the system.

export function followTheme(node, wanted = "auto") {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    node.dataset.theme = wanted === "light" || wanted === "dark" ? wanted : themeAround() ?? (dark.matches ? "dark" : "light");
  };
  const watch = new MutationObserver(apply);
  const attributeFilter = ["data-jp-theme-light", "data-theme", "data-mode", "data-vscode-theme-kind"];
  for (const place of [document.documentElement, document.body]) watch.observe(place, { attributes: true, attributeFilter });
  dark.addEventListener("change", apply);
  apply();
  return () => {
    watch.disconnect();
    dark.removeEventListener("change", apply);
  };
}

function themeAround() {
  const { body, documentElement } = document;
  const lab = body.dataset.jpThemeLight;
  if (lab === "true" || lab === "false") return lab === "true" ? "light" : "dark";
  const code = body.dataset.vscodeThemeKind;
  if (code) return /light/.test(code) ? "light" : "dark";
  return [documentElement, body].map((node) => node.dataset.theme).find((theme) => theme === "light" || theme === "dark");
}
