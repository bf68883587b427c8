import type { Values } from './workload.ts';

/** What one run of one engine came to. */
export type Outcome = { readonly values: Values } | { readonly failure: string };

/** How a failure begins whose cause is that it takes too long. */
export const TOO_SLOW = 'too slow';
