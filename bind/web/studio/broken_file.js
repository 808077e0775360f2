// A face file that cannot be opened: its sentence, and its text at the place that the sentence speaks of, to be mended
// and tried again. The face before stays until it works.

import { TextEditor } from './text_editor.js';

/** "mine.face.json:2:33: /canvas" as { line, column, pointer }; null: it is no place in that file. */
export function placeIn(where, name) {
  const [, line, column, pointer = ''] = (where.startsWith(`${name}:`) && where.slice(name.length + 1).match(/^(\d+):(\d+)(?:: (.*))?$/)) || [];
  return line ? { line: Number(line), column: Number(column), pointer } : null;
}

export class BrokenFile {
  #dialog; #studio; #editor; #name = ''; #given = ''; #warned = false;
  constructor(dialog, studio) {
    this.#dialog = dialog, this.#studio = studio;
    this.#editor = new TextEditor(dialog.querySelector('.editor'));
    const does = { close: () => this.#leave(), try: () => this.#try(), save: () => this.#save(), place: () => this.#editor.toPlace() };
    for (const button of dialog.querySelectorAll('[data-do]')) button.onclick = does[button.dataset.do];
    dialog.querySelector('form').onsubmit = (event) => event.preventDefault();
    dialog.oncancel = (event) => { event.preventDefault(), this.#leave(); };
    dialog.onkeydown = (event) => { if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) event.preventDefault(), this.#try(); };
  }
  /** Shows a file's text where it was refused; false: the refusal names no place in it. */
  open(name, text, refused) {
    const place = placeIn(refused.where ?? '', name);
    if (!place) return false;
    this.#name = name, this.#given = text, this.#warned = false;
    this.#find('name').textContent = name;
    this.#editor.text = text;
    if (!this.#dialog.open) this.#dialog.showModal();
    this.#show(place, refused.what);
    return true;
  }
  close() { if (this.#dialog.open) this.#dialog.close(); }

  #find(name) { return this.#dialog.querySelector(`[data-for=${name}]`); }
  #say(text) { this.#find('said').textContent = text; }
  #show(place, what) {
    const { line, column, pointer } = place ?? {};
    this.#find('where').textContent = place ? `Line ${line}, column ${column}${pointer && `, ${pointer}`}` : this.#name;
    this.#find('what').textContent = what;
    this.#say('');
    place ? this.#editor.mark(place) : this.#editor.unmark();
  }
  async #try() {
    const { text } = this.#editor;
    try {
      await this.#studio.take(this.#name, text);
      this.close();
    } catch (refused) {
      this.#show(placeIn(refused.where ?? '', this.#name), refused.what ?? refused.message);
    }
  }
  #save() {
    this.#given = this.#editor.text;
    this.#studio.save(new Blob([this.#given], { type: 'application/json' }), this.#name);
    this.#say(`Saved ${this.#name}.`);
  }
  /** Closes; where something was changed, only when it is asked for again. */
  #leave() {
    if (this.#editor.text === this.#given.replaceAll('\r\n', '\n') || this.#warned) return this.close();
    this.#warned = true;
    this.#say('What you changed here is not saved. Close once more to leave it.');
  }
}
