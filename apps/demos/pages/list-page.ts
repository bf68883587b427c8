import type { Scene } from '../src/scenes/scene.ts';
import { type Html, html } from './html.ts';
import { type Assets, layout, shapeOf } from './layout.ts';

/** The list of all scenes, each of them running. */
export function listPage(scenes: readonly Scene[], assets: Assets): string {
  const description =
    'A small, exact, typed 2D physics engine for TypeScript games. Every scene runs in the page: change it, take it apart, read its code.';
  return layout(
    {
      title: 'Mass: physics of particles and links',
      description,
      kind: 'list',
      main: html`<section class="hero">
<h1>Everything is particles and links.</h1>
<p>Mass is a small, exact, typed 2D physics engine for TypeScript games. Each scene below is the engine at work: open it, change its numbers, read its code.</p>
</section>
<ul class="cards">
${scenes.map(card)}</ul>`,
    },
    assets,
  );
}

function card(scene: Scene): Html {
  return html`<li class="card"><a href="scenes/${scene.id}/">
<div class="thumbnail" data-scene="${scene.id}" style="--shape: ${shapeOf(scene)}"></div>
<div class="words"><p class="figure">${scene.figure}</p><h2>${scene.title}</h2><p class="look">${scene.lookFor}</p></div>
</a></li>
`;
}
