import { type Palette, palette } from '../scenes/palette.ts';

const darkByPreference = matchMedia('(prefers-color-scheme: dark)');

/** The palette that the page shows now. */
export function currentPalette(): Palette {
  const chosen = document.documentElement.dataset['theme'];
  return palette(chosen === undefined ? darkByPreference.matches : chosen === 'dark');
}

/** Wires the button that switches between light and dark, and tells when the palette changes, for whatever reason. */
export function watchTheme(changed: (palette: Palette) => void): void {
  document.getElementById('theme')?.addEventListener('click', () => {
    const theme = currentPalette().dark ? 'light' : 'dark';
    document.documentElement.dataset['theme'] = theme;
    remember(theme);
    changed(currentPalette());
  });
  darkByPreference.addEventListener('change', () => changed(currentPalette()));
}

function remember(theme: string): void {
  try {
    localStorage.setItem('theme', theme);
  } catch {
    // Storage is forbidden in some windows: the choice then lasts as long as the page.
  }
}
