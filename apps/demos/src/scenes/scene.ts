import type { Particle, PointerSpringOptions, World } from '@mass/core';
import type { Bounds, Style } from '@mass/core/view';
import type { Palette } from './palette.ts';

/**
 * A scene is data and a `build()`. It knows the core alone: no DOM, no renderer, no loop, no clock. The gallery, the
 * headless test, the browser tests and the benchmarks all run the same scenes.
 */
export interface Scene<Name extends string = string> {
  /** The scene's address, `scenes/<id>/`. Kebab-case, as its file. */
  readonly id: string;
  /** Where it stands in the thesis, "Figure 5". */
  readonly figure: string;
  readonly title: string;
  /** What happens here and why, in two or three sentences. */
  readonly summary: string;
  /** What to look for, in one sentence. */
  readonly lookFor: string;
  /** The law that the scene shows, in TeX. */
  readonly formula: string;
  /** What the reader may change, in the order of the sliders. */
  readonly parameters: { readonly [name in Name]: Parameter };
  /** The part of the plane that is fitted into the picture. Unit: m. */
  readonly show: Bounds;
  /** The fixed step, @default 1 / 60. Unit: s. */
  readonly step?: number;
  /** How far a thumbnail that must not move has run. @default 2. Unit: s. */
  readonly poster?: number;
  /** What is less than on its page in a thumbnail and in the tests of all scenes, where there is a lot. */
  readonly light?: Partial<Values<Name>>;
  /** How it is drawn: plain data, the same for every renderer. */
  style(palette: Palette): Style;
  /** Makes the world. The same values and seed make the same world, to the bit. */
  build(values: Values<Name>, seed: number): Setup;
  /** What must be seen, found out on a world that runs without a picture. */
  check(run: Run<Name>): readonly Finding[];
}

/** A number that the reader may change. */
export interface Parameter {
  readonly label: string;
  readonly unit?: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** What it is until it is changed. */
  readonly value: number;
  /** Read while the scene runs, from the same object that `build` was given. By default a change starts the scene anew. */
  readonly live?: boolean;
}

/** The values of the parameters. */
export type Values<Name extends string = string> = { [name in Name]: number };

/** A point of the plane. Unit: m. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** A scene that was built: a world and what goes with it. */
export interface Setup {
  readonly world: World;
  /** A heading over the world, where there are several. */
  readonly label?: string;
  /** More worlds, drawn beside the first and stepped with it: the wrong answer and the right one. */
  readonly beside?: readonly Beside[];
  /** What the reader can do, each by its key or button. */
  readonly actions?: readonly Action[];
  /** What a click or a tap does. */
  tap?(at: Point): void;
  /** Whether the pointer may take hold of a particle that can move. @default always */
  takes?(particle: Particle): boolean;
  /** How the pointer drags what it takes hold of, where it must be stronger than usual: to tear something. */
  readonly hand?: PointerSpringOptions;
  /** What a drag does where there is no particle to take hold of. */
  readonly pointer?: Pointer;
  /** Called before each step of the world. Unit: s. */
  beforeStep?(dt: number): void;
  /** Lines, marks and words over the picture, in metres. Asked for at each frame. */
  guides?(): readonly Guide[];
  /** Numbers that are worth reading while it runs. Asked for a few times a second. */
  readouts?(): readonly Readout[];
}

/** One more world of a scene, and what is drawn over it. */
export interface Beside {
  readonly world: World;
  readonly label: string;
  guides?(): readonly Guide[];
}

/** Something that the reader can do. */
export interface Action {
  /** As in `KeyboardEvent.key`: one printable character, an arrow or Enter. */
  readonly key: string;
  readonly label: string;
  /** The group of the particles that it brings forth: the button takes their colour. */
  readonly group?: number;
  run(): void;
}

/** What a drag does, in metres. One pointer at a time. */
export interface Pointer {
  /** False leaves the pointer to the page. */
  down(at: Point): boolean;
  move?(at: Point): void;
  up?(at: Point): void;
}

/** How a guide is coloured: `quiet`, `ink`, `accent`, or as the particles of a group. */
export type Tone = 'quiet' | 'ink' | 'accent' | number;

/** Something drawn over the picture. Positions in metres; widths and text sizes are the stage's. */
export type Guide =
  /** A line through points, x and y in turn. */
  | {
      readonly kind: 'curve';
      readonly points: ArrayLike<number>;
      readonly tone?: Tone;
      readonly dashed?: boolean;
      /** Wider: what the eye should follow. */
      readonly bold?: boolean;
      readonly opacity?: number;
    }
  /** A ring or a dot. */
  | {
      readonly kind: 'circle';
      readonly x: number;
      readonly y: number;
      readonly radius: number;
      readonly tone?: Tone;
      readonly filled?: boolean;
      readonly opacity?: number;
    }
  | {
      readonly kind: 'arrow';
      readonly from: Point;
      readonly to: Point;
      readonly tone?: Tone;
      /** Wider: what the eye should follow. */
      readonly bold?: boolean;
      readonly opacity?: number;
    }
  | {
      readonly kind: 'label';
      readonly x: number;
      readonly y: number;
      readonly text: string;
      readonly tone?: Tone;
      /** @default 'center' */
      readonly align?: 'left' | 'center' | 'right';
      readonly opacity?: number;
    };

/** A number that is worth reading. */
export interface Readout {
  readonly label: string;
  readonly value: number;
  readonly unit?: string;
  /** Digits after the point. @default 2 */
  readonly digits?: number;
}

/** Starts a scene without a picture, with its own values where none are given. */
export type Run<Name extends string = string> = (values?: Partial<Values<Name>>, seed?: number) => Trial;

/** A scene that runs without a picture. */
export interface Trial {
  readonly setup: Setup;
  /** Does what the key does. */
  press(key: string): void;
  /** Steps, and looks on after each of them. */
  run(seconds: number, look?: () => void): void;
}

/** Something found out by a check: `value` must lie between the bounds that are given. */
export interface Finding {
  readonly name: string;
  readonly value: number;
  readonly atLeast?: number;
  readonly atMost?: number;
}

/** Whether what was found is what must be seen. */
export function holds({ value, atLeast = -Infinity, atMost = Infinity }: Finding): boolean {
  return value >= atLeast && value <= atMost;
}
