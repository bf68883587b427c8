import { BoxTree } from './box-tree.ts';
import type { Shape } from './shape.ts';
import { checkSurface } from './surface-options.ts';

/** How many shapes lie in one strip of the tree: a square of them, about. */
const perStrip = (count: number): number => Math.ceil(Math.sqrt(count / 4)) * 4;

/** Static shapes in a tree of the boxes around them, which is made anew when any comes or goes. */
export class ShapeIndex {
  #shapes: Shape[] = [];
  #order: Int32Array = new Int32Array(0);
  #tree: BoxTree = new BoxTree(new Float64Array(0));

  /** Takes the shapes as they are now. @returns Whether any came or went. */
  update(shapes: readonly Shape[]): boolean {
    if (!this.#differs(shapes)) return false;
    for (const shape of shapes) checkSurface('Shape', shape);
    this.#shapes = [...shapes];
    this.#order = sorted(shapes);
    this.#tree = new BoxTree(boxesOf(shapes, this.#order));
    return true;
  }

  #differs(shapes: readonly Shape[]): boolean {
    for (let s = 0; s < shapes.length; s++) if (shapes[s] !== this.#shapes[s]) return true;
    return shapes.length !== this.#shapes.length;
  }

  /** Finds the shapes whose boxes overlap or touch a square. Unit: m. @returns How many: see `at`. */
  find(x: number, y: number, half: number): number {
    return this.#tree.find(x - half, y - half, x + half, y + half);
  }

  /** The number of a shape that was found last. */
  at(found: number): number {
    return this.#order[this.#tree.found[found]];
  }
}

/** Shapes in the order of their places, so that neighbours lie near each other: strip by strip, those without end first. */
function sorted(shapes: readonly Shape[]): Int32Array {
  const middle = (min: number, max: number) => (max - min < Infinity ? min + max : -Infinity);
  const x = shapes.map(({ minX, maxX, minY, maxY }) => (maxY - minY < Infinity ? middle(minX, maxX) : -Infinity));
  const y = shapes.map(({ minY, maxY }) => middle(minY, maxY));
  const order = Int32Array.from(shapes.keys()).sort((a, b) => x[a] - x[b]);
  const size = perStrip(shapes.length);
  for (let start = 0; start < order.length; start += size) {
    order.subarray(start, start + size).sort((a, b) => y[a] - y[b]);
  }
  return order;
}

function boxesOf(shapes: readonly Shape[], order: Int32Array): Float64Array {
  const boxes = new Float64Array(order.length * 4);
  for (let n = 0; n < order.length; n++) {
    const { minX, minY, maxX, maxY } = shapes[order[n]];
    boxes.set([minX, minY, maxX, maxY], n * 4);
  }
  return boxes;
}
