/** Numbers between two bounds, the same ones for the same seed: mulberry32. Scenes depend on no engine. */
export function randomBetween(seed: number): (least: number, most: number) => number {
  let state = seed | 0;
  return (least, most) => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return least + (((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32) * (most - least);
  };
}
