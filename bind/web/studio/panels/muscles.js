// Muscles: what feelings pull at, one by one.

import { Sides } from './sides.js';

const DOES = {
  'inner-frontalis': 'raises the inner brow', 'outer-frontalis': 'raises the outer brow', corrugator: 'draws the brows together', procerus: 'lowers the brow',
  'levator-palpebrae': 'raises the upper lid', 'orbicularis-oculi': 'narrows the eye', 'lid-depressor': 'lowers the upper lid',
  'levator-labii': 'raises the upper lip', nasalis: 'wrinkles the nose', zygomaticus: 'smiles', 'depressor-anguli': 'lowers the mouth’s corner', 'depressor-labii': 'lowers the lower lip',
  mentalis: 'pushes up the chin', risorius: 'widens the mouth', 'orbicularis-oris': 'purses the lips', jaw: 'opens the mouth',
};

export class Muscles {
  #sides; #none;
  constructor(root, studio) {
    this.#sides = new Sides(studio, 'muscle', 'muscles', DOES);
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
