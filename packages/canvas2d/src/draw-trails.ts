import { type Camera, type DrawList, type Palette, type Trails, trailLevels, type ViewedWorld } from '@mass/core/view';
import type { CanvasContext } from './canvas-context.ts';

/** Segments in one path, about: more of them take the browser's rasteriser longer than as many in two. */
const pathLength = 512;

/** Draws the trails, a few paths a class and level of fading, the oldest first. */
export function drawTrails(
  context: CanvasContext,
  world: ViewedWorld,
  list: DrawList,
  trails: Trails,
  palette: Palette,
  camera: Camera,
): void {
  context.lineCap = 'butt';
  context.lineJoin = 'round';
  for (let c = 0; c < palette.trails.length; c++) {
    const paint = palette.trails[c];
    if (paint === null) continue;
    context.strokeStyle = paint.color;
    for (let level = trailLevels - 1; level >= 0; level--) {
      const at = c * (trailLevels + 1) + level;
      const first = trails.ranges[at];
      const end = trails.ranges[at + 1];
      if (first === end) continue;
      context.globalAlpha = paint.alpha[level];
      context.lineWidth = paint.width[level];
      strokeLevel(context, world, list, trails, c, first, end, camera);
    }
  }
}

function strokeLevel(
  context: CanvasContext,
  { particles: { count, alive } }: ViewedWorld,
  list: DrawList,
  { x, y, length, capacity, head }: Trails,
  c: number,
  first: number,
  end: number,
  camera: Camera,
): void {
  const scale = camera.pixelsPerMetre;
  const left = camera.toScreenX(0);
  const top = camera.toScreenY(0);
  context.beginPath();
  let segments = 0;
  for (let i = 0; i < count; i++) {
    const last = Math.min(end, length[i]);
    if (alive[i] === 0 || list.classes[i] !== c || first >= last) continue;
    if (segments >= pathLength) {
      context.stroke();
      context.beginPath();
      segments = 0;
    }
    segments += last - first;
    const row = i * capacity;
    if (first === 0) context.moveTo(list.x[i], list.y[i]);
    else {
      const at = row + ((head - first + 1 + capacity) % capacity);
      context.moveTo(left + x[at] * scale, top - y[at] * scale);
    }
    for (let k = first; k < last; k++) {
      const at = row + ((head - k + capacity) % capacity);
      context.lineTo(left + x[at] * scale, top - y[at] * scale);
    }
  }
  context.stroke();
}
