/** The bits of each scene after five seconds at its own values. A change that is meant to change them changes them here. */
export const goldenHashes: { readonly [id: string]: string } = {
  fireworks: '4fb79e95',
  'force-generators': 'ebdf6886',
  projectiles: '993935e4',
};
