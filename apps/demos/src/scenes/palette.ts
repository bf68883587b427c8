/** The colours of the page, from which a scene takes its own. Each is a CSS colour `#rrggbb`. */
export interface Palette {
  readonly dark: boolean;
  /** Behind the picture. */
  readonly paper: string;
  /** Text, and what stands fast. */
  readonly ink: string;
  /** Guides, and what is not the matter of the scene. */
  readonly quiet: string;
  /** What the eye should follow. */
  readonly accent: string;
  /** Colours that are told apart easily, in light and dark and by the colour-blind. */
  readonly series: readonly string[];
}

/** The palette of the page, light or dark. The same numbers as in `styles/tokens.css`. */
export function palette(dark: boolean): Palette {
  return dark
    ? {
        dark,
        paper: '#14171c',
        ink: '#e6e9ee',
        quiet: '#8a93a1',
        accent: '#ff8a5c',
        series: ['#8fa3b8', '#6cb2ff', '#ff8a5c', '#ffcf5c', '#5fd6b4', '#c39bff', '#ff8fb3', '#a5d65f'],
      }
    : {
        dark,
        paper: '#ffffff',
        ink: '#1d2430',
        quiet: '#6d7683',
        accent: '#d9480f',
        series: ['#5b6b7e', '#1c6dd0', '#d9480f', '#c58a00', '#0b8a6a', '#7c4dcc', '#c9356e', '#5c8a12'],
      };
}
