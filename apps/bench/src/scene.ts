/** A disc, or a point mass where nothing collides. SI units throughout; +y is up. */
export interface Disc {
  readonly x: number;
  readonly y: number;
  readonly vx?: number;
  readonly vy?: number;
  readonly radius: number;
  readonly mass: number;
  /** Held in place. */
  readonly fixed?: boolean;
  /** So fast that an engine's continuous collision, where it must be asked for, is asked for. */
  readonly fast?: boolean;
}

/** A square box that moves. */
export interface Crate {
  readonly x: number;
  readonly y: number;
  readonly size: number;
  readonly mass: number;
}

/** An immovable, upright, solid box. */
export interface Bar {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A constant distance of the centres of two discs. */
export interface Link {
  readonly a: number;
  readonly b: number;
  readonly length: number;
}

/** A floor and two walls without end, each solid beyond its surface. */
export interface Container {
  readonly left: number;
  readonly right: number;
  readonly floor: number;
}

/** Resistance of the air, -k1·v in newtons, by what the engine has for it or by a function of the user's, called for each disc. */
export interface Drag {
  readonly k1: number;
  readonly by: 'engine' | 'function';
}

/** What is simulated, in plain terms that every engine is given alike. */
export interface Scene {
  /** Downwards. Unit: m/s². */
  readonly gravity: number;
  /** Length of a step. Unit: s. */
  readonly dt: number;
  readonly discs: readonly Disc[];
  readonly crates: readonly Crate[];
  readonly links: readonly Link[];
  readonly bars: readonly Bar[];
  readonly container?: Container;
  readonly drag?: Drag;
  /** Whether discs collide with one another. */
  readonly collide: boolean;
  /** Of everything that touches. */
  readonly friction: number;
  readonly restitution: number;
  /** Whether what rests may fall asleep, in an engine that knows sleep. */
  readonly sleep: boolean;
}

/** A scene of which only what matters is given: 60 steps a second, earth's gravity, nothing that collides. */
export function makeScene(parts: Partial<Scene>): Scene {
  return {
    gravity: 9.81,
    dt: 1 / 60,
    discs: [],
    crates: [],
    links: [],
    bars: [],
    collide: false,
    friction: 0,
    restitution: 0,
    sleep: false,
    ...parts,
  };
}
