/** How one path is painted: a fill, or a line of some width. */
export interface PathPaint {
  readonly color: string;
  /** 0xrrggbb. */
  readonly rgb: number;
  /** 0 to 1. */
  readonly alpha: number;
  /** Unit: CSS px; 0 for a fill. */
  readonly width: number;
  /** Whether paths of this paint may share one stroke: they do not overlap, or it does not show. */
  readonly together: boolean;
}

/** What a path is: a filled polygon, a filled strip (points from edge to edge and back), a line, or a closed line. */
export const pathKinds = { fill: 0, strip: 1, line: 2, ring: 3 } as const;

/**
 * Lines and polygons of one layer of a picture, in CSS px, in the order in which they are drawn. Emptied and filled anew,
 * it allocates only when it has to grow. For authors of renderers.
 */
export class PathList {
  /** How many paths there are. */
  count = 0;
  /** x and y of every point, path after path. Unit: CSS px. */
  points: Float64Array = new Float64Array(256);
  /** The first number of each path in `points`; one entry more than there are paths. */
  starts: Uint32Array = new Uint32Array(64);
  /** One of `pathKinds` for each path. */
  kinds: Uint8Array = new Uint8Array(64);
  /** How each path is painted. */
  readonly paints: PathPaint[] = [];
  /** Grows each time that it is filled anew. */
  version = 0;
  #length = 0;

  /** Forgets all paths. */
  clear(): void {
    this.count = 0;
    this.#length = 0;
    this.version++;
  }

  /** Adds a point to the path that is being made. */
  add(x: number, y: number): void {
    if (this.#length + 2 > this.points.length) this.#growPoints();
    this.points[this.#length] = x;
    this.points[this.#length + 1] = y;
    this.#length += 2;
  }

  /** Ends the path that was being made. */
  end(kind: number, paint: PathPaint): void {
    const p = this.count;
    if (p + 2 > this.starts.length) this.#growPaths();
    this.count++;
    this.kinds[p] = kind;
    this.paints[p] = paint;
    this.starts[p + 1] = this.#length;
  }

  /** Takes back the points of the path that is being made. */
  drop(): void {
    this.#length = this.starts[this.count];
  }

  /** Adds a straight line. */
  line(x0: number, y0: number, x1: number, y1: number, paint: PathPaint): void {
    this.add(x0, y0);
    this.add(x1, y1);
    this.end(pathKinds.line, paint);
  }

  #growPoints(): void {
    const points = new Float64Array(this.points.length * 2);
    points.set(this.points);
    this.points = points;
  }

  #growPaths(): void {
    const starts = new Uint32Array(this.starts.length * 2);
    const kinds = new Uint8Array(this.starts.length * 2);
    starts.set(this.starts);
    kinds.set(this.kinds);
    this.starts = starts;
    this.kinds = kinds;
  }
}
