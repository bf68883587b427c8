import {
  describe,
  requireFinite,
  requireInteger,
  requireNonNegative,
  requirePositive,
  requireShare,
} from '../math/checks.ts';
import type { Ramp } from './color-style.ts';
import { parseColor } from './colors.ts';
import type { BungeeStyle, LinkStyle, SpringStyle } from './link-style.ts';
import type { SceneStyle } from './scene-style.ts';
import type { ArrowStyle, BodyStyle, ContactStyle, LiquidStyle, ShapeStyle } from './scenery-style.ts';
import type { Style } from './style.ts';

const sections = [
  'links',
  'springs',
  'bungees',
  'pins',
  'shapes',
  'liquids',
  'bodies',
  'velocities',
  'forces',
  'contacts',
] as const;

/** Throws where a section is neither data nor `null`, before it is completed. */
export function checkSections(style: Style): void {
  for (const name of sections) {
    const section: unknown = style[name];
    if (section === undefined || (typeof section === 'object' && !Array.isArray(section))) continue;
    throw new TypeError(
      `Style: ${name} must be an object, {} for the defaults, or null to leave them out; got ${describe(section)}.`,
    );
  }
}

/** Throws at the first thing in the completed sections that cannot be drawn; the message names its place in the data. */
export function checkSceneStyle(style: SceneStyle): void {
  for (const [kind, link] of Object.entries(style.links)) if (link) checkLink(`Style: links.${kind}`, link);
  if (style.springs) checkSprings('Style: springs', style.springs);
  if (style.bungees) checkCord('Style: bungees', style.bungees);
  if (style.pins) {
    checkColor('Style: pins', style.pins);
    requireNonNegative('Style: pins', 'radius', style.pins.radius, 'pixels');
  }
  if (style.shapes) checkShapes('Style: shapes', style.shapes);
  if (style.liquids) checkLiquids('Style: liquids', style.liquids);
  if (style.bodies) checkBodies('Style: bodies', style.bodies);
  if (style.velocities) checkArrows('Style: velocities', style.velocities);
  if (style.forces) checkArrows('Style: forces', style.forces);
  if (style.contacts) checkContacts('Style: contacts', style.contacts);
}

/** The same for a ramp of colours; `units` has the unit of each quantity that it may go by. */
export function checkRamp<By extends string>(
  where: string,
  ramp: Ramp<By>,
  units: { readonly [by in By]: string },
): void {
  if (!Object.hasOwn(units, ramp.by)) {
    const names = Object.keys(units).map((name) => `'${name}'`);
    throw new TypeError(`${where}: by must be ${names.join(' or ')}; got ${describe(ramp.by)}.`);
  }
  const { from, to, colors } = ramp;
  requireFinite(where, 'from', from, units[ramp.by]);
  requireFinite(where, 'to', to, units[ramp.by]);
  requirePositive(where, 'to - from', to - from, units[ramp.by], 'Turn the colours around to have it the other way.');
  if (!Array.isArray(colors) || colors.length < 2) {
    throw new RangeError(`${where}: colors must be two colours or more; got ${describe(colors)}.`);
  }
  for (const [i, color] of colors.entries()) parseColor(`${where}.colors[${i}]`, color);
}

function checkColor(where: string, { color, alpha }: Pick<LinkStyle, 'color' | 'alpha'>): void {
  parseColor(`${where}.color`, color);
  requireShare(where, 'alpha', alpha);
}

function checkLine(where: string, style: Omit<LinkStyle, 'colorBy'>): void {
  checkColor(where, style);
  requirePositive(where, 'width', style.width, 'pixels');
}

function checkLink(where: string, style: LinkStyle): void {
  checkLine(where, style);
  if (style.colorBy) checkRamp(`${where}.colorBy`, style.colorBy, { strain: '' });
}

function checkCord(where: string, style: BungeeStyle): void {
  checkLine(where, style);
  if (style.colorBy) {
    checkRamp(`${where}.colorBy`, style.colorBy, { strain: '', force: 'newtons', stiffness: 'newtons per metre' });
  }
}

function checkSprings(where: string, style: SpringStyle): void {
  checkCord(where, style);
  requireInteger(where, 'coils', style.coils, 0, 100);
  requireNonNegative(where, 'diameter', style.diameter, 'pixels');
}

function checkShapes(where: string, style: ShapeStyle): void {
  for (const name of ['fill', 'stroke', 'hatch'] as const) {
    const color = style[name];
    if (color !== null) parseColor(`${where}.${name}`, color);
  }
  requireShare(where, 'fillAlpha', style.fillAlpha);
  requireShare(where, 'hatchAlpha', style.hatchAlpha);
  requireNonNegative(where, 'strokeWidth', style.strokeWidth, 'pixels');
  if (!(style.hatchSpacing >= 2 && style.hatchSpacing < Infinity)) {
    throw new RangeError(
      `${where}: hatchSpacing must be a finite number of pixels, 2 or more; got ${describe(style.hatchSpacing)}. ` +
        'For no hatching set hatch to null.',
    );
  }
}

function checkLiquids(where: string, style: LiquidStyle): void {
  parseColor(`${where}.fill`, style.fill);
  requireShare(where, 'alpha', style.alpha);
  requireNonNegative(where, 'surfaceWidth', style.surfaceWidth, 'pixels');
  if (style.colorBy) checkRamp(`${where}.colorBy`, style.colorBy, { density: 'kilograms per cubic metre' });
}

function checkBodies(where: string, style: BodyStyle): void {
  if (style.fill !== null) parseColor(`${where}.fill`, style.fill);
  if (style.stroke !== null) parseColor(`${where}.stroke`, style.stroke);
  requireShare(where, 'fillAlpha', style.fillAlpha);
  requireNonNegative(where, 'strokeWidth', style.strokeWidth, 'pixels');
}

function checkArrows(where: string, style: ArrowStyle): void {
  checkLine(where, style);
  requirePositive(where, 'scale', style.scale, '');
  requirePositive(where, 'longest', style.longest, 'pixels');
}

function checkContacts(where: string, style: ContactStyle): void {
  checkLine(where, style);
  requireNonNegative(where, 'scale', style.scale, '');
  requireNonNegative(where, 'normal', style.normal, 'pixels');
  requirePositive(where, 'longest', style.longest, 'pixels');
}
