// Muscles: what feelings pull at, one by one.

import { Sides } from './sides.js';

export class Muscles {
  #sides; #none;
  constructor(root, studio) {
    this.#sides = new Sides(studio, 'muscle', 'muscles');
    root.innerHTML = '<p class="hint">This face has no muscles.</p>';
    this.#none = root.firstChild;
    root.append(this.#sides.root);
  }
  update(document, opened) {
    const has = this.#sides.names(opened.names).length > 0;
    this.#none.hidden = has, this.#sides.root.hidden = !has;
    this.#sides.update(document, opened);
  }
}
