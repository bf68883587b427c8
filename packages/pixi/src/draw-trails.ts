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
  for (let i = 0; i < count; i++) {
    const last = Math.min(end, length[i]);
    if (alive[i] === 0 || list.classes[i] !== c || first >= last) continue;
    const row = i * capacity;
    const before = row + ((head - first + 1 + capacity) % capacity);
    let x0 = first === 0 ? list.x[i] : left + x[before] * scale;
    let y0 = first === 0 ? list.y[i] : top - y[before] * scale;
    for (let k = first; k < last; k++) {
      const at = row + ((head - k + capacity) % capacity);
      const x1 = left + x[at] * scale;
      const y1 = top - y[at] * scale;
      const dx = x1 - x0;
      const dy = y1 - y0;
      const span = Math.sqrt(dx * dx + dy * dy);
      if (span > 0) {
        batch.add(
          texture,
          (x0 + x1) / 2,
          (y0 + y1) / 2,
          span,
          scaleY,
          Math.atan2(dy, dx),
          paint.rgb,
          paint.alpha[level],
        );
      }
      x0 = x1;
      y0 = y1;
    }
  }
}
