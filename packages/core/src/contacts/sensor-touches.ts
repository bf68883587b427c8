import { growColumns } from '../math/columns.ts';

/** What touches sensors in a step: kept apart from the contacts, so that no resolver pushes it. */
export class SensorTouches {
  count = 0;
  /** Slots of the two; `b` is `SCENERY` for a static shape. */
  a: Int32Array = new Int32Array(16);
  b: Int32Array = new Int32Array(16);
  /** Unit normal, towards the first. */
  normalX: Float64Array = new Float64Array(16);
  normalY: Float64Array = new Float64Array(16);
  /** Where it comes from: see `ContactSources.at`. */
  source: Int32Array = new Int32Array(16);

  add(a: number, b: number, normalX: number, normalY: number, source: number): void {
    if (this.count === this.a.length) growColumns(this, this.count * 2);
    const t = this.count++;
    this.a[t] = a;
    this.b[t] = b;
    this.normalX[t] = normalX;
    this.normalY[t] = normalY;
    this.source[t] = source;
  }
}
