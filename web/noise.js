// Photon noise and read noise of a sensor, from a seeded generator: the same settings have the same noise.

import { crc32 } from "./checksum.js";

// Uniform numbers between 0 and 1, both excluded: Marsaglia's xorshift128, Xorshift RNGs, J. Stat. Softw. 8(14), 2003.
export function generator(text) {
  const state = Uint32Array.from({ length: 4 }, (_, i) => crc32(new TextEncoder().encode(`${i} ${text}`)) | 1);
  return () => {
    const [x, w] = [state[0], state[3]];
    const t = x ^ (x << 11);
    state.copyWithin(0, 1);
    state[3] = w ^ (w >>> 19) ^ t ^ (t >>> 8);
    return (state[3] + 0.5) / 2 ** 32;
  };
}

export function normal(uniform) {
  return Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}

// Below 30 by multiplication; above by transformed rejection (W. Hörmann, Insurance: Mathematics and Economics 12, 39, 1993).
function poisson(mean, uniform) {
  if (mean < 30) {
    const end = Math.exp(-mean);
    let count = 0;
    for (let product = uniform(); product > end; product *= uniform()) count++;
    return count;
  }
  const slope = 0.931 + 2.53 * Math.sqrt(mean);
  const a = -0.059 + 0.02483 * slope;
  const [log, inverse] = [Math.log(mean), 1.1239 + 1.1328 / (slope - 3.4)];
  for (;;) {
    const u = uniform() - 0.5;
    const v = uniform();
    const us = 0.5 - Math.abs(u);
    const k = Math.floor(((2 * a) / us + slope) * u + mean + 0.43);
    if (us >= 0.07 && v <= 0.9277 - 3.6224 / (slope - 2)) return k;
    if (k < 0 || (us < 0.013 && v > us)) continue;
    if (Math.log((v * inverse) / (a / us ** 2 + slope)) <= k * log - mean - logFactorial(k)) return k;
  }
}

// By Stirling's series, whose next term is below 1e-9 from 10 on.
function logFactorial(k) {
  let below = 0;
  let n = k + 1;
  for (; n < 10; n++) below += Math.log(n);
  return (n - 0.5) * Math.log(n) - n + 0.9189385332046727 + (1 / 12 - 1 / (360 * n * n)) / n - below;
}

// Noisy electrons of expected ones.
export function counted(expected, { read_noise }, seed) {
  const uniform = generator(seed);
  const read = read_noise ? () => read_noise * normal(uniform) : () => 0;
  return Float32Array.from(expected, (mean) => poisson(mean, uniform) + read());
}
