/** The bits of each scene after five seconds at its own values. A change that is meant to change them changes them here. */
export const goldenHashes: { readonly [id: string]: string } = {
  fireworks: 'c55b8772',
  'force-generators': 'ebdf6886',
  projectiles: '993935e4',
};
