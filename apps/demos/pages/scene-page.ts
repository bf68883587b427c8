import { readFile } from 'node:fs/promises';
import katex from 'katex';
import { codeToHtml } from 'shiki';
import { DEFAULT_SEED, defaultValues } from '../src/scenes/run.ts';
import type { Scene } from '../src/scenes/scene.ts';
import { Html, html } from './html.ts';
import { type Assets, layout, shapeOf } from './layout.ts';

/** The scenes before and after, in the order of the thesis. */
export interface Neighbours {
  readonly previous?: Scene;
  readonly next?: Scene;
}

/** The page of one scene: the scene, its controls, what it shows, its formula, its code. */
export async function scenePage(scene: Scene, neighbours: Neighbours, assets: Assets): Promise<string> {
  return layout(
    {
      title: `${scene.title} · Mass`,
      description: scene.lookFor,
      kind: 'scene',
      head: html`<link rel="stylesheet" href="${assets.formulaStyle}" media="print" onload="this.media='all'">
<script>${new Html(preloadPixi(assets))}</script>`,
      navigation: navigation(neighbours),
      main: html`<article data-scene="${scene.id}">
<header class="opening">
<p class="figure">${scene.figure}</p>
<h1>${scene.title}</h1>
<p class="look">${scene.lookFor}</p>
</header>
<section class="stage" id="stage" aria-label="${scene.title}, running" style="--shape: ${shapeOf(scene)}"><button type="button" id="fit" class="fit" title="All of the scene (0)" hidden>Fit the view</button><noscript>This scene is a program: it needs JavaScript.</noscript></section>
${transport(scene)}
<div class="desk">
<section class="controls" id="controls" aria-label="Controls">
${Object.entries(scene.parameters).map(
  ([
    name,
    parameter,
  ]) => html`<div class="slider" data-parameter="${name}"><span class="slider-label">${parameter.label}</span></div>
`,
)}${options()}
</section>
<section class="explanation">
<p>${scene.summary}</p>
<div class="formula" tabindex="0" role="group" aria-label="Formula">${formula(scene)}</div>
</section>
</div>
<section class="code">
<h2>The whole scene</h2>
${await code(scene)}
</section>
</article>
${onwards(neighbours)}`,
    },
    assets,
  );
}

/** Where the address asks for PixiJS, it is loaded beside the page's own script, not after it. */
function preloadPixi({ pixiPreload }: Assets): string {
  const links = `Object.assign(document.createElement('link'),{rel:'modulepreload',href:a})`;
  return `if(/[?&]renderer=pixi\\b/.test(location.search))for(const a of ${JSON.stringify(pixiPreload)})document.head.append(${links})`;
}

function navigation({ previous, next }: Neighbours): Html {
  const link = (scene: Scene | undefined, name: string, arrow: string): Html =>
    scene
      ? html`<a href="../${scene.id}/" rel="${name}" title="${scene.title}"><span class="visually-hidden">${name === 'prev' ? 'Previous' : 'Next'} scene: ${scene.title}</span><span aria-hidden="true">${arrow}</span></a>`
      : html`<span class="none" aria-hidden="true">${arrow}</span>`;
  return html`<nav aria-label="Scenes">${link(previous, 'prev', '←')}${link(next, 'next', '→')}</nav>`;
}

/** What is written on a key that prints nothing. */
const keyNames: { readonly [key: string]: string } = {
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Enter: '↵',
};

/** What is always at hand under the scene: playback, and a button for each of the scene's own actions. */
function transport(scene: Scene): Html {
  const { actions = [] } = scene.build(defaultValues(scene), DEFAULT_SEED);
  return html`<div class="transport" id="transport" role="toolbar" aria-label="Playback">
<button type="button" id="play" aria-keyshortcuts="Space"><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="icon-pause" d="M3 2h4v12H3zM9 2h4v12H9z"/><path class="icon-play" d="M3.5 1.5v13L14 8z"/></svg><span class="text">Pause</span></button>
<button type="button" id="step" aria-keyshortcuts="." title="One step (.)"><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M2.5 1.5v13L10 8zM11 2h3v12h-3z"/></svg><span class="text">Step</span></button>
<button type="button" id="reset" aria-keyshortcuts="r" title="From the start (r)"><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M8 2a6 6 0 1 1-5.7 4.1l1.7.6A4.2 4.2 0 1 0 8 3.8V6L4 3l4-3z"/></svg><span class="text">Reset</span></button>
<span class="actions">${actions.map(
    ({ key, label, group }) =>
      html`<button type="button" data-key="${key}" aria-keyshortcuts="${key}"${group === undefined ? '' : html` data-group="${group}"`}><kbd aria-hidden="true">${keyNames[key] ?? key}</kbd>${label}</button>`,
  )}</span>
<output class="statistics" id="statistics" aria-live="off"></output>
</div>
<p class="fault" id="fault" role="alert" hidden></p>`;
}

function options(): Html {
  return html`<div class="choice" data-choice="speed"><span class="choice-label">Speed</span></div>
<div class="choice" data-choice="renderer"><span class="choice-label">Renderer</span></div>
<label class="seed">Seed<input type="number" id="seed" min="0" max="4294967295" step="1" inputmode="numeric"></label>
`;
}

function formula(scene: Scene): Html {
  return new Html(katex.renderToString(scene.formula, { displayMode: true, strict: 'error' }));
}

async function code(scene: Scene): Promise<Html> {
  const source = await readFile(new URL(`../src/scenes/${scene.id}.ts`, import.meta.url), 'utf8');
  const highlighted = await codeToHtml(source.trimEnd(), {
    lang: 'typescript',
    themes: { light: 'github-light', dark: 'github-dark' },
    defaultColor: 'light-dark()',
    // The ground is the page's.
    transformers: [{ pre: (node) => void delete node.properties['style'] }],
  });
  return new Html(highlighted);
}

function onwards({ next }: Neighbours): Html {
  return next
    ? html`<footer class="onwards"><a href="../${next.id}/"><span>Next</span><strong>${next.title}</strong></a></footer>`
    : html`<footer class="onwards"><a href="../../"><span>That was the last one</span><strong>All scenes</strong></a></footer>`;
}
