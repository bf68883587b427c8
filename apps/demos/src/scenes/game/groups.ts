/** What the particles of the game are: a style colours them by it, the rules ask for it. */
export const BALL = 1;
export const TARGET = 2;
export const CHAIN = 3;
export const WEIGHT = 4;
export const SLING = 5;
export const DUST = 6;
export const BURST = 11;
export const SPARK = 12;
export const EMBER = 13;
export const SPLASH = 14;
export const DROP = 15;
