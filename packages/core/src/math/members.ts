import { absent, describe, wrong } from './checks.ts';

/** A list of things that were added, each once, in order; what is added must have a certain method. */
export class Members<T extends object> {
  /** The members themselves: to read. Taking one out makes a new list, so that a loop over the old one misses none. */
  list: T[] = [];
  readonly #members = new Set<T>();
  readonly #what: string;
  readonly #method: string;

  /**
   * @param what - What the things are, for error messages, such as 'an effect'.
   * @param method - The method that each must have, with its arguments, such as 'afterStep(world, expired, dt)'.
   */
  constructor(what: string, method: string) {
    this.#what = what;
    this.#method = method;
  }

  /** Throws the error that says why something cannot be added, if it cannot. */
  check(where: string, member: T): void {
    const name = this.#method.slice(0, this.#method.indexOf('('));
    if (typeof member !== 'object' || member === null || !(name in member)) {
      throw wrong(where, `${this.#what} must have a method ${this.#method}`, member);
    }
    if (this.#members.has(member)) {
      throw new Error(`${where}: ${this.#what} can be added once; ${describe(member)} is in the world already.`);
    }
  }

  add(where: string, member: T): void {
    this.check(where, member);
    this.#members.add(member);
    this.list.push(member);
  }

  has(member: T): boolean {
    return this.#members.has(member);
  }

  /** Takes something out. */
  remove(where: string, member: T): void {
    if (!this.#members.has(member)) throw absent(where, this.#what, member);
    this.keep((other) => other !== member);
  }

  /** Takes out what does not pass a test. */
  keep(passes: (member: T) => boolean): void {
    this.list = this.list.filter((member) => passes(member) || !this.#members.delete(member));
  }
}
