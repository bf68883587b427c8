import {
  type Camera,
  type DrawList,
  type Palette,
  type TrailPaint,
  type Trails,
  trailLevels,
  type ViewedWorld,
} from '@mass/core/view';
import type { Atlas } from './atlas.ts';
import type { QuadBatch } from './quad-batch.ts';

/** What is shorter is not drawn. Unit: CSS px. */
const shortest = 0.01;
/** How far segments overlap where the trail is straight, against seams of rounding. Unit: CSS px. */
const seam = 0.01;

/** Adds the trails, a stretched piece of line a segment, the oldest first. */
export function drawTrails(
  batch: QuadBatch,
  atlas: Atlas,
  world: ViewedWorld,
  list: DrawList,
  trails: Trails,
  palette: Palette,
  camera: Camera,
  pixelRatio: number,
): void {
  for (let c = 0; c < palette.trails.length; c++) {
    const paint = palette.trails[c];
    if (paint === null) continue;
    for (let level = trailLevels - 1; level >= 0; level--) {
      addLevel(batch, atlas, world, list, trails, paint, c, level, camera, pixelRatio);
    }
  }
}

function addLevel(
  batch: QuadBatch,
  atlas: Atlas,
  { particles: { count, alive } }: ViewedWorld,
  list: DrawList,
  { x, y, length, capacity, head, ranges }: Trails,
  paint: TrailPaint,
  c: number,
  level: number,
  camera: Camera,
  pixelRatio: number,
): void {
  const first = ranges[c * (trailLevels + 1) + level];
  const end = ranges[c * (trailLevels + 1) + level + 1];
  if (first === end) return;
  const { texture, size } = atlas.line(paint.width[level] * pixelRatio);
  const scaleY = paint.width[level] / size;
  const scale = camera.pixelsPerMetre;
  const left = camera.toScreenX(0);
  const top = camera.toScreenY(0);
  const half = paint.width[level] / 2;
  for (let i = 0; i < count; i++) {
    const last = Math.min(end, length[i]);
    if (alive[i] === 0 || list.classes[i] !== c || first >= last) continue;
    const row = i * capacity;
    const start = Math.max(0, first - 1); // one more, for the turn into the first
    const before = row + ((head - start + 1 + capacity) % capacity);
    let x0 = start === 0 ? list.x[i] : left + x[before] * scale;
    let y0 = start === 0 ? list.y[i] : top - y[before] * scale;
    let ux = 0; // direction of the segment before
    let uy = 0;
    for (let k = start; k < last; k++) {
      const at = row + ((head - k + capacity) % capacity);
      const x1 = left + x[at] * scale;
      const y1 = top - y[at] * scale;
      const dx = x1 - x0;
      const dy = y1 - y0;
      const span = Math.sqrt(dx * dx + dy * dy);
      if (span > shortest) {
        const nx = dx / span;
        const ny = dy / span;
        if (k >= first) {
          // Begins as much earlier as fills the wedge of the turn.
          const more = Math.min(half, seam + half * Math.abs(ux * ny - uy * nx));
          const mx = (x0 + x1 - nx * more) / 2;
          const my = (y0 + y1 - ny * more) / 2;
          batch.add(texture, mx, my, span + more, scaleY, Math.atan2(dy, dx), paint.rgb, paint.alpha[level]);
        }
        ux = nx;
        uy = ny;
      }
      x0 = x1;
      y0 = y1;
    }
  }
}
