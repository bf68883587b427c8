/**
 * Sine from exactly specified arithmetic alone, which `Math.sin` is not. It takes turns instead of radians: 1 is a full turn,
 * so that bringing an angle into range is exact, however large it is.
 */

const TAU = 6.283185307179586;

/** Sine of an angle in turns. Within 2 units in the last place of 1. */
export function sineOfTurns(turns: number): number {
  const part = turns - Math.floor(turns + 0.5); // -1/2 to 1/2
  const size = Math.abs(part);
  const fromCrest = Math.abs(size - 0.25);
  const value = fromCrest < 0.125 ? cosine(fromCrest * TAU) : sine(Math.min(size, 0.5 - size) * TAU);
  return part < 0 ? 0 - value : value; // never -0
}

/** For angles in radians of at most π/4: the series to r^16 reaches the last bit. */
function cosine(r: number): number {
  const q = r * r;
  let series = 1;
  for (let n = 15; n >= 1; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  return series;
}

/** For angles in radians of at most π/4: the series to r^17 reaches the last bit. */
function sine(r: number): number {
  const q = r * r;
  let series = 1;
  for (let n = 16; n >= 2; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  return r * series;
}
