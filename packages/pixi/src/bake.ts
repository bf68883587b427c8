/**
 * Writes a ring of white, from `inner` to `outer`, into an RGBA image, with premultiplied alpha that is the share of each
 * pixel covered; an `inner` of 0 makes a disc. `left` and `top` are the corner of a square of `size` pixels that has the
 * centre in its middle.
 */
export function bakeRing(
  image: Uint8Array,
  imageWidth: number,
  left: number,
  top: number,
  size: number,
  inner: number,
  outer: number,
): void {
  const centre = size / 2;
  for (let row = 0; row < size; row++) {
    const dy = row + 0.5 - centre;
    let at = ((top + row) * imageWidth + left) * 4;
    for (let column = 0; column < size; column++, at += 4) {
      const dx = column + 0.5 - centre;
      const value = Math.round(255 * ringCoverage(Math.sqrt(dx * dx + dy * dy), inner, outer));
      image[at] = value;
      image[at + 1] = value;
      image[at + 2] = value;
      image[at + 3] = value;
    }
  }
}

/** Writes a piece of a horizontal white line, `width` pixels wide, along the middle of a rectangle of the image. */
export function bakeLine(
  image: Uint8Array,
  imageWidth: number,
  left: number,
  top: number,
  length: number,
  height: number,
  width: number,
): void {
  for (let row = 0; row < height; row++) {
    const distance = Math.abs(row + 0.5 - height / 2);
    const value = Math.round(255 * Math.min(1, width, Math.max(0, width / 2 + 0.5 - distance)));
    const at = ((top + row) * imageWidth + left) * 4;
    image.fill(value, at, at + length * 4);
  }
}

/** How much of a pixel at `distance` from the centre the ring covers, 0 to 1. */
function ringCoverage(distance: number, inner: number, outer: number): number {
  return discCoverage(distance, outer) - (inner > 0 ? discCoverage(distance, inner) : 0);
}

/** The edge counts as straight, which is right but for discs smaller than a pixel: those keep their area. */
function discCoverage(distance: number, radius: number): number {
  const edge = Math.min(1, Math.max(0, radius + 0.5 - distance));
  return radius < 0.5 ? edge * Math.min(1, Math.PI * radius * radius * 2) : edge;
}
