/** The renderers that a reader can choose from. */
export const rendererKinds = ['canvas2d', 'pixi'] as const;

/** The name of a renderer, as in the address. */
export type RendererKind = (typeof rendererKinds)[number];

/** What they are called on the page. */
export const rendererNames: { readonly [kind in RendererKind]: string } = { canvas2d: 'Canvas 2D', pixi: 'PixiJS' };
