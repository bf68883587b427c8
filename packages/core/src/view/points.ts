/** Where geometry puts the points that it makes, in CSS px. */
export interface PointSink {
  add(x: number, y: number): void;
}

/** A list of points that is used again and again. */
export class Points implements PointSink {
  /** x, y, x, y, ... */
  data: Float64Array = new Float64Array(64);
  count = 0;

  clear(): this {
    this.count = 0;
    return this;
  }

  add(x: number, y: number): void {
    if (2 * this.count === this.data.length) {
      const data = new Float64Array(this.data.length * 2);
      data.set(this.data);
      this.data = data;
    }
    this.data[2 * this.count] = x;
    this.data[2 * this.count + 1] = y;
    this.count++;
  }

  /** Adds all of them to a path. */
  copyTo(sink: PointSink): void {
    for (let i = 0; i < this.count; i++) sink.add(this.data[2 * i], this.data[2 * i + 1]);
  }
}
