// Who it is: somebody by a word or a code, of a crowd, like the one before, a sample, or a file of one's own.

import { ofFace, ofPerson } from '../document.js';
import { spelled } from '../words.js';
import { Thumbs } from './thumbs.js';

const CROWD = 12, RELATIVES = 4;
const SAMPLES = {
  toon: new URL('../faces/toon.face.json', import.meta.url), bruno: new URL('../faces/bruno.face.json', import.meta.url), clay: new URL('../faces/clay.face.json', import.meta.url),
  male: new URL('../faces/male.face.json', import.meta.url), seed0: new URL('../faces/seed0.face.json', import.meta.url),
};
const IS_CODE = /^[0-9a-z]{5}-?[0-9a-z]{5}-?[0-9a-z]{2}(~|$)/i;

export class People {
  #studio; #crowd; #relatives; #samples; #word = 'studio'; #of = null; #begun = false;
  constructor(root, studio) {
    this.#studio = studio;
    root.innerHTML = `<form class="line"><label class="wide">A word or a code<input name="who" placeholder="Your name" autocomplete="off" spellcheck="false"></label><button>Meet</button></form>
      <p class="hint">The same word is always the same person.</p>
      <div class="head"><h3>A crowd</h3><button type="button" class="quiet" data-do="others">Others</button></div><div data-for="crowd"></div>
      <div class="head" data-for="kin"><h3>Like this one</h3><button type="button" class="quiet" data-do="kin">Others</button></div><div data-for="relatives"></div>
      <div class="head"><h3>Samples</h3><button type="button" class="quiet" data-do="file">Open a file…</button></div><div data-for="samples"></div>`;
    const put = (name, label, chosen) => {
      const thumbs = new Thumbs(studio.gallery, label, chosen);
      root.querySelector(`[data-for=${name}]`).append(thumbs.grid);
      return thumbs;
    };
    this.#crowd = put('crowd', 'A crowd', (code) => this.meet(code));
    this.#relatives = put('relatives', 'Like this one', (code) => this.meet(code));
    this.#samples = put('samples', 'Samples', (name) => this.#sample(name));
    this.root = root;
    const form = root.querySelector('form');
    form.onsubmit = (event) => { event.preventDefault(), this.who(form.who.value.trim()); };
    root.querySelector('[data-do=others]').onclick = () => { this.#word = String(Math.random()), this.#drawCrowd(); };
    root.querySelector('[data-do=kin]').onclick = () => { this.#of = null, this.#drawRelatives(String(Math.random())); };
    root.querySelector('[data-do=file]').onclick = () => studio.openFile();
  }
  update() {
    if (!this.#begun) this.#begun = true, this.#drawCrowd(), this.#drawSamples();
    this.#drawRelatives();
  }
  /** Somebody by a code or, if it is none, by a word. */
  async who(text) {
    if (!text) return;
    await this.#studio.trying(async () => this.meet(IS_CODE.test(text) ? text : await this.#studio.desk.ask('code', { word: text })));
  }
  meet(code) {
    return this.#studio.trying(async () => {
      await this.#studio.gallery.ask('recipe', { code });  // refused here, it changes nothing
      this.#studio.change((before) => ofPerson({ code, held: {}, style: before.person?.style ?? 'soft' }, before));
    });
  }
  random() { return this.who(`${Math.random()}`); }
  async #drawCrowd() {
    const codes = await this.#studio.gallery.ask('crowd', { word: this.#word, count: CROWD });
    this.#crowd.fill(await this.#people(codes));
  }
  async #drawRelatives(word = 'kin') {
    const code = this.#studio.opened?.code;
    this.root.querySelector('[data-for=kin]').hidden = this.#relatives.grid.hidden = !code;
    if (!code || code === this.#of) return;
    this.#of = code;
    const codes = await Promise.all(Array.from({ length: RELATIVES }, (_, i) => this.#studio.gallery.ask('near', { code, by: 0.25, word: `${word} ${i}` })));
    this.#relatives.fill(await this.#people(codes));
  }
  async #people(codes) {
    return Promise.all(codes.map(async (code) => ({ key: code, label: code, face: { text: JSON.stringify(await this.#studio.gallery.ask('recipe', { code })), name: code } })));
  }
  async #sample(name) {
    await this.#studio.trying(async () => this.#studio.change((before) => ofFace(`${name}.face.json`, this.#texts[name], before)));
  }
  #texts = {};
  async #drawSamples() {
    await Promise.all(Object.entries(SAMPLES).map(async ([name, address]) => { this.#texts[name] = await (await fetch(address)).text(); }));
    this.#samples.fill(Object.keys(SAMPLES).map((name) => ({ key: name, label: spelled(name), face: { text: this.#texts[name], name } })));
  }
}
