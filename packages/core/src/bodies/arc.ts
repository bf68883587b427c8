import { cos, sin } from '../math/trigonometry.ts';
import type { Vec2 } from '../math/vec2.ts';

/**
 * The joints of `count` equal straight links of a length in all, from one place to another, as an arc of a circle that bends
 * to the lower side; a straight line where they are as long as the way. First and last are the two places themselves.
 */
export function arc(from: Readonly<Vec2>, to: Readonly<Vec2>, length: number, count: number): Vec2[] {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const distance = Math.sqrt(dx * dx + dy * dy);
  const ux = distance === 0 ? 1 : dx / distance;
  const uy = distance === 0 ? 0 : dy / distance;
  const side = ux < 0 ? 1 : -1; // of the two normals ±(-uy, ux) the one that points down
  const each = length / count;
  const half = halfTurn(Math.min(1, distance / length), count);
  const places: Vec2[] = [{ x: from.x, y: from.y }];
  let along = 0;
  let off = 0;
  for (let link = 0; link < count - 1; link++) {
    const angle = (count - 1 - 2 * link) * half; // between this link and the straight line
    along += each * cos(angle);
    off += side * each * sin(angle);
    places.push({ x: from.x + along * ux - off * uy, y: from.y + along * uy + off * ux });
  }
  places.push({ x: to.x, y: to.y });
  return places;
}

/**
 * Half the angle t by which each link turns against the one before: n equal chords of a circle span sin(n·t) / (n·sin(t)) of
 * their length, from 1 where t = 0 down to 0 where they close the circle, t = π/n. By bisection. Unit: rad.
 */
function halfTurn(span: number, count: number): number {
  let low = 0;
  let high = Math.PI / count;
  for (let i = 0; i < 60 && count > 1; i++) {
    const middle = (low + high) / 2;
    if (sin(middle * count) > span * count * sin(middle)) low = middle;
    else high = middle;
  }
  return span === 1 ? 0 : (low + high) / 2;
}
