// Feelings, each seen on the face itself.

import { spelled } from '../words.js';
import { Sides } from './sides.js';
import { Thumbs } from './thumbs.js';

export class Feelings {
  #studio; #sides; #none; #thumbs; #mixed;
  constructor(root, studio) {
    this.#studio = studio;
    this.#sides = new Sides(studio, 'emotion', 'emotions');
    this.#thumbs = new Thumbs(studio.gallery, 'Feelings', (name) => this.#feel(name));
    root.innerHTML = '<p class="hint">This face has no feelings of its own.</p><h3>Mixed</h3>';
    [this.#none, this.#mixed] = root.children;
    this.#none.after(this.#thumbs.grid), root.append(this.#sides.root);
  }
  update(document, opened) {
    const feelings = this.#sides.names(opened.names), has = feelings.length > 0;
    this.#none.hidden = has, this.#thumbs.grid.hidden = this.#mixed.hidden = this.#sides.root.hidden = !has;
    const { text, name: file } = opened, { emotions } = document.pose;
    this.#thumbs.fill(feelings.map((name) => ({ key: name, label: spelled(name), pressed: (emotions[name] ?? 0) > 0, face: { text, name: file }, pose: { emotions: { [name]: 1 } } })));
    this.#sides.update(document, opened);
  }
  /** This feeling alone; once more, none. */
  #feel(name) {
    this.#studio.change((before) => {
      const { emotions } = before.pose, alone = Object.keys(emotions).length === 1 && emotions[name] === 1;
      return { ...before, pose: { ...before.pose, emotions: alone ? {} : { [name]: 1 } } };
    });
  }
}
