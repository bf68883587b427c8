import { describe, requireInteger, requireNonNegative, requirePositive, requireShare } from '../math/checks.ts';
import { checkRamp } from './check-scene-style.ts';
import { parseColor } from './colors.ts';
import type { ParticleStyle, Style, TrailStyle } from './style.ts';

/** Throws at the first thing in a style that cannot be drawn; the message names its place in the data. */
export function checkStyle(style: Style): void {
  if (typeof style !== 'object' || style === null) {
    throw new TypeError(`Style: must be an object such as { particle: { fill: '#2563eb' } }; got ${describe(style)}.`);
  }
  if (style.background !== undefined) parseColor('Style: background', style.background);
  for (const group of Object.keys(style.groups ?? {})) {
    requireInteger('Style', `the key groups[${JSON.stringify(group)}]`, Number(group), 0, 65535);
  }
}

/** The same for one complete particle style, found at `where`. */
export function checkParticleStyle(where: string, style: ParticleStyle): void {
  if (style.fill !== null) parseColor(`${where}.fill`, style.fill);
  if (style.stroke !== null) parseColor(`${where}.stroke`, style.stroke);
  requireNonNegative(where, 'strokeWidth', style.strokeWidth, 'pixels');
  requireShare(where, 'alpha', style.alpha);
  requireNonNegative(where, 'minRadius', style.minRadius, 'pixels');
  requireNonNegative(where, 'fadeOut', style.fadeOut, 'seconds');
  if (style.trail) checkTrail(`${where}.trail`, style.trail);
  if (style.colorBy) checkRamp(`${where}.colorBy`, style.colorBy, { speed: 'metres per second' });
}

function checkTrail(where: string, { seconds, points = 2, width = 2, color, alpha = 1 }: TrailStyle): void {
  requirePositive(where, 'seconds', seconds, 'seconds');
  requireInteger(where, 'points', points, 2, 240);
  requirePositive(where, 'width', width, 'pixels');
  requireShare(where, 'alpha', alpha);
  if (color !== undefined) parseColor(`${where}.color`, color);
}
