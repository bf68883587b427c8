import { describe } from '../math/checks.ts';

/** `#rgb` or `#rrggbb` as the number 0xrrggbb. */
export function parseColor(where: string, color: string): number {
  const digits = /^#([0-9a-f]{3}|[0-9a-f]{6})$/i.exec(color)?.[1];
  if (digits === undefined) {
    const mend = typeof color === 'string' ? ` Opacity has a field of its own.` : '';
    throw new TypeError(`${where} must be a colour, '#rgb' or '#rrggbb'; got ${describe(color)}.${mend}`);
  }
  if (digits.length === 6) return parseInt(digits, 16);
  return parseInt(digits.replace(/./g, '$&$&'), 16);
}

/** The number 0xrrggbb as `#rrggbb`. */
export function formatColor(rgb: number): string {
  return `#${rgb.toString(16).padStart(6, '0')}`;
}

/** The colour at `share`, 0 to 1, along evenly spaced colours 0xrrggbb. */
export function mixColors(colors: readonly number[], share: number): number {
  const at = share * (colors.length - 1);
  const first = Math.min(Math.floor(at), colors.length - 2);
  const t = at - first;
  let mixed = 0;
  for (let shift = 16; shift >= 0; shift -= 8) {
    const a = (colors[first] >> shift) & 255;
    const b = (colors[first + 1] >> shift) & 255;
    mixed |= Math.round(a + (b - a) * t) << shift;
  }
  return mixed;
}
