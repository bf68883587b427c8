import type { Particle } from '@mass/core';
import { pickParticle } from '@mass/core/view';
import type { Guide, Point } from '../scenes/scene.ts';
import { Grab } from './grab.ts';
import type { Pane } from './pane.ts';
import type { Stage } from './stage.ts';

/** How near a pointer must come to what it takes hold of. Unit: CSS px. */
const REACH = { mouse: 8, touch: 22 };

/** How far a pointer may stray and still be a tap. Unit: CSS px. */
const TAP = 6;

/** What one pointer is doing. */
type Gesture =
  | { readonly kind: 'grab'; readonly particle: Particle; readonly grab: Grab; readonly pane: Pane }
  | { readonly kind: 'scene' }
  | { readonly kind: 'pan' }
  | { readonly kind: 'tap'; readonly x: number; readonly y: number };

/**
 * The reader's hand on a stage: takes hold of particles, taps, pans, zooms, by mouse, pen and touch. It leaves the page its
 * scroll: a finger is taken only where it hits something, a wheel only with Ctrl or ⌘.
 */
export class Hand {
  readonly #stage: Stage;
  readonly #gestures = new Map<number, Gesture>();
  readonly #touches = new Map<number, { x: number; y: number }>();

  constructor(stage: Stage) {
    this.#stage = stage;
    stage.extraGuides = () => this.#guides();
    for (const pane of stage.panes) this.#listen(pane);
  }

  #listen(pane: Pane): void {
    const { element } = pane;
    element.addEventListener('pointerdown', (event) => this.#down(pane, event));
    element.addEventListener('pointermove', (event) => this.#move(pane, event));
    element.addEventListener('pointerup', (event) => this.#up(pane, event, true));
    element.addEventListener('pointercancel', (event) => this.#up(pane, event, false));
    element.addEventListener('wheel', (event) => this.#wheel(pane, event), { passive: false });
    // The browser scrolls by a finger unless its first touch is refused: it is, where it hits something or is one of two.
    element.addEventListener('touchstart', (event) => this.#touch(pane, event), { passive: false });
    element.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  #down(pane: Pane, event: PointerEvent): void {
    const at = worldPoint(pane, event);
    if (event.pointerType === 'touch') this.#touches.set(event.pointerId, screenPoint(pane, event));
    if (this.#touches.size === 2) this.#endGestures(pane);
    const gesture = this.#begin(pane, event, at);
    if (!gesture) return;
    this.#gestures.set(event.pointerId, gesture);
    if (gesture.kind !== 'tap') {
      pane.element.setPointerCapture(event.pointerId);
      pane.element.classList.toggle('grabbing', true);
      this.#stage.invalidate();
    }
  }

  #begin(pane: Pane, event: PointerEvent, at: Point): Gesture | undefined {
    if (this.#touches.size > 1) return undefined;
    if (event.pointerType === 'mouse' && (event.button !== 0 || event.shiftKey)) return { kind: 'pan' };
    const particle = this.#pick(pane, event, at);
    if (particle) {
      const grab = pane.world.addForce(new Grab(at.x, at.y), [particle]);
      return { kind: 'grab', particle, grab, pane };
    }
    if (this.#stage.setup.pointer?.down(at)) return { kind: 'scene' };
    return { kind: 'tap', ...screenPoint(pane, event) };
  }

  #move(pane: Pane, event: PointerEvent): void {
    const { x, y } = screenPoint(pane, event);
    const before = this.#touches.get(event.pointerId);
    if (before) {
      if (this.#touches.size === 2) this.#pinch(pane, event.pointerId, before, { x, y });
      this.#touches.set(event.pointerId, { x, y });
    }
    const gesture = this.#gestures.get(event.pointerId);
    const at = worldPoint(pane, event);
    switch (gesture?.kind) {
      case 'grab':
        gesture.grab.x = at.x;
        gesture.grab.y = at.y;
        break;
      case 'scene':
        this.#stage.setup.pointer?.move?.(at);
        break;
      case 'pan':
        this.#stage.moveCameras((camera) => camera.pan(event.movementX, event.movementY));
        break;
      case undefined:
        if (event.pointerType === 'mouse') {
          pane.element.classList.toggle('grabbable', this.#pick(pane, event, at) !== undefined);
        }
        return;
    }
    this.#stage.invalidate();
  }

  #up(pane: Pane, event: PointerEvent, meant: boolean): void {
    this.#touches.delete(event.pointerId);
    const gesture = this.#gestures.get(event.pointerId);
    if (!gesture) return;
    const { x, y } = screenPoint(pane, event);
    this.#end(pane, event.pointerId, gesture);
    if (gesture.kind === 'tap' && meant && Math.hypot(x - gesture.x, y - gesture.y) <= TAP) {
      this.#stage.attempt(() => this.#stage.setup.tap?.(worldPoint(pane, event)));
    } else if (gesture.kind === 'scene') {
      this.#stage.attempt(() => this.#stage.setup.pointer?.up?.(worldPoint(pane, event)));
    }
  }

  #end(pane: Pane, pointer: number, gesture: Gesture): void {
    this.#gestures.delete(pointer);
    pane.element.classList.remove('grabbing');
    // A reset may have taken the world away meanwhile.
    if (gesture.kind === 'grab' && gesture.particle.isIn(pane.world.particles)) pane.world.removeForce(gesture.grab);
    this.#stage.invalidate();
  }

  #endGestures(pane: Pane): void {
    for (const [pointer, gesture] of this.#gestures) this.#end(pane, pointer, gesture);
  }

  #touch(pane: Pane, event: TouchEvent): void {
    if (!event.cancelable) return;
    const at = worldPoint(pane, event.changedTouches[0]);
    const hit = this.#pick(pane, { pointerType: 'touch' }, at) !== undefined;
    const taken = [...this.#gestures.values()].some(({ kind }) => kind !== 'tap');
    if (event.touches.length > 1 || hit || taken) event.preventDefault();
  }

  /** Two fingers: the camera follows them, as if they touched the world itself. */
  #pinch(pane: Pane, pointer: number, before: Point, now: Point): void {
    const other = [...this.#touches].find(([id]) => id !== pointer)?.[1];
    if (!other) return;
    const factor = distance(now, other) / Math.max(1, distance(before, other));
    this.#stage.moveCameras((camera) => {
      camera.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
      camera.zoomAt((now.x + other.x) / 2, (now.y + other.y) / 2, Math.max(0.5, Math.min(2, factor)));
    });
    pane.element.classList.remove('grabbing');
  }

  #wheel(pane: Pane, event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const { x, y } = screenPoint(pane, event);
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    this.#stage.moveCameras((camera) => camera.zoomAt(x, y, Math.exp(-Math.max(-200, Math.min(200, pixels)) / 300)));
  }

  #pick(pane: Pane, { pointerType }: { pointerType: string }, at: Point): Particle | undefined {
    if (!this.#stage.scene.draggable) return undefined;
    const reach = pointerType === 'mouse' ? REACH.mouse : REACH.touch;
    return pickParticle(pane.world, at.x, at.y, reach / pane.camera.pixelsPerMetre);
  }

  #guides(): readonly Guide[] {
    const guides: Guide[] = [];
    for (const gesture of this.#gestures.values()) {
      if (gesture.kind !== 'grab' || !gesture.particle.isIn(gesture.pane.world.particles)) continue;
      const { particle, grab } = gesture;
      guides.push({ kind: 'curve', points: [particle.x, particle.y, grab.x, grab.y], tone: 'accent' });
    }
    return guides;
  }
}

function screenPoint({ element }: Pane, { clientX, clientY }: { clientX: number; clientY: number }): Point {
  const { left, top } = element.getBoundingClientRect();
  return { x: clientX - left, y: clientY - top };
}

function worldPoint(pane: Pane, event: { clientX: number; clientY: number }): Point {
  const { x, y } = screenPoint(pane, event);
  return { x: pane.camera.toWorldX(x), y: pane.camera.toWorldY(y) };
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
