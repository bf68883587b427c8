import { type Particle, PointerSpring, type PointerSpringOptions, type World } from '@mass/core';
import { pickParticle } from '@mass/core/view';
import type { Guide, Point } from '../scenes/scene.ts';
import type { Pane } from './pane.ts';
import type { Stage } from './stage.ts';

/** How near a pointer must come to what it takes hold of. Unit: CSS px. */
const REACH = { mouse: 8, touch: 22 };

/** How far a pointer may stray and still be a tap. Unit: CSS px. */
const TAP = 6;

/** What one pointer is doing. */
type Gesture =
  | { readonly kind: 'grab'; readonly from: Point; readonly hold: Hold }
  | { readonly kind: 'scene' }
  | { readonly kind: 'pan' }
  | { readonly kind: 'tap'; readonly from: Point };

/** A particle in the hand, and how far from its centre the pointer took it: it is dragged by that place, without a jerk. */
interface Hold {
  readonly pane: Pane;
  readonly world: World;
  readonly spring: PointerSpring;
  readonly offset: Point;
}

/**
 * The reader's hand on a stage: takes hold of particles, taps, pans, zooms, by mouse, pen and touch. It leaves the page its
 * scroll: a finger is taken only where it hits something, a wheel only with Ctrl or ⌘.
 */
export class Hand {
  readonly #stage: Stage;
  readonly #gestures = new Map<number, Gesture>();
  readonly #touches = new Map<number, { x: number; y: number }>();

  readonly #movesCamera: boolean;

  /** `camera: false` for a stage whose view stays as it is. */
  constructor(stage: Stage, { camera = true }: { readonly camera?: boolean } = {}) {
    this.#stage = stage;
    this.#movesCamera = camera;
    stage.extraGuides = (pane) => this.#guides(pane);
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
    if (event.pointerType === 'mouse' && (event.button !== 0 || event.shiftKey)) {
      return this.#movesCamera ? { kind: 'pan' } : undefined;
    }
    const particle = this.#pick(pane, event, at);
    const from = screenPoint(pane, event);
    if (particle) return { kind: 'grab', from, hold: take(pane, particle, at, this.#stage.setup.hand) };
    let taken = false;
    this.#stage.attempt(() => {
      taken = this.#stage.setup.pointer?.down(at) ?? false;
    });
    if (taken) return { kind: 'scene' };
    return { kind: 'tap', from };
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
        gesture.hold.spring.moveTo(at.x + gesture.hold.offset.x, at.y + gesture.hold.offset.y);
        break;
      case 'scene':
        this.#stage.attempt(() => this.#stage.setup.pointer?.move?.(at));
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
    this.#end(pane, event.pointerId, gesture);
    // What is taken and let go where it was, was tapped.
    if ('from' in gesture && meant && distance(screenPoint(pane, event), gesture.from) <= TAP) {
      this.#stage.attempt(() => this.#stage.setup.tap?.(worldPoint(pane, event)));
    } else if (gesture.kind === 'scene') {
      this.#stage.attempt(() => this.#stage.setup.pointer?.up?.(worldPoint(pane, event)));
    }
  }

  #end(pane: Pane, pointer: number, gesture: Gesture): void {
    this.#gestures.delete(pointer);
    pane.element.classList.remove('grabbing');
    if (gesture.kind === 'grab') letGo(gesture.hold);
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
    if ((this.#movesCamera && event.touches.length > 1) || hit || taken) event.preventDefault();
  }

  /** Two fingers: the camera follows them, as if they touched the world itself. */
  #pinch(pane: Pane, pointer: number, before: Point, now: Point): void {
    const other = [...this.#touches].find(([id]) => id !== pointer)?.[1];
    if (!other || !this.#movesCamera) return;
    const factor = distance(now, other) / Math.max(1, distance(before, other));
    this.#stage.moveCameras((camera) => {
      camera.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
      camera.zoomAt((now.x + other.x) / 2, (now.y + other.y) / 2, Math.max(0.5, Math.min(2, factor)));
    });
    pane.element.classList.remove('grabbing');
  }

  #wheel(pane: Pane, event: WheelEvent): void {
    if (!this.#movesCamera || (!event.ctrlKey && !event.metaKey)) return;
    event.preventDefault();
    const { x, y } = screenPoint(pane, event);
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    this.#stage.moveCameras((camera) => camera.zoomAt(x, y, Math.exp(-Math.max(-200, Math.min(200, pixels)) / 300)));
  }

  #pick(pane: Pane, { pointerType }: { pointerType: string }, at: Point): Particle | undefined {
    const reach = pointerType === 'mouse' ? REACH.mouse : REACH.touch;
    const particle = pickParticle(pane.world, at.x, at.y, reach / pane.camera.pixelsPerMetre);
    if (!particle || particle.mass === Infinity) return undefined;
    return this.#stage.setup.takes?.(particle) === false ? undefined : particle;
  }

  /** A line from where each held particle was taken to the pointer. */
  #guides(pane: Pane): readonly Guide[] {
    const guides: Guide[] = [];
    for (const gesture of this.#gestures.values()) {
      // A reset takes the world away, and a scene may take the particle.
      if (gesture.kind !== 'grab' || gesture.hold.pane !== pane || gesture.hold.world !== pane.world) continue;
      const { spring, offset } = gesture.hold;
      if (!spring.held) continue;
      const { x, y } = spring.held;
      const points = [x - offset.x, y - offset.y, spring.x - offset.x, spring.y - offset.y];
      guides.push({ kind: 'curve', points, tone: 'accent' });
    }
    return guides;
  }
}

function take(pane: Pane, particle: Particle, at: Point, options?: PointerSpringOptions): Hold {
  const { world } = pane;
  const spring = world.addForce(new PointerSpring(options));
  spring.grab(particle);
  return { pane, world, spring, offset: { x: particle.x - at.x, y: particle.y - at.y } };
}

function letGo({ world, spring }: Hold): void {
  // A scene that clears its world has taken the spring out, too.
  if (world.forces.includes(spring)) world.removeForce(spring);
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
