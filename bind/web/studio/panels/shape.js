// The numbers of a recipe: how old, how wide, how large.

import { holding, stepped } from '../person.js';
import { slider } from '../slider.js';
import { spelled } from '../words.js';

/** "eye.size" is of the group "eye"; names without a dot are of the head. */
const groupOf = (name) => (name.includes('.') ? name.slice(0, name.indexOf('.')) : 'head');

export class Shape {
  #studio; #root; #sliders = new Map(); #of = null;
  constructor(root, studio) { this.#studio = studio, this.#root = root; }
  update(_, { lists, recipe }) {
    if (!recipe) {
      this.#of = null, this.#sliders.clear();
      this.#root.innerHTML = '<p class="hint">This face is a whole of its own, without numbers of a recipe. Take somebody under People.</p>';
      return;
    }
    if (this.#of !== lists) this.#build(lists.numbers), this.#of = lists;
    const { numbers } = recipe;
    for (const [name, { set }] of this.#sliders) if (numbers[name] !== undefined) set(numbers[name]);
  }
  #build(numbers) {
    this.#root.replaceChildren(), this.#sliders.clear();
    for (const [group, all] of Map.groupBy ? Map.groupBy(numbers, ({ name }) => groupOf(name)) : grouped(numbers)) {
      const title = Object.assign(document.createElement('h3'), { textContent: spelled(group) });
      this.#root.append(title, ...all.map((number) => this.#slider(number)));
    }
  }
  #slider(number) {
    const { name, lo, hi, rest } = number;
    const made = slider({ label: spelled(name.slice(name.indexOf('.') + 1)), lo, hi, rest,
      changed: (value) => this.#studio.change((before) => ({ ...before, person: holding(before.person, name, stepped(number, value)) }), name) });
    this.#sliders.set(name, made);
    return made.row;
  }
}

function grouped(numbers) {
  const groups = new Map();
  for (const number of numbers) groups.set(groupOf(number.name), [...groups.get(groupOf(number.name)) ?? [], number]);
  return groups;
}
