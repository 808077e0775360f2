// Export: a PNG of any size, an SVG file, the face's file, and the same picture in other languages.

import { changesOf } from './changes.js';
import { Desk } from './desk.js';
import { drawnPose } from './document.js';
import { patchText } from './patch.js';
import { FILE, LANGUAGES } from './snippets.js';
import { fileSize } from './words.js';

const MOST = 32768;  // [px] of a side

export class ExportDialog {
  #dialog; #form; #language = 'Command line'; #studio; #desk = null; #aspect = 1; #changes = null;
  constructor(dialog, studio) {
    this.#dialog = dialog, this.#form = dialog.querySelector('form'), this.#studio = studio;
    const does = { close: () => dialog.close(), png: () => this.#savePng(), svg: () => this.#saveSvg(), face: () => this.#saveFace(), cancel: () => this.#desk?.close(), copy: () => this.#copy('pre'), copyPatch: () => this.#copy('[data-for=patch]') };
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
    this.#say(''), this.#find('simplified').hidden = true;
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
    for (const what of ['png', 'svg']) this.#dialog.querySelector(`[data-do=${what}]`).disabled = !size;
    this.#find('size').textContent = size ? `${(size.width * size.height / 1e6).toFixed(1)} million pixels. Nothing leaves this page.` : `Sides are whole numbers from 1 to ${MOST}.`;
    for (const chip of this.#find('languages').children) chip.setAttribute('aria-pressed', chip.textContent === this.#language);
    if (!size) return;
    const { code } = opened, style = of.person?.style ?? 'soft';
    const text = LANGUAGES[this.#language]({ code, style, pose: of.pose, background: of.background, ...size });
    this.#dialog.querySelector('pre').textContent = text;
    this.#find('file').hidden = !text.includes(FILE);
    this.#find('file').textContent = `${FILE} is what “Save .face.json” saves.`;
  }
  /** What has changed; said once it is known. */
  async #showChanges() {
    for (const name of ['changes', 'patch', 'left']) this.#find(name).textContent = '';
    const hide = (name, on) => { this.#find(name).hidden = on; };
    const known = this.#changes = changesOf(this.#studio.document, this.#studio.opened, this.#studio.gallery);
    hide('patch', true), hide('left', true), this.#dialog.querySelector('[data-do=copyPatch]').hidden = true;
    try {
      const { patch, left, of } = await known, count = patch.length === 1 ? 'one change' : `${patch.length} changes`;
      if (known !== this.#changes) return;
      this.#find('patch').textContent = patchText(patch);
      this.#find('left').textContent = `Only in the pose, and so not in the patch: ${left.join(', ')}.`;
      hide('patch', !patch.length), hide('left', !left.length), this.#dialog.querySelector('[data-do=copyPatch]').hidden = !patch.length;
      this.#find('changes').textContent = patch.length ? `A JSON patch (RFC 6902) of ${count} to ${of}:` : `Nothing: this is still ${of}.`;
    } catch (refused) {
      if (known === this.#changes) this.#find('changes').textContent = refused.message;
    }
  }
  async #copy(which) {
    const text = this.#dialog.querySelector(which).textContent;
    this.#say(await this.#studio.copied(text) ? 'Copied.' : 'The browser does not let pages copy here: select the text instead.');
  }
  #savePng() {
    return this.#save('png', 'face.png', (blob) => blob);
  }
  /** Its sentences on what SVG cannot say are shown. */
  #saveSvg() {
    return this.#save('svg', 'face.svg', ({ text, simplified }) => {
      this.#find('simplified').replaceChildren(...simplified.map((one) => Object.assign(document.createElement('li'), { textContent: `${one}.` })));
      this.#find('simplified').hidden = !simplified.length;
      return new Blob([text], { type: 'image/svg+xml' });
    });
  }
  /** Draws in a worker of its own, which can be stopped, and saves what `blobOf` makes of the answer. */
  async #save(what, file, blobOf) {
    const size = this.#size(), { document: of, opened } = this.#studio;
    this.#working(true);
    this.#desk = new Desk();
    const bar = this.#dialog.querySelector('progress');
    try {
      const blob = blobOf(await this.#desk.ask(what, { text: opened.text, name: opened.name, pose: drawnPose(of), ...size }, { tell: (share) => { bar.value = share; } }));
      this.#studio.save(blob, file);
      this.#say(`Saved ${file}, ${fileSize(blob.size)}.`);
    } catch (refused) {
      this.#say(refused.message);
    }
    this.#desk.close();
    this.#desk = null;
    this.#working(false);
  }
  #working(on) {
    this.#dialog.querySelector('progress').hidden = this.#dialog.querySelector('[data-do=cancel]').hidden = !on;
    for (const what of ['png', 'svg']) this.#dialog.querySelector(`[data-do=${what}]`).disabled = on;
    this.#dialog.querySelector('progress').value = 0;
    if (on) this.#say(''), this.#find('simplified').hidden = true;
  }
  /** The file with all that it can hold; what it cannot is said. */
  async #saveFace() {
    this.#find('simplified').hidden = true;
    try {
      const { text, lost, full } = await this.#changes;
      this.#studio.save(new Blob([text], { type: 'application/json' }), FILE);
      const said = full ? `Saved ${FILE} in full: with the points and colours that you changed, it is no longer made of parts.` : `Saved ${FILE}.`;
      this.#say(lost.length ? `${said} Left out, for only the pose has it: ${lost.join(', ')}. The command line says it, too.` : said);
    } catch (refused) {
      this.#say(refused.message);
    }
  }
}
