import type { Scene } from '../src/scenes/scene.ts';

/** A part of the list: scenes that belong together, in the order of the thesis. */
export interface Chapter {
  /** Where it is on the page, as in `#springs`. */
  readonly id: string;
  readonly title: string;
  /** What it is about, in a few words. */
  readonly about: string;
  readonly scenes: readonly Scene[];
}

/** The scene at the top of the list, which can be played with at once, and the part of it that is shown there. Unit: m. */
export const hero = {
  id: 'buoyancy-waves',
  invitation: 'Drag a float and let it go.',
  // So flat that the width decides: the row of floats leaves the picture on both sides.
  wide: { minX: 0.5, maxX: 23.5, minY: -0.9, maxY: -0.8 },
  narrow: { minX: 6.5, maxX: 17.5, minY: -0.9, maxY: -0.8 },
} as const;

/** Scenes to begin with, below it. */
export const featuredIds: readonly string[] = ['game', 'billiards', 'rods-and-cables', 'cables-hanging'];

/** Each chapter begins with a scene and lasts until the next one begins. */
const beginnings = [
  { begins: 'projectiles', title: 'Particles', about: 'Points with a mass that fly, burst and fade' },
  { begins: 'force-generators', title: 'Forces', about: 'Drag and springs, each beside its closed form' },
  { begins: 'buoyancy-explained', title: 'Water', about: 'What floats, how deep, and why' },
  { begins: 'contact-normal', title: 'Contacts', about: 'The wrong answer beside the right one' },
  { begins: 'restitution', title: 'Collisions', about: 'How high, how fast, and which way afterwards' },
  { begins: 'cables-hanging', title: 'Cables and rods', about: 'Links that keep a length, in machines and bridges' },
  { begins: 'aggregates-squares', title: 'Bodies', about: 'Particles and rods that tumble as one, and a game of them' },
  { begins: 'newtons-cradle', title: 'Hit by hit', about: 'Where the order of impacts is all' },
  { begins: 'rope-bridge', title: 'Ropes and piles', about: 'What bears, tears, and comes to rest by the thousand' },
] as const;

/** Divides the scenes into chapters; an error says which scene is missing or out of order. */
export function chaptersOf(scenes: readonly Scene[]): Chapter[] {
  const starts = beginnings.map(({ begins }) => scenes.indexOf(sceneAt(scenes, begins)));
  return beginnings.map(({ begins, title, about }, n) => {
    const [from, to = scenes.length] = [starts[n], starts[n + 1]];
    if (to <= from || starts[0] !== 0) {
      throw new Error(
        `chaptersOf: "${begins}", where "${title}" begins, must come after the chapter before; it does not.`,
      );
    }
    return { id: title.toLowerCase().replaceAll(' ', '-'), title, about, scenes: scenes.slice(from, to) };
  });
}

/** The scene of an id; an error says that there is none. */
export function sceneAt(scenes: readonly Scene[], id: string): Scene {
  const scene = scenes.find((each) => each.id === id);
  if (!scene) throw new Error(`sceneAt: the list must have the scene "${id}"; there is none.`);
  return scene;
}
