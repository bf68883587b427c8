/** How far two things are apart along their paths, as a function of the time from now. */
export interface GapPath {
  /** Gap at the time asked for last, negative where they overlap; `Infinity` where they are too far apart to touch. Unit: m. */
  readonly gap: number;
  /** How fast the gap grows there. Unit: m/s. */
  readonly rate: number;
  /** Finds the gap and its rate at a time from now. Unit: s. */
  at(time: number): void;
}
