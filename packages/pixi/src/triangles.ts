import { Mesh, MeshGeometry } from 'pixi.js';
import type { Swatches } from './swatches.ts';

const firstVertices = 256;

/** Triangles in one draw call, filled anew as often as need be, without garbage; each corner has a colour and a coverage. */
export class Triangles {
  readonly mesh: Mesh;
  readonly #geometry: MeshGeometry;
  readonly #swatches: Swatches;
  #positions: Float32Array = new Float32Array(2 * firstVertices);
  #uvs: Float32Array = new Float32Array(2 * firstVertices);
  #indices: Uint32Array = new Uint32Array(3 * firstVertices);
  #vertices = 0;
  #used = 0;
  #drawn = 0;
  #u = 0;
  #v = 0;

  constructor(swatches: Swatches) {
    this.#swatches = swatches;
    this.#geometry = new MeshGeometry({ positions: this.#positions, uvs: this.#uvs, indices: this.#indices });
    this.#geometry.batchMode = 'no-batch';
    this.mesh = new Mesh({
      geometry: this.#geometry,
      texture: swatches.texture,
      visible: false,
      eventMode: 'none',
      label: 'mass paths',
    });
  }

  begin(): void {
    this.#vertices = 0;
    this.#used = 0;
  }

  /** The colour of the corners to come, 0xrrggbb, and its opacity. */
  color(rgb: number, alpha: number): void {
    const place = this.#swatches.place(rgb, alpha);
    this.#u = this.#swatches.u(place);
    this.#v = this.#swatches.v(place);
  }

  /** Adds a corner, of which so much is covered, 0 to 1. Returns its number. */
  corner(x: number, y: number, coverage: number): number {
    const at = 2 * this.#vertices;
    if (at === this.#positions.length) this.#growVertices();
    this.#positions[at] = x;
    this.#positions[at + 1] = y;
    this.#uvs[at] = this.#u + coverage * this.#swatches.pitch;
    this.#uvs[at + 1] = this.#v;
    return this.#vertices++;
  }

  triangle(a: number, b: number, c: number): void {
    if (this.#used + 3 > this.#indices.length) this.#growIndices();
    this.#indices[this.#used] = a;
    this.#indices[this.#used + 1] = b;
    this.#indices[this.#used + 2] = c;
    this.#used += 3;
  }

  /** Two triangles, between the sides a to b and c to d. */
  quad(a: number, b: number, c: number, d: number): void {
    this.triangle(a, b, c);
    this.triangle(b, d, c);
  }

  end(): void {
    // What was drawn before and is not now becomes triangles without area.
    if (this.#drawn > this.#used) this.#indices.fill(0, this.#used, this.#drawn);
    const changed = Math.max(this.#drawn, this.#used);
    this.#drawn = this.#used;
    this.mesh.visible = this.#used > 0;
    if (this.#used === 0) return;
    const { positions, indices } = this.#geometry;
    if (positions === this.#positions) {
      this.#geometry.getBuffer('aPosition').update(8 * this.#vertices);
      this.#geometry.getBuffer('aUV').update(8 * this.#vertices);
    } else {
      this.#geometry.positions = this.#positions;
      this.#geometry.uvs = this.#uvs;
    }
    if (indices === this.#indices) this.#geometry.indexBuffer.update(4 * changed);
    else this.#geometry.indices = this.#indices;
  }

  /** Frees the mesh and its buffers; the texture is not its own. */
  destroy(): void {
    this.mesh.destroy();
    this.#geometry.destroy(true);
  }

  #growVertices(): void {
    const positions = new Float32Array(2 * this.#positions.length);
    const uvs = new Float32Array(2 * this.#positions.length);
    positions.set(this.#positions);
    uvs.set(this.#uvs);
    this.#positions = positions;
    this.#uvs = uvs;
  }

  #growIndices(): void {
    const indices = new Uint32Array(2 * this.#indices.length);
    indices.set(this.#indices);
    this.#indices = indices;
  }
}
