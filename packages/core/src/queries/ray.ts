/** A ray that ends: a start, the way from there to its end, and its length. Unit: m. */
export interface Ray {
  readonly x: number;
  readonly y: number;
  readonly dx: number;
  readonly dy: number;
  readonly length: number;
}
