/** A colour that every renderer reads alike: `#rgb` or `#rrggbb`. */
export type Color = string;

/** Colour by a quantity: the first colour at `from` and below, the last at `to` and above, even steps between. */
export interface Ramp<By extends string> {
  readonly by: By;
  /** In the unit of the quantity. */
  readonly from: number;
  /** In the unit of the quantity. */
  readonly to: number;
  /** Two or more. */
  readonly colors: readonly Color[];
}
