// Export: a PNG of any size, the face's file, and the same picture in other languages.

import { changesOf } from './changes.js';
import { Desk } from './desk.js';
import { drawnPose } from './document.js';
import { patchText } from './patch.js';
import { FILE, LANGUAGES } from './snippets.js';

const MOST = 32768;  // [px] of a side

export class ExportDialog {
  #dialog; #form; #language = 'Command line'; #studio; #desk = null; #aspect = 1;
  constructor(dialog, studio) {
    this.#dialog = dialog, this.#form = dialog.querySelector('form'), this.#studio = studio;
    const does = { close: () => dialog.close(), png: () => this.#savePng(), face: () => this.#saveFace(), cancel: () => this.#desk?.close(), copy: () => this.#copy('pre'), copyPatch: () => this.#copy('[data-for=patch]') };
    for (const button of dialog.querySelectorAll('[data-do]')) button.onclick = does[button.dataset.do];
    this.#form.onsubmit = (event) => event.preventDefault();
    this.#form.width.oninput = () => this.#resize('width', 'height', 1 / this.#aspect);
    this.#form.height.oninput = () => this.#resize('height', 'width', this.#aspect);
    this.#form.background.onchange = this.#form.color.oninput = () => this.#background();
    dialog.onclose = () => this.#desk?.close();
    dialog.querySelector('[data-for=languages]').append(...Object.keys(LANGUAGES).map((name) => this.#chip(name)));
  }
  open() {
    const { box: [x0, y0, x1, y1] } = this.#studio.opened.canvas, { background } = this.#studio.document;
    this.#aspect = (x1 - x0) / (y1 - y0);
    this.#form.background.value = background === null ? '' : background === '#00000000' ? background : 'color';
    if (background?.length === 7) this.#form.color.value = background;
    this.#resize('width', 'height', 1 / this.#aspect);
    this.#showChanges();
    this.#say('');
    this.#dialog.showModal();
  }

  #find(name) { return this.#dialog.querySelector(`[data-for=${name}]`); }
  #say(text) { this.#find('said').textContent = text; }
  #chip(name) {
    const chip = Object.assign(document.createElement('button'), { type: 'button', className: 'chip', textContent: name });
    chip.onclick = () => { this.#language = name, this.#show(); };
    return chip;
  }
  #resize(given, other, factor) {
    const value = Math.round(Number(this.#form[given].value));
    if (value > 0) this.#form[other].value = Math.max(1, Math.round(value * factor));
    this.#show();
  }
  #background() {
    const chosen = this.#form.background.value;
    this.#studio.change((before) => ({ ...before, background: chosen === 'color' ? this.#form.color.value : chosen || null }), 'background');
    this.#show();
  }
  #size() {
    const [width, height] = ['width', 'height'].map((name) => Number(this.#form[name].value));
    const fits = (n) => Number.isInteger(n) && n >= 1 && n <= MOST;
    return fits(width) && fits(height) ? { width, height } : null;
  }
  #show() {
    const size = this.#size(), { document: of, opened } = this.#studio;
    this.#form.color.parentElement.hidden = this.#form.background.value !== 'color';
    this.#dialog.querySelector('[data-do=png]').disabled = !size;
    this.#find('size').textContent = size ? `${(size.width * size.height / 1e6).toFixed(1)} million pixels, drawn in strips; nothing leaves this page.` : `Sides are whole numbers from 1 to ${MOST}.`;
    for (const chip of this.#find('languages').children) chip.setAttribute('aria-pressed', chip.textContent === this.#language);
    if (!size) return;
    const { code } = opened, style = of.person?.style ?? 'soft';
    const text = LANGUAGES[this.#language]({ code, style, pose: of.pose, background: of.background, ...size });
    this.#dialog.querySelector('pre').textContent = text;
    this.#find('file').hidden = !text.includes(FILE);
    this.#find('file').textContent = `${FILE} is what “Save .face.json” saves.`;
  }
  #showChanges() {
    const { patch, left, of } = changesOf(this.#studio.document, this.#studio.opened), count = patch.length === 1 ? 'one change' : `${patch.length} changes`;
    this.#find('changes').textContent = patch.length ? `A JSON patch (RFC 6902) of ${count} to ${of}:` : `Nothing: this is still ${of}.`;
    this.#find('patch').hidden = this.#dialog.querySelector('[data-do=copyPatch]').hidden = !patch.length;
    this.#find('patch').textContent = patchText(patch);
    this.#find('left').hidden = !left.length;
    this.#find('left').textContent = `Only in the pose, and so not in the patch: ${left.join(', ')}.`;
  }
  async #copy(which) {
    const text = this.#dialog.querySelector(which).textContent;
    this.#say(await this.#studio.copied(text) ? 'Copied.' : 'The browser does not let pages copy here: select the text instead.');
  }
  async #savePng() {
    const size = this.#size(), { document: of, opened } = this.#studio;
    this.#working(true);
    this.#desk = new Desk();
    const bar = this.#dialog.querySelector('progress');
    try {
      const blob = await this.#desk.ask('png', { text: opened.text, name: opened.name, pose: drawnPose(of), ...size }, { tell: (share) => { bar.value = share; } });
      this.#studio.save(blob, 'face.png');
      this.#say(`Saved face.png, ${(blob.size / 1e6).toFixed(2)} MB.`);
    } catch (refused) {
      this.#say(refused.message);
    }
    this.#desk.close();
    this.#desk = null;
    this.#working(false);
  }
  #working(on) {
    this.#dialog.querySelector('progress').hidden = this.#dialog.querySelector('[data-do=cancel]').hidden = !on;
    this.#dialog.querySelector('[data-do=png]').disabled = on;
    this.#dialog.querySelector('progress').value = 0;
    if (on) this.#say('');
  }
  #saveFace() {
    this.#studio.save(new Blob([this.#studio.opened.text], { type: 'application/json' }), FILE);
    this.#say(`Saved ${FILE}. The pose is in the command line, not in the file.`);
  }
}
