// Strengths of both sides, of the left or of the right one: a choice of sides, and a slider for each name.

import { withPose } from '../document.js';
import { slider } from '../slider.js';
import { spelled } from '../words.js';

const SIDES = { 'Both sides': '', Left: 'left', Right: 'right' };

/** A choice of sides; `chosen` hears of another one. */
export class SideChips {
  side = '';
  constructor(chosen) {
    this.root = Object.assign(document.createElement('div'), { className: 'chips' });
    this.root.setAttribute('role', 'group'), this.root.setAttribute('aria-label', 'Sides, as the face has them');
    this.root.append(...Object.entries(SIDES).map(([label, side]) => {
      const chip = Object.assign(document.createElement('button'), { type: 'button', className: 'chip', textContent: label });
      if (side) chip.title = `The face’s own ${side}`;
      chip.dataset.side = side;
      chip.onclick = () => { this.side = side, this.#show(), chosen(); };
      return chip;
    }));
    this.#show();
  }
  #show() { for (const chip of this.root.children) chip.setAttribute('aria-pressed', chip.dataset.side === this.side); }
}

export class Sides {
  #studio; #group; #kind; #hints; #rows = new Map(); #chips;
  /** `kind`: of controls, "emotion"; `group`: of the pose, "emotions"; `hints`: what names say to few. */
  constructor(studio, kind, group, hints = {}) {
    this.#studio = studio, this.#kind = kind, this.#group = group, this.#hints = hints;
    this.root = document.createElement('div');
    this.#chips = new SideChips(() => studio.refresh());
    this.place = document.createElement('div');
    this.root.append(this.#chips.root, this.place);
  }
  get #side() { return this.#chips.side && `${this.#chips.side}.`; }
  /** The names that the face has, without sides. */
  names(all) { return this.#of(all, ''); }
  #of(all, side) {
    const begin = `${this.#kind}.${side}`;
    return all.map(({ name }) => name).filter((name) => name.startsWith(begin) && !name.slice(begin.length).includes('.')).map((name) => name.slice(begin.length));
  }
  update({ pose }, { names }) {
    const some = this.#of(names, this.#side), of = this.#side + some.join();
    if (this.#rows.of !== of) this.#rows.clear(), this.#rows.of = of, this.place.replaceChildren(...some.map((name) => this.#slider(name)));
    for (const [key, { set }] of this.#rows) set(pose[this.#group][key] ?? 0);
  }
  #slider(name) {
    const key = this.#side + name;
    const made = slider({ label: spelled(name), hint: this.#hints[name], lo: 0, hi: 1, rest: 0, changed: (value) => this.#studio.change((before) => withPose(before, this.#group, key, value || null), this.#kind + key) });
    this.#rows.set(key, made);
    return made.row;
  }
}
