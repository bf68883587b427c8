import type { Camera, Style } from '@mass/core/view';
import type { Palette } from '../scenes/palette.ts';
import type { Guide, Tone } from '../scenes/scene.ts';

/** Width of the lines, rounded to whole device px. Unit: CSS px. */
const LINE = 1.25;

/** What the overlay draws with. */
export interface Ink {
  readonly palette: Palette;
  readonly style: Style;
  /** Size of the words; 0 leaves them out. Unit: CSS px. */
  readonly textSize: number;
}

/** Draws guides over the picture of any renderer: thin lines and words that stay crisp at any zoom. */
export class Overlay {
  readonly #context: CanvasRenderingContext2D;
  #ratio = 1;

  constructor(canvas: HTMLCanvasElement) {
    const context = canvas.getContext('2d');
    if (!context) throw new Error('Overlay: the browser must offer a 2D context; it gave none.');
    this.#context = context;
  }

  /** A new size in CSS px, and the device pixels in each. */
  resize(width: number, height: number, ratio: number): void {
    const { canvas } = this.#context;
    this.#ratio = ratio;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }

  /** Draws what is given, and nothing else. */
  draw(guides: readonly Guide[], camera: Camera, ink: Ink): void {
    const context = this.#context;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, context.canvas.width, context.canvas.height);
    context.scale(this.#ratio, this.#ratio);
    const line = Math.max(1, Math.round(LINE * this.#ratio)) / this.#ratio;
    context.lineCap = 'round';
    context.lineJoin = 'round';
    context.font = `500 ${ink.textSize}px system-ui, sans-serif`;
    context.textBaseline = 'middle';
    for (const guide of guides) {
      const color = colorOf(guide.tone ?? 'quiet', ink);
      context.globalAlpha = guide.opacity ?? 1;
      context.lineWidth = 'bold' in guide && guide.bold ? line + 1.25 : line;
      context.strokeStyle = color;
      context.fillStyle = color;
      drawGuide(context, guide, camera, ink);
    }
    context.globalAlpha = 1;
  }
}

function drawGuide(context: CanvasRenderingContext2D, guide: Guide, camera: Camera, ink: Ink): void {
  switch (guide.kind) {
    case 'curve':
      if (guide.dashed) {
        context.setLineDash([0.1, 5]);
        context.lineWidth *= 1.7;
      }
      if (guide.points.length === 4 && guide.points[1] === guide.points[3]) drawLevel(context, guide.points, camera);
      else drawCurve(context, guide.points, camera);
      context.setLineDash([]);
      return;
    case 'circle':
      context.beginPath();
      context.arc(
        camera.toScreenX(guide.x),
        camera.toScreenY(guide.y),
        Math.max(1, guide.radius * camera.pixelsPerMetre),
        0,
        2 * Math.PI,
      );
      if (guide.filled) context.fill();
      else context.stroke();
      return;
    case 'arrow':
      drawArrow(
        context,
        camera.toScreenX(guide.from.x),
        camera.toScreenY(guide.from.y),
        camera.toScreenX(guide.to.x),
        camera.toScreenY(guide.to.y),
      );
      return;
    case 'label':
      if (ink.textSize > 0) drawLabel(context, guide, camera, ink);
  }
}

function drawCurve(context: CanvasRenderingContext2D, points: ArrayLike<number>, camera: Camera): void {
  context.beginPath();
  for (let n = 0; n + 1 < points.length; n += 2) {
    context.lineTo(camera.toScreenX(points[n]), camera.toScreenY(points[n + 1]));
  }
  context.stroke();
}

/** A level line, on whole device px: it is crisp. */
function drawLevel(context: CanvasRenderingContext2D, points: ArrayLike<number>, camera: Camera): void {
  const ratio = context.getTransform().d;
  const edge = (context.lineWidth * ratio) / 2;
  const screenY = (Math.round(camera.toScreenY(points[1]) * ratio - edge) + edge) / ratio;
  context.beginPath();
  context.moveTo(camera.toScreenX(points[0]), screenY);
  context.lineTo(camera.toScreenX(points[2]), screenY);
  context.stroke();
}

/** An arrow in CSS px, whose head shrinks with it so that a short one still points. */
function drawArrow(context: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 0.5) return;
  const head = Math.min(6 + 2.5 * context.lineWidth, length * 0.6);
  const ux = (x1 - x0) / length;
  const uy = (y1 - y0) / length;
  const neckX = x1 - ux * head;
  const neckY = y1 - uy * head;
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(neckX, neckY);
  context.stroke();
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(neckX - uy * head * 0.45, neckY + ux * head * 0.45);
  context.lineTo(neckX + uy * head * 0.45, neckY - ux * head * 0.45);
  context.fill();
}

/** Words, with a rim of the paper's colour so that they can be read over anything. */
function drawLabel(
  context: CanvasRenderingContext2D,
  { x, y, text, align }: Extract<Guide, { kind: 'label' }>,
  camera: Camera,
  { palette, style }: Ink,
): void {
  context.textAlign = align ?? 'center';
  const screenX = camera.toScreenX(x);
  const screenY = camera.toScreenY(y);
  const color = context.fillStyle;
  context.strokeStyle = style.background ?? palette.paper;
  context.lineWidth = 4;
  context.strokeText(text, screenX, screenY);
  context.fillStyle = color;
  context.fillText(text, screenX, screenY);
}

function colorOf(tone: Tone, { palette, style }: Ink): string {
  if (tone === 'quiet') return palette.quiet;
  if (tone === 'ink') return palette.ink;
  if (tone === 'accent') return palette.accent;
  return style.groups?.[tone]?.fill ?? style.particle?.fill ?? palette.ink;
}
