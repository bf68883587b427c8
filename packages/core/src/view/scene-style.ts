import type { BungeeStyle, LinkStyle, PinStyle, SpringStyle } from './link-style.ts';
import type { ArrowStyle, BodyStyle, ContactStyle, LiquidStyle, ShapeStyle } from './scenery-style.ts';

/** The sections of a style that are not about particles, complete; `null` for what is not drawn. */
export interface SceneStyle {
  readonly links: { readonly [kind: string]: LinkStyle | null };
  /** Links of a kind that the style does not name. */
  readonly otherLinks: LinkStyle | null;
  readonly springs: SpringStyle | null;
  readonly bungees: BungeeStyle | null;
  readonly pins: PinStyle | null;
  readonly shapes: ShapeStyle | null;
  readonly liquids: LiquidStyle | null;
  readonly bodies: BodyStyle | null;
  readonly velocities: ArrowStyle | null;
  readonly forces: ArrowStyle | null;
  readonly contacts: ContactStyle | null;
}
