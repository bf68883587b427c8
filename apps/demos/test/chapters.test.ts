import { expect, it } from 'vitest';
import { chaptersOf, featuredIds, hero, sceneAt } from '../pages/chapters.ts';
import { scenes } from '../src/scenes/index.ts';

it('every scene is in one chapter, in the order of the scenes', () => {
  expect(chaptersOf(scenes).flatMap((chapter) => chapter.scenes)).toEqual(scenes);
});

it('a chapter whose first scene is gone or out of order is an error that names it', () => {
  expect(() => chaptersOf(scenes.filter(({ id }) => id !== 'restitution'))).toThrow('"restitution"');
  expect(() => chaptersOf(scenes.toReversed())).toThrow('must come after');
});

it('the scenes at the top of the list exist', () => {
  for (const id of [hero.id, ...featuredIds]) expect(sceneAt(scenes, id).id).toBe(id);
});
