import { cos, sin } from './trigonometry.ts';

const TAU = 6.283185307179586;

/**
 * Sine of an angle in turns, of which 1 is a full one: whole turns go without rounding, however many, and quarter turns give
 * exactly 0, 1 and -1. The cosine is the sine of a quarter turn more.
 */
export function sineOfTurns(turns: number): number {
  const part = turns - Math.floor(turns + 0.5); // -1/2 to 1/2
  const size = Math.abs(part);
  const fromCrest = Math.abs(size - 0.25);
  const value = fromCrest < 0.125 ? cos(fromCrest * TAU) : sin(Math.min(size, 0.5 - size) * TAU);
  return part < 0 ? 0 - value : value; // never -0
}
