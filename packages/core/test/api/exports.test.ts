import { readdirSync, readFileSync } from 'node:fs';
import * as core from '@mass/core';
import { expect, it } from 'vitest';

it('[A1] the package exports exactly these names', () => {
  expect(Object.keys(core).sort()).toMatchInlineSnapshot(`
    [
      "Attraction",
      "Box",
      "Bungees",
      "Buoyancy",
      "Disc",
      "DiscContacts",
      "DistanceLink",
      "Drag",
      "EdgeContacts",
      "Fireworks",
      "FixedTimestep",
      "ForceProbe",
      "Gravity",
      "HalfPlane",
      "Particle",
      "PointerSpring",
      "Polygon",
      "Polyline",
      "Random",
      "Segment",
      "Springs",
      "Wind",
      "World",
      "aggregate",
      "box",
      "bungee",
      "cable",
      "castRay",
      "chain",
      "cloth",
      "contactKeeper",
      "explicitEuler",
      "firstHit",
      "forEachParticle",
      "fuelled",
      "impact",
      "inRegion",
      "insideBox",
      "insideDisc",
      "insideHalfPlane",
      "lasting",
      "nearestParticle",
      "particlesAt",
      "particlesInBox",
      "particlesInCircle",
      "polygon",
      "regularPolygon",
      "rod",
      "semiImplicitEuler",
      "severity",
      "shapeFinder",
      "spring",
      "substep",
      "travellingWave",
      "triangle",
      "vec2",
    ]
  `);
});

it('every rule of SPEC.md is cited by a test, and has one number', () => {
  const rules = [
    ...readFileSync(new URL('../../SPEC.md', import.meta.url), 'utf8').matchAll(/^- \*\*([A-Z]\d+)\*\*/gm),
  ];
  const numbers = rules.map(([, number]) => number);
  expect(numbers.length).toBeGreaterThan(50);
  expect(new Set(numbers).size).toBe(numbers.length);
  const folder = new URL('../', import.meta.url);
  const tests = readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.test.ts'))
    .map((file) => readFileSync(new URL(file.replaceAll('\\', '/'), folder), 'utf8'))
    .join('\n');
  expect(numbers.filter((number) => !tests.includes(`[${number}] `))).toEqual([]);
});
