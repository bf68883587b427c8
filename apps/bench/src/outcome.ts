import type { Values } from './workload.ts';

/** What one run of one engine came to. */
export type Outcome = { readonly values: Values } | { readonly failure: string };
