/**
 * Sine from exactly specified arithmetic alone, which `Math.sin` is not. It takes turns instead of radians: 1 is a full turn,
 * so that bringing an angle into range is exact, however large it is.
 */

const TAU = 6.283185307179586;

/** Sine of an angle in turns. Within 2 units in the last place of 1. */
export function sineOfTurns(turns: number): number {
  let part = turns - Math.floor(turns + 0.5); // -1/2 to 1/2
  if (part > 0.25) part = 0.5 - part;
  else if (part < -0.25) part = -0.5 - part;
  const r = part * TAU; // at most π/2: the Taylor series to r^21 reaches the last bit
  const q = r * r;
  let series = 1;
  for (let n = 20; n >= 2; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  return r * series;
}
