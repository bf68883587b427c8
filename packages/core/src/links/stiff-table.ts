/** Numbers a row in `across`. */
export const ACROSS = 5;

/** What `solve-stiff-tree.ts` needs to know of links on top of what a `TreeTable` has, row by row. */
export class StiffTable {
  minLength: Float64Array = new Float64Array(0);
  maxLength: Float64Array = new Float64Array(0);
  compliance: Float64Array = new Float64Array(0);
  damping: Float64Array = new Float64Array(0);
  restitution: Float64Array = new Float64Array(0);
  /** At which limit the link is: 1 the greatest, -1 the least, 0 neither; 2 both, a rod. */
  side: Int8Array = new Int8Array(0);
  /** 1 where the link was at a limit or next to it: it jerks no more. */
  taut: Uint8Array = new Uint8Array(0);
  /** The length to aim at in this small step. Unit: m. */
  goal: Float64Array = new Float64Array(0);
  /** The tension of the small step before. Unit: N·s/m. */
  before: Float64Array = new Float64Array(0);
  /** How the link resists being turned, and what that comes to: see `eliminateStiff`. */
  across: Float64Array = new Float64Array(0);

  /** Makes room for so many rows, all empty. */
  clear(room: number): void {
    this.taut.fill(0);
    this.maxLength.fill(0); // no link has this length: all will be read
    if (room <= this.side.length) return;
    this.minLength = new Float64Array(room);
    this.maxLength = new Float64Array(room);
    this.compliance = new Float64Array(room);
    this.damping = new Float64Array(room);
    this.restitution = new Float64Array(room);
    this.side = new Int8Array(room);
    this.taut = new Uint8Array(room);
    this.goal = new Float64Array(room);
    this.before = new Float64Array(room);
    this.across = new Float64Array(room * ACROSS);
  }
}
