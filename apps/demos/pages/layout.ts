import { DEFAULT_SEED, defaultValues } from '../src/scenes/run.ts';
import type { Scene } from '../src/scenes/scene.ts';
import { Html, html } from './html.ts';

/** The addresses of what a page loads, seen from the page. */
export interface Assets {
  readonly toRoot: string;
  readonly script: string;
  readonly preload: readonly string[];
  /** What is loaded besides where the address asks for PixiJS. */
  readonly pixiPreload: readonly string[];
  readonly style: string;
  readonly formulaStyle: string;
}

/** What one page has of its own. */
export interface Page {
  readonly title: string;
  readonly description: string;
  readonly kind: 'list' | 'scene' | 'benchmarks';
  readonly head?: Html;
  readonly navigation?: Html;
  readonly main: Html;
}

// Runs before anything is painted: a page that is dark does not flash white.
const theme = `try{const t=localStorage.getItem('theme');if(t==='light'||t==='dark')document.documentElement.dataset.theme=t}catch{}`;

// A disc falling along its arc: the engine's whole matter in 32 pixels.
const icon = `data:image/svg+xml,${encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32"><path d="M3 27C8 6 19 3 25 19" fill="none" stroke="#d9480f" stroke-width="2.5" stroke-dasharray="1 5" stroke-linecap="round"/><circle cx="25" cy="22" r="6" fill="#d9480f"/></svg>')}`;

/** A whole page: the head, the bar at the top, what is its own. */
export function layout(page: Page, assets: Assets): string {
  return html`<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${page.title}</title>
<meta name="description" content="${page.description}">
<meta name="color-scheme" content="light dark">
<meta property="og:title" content="${page.title}">
<meta property="og:description" content="${page.description}">
<link rel="icon" href="${icon}">
${assets.preload.map((address) => html`<link rel="modulepreload" href="${address}">\n`)}<link rel="stylesheet" href="${assets.style}">
${page.head}
<script>${new Html(theme)}</script>
<script type="module" src="${assets.script}"></script>
</head>
<body class="${page.kind}-page">
<header class="bar">
<a class="home" href="${assets.toRoot}./" aria-label="Mass: all scenes"><span class="dot" aria-hidden="true"></span>Mass</a>
${page.navigation}
<button class="theme" type="button" id="theme" aria-label="Switch between light and dark" title="Light or dark"><svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><circle cx="10" cy="10" r="7.25" fill="none" stroke="currentColor" stroke-width="1.5"/><path d="M10 2.75a7.25 7.25 0 0 1 0 14.5z" fill="currentColor"/></svg></button>
</header>
<main>
${page.main}
</main>
</body>
</html>
`.text;
}

/** Width to height of what a scene shows, all of its worlds side by side, as CSS has it. */
export function shapeOf(scene: Scene): string {
  const { minX, maxX, minY, maxY } = scene.show;
  const { beside = [] } = scene.build(defaultValues(scene), DEFAULT_SEED);
  return `${(1 + beside.length) * (maxX - minX)} / ${maxY - minY}`;
}
