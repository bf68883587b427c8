import type { ForceGenerator } from '../forces/force-generator.ts';

/** The generator at the heart of those that limit another: in space, in time, by fuel. */
export function generatorWithin(generator: ForceGenerator): ForceGenerator {
  let inner = generator;
  while ('generator' in inner) inner = inner.generator as ForceGenerator;
  return inner;
}
