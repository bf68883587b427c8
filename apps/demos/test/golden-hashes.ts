/** The bits of each scene after five seconds at its own values. A change that is meant to change them changes them here. */
export const goldenHashes: { readonly [id: string]: string } = {
  'buoyancy-explained': '4dfc8f06',
  'buoyancy-liquids': '0ed0396c',
  'buoyancy-masses': '9d8ee06b',
  'buoyancy-volumes': 'b4740f6f',
  'buoyancy-waves': '6db79583',
  fireworks: 'c55b8772',
  'force-generators': 'ebdf6886',
  projectiles: '993935e4',
  'springs-amplitude': '0af3dd99',
  'springs-period': 'f5d2daef',
};
