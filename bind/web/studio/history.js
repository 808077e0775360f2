// Undo and redo over documents, which are never changed but replaced.

const ONE_GESTURE = 900;  // [ms] within which changes of one thing are one step

export class History {
  #past = []; #future = []; #now; #key = null; #at = 0;
  constructor(first) { this.#now = first; }
  get now() { return this.#now; }
  get canUndo() { return this.#past.length > 0; }
  get canRedo() { return this.#future.length > 0; }
  /** `key` names what is changed: a slider that is dragged is one step. */
  change(next, key = null, at = performance.now()) {
    const goesOn = key !== null && key === this.#key && at - this.#at < ONE_GESTURE;
    if (!goesOn) this.#past.push(this.#now);
    this.#now = next, this.#future = [], this.#key = key, this.#at = at;
  }
  undo() { this.#step(this.#past, this.#future); }
  redo() { this.#step(this.#future, this.#past); }
  #step(from, to) {
    if (!from.length) return;
    to.push(this.#now);
    this.#now = from.pop(), this.#key = null;
  }
}
