import type { Scene } from '../src/scenes/scene.ts';
import { type Chapter, chaptersOf, featuredIds, hero, sceneAt } from './chapters.ts';
import { type Html, html } from './html.ts';
import { type Assets, layout, shapeOf } from './layout.ts';

/** The list of all scenes: one to play with at once, a few to begin with, then all of them by chapter, each of them running. */
export function listPage(scenes: readonly Scene[], assets: Assets): string {
  const description =
    'A small, exact, typed 2D physics engine for TypeScript games. Every scene runs in the page: change it, take it apart, read its code.';
  const chapters = chaptersOf(scenes);
  const first = sceneAt(scenes, hero.id);
  return layout(
    {
      title: 'Mass: physics of particles and links',
      description,
      kind: 'list',
      navigation: html`<a class="text-link" href="benchmarks/">Benchmarks</a>`,
      main: html`<section class="hero">
<div class="words">
<h1>Everything is particles and links.</h1>
<p>Mass is a small, exact, typed 2D physics engine for TypeScript games. This is the engine at work: take hold of something, change its numbers, read its code.</p>
</div>
<div class="stage" id="hero" data-scene="${first.id}" data-wide="${JSON.stringify(hero.wide)}" data-narrow="${JSON.stringify(hero.narrow)}" role="group" aria-label="${first.title}, running"></div>
<p class="caption"><span>${hero.invitation}</span> <a href="scenes/${first.id}/">${first.title} <span aria-hidden="true">→</span></a></p>
</section>
<section aria-labelledby="begin">
<h2 class="chapter" id="begin">Begin with these</h2>
<ul class="cards featured">
${featuredIds.map((id) => card(sceneAt(scenes, id), 'short'))}</ul>
</section>
<nav class="contents" aria-label="Chapters">${chapters.map(({ id, title, scenes: { length } }) => html`<a href="#${id}">${title} <span>${length}</span></a>`)}</nav>
${chapters.map(chapterOf)}`,
    },
    assets,
  );
}

function chapterOf({ id, title, about, scenes }: Chapter): Html {
  return html`<section aria-labelledby="${id}">
<h2 class="chapter" id="${id}">${title} <small>${about}</small></h2>
<ul class="cards">
${scenes.map((scene) => card(scene, 'whole'))}</ul>
</section>
`;
}

function card(scene: Scene, words: 'short' | 'whole'): Html {
  return html`<li class="card"><a href="scenes/${scene.id}/">
<div class="thumbnail" data-scene="${scene.id}" style="--shape: ${shapeOf(scene)}"></div>
<div class="words"><p class="figure">${scene.figure}</p><h3>${scene.title}</h3>${words === 'whole' && html`<p class="look">${scene.lookFor}</p>`}</div>
</a></li>
`;
}
