// Which parts: a family at a time, each part seen on the face itself.

import { holding, partOf, withPart } from '../person.js';
import { spelled } from '../words.js';
import { Thumbs } from './thumbs.js';

export const COLORS = ['hair_color', 'iris', 'cloth_color', 'backdrop', 'accent', 'frame_color'];

/** What changes with a part. Hats hide hair: whoever gets other hair takes the hat off. */
const taking = (family, part) => (family === 'hair' ? [['headwear', 'none'], [family, part]] : [[family, part]]);
const wearing = (recipe, family, part) => taking(family, part).reduce((now, one) => withPart(now, ...one), recipe);

/** The choices of a family, as Thumbs.fill takes them. */
export function choicesOf({ recipe, name, family }) {
  return family.parts.map((part) => ({ key: part, label: spelled(part), pressed: (partOf(recipe, family.name) ?? 'none') === part,
    face: { text: JSON.stringify(wearing(recipe, family.name, part)), name } }));
}

export class Parts {
  #studio; #family = 'style'; #chips; #thumbs; #none;
  constructor(root, studio) {
    this.#studio = studio;
    root.innerHTML = '<p class="hint" hidden>This face is a whole of its own: it has no parts to choose from. Take somebody under People.</p><div class="chips" role="group" aria-label="Families of parts"></div>';
    [this.#none, this.#chips] = root.children;
    this.#thumbs = new Thumbs(studio.gallery, 'Parts', (part) => this.#take(part));
    root.append(this.#thumbs.grid);
  }
  update(_, { lists, recipe }) {
    this.#none.hidden = Boolean(recipe), this.#chips.hidden = this.#thumbs.grid.hidden = !recipe;
    if (!recipe) return;
    const families = lists.families.filter(({ name }) => !COLORS.includes(name));
    if (!this.#chips.childElementCount) this.#chips.append(...['style', ...families.map(({ name }) => name)].map((name) => this.#chip(name)));
    for (const chip of this.#chips.children) chip.setAttribute('aria-pressed', chip.dataset.name === this.#family);
    this.#thumbs.grid.setAttribute('aria-label', spelled(this.#family));
    this.#thumbs.fill(this.#family === 'style' ? this.#styles(recipe, lists.styles) : choicesOf({ recipe, name: 'part', family: families.find(({ name }) => name === this.#family) }));
  }
  /** The family to be seen from now on. */
  show(family) { this.#family = family; }
  #styles(recipe, styles) {
    return styles.map((style) => ({ key: style, label: spelled(style), pressed: recipe.style === style, face: { text: JSON.stringify({ ...recipe, style }), name: style } }));
  }
  #chip(name) {
    const chip = Object.assign(document.createElement('button'), { type: 'button', className: 'chip', textContent: spelled(name) });
    chip.dataset.name = name;
    chip.onclick = () => { this.#family = name, this.#studio.refresh(); };
    return chip;
  }
  #take(part) {
    const family = this.#family;
    const changed = (person) => (family === 'style' ? { ...person, style: part } : taking(family, part).reduce((now, one) => holding(now, ...one), person));
    this.#studio.change((before) => ({ ...before, person: changed(before.person) }));
  }
}
