import { checkSceneStyle, checkSections } from './check-scene-style.ts';
import type { Color } from './color-style.ts';
import { parseColor } from './colors.ts';
import type { LinkStyle } from './link-style.ts';
import type { SceneStyle } from './scene-style.ts';
import type { ArrowStyle } from './scenery-style.ts';
import type { Style } from './style.ts';

/** Colours that suit a background: light, dark, or, where there is none, either. */
interface Tones {
  readonly ink: Color;
  readonly line: Color;
  readonly liquid: Color;
  readonly velocity: Color;
  readonly force: Color;
  readonly contact: Color;
}

const onLight: Tones = {
  ink: '#475569',
  line: '#64748b',
  liquid: '#0284c7',
  velocity: '#15803d',
  force: '#dc2626',
  contact: '#c2410c',
};

const onDark: Tones = {
  ink: '#94a3b8',
  line: '#a3b1c4',
  liquid: '#38bdf8',
  velocity: '#4ade80',
  force: '#f87171',
  contact: '#fb923c',
};

const onEither: Tones = {
  ink: '#64748b',
  line: '#7687a0',
  liquid: '#0ea5e9',
  velocity: '#16a34a',
  force: '#ef4444',
  contact: '#ea580c',
};

/** Completes the sections of a style by their defaults. What cannot be drawn is an error that names its place. */
export function completeStyle(style: Style): SceneStyle {
  checkSections(style);
  const tones = tonesFor(style.background);
  const { links = {} } = style;
  const section = <T>(given: Partial<T> | null | undefined, defaults: T): T | null =>
    given === null ? null : { ...defaults, ...given };
  const asked = <T>(given: Partial<T> | null | undefined, defaults: T): T | null =>
    given === undefined ? null : section(given, defaults);
  const line = (width: number): LinkStyle => ({ color: tones.line, colorBy: null, width, alpha: 1 });
  const widths: { readonly [kind: string]: number } = { rod: 3, cable: 1.75 };
  const kinds = new Set([...Object.keys(widths), ...Object.keys(links ?? {})]);
  const complete: SceneStyle = {
    links: Object.fromEntries(
      [...kinds].map((kind) => [kind, links === null ? null : section(links[kind], line(widths[kind] ?? 2))]),
    ),
    otherLinks: links === null ? null : line(2),
    springs: section(style.springs, {
      color: tones.line,
      colorBy: null,
      width: 1.75,
      alpha: 1,
      coils: 9,
      diameter: 16,
    }),
    bungees: section(style.bungees, { color: tones.line, colorBy: null, width: 4, alpha: 1 }),
    pins: section(style.pins, { color: tones.ink, radius: 5, alpha: 1 }),
    shapes: section(style.shapes, {
      fill: tones.ink,
      fillAlpha: 0.1,
      stroke: tones.ink,
      strokeWidth: 2,
      hatch: tones.ink,
      hatchAlpha: 0.26,
      hatchSpacing: 9,
    }),
    liquids: section(style.liquids, {
      fill: tones.liquid,
      colorBy: null,
      alpha: 0.22,
      surfaceWidth: 2,
      hulls: true,
    }),
    bodies: section(style.bodies, {
      fill: null,
      fillAlpha: 0.3,
      stroke: null,
      strokeWidth: 2,
      mark: true,
      skeleton: false,
    }),
    velocities: asked(style.velocities, arrow(tones.velocity, 0.15)),
    forces: asked(style.forces, arrow(tones.force, 0.05)),
    contacts: asked(style.contacts, {
      color: tones.contact,
      width: 1.75,
      normal: 14,
      scale: 0.5,
      longest: 160,
      alpha: 1,
    }),
  };
  checkSceneStyle(complete);
  return complete;
}

function arrow(color: Color, scale: number): ArrowStyle {
  return { color, width: 2, scale, longest: 160, alpha: 1 };
}

function tonesFor(background: Color | undefined): Tones {
  if (background === undefined) return onEither;
  const rgb = parseColor('Style: background', background);
  const luma = 0.3 * (rgb >> 16) + 0.59 * ((rgb >> 8) & 255) + 0.11 * (rgb & 255);
  return luma > 128 ? onLight : onDark;
}
