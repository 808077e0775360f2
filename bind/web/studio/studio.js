// The studio: a document, its history, a stage, and panels that change it.

import { BrokenFile } from './broken_file.js';
import { Desk, Gallery } from './desk.js';
import { drawnPose, isAtRest, ofFace, ofPerson, REST, withPose } from './document.js';
import { ExportDialog } from './export_dialog.js';
import { History } from './history.js';
import { Colours } from './panels/colours.js';
import { Feelings } from './panels/feelings.js';
import { Muscles } from './panels/muscles.js';
import { Parts } from './panels/parts.js';
import { People } from './panels/people.js';
import { Pose } from './panels/pose.js';
import { Shape } from './panels/shape.js';
import { Stage } from './stage.js';
import { tabs } from './tabs.js';
import { TimeLine } from './time_line.js';
import { placeOf } from './under.js';
import { spelled } from './words.js';

const by = (id) => document.getElementById(id);
const PANELS = { People, Parts, Shape, Colours, Feelings, Muscles, Pose };
const FIRST = 'AM9XB-0E85E-9Y';  // who is there when the studio opens
const LONGEST_FILE = 16 << 20;

class Studio {
  #history = null; #shown = null; #opening = false; #stage; #tabs; #timeLine; #broken; #lists = null;
  desk = new Desk();
  gallery = new Gallery();
  opened = null;  // what the worker told of the open face

  constructor() {
    this.#stage = new Stage(this, document.querySelector('.frame'), {
      change: (key, values) => this.change((before) => Object.entries(values).reduce((now, [name, value]) => withPose(now, 'set', name, value || null), before), key),
      drawn: (ms, refused) => { refused ? this.say(refused.message) : this.#timeLine.tell(); },
    });
    this.#timeLine = new TimeLine(this, this.#stage, document.querySelector('.timeline'));
    this.#tabs = tabs(document.querySelector('[role=tablist]'), document.querySelector('.panels'), PANELS, this);
    this.exporting = new ExportDialog(by('exporting'), this);
    this.#broken = new BrokenFile(by('broken'), this);
    this.#wire();
  }
  get opening() { return this.#opening; }
  get document() { return this.#history.now; }

  /** Begins with somebody: the code of the address, or FIRST. */
  async begin() {
    const code = decodeURIComponent(location.hash.slice(1)) || FIRST;
    const known = await this.desk.ask('recipe', { code }).then(() => code, (refused) => {
      this.refused = refused.message;
      return FIRST;
    });
    this.#history = new History(ofPerson({ code: known, held: {}, style: 'soft' }));
    await this.refresh();
  }
  /** Changes the document; what mien refuses is taken back and said. */
  change(make, key = null) {
    if (!this.#history) return this.#history = new History(make({})), this.refresh();
    this.say('');
    this.#history.change(make(this.document), key);
    return this.refresh();
  }
  /** Runs work and says what is refused. */
  async trying(work) {
    try { return await work(); } catch (refused) { this.say(refused.message); }
  }
  say(text) {
    if (by('said').textContent !== text) by('said').textContent = text;
  }

  /** Whether clicks on the picture are for points. */
  get shaping() { return this.#stage.points.on; }
  /** Opens the panel where a feature is changed, and says its name. */
  select(feature) {
    if (!feature) return this.say('There is nothing.');
    const place = this.opened.recipe ? placeOf(feature) : { panel: 'Colours' };
    if (!place) return this.say(`${spelled(feature)}.`);
    if (place.family) this.#tabs.panel(place.panel).show(place.family);
    this.#tabs.choose(place.panel);
    this.say(place.family ? `${spelled(feature)}: ${place.panel}, ${spelled(place.family)}` : `${spelled(feature)}: ${place.panel}`);
  }

  /** Shows the document as it is now. */
  async refresh() {
    this.#stage.busy(true);
    if (this.#stage.stuck) this.#restart();
    if (this.#opening) return;  // it looks again when the face is there
    this.#opening = true;
    try {
      for (let of; (of = this.document.person ?? this.document.face) !== this.#shown;) await this.#open(of);
    } finally { this.#opening = false; }
    this.#show();
  }
  /** Ends the picture that is being drawn, and the worker with it. */
  #restart() {
    this.desk.close();
    this.desk = new Desk();
    this.#shown = null;
  }
  async #open(of) {
    const { person, face } = this.document;
    try {
      const opened = await this.desk.ask('open', person ? { person, name: 'face.face.json' } : face);
      if (opened.recipe) this.#lists ??= await this.desk.ask('parts');
      this.opened = { ...opened, name: face?.name ?? 'face.face.json', lists: this.#lists };
      this.#shown = of;
    } catch (refused) {
      if (refused.stopped || this.document.person !== person || this.document.face !== face) return;  // it is another meanwhile
      if (!this.#history.canUndo) throw refused;
      this.#history.undo();
      this.refused = refused.message;
    }
  }
  #show() {
    if (!this.opened) return;
    this.#stage.show(this.document, this.opened);
    this.#timeLine.show(this.document, this.opened);
    this.#tabs.update();
    by('undo').disabled = !this.#history.canUndo, by('redo').disabled = !this.#history.canRedo;
    by('rest').disabled = isAtRest(this.document);
    by('code').value = this.opened.code ?? (this.opened.title || this.opened.name);
    by('copy').hidden = !this.opened.code;
    const hash = this.opened.code ? `#${this.opened.code}` : '';
    if (location.hash !== hash) history.replaceState(null, '', `${location.pathname}${hash}`);
    document.documentElement.dataset.ready = '';
    if (this.refused) this.say(this.refused), this.refused = null;
  }

  #step(way) {
    this.#history[way]();
    this.refresh();
  }
  #wire() {
    by('undo').onclick = () => this.#step('undo');
    by('redo').onclick = () => this.#step('redo');
    by('random').onclick = () => this.#tabs.panel('People').random();
    by('rest').onclick = () => { this.#timeLine.leave(), this.change((before) => ({ ...before, pose: REST })); };
    by('export').onclick = () => this.#export();
    by('copy').onclick = async () => this.say(await this.copied(this.opened.code) ? 'Copied.' : 'The browser does not let pages copy here.');
    by('theme').onclick = () => this.#theme();
    const toggle = (id, work) => { by(id).onclick = () => { const on = by(id).getAttribute('aria-pressed') !== 'true'; by(id).setAttribute('aria-pressed', on), work(on); }; };
    toggle('follow', (on) => this.#stage.follow(on));
    toggle('points', (on) => { this.#stage.points.turn(on), by('snap').hidden = !on; });
    toggle('snap', (on) => { this.#stage.points.snapping = on; });
    by('file').onchange = () => this.#read(by('file').files[0]);
    document.addEventListener('dragover', (event) => event.preventDefault());
    document.addEventListener('drop', (event) => { event.preventDefault(), this.#read(event.dataTransfer.files[0]); });
    document.addEventListener('keydown', (event) => this.#key(event));
    window.addEventListener('hashchange', () => { if (location.hash.length > 1) this.#tabs.panel('People').who(decodeURIComponent(location.hash.slice(1))); });
  }
  #key(event) {
    if (event.key === 'Escape' && this.shaping && !document.querySelector('dialog[open]')) by('points').click(), by('points').focus();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || document.querySelector('dialog[open]')) return;
    const way = { z: event.shiftKey ? 'redo' : 'undo', y: 'redo' }[event.key.toLowerCase()];
    if (!way || event.target.matches('input:not([type=range]):not([type=color])')) return;
    event.preventDefault();
    this.#step(way);
  }
  /** Of the picture as it is: what moves stops, and the eyes no longer follow. */
  #export() {
    if (!this.opened) return;
    this.#timeLine.pause();
    this.#stage.lookAhead();
    this.exporting.open();
  }
  #theme() {
    const { dataset } = document.documentElement, dark = dataset.theme ? dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    dataset.theme = dark ? 'light' : 'dark';
  }

  openFile() { by('file').click(); }
  async #read(file) {
    by('file').value = '';
    if (!file) return;
    if (file.size > LONGEST_FILE) return this.say(`${file.name}: a face file has at most ${LONGEST_FILE >> 20} MB`);
    const text = await file.text();
    try {
      await this.take(file.name, text);
      this.#broken.close();
    } catch (refused) {
      this.say(refused.message);
      this.#broken.open(file.name, text, refused);
    }
  }
  /** Shows the face of a file's text, if it is one. */
  async take(name, text) {
    const person = await this.gallery.ask('person', { text, name });
    return this.change((before) => (person ? ofPerson(person, { background: before.background }) : ofFace(name, text, before)));
  }
  save(blob, name) {
    const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }
  async copied(text) {
    try { return await navigator.clipboard.writeText(text), true; } catch { return false; }
  }
}

const studio = new Studio();
studio.begin().catch((refused) => studio.say(refused.message));
