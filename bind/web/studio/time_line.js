// The time line: which clip the face runs, and the moment of it that is seen. The document holds both; while the clip
// plays, the moment is the clock's, and where it is stopped it is the document's again.

import { FRAMES, framesOn, rounded, shownOf } from './clip_time.js';
import { spelled } from './words.js';

const SECOND = FRAMES;  // [frames]

export class TimeLine {
  #studio; #stage; #root; #play; #clip; #bar; #field; #length; #loop; #seconds = 0; #of = null; #begun = null;
  looping = true;
  constructor(studio, stage, root) {
    this.#studio = studio, this.#stage = stage, this.#root = root;
    [this.#play, this.#clip, this.#bar, this.#field, this.#length, this.#loop] = ['play', 'clip', 'bar', 'moment', 'length', 'loop'].map((name) => root.querySelector(`[data-for=${name}]`));
    this.#play.onclick = () => this.toggle();
    this.#loop.onclick = () => { this.looping = !this.looping, this.#loop.setAttribute('aria-pressed', this.looping); };
    this.#clip.onchange = () => this.#choose(this.#clip.value || null);
    this.#bar.oninput = () => this.seek(this.#bar.valueAsNumber);
    this.#bar.onkeydown = (event) => this.#key(event);
    this.#field.onchange = () => this.#take(this.#field.value);
    this.#field.onfocus = () => this.#field.select();
    document.addEventListener('keydown', (event) => this.#space(event));
  }
  get playing() { return this.#begun !== null; }
  get #pose() { return this.#studio.document.pose; }
  /** [s] The moment that is seen. */
  get moment() {
    if (!this.playing) return this.#pose.time;
    const { at, time } = this.#begun, on = time + (performance.now() - at) / 1000;
    return this.looping ? on % this.#seconds : Math.min(on, this.#seconds);
  }

  /** Another document is shown, or another face. */
  show({ pose }, { clips, clipLengths }) {
    const of = JSON.stringify(clips);
    if (this.#of !== of) this.#of = of, this.#clip.replaceChildren(new Option('No clip', ''), ...clips.map((name) => new Option(spelled(name), name)));
    this.#root.classList.toggle('empty', !clips.length);
    this.#clip.value = pose.clip ?? '';
    if (!pose.clip) this.leave();
    this.#bar.disabled = this.#field.disabled = !pose.clip;
    this.#seconds = Math.max(shownOf(clipLengths[pose.clip]), pose.time);
    this.#bar.max = this.#seconds, this.#root.style.setProperty('--seconds', this.#seconds);
    this.#length.textContent = `/ ${this.#seconds} s`;
    this.tell();
  }
  /** Says the moment; where a clip that does not loop is at its end, it stops. */
  tell() {
    const { moment } = this, running = this.playing;
    if (running && !this.looping && moment >= this.#seconds) return this.pause();
    this.#bar.value = moment;
    this.#bar.style.setProperty('--at', moment / this.#seconds);
    this.#bar.setAttribute('aria-valuetext', `${moment.toFixed(2)} of ${this.#seconds} seconds`);
    if (document.activeElement !== this.#field || running) this.#field.value = running ? moment.toFixed(2) : String(rounded(moment));
    this.#play.setAttribute('aria-label', running ? 'Pause' : 'Play'), this.#play.title = `${running ? 'Pause' : 'Play'} (Space)`;
    this.#play.classList.toggle('running', running);
  }

  toggle() { this.playing ? this.pause() : this.play(); }
  /** Runs the clip from the moment on that is seen; where there is none, the face's first one. */
  play() {
    const { clips } = this.#studio.opened ?? {};
    if (!clips?.length) return;
    if (!this.#pose.clip) this.#put({ clip: clips[0], time: 0 });
    const { time } = this.#pose;
    this.#begun = { at: performance.now(), time: time >= this.#seconds ? 0 : time };
    this.#run();
  }
  /** Stops where it is; the document has that moment. */
  pause() {
    if (!this.playing) return;
    const time = rounded(this.moment);
    this.leave();
    this.#put({ time });
  }
  /** Stops, and nobody asks where. */
  leave() {
    if (!this.playing) return;
    this.#begun = null;
    this.#run();
  }
  seek(time) {
    if (!this.#pose.clip) return;
    this.leave();
    this.#put({ time: rounded(Math.min(this.#seconds, Math.max(0, time))) }, 'time');
  }

  #run() {
    this.#stage.play(this.playing ? () => this.moment : null);
    this.tell();
  }
  #put(values, key = null) { this.#studio.change((before) => ({ ...before, pose: { ...before.pose, ...values } }), key); }
  /** Another clip begins at its beginning, and goes on playing. */
  #choose(clip) {
    const { playing } = this;
    this.leave();
    this.#put({ clip, time: 0 });
    if (clip && playing) this.play();
  }
  #take(text) {
    const time = text.trim() === '' ? 0 : Number(text.replace(',', '.'));
    Number.isFinite(time) ? this.seek(time) : this.tell();
    this.#field.value = String(rounded(this.moment));
  }
  #key(event) {
    const { key, shiftKey } = event, by = shiftKey ? SECOND : 1;
    const frames = { ArrowRight: by, ArrowUp: by, ArrowLeft: -by, ArrowDown: -by, PageUp: SECOND, PageDown: -SECOND }[key];
    if (frames) this.seek(framesOn(this.moment, frames));
    else if (key === 'Home' || key === 'End') this.seek(key === 'Home' ? 0 : this.#seconds);
    else return;
    event.preventDefault();
  }
  /** The space bar plays wherever it does nothing else. */
  #space(event) {
    if (event.key !== ' ' || event.ctrlKey || event.altKey || event.metaKey || !event.target.matches('body, .frame canvas, .timeline [type=range]')) return;
    event.preventDefault();
    if (!event.repeat) this.toggle();
  }
}
