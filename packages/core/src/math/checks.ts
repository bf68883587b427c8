/**
 * The wording of argument errors, in one place: *where: what must hold; what came. How to mend it.*
 * The comparisons are written so that NaN fails them. A bad number is a RangeError, what is no number a TypeError.
 */

/** The error of something wrong, to be thrown: of a thing, or of a number where `Kind` is RangeError. */
export function wrong(
  where: string,
  must: string,
  value: unknown,
  mend = '',
  Kind: ErrorConstructor = TypeError,
): Error {
  return new Kind(`${where}: ${must}; got ${describe(value)}. ${mend}`.trimEnd());
}

function fail(where: string, must: string, value: unknown, mend: string): never {
  throw wrong(where, must, value, mend, typeof value === 'number' ? RangeError : TypeError);
}

/** The error of something that should be taken out and is not in the world. */
export function absent(where: string, what: string, member: unknown): Error {
  return new Error(`${where}: ${what} must be in the world to be taken out; ${describe(member)} is not.`);
}

/** A value as an error message shows it: short, and a string told from a number. */
export function describe(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'function') return `function ${value.name}`;
  if (Array.isArray(value)) return 'an array';
  if (typeof value === 'object' && value !== null) return value.constructor?.name ?? 'an object';
  return String(value);
}

/** An object to take options out of; `example` shows one. */
export function requireOptions(where: string, name: string, value: object, example: string): void {
  if (typeof value !== 'object' || value === null) {
    throw wrong(where, `${name} must be an object such as ${example}`, value);
  }
}

/** A function; `what` says of what. */
export function requireFunction(where: string, name: string, value: unknown, what: string): void {
  if (typeof value !== 'function') throw wrong(where, `${name} must be a function ${what}`, value);
}

function of(unit: string): string {
  return unit === '' ? '' : ` of ${unit}`;
}

/** A finite number, in `unit`; a plain number where `unit` is empty. */
export function requireFinite(where: string, name: string, value: number, unit: string, mend = ''): void {
  if (typeof value !== 'number' || !Number.isFinite(value)) {
    fail(where, `${name} must be a finite number${of(unit)}`, value, mend);
  }
}

/** A positive, finite number. */
export function requirePositive(where: string, name: string, value: number, unit: string, mend = ''): void {
  if (typeof value !== 'number' || !(value > 0 && value < Infinity)) {
    fail(where, `${name} must be a positive, finite number${of(unit)}`, value, mend);
  }
}

/** A positive number, where `Infinity` is one of the answers. */
export function requirePositiveOrInfinite(where: string, name: string, value: number, unit: string, mend = ''): void {
  if (typeof value !== 'number' || !(value > 0)) {
    fail(where, `${name} must be a positive number${of(unit)}`, value, mend);
  }
}

/** A mass: a positive number whose inverse is finite, or `Infinity`. */
export function requireMass(where: string, value: number): void {
  if (typeof value !== 'number' || !(value > 0 && 1 / value < Infinity)) {
    fail(where, 'mass must be a positive number of kilograms', value, 'Use Infinity to pin the particle.');
  }
}

/** A finite number that is 0 or more. */
export function requireNonNegative(where: string, name: string, value: number, unit: string, mend = ''): void {
  if (typeof value !== 'number' || !(value >= 0 && value < Infinity)) {
    fail(where, `${name} must be a finite number${of(unit)}, 0 or more`, value, mend);
  }
}

/** A share, 0 to 1. */
export function requireShare(where: string, name: string, value: number, mend = ''): void {
  if (typeof value !== 'number' || !(value >= 0 && value <= 1)) {
    fail(where, `${name} must be a number from 0 to 1`, value, mend);
  }
}

/** A whole number from `min` to `max`. */
export function requireInteger(where: string, name: string, value: number, min: number, max: number, mend = ''): void {
  if (!(Number.isInteger(value) && value >= min && value <= max)) {
    fail(where, `${name} must be a whole number from ${min} to ${max}`, value, mend);
  }
}

/** A truth value. */
export function requireFlag(where: string, name: string, value: boolean): void {
  if (typeof value !== 'boolean') fail(where, `${name} must be true or false`, value, '');
}

/** One of a few words; `undefined` among them is for what may be left out. */
export function requireOneOf(where: string, name: string, value: unknown, allowed: readonly unknown[]): void {
  if (allowed.includes(value)) return;
  const words = allowed.filter((word) => word !== undefined).map((word) => `'${word}'`);
  throw wrong(where, `${name} must be ${words.join(' or ')}`, value, '', RangeError);
}

/** Two finite coordinates or components, `{ x, y }`. */
export function requireVector(where: string, name: string, value: { x: number; y: number }, unit: string): void {
  if (typeof value !== 'object' || value === null) {
    throw wrong(where, `${name} must be { x, y }, in ${unit}`, value);
  }
  requireFinite(where, `${name}.x`, value.x, unit);
  requireFinite(where, `${name}.y`, value.y, unit);
}

/** `max` is at least `min`. */
export function requireOrdered(where: string, name: string, min: number, max: number, unit: string): void {
  if (!(min <= max))
    fail(where, `the greatest ${name} must be at least the smallest, ${`${min} ${unit}`.trimEnd()}`, max, 'Swap them.');
}
