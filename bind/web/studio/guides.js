// Lines over the picture, while a dragged point is held by them.

const SVG = 'http://www.w3.org/2000/svg';
const SAID = { axis: 'the mirror axis', partner: 'its mirror image', tangent: 'a tangent', point: 'another point' };

export class Guides {
  #root = document.createElementNS(SVG, 'svg');
  constructor(layer) {
    this.#root.setAttribute('class', 'guides'), this.#root.setAttribute('aria-hidden', 'true');
    this.#root.setAttribute('viewBox', '0 0 1 1'), this.#root.setAttribute('preserveAspectRatio', 'none');
    layer.append(this.#root);
  }
  /** `lines` in face units; `shareOf` says where in the picture a place is, from 0 to 1. */
  show(lines, shareOf) {
    this.#root.replaceChildren(...lines.flatMap((line) => [this.#line(line, shareOf, 'edge'), this.#line(line, shareOf, line.why)]));
  }
  clear() { this.#root.replaceChildren(); }
  #line({ through: [x, y], along: [dx, dy] }, shareOf, kind) {
    const [a, b] = shareOf([x, y]), [c, d] = shareOf([x + dx, y + dy]), far = 4 / Math.hypot(c - a, d - b);  // beyond the picture on both sides
    const line = document.createElementNS(SVG, 'line');
    line.setAttribute('class', kind);
    const ends = { x1: a - far * (c - a), y1: b - far * (d - b), x2: a + far * (c - a), y2: b + far * (d - b) };
    for (const [name, value] of Object.entries(ends)) line.setAttribute(name, value);
    return line;
  }
}

/** What holds a point, in words. */
export const heldBy = (lines) => [...new Set(lines.map(({ why }) => SAID[why]))].join(' and ');
