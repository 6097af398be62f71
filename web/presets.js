// What the menu of presets offers: a lens without fault, and those of examples/lenses.

import { SHIPPED } from "./shipped.js";

export const PRESETS = [{ name: "A lens without aberration", source: "", state: { defocus: 0 }, left_out: "" }, ...SHIPPED];
