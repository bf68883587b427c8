import { DiscContacts, HalfPlane, Random, rod, World } from '@mass/core';
import { expect, it } from 'vitest';
import { ContactBuffer } from '../../src/contacts/contact-buffer.ts';

/** The pairs that a generator finds, in its order. */
function pairsOf(generator: DiscContacts, world: World, lookAhead: number): string[] {
  const contacts = new ContactBuffer(Infinity);
  const linked = world.links.map(({ a, b }) => [a, b].map((end) => ('slot' in end ? (end.slot as number) : -1)));
  contacts.clear(world.particles.count, new Set(linked.map(([a, b]) => Math.min(a, b) * 0x400_0000 + Math.max(a, b))));
  contacts.linkVersion = linked.length;
  contacts.lookAhead = lookAhead;
  contacts.margin = 0.002;
  generator.addContacts(world.particles, contacts);
  return Array.from({ length: contacts.count }, (_, c) => `${contacts.a[c]} ${contacts.b[c]}`);
}

/** Each pair of discs that overlap. */
function overlaps({ particles: { count, x, y, radius, alive } }: World, linked: ReadonlySet<string>): string[] {
  const pairs: string[] = [];
  for (let i = 0; i < count; i++) {
    for (let j = i + 1; j < count; j++) {
      if (alive[i] + alive[j] < 2 || radius[i] * radius[j] === 0 || linked.has(`${i} ${j}`)) continue;
      if (Math.hypot(x[i] - x[j], y[i] - y[j]) < radius[i] + radius[j]) pairs.push(`${i} ${j}`);
    }
  }
  return pairs;
}

it.each([0.3, 3, 30])(
  '[C10] discs at %d m/s: the pairs are sorted, and those of a new generator, whatever happened before',
  (speed) => {
    const random = new Random(11);
    const w = new World({ gravity: { x: 0, y: -9.81 } });
    const kept = w.addContactGenerator(new DiscContacts());
    w.addShape(new HalfPlane());
    for (const x of [-3, 3]) w.addShape(new HalfPlane({ point: { x, y: 0 }, normal: { x: -Math.sign(x), y: 0 } }));
    const add = (radius: number, y = random.between(0.2, 4)) =>
      w.addParticle({
        x: random.between(-2.8, 2.8),
        y,
        vx: random.between(-speed, speed),
        radius,
        mass: radius + 0.01,
      });
    const discs = Array.from({ length: 300 }, () => add(random.between(0.04, 0.12)));
    for (const radius of [0, 0, 0.8, 0.4]) add(radius);
    w.addLink(rod(discs[0], discs[1]));
    let found = 0;
    for (let step = 0; step < 150; step++) {
      w.step(1 / 60);
      const some = () => discs[random.integer(0, discs.length - 1)];
      for (let n = 0; n < step % 5; n++) some().vx = random.between(-speed, speed) * (step % 7);
      if (step % 20 === 7) some().x = random.between(-2.8, 2.8);
      if (step % 20 === 9) some().radius = Math.max(0, random.between(-0.1, 0.3));
      if (step % 50 === 30) add(0.1, 5);
      const pairs = pairsOf(kept, w, step % 3 === 0 ? 1 / 120 : 1 / 60);
      expect(pairs).toEqual(pairsOf(new DiscContacts(), w, step % 3 === 0 ? 1 / 120 : 1 / 60));
      const order = pairs.map((pair) => pair.split(' ').map(Number));
      expect(order).toEqual(order.toSorted((p, q) => p[0] - q[0] || p[1] - q[1]));
      const known = new Set(pairs);
      expect(known.size).toBe(pairs.length);
      expect(overlaps(w, new Set(['0 1'])).filter((pair) => !known.has(pair))).toEqual([]);
      found += pairs.length;
    }
    expect(found).toBeGreaterThan(20000);
  },
);
