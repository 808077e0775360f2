// Colours: of a person the families of colours, and of every face each colour by itself.

import { withPose } from '../document.js';
import { holding, stepped, withNumber } from '../person.js';
import { hexOf, spelled } from '../words.js';
import { choicesOf, COLORS } from './parts.js';
import { Thumbs } from './thumbs.js';

const TONE = 'skin.tone';

export class Colours {
  #studio; #families; #singles; #rows = new Map(); #of = null; #thumbs = new Map();
  constructor(root, studio) {
    this.#studio = studio;
    root.innerHTML = '<div></div><details><summary>Every colour by itself</summary><p class="hint">These belong to the pose. Shades of a colour do not follow it.</p><div class="swatches"></div></details>';
    this.#families = root.firstChild;
    this.#singles = root.querySelector('.swatches');
  }
  update({ pose }, { lists, recipe, names }) {
    this.#families.hidden = !recipe;
    if (recipe) this.#showFamilies(recipe, lists);
    const colours = names.filter(({ name, count }) => name.startsWith('palette/') && count >= 3), of = colours.map(({ name, values }) => name + values).join();
    if (this.#of !== of) this.#of = of, this.#rows.clear(), this.#singles.replaceChildren(...colours.map((one) => this.#swatch(one)));
    for (const { name, values } of colours) this.#rows.get(name)(pose.set[name], hexOf(values));
    if (!recipe) this.#singles.closest('details').open = true;
  }
  /** The family to be seen first, once the panel is. */
  show(family) { requestAnimationFrame(() => this.#thumbs.get(family)?.grid.scrollIntoView({ block: 'nearest' })); }
  #showFamilies(recipe, { families, numbers }) {
    this.#showSkin(recipe, numbers.find(({ name }) => name === TONE));
    for (const name of COLORS) {
      const family = families.find((one) => one.name === name);
      if (!family) continue;
      if (!this.#thumbs.has(name)) this.#add(name, (part) => this.#studio.change((before) => ({ ...before, person: holding(before.person, name, part) })));
      this.#thumbs.get(name).fill(choicesOf({ recipe, name: 'colour', family }));
    }
  }
  /** A skin tone is a number: each whole one is shown. */
  #showSkin(recipe, tone) {
    if (!tone) return;
    if (!this.#thumbs.has(TONE)) this.#add(TONE, (key) => this.#studio.change((before) => ({ ...before, person: holding(before.person, TONE, stepped(tone, Number(key))) })));
    const tones = Array.from({ length: Math.floor(tone.hi - tone.lo) + 1 }, (_, i) => tone.lo + i), now = Math.round(recipe.numbers[TONE]);
    this.#thumbs.get(TONE).fill(tones.map((one) => ({ key: String(one), label: String(one), pressed: one === now, face: { text: JSON.stringify(withNumber(recipe, TONE, one)), name: 'tone' } })));
  }
  #add(name, chosen) {
    const thumbs = new Thumbs(this.#studio.gallery, spelled(name), chosen);
    thumbs.grid.classList.add('row');
    this.#thumbs.set(name, thumbs);
    this.#families.append(Object.assign(document.createElement('h3'), { textContent: spelled(name) }), thumbs.grid);
  }
  #swatch({ name }) {
    const label = document.createElement('label'), change = (value) => this.#studio.change((before) => withPose(before, 'set', name, value), name);
    label.className = 'swatch';
    label.innerHTML = '<input type="color"><span></span><button type="button" class="quiet">Back</button>';
    const [input, text, back] = label.children;
    text.textContent = spelled(name.slice('palette/'.length));
    back.setAttribute('aria-label', `${text.textContent} as it was`);
    input.oninput = () => change(input.value);
    back.onclick = (event) => { event.preventDefault(), change(null); };
    this.#rows.set(name, (set, rest) => { input.value = set ?? rest, back.hidden = set === undefined; });
    return label;
  }
}
