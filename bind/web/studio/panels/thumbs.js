// Small pictures to choose from, drawn when their turn comes.

const SIDE = 84;  // [CSS px]

/** A grid of buttons. Call fill() with what is to be chosen; a picture whose face and pose are as before stays. */
export class Thumbs {
  #gallery; #group; #chosen; #buttons = new Map(); #seen = null;
  constructor(gallery, label, chosen) {
    this.#gallery = gallery, this.#group = Symbol(label), this.#chosen = chosen;
    this.grid = document.createElement('div');
    this.grid.className = 'thumbs';
    this.grid.setAttribute('role', 'group');
    this.grid.setAttribute('aria-label', label);
  }
  /** `choices`: [{ key, label, face: { text, name }, pose, pressed }] */
  fill(choices) {
    this.#gallery.forget(this.#group);
    const before = this.#buttons;
    this.#buttons = new Map(choices.map((choice) => [choice.key, before.get(choice.key) ?? this.#made(choice)]));
    const buttons = choices.map(({ key }) => this.#buttons.get(key));
    if (buttons.length !== this.grid.childElementCount || buttons.some((one, i) => this.grid.children[i] !== one)) this.grid.replaceChildren(...buttons);
    choices.forEach((choice, i) => this.#show(buttons[i], choice));
    this.#reveal(buttons.find((one) => one.getAttribute('aria-pressed') === 'true'));
  }
  /** Another one is chosen: where it is out of sight of its row, the row goes there. */
  #reveal(button) {
    if (!button || this.#seen === button) return;
    this.#seen = button;
    const row = this.grid.getBoundingClientRect(), { left, right, width } = button.getBoundingClientRect();
    if (left < row.left || right > row.right) this.grid.scrollLeft += left - row.left - (row.width - width) / 2;
  }
  #made({ key, label }) {
    const button = document.createElement('button');
    button.type = 'button', button.className = 'thumb';
    button.innerHTML = '<canvas></canvas><span></span>';
    button.lastChild.textContent = label;
    button.title = label;
    button.onclick = () => this.#chosen(key);
    return button;
  }
  #show(button, { face, pose, pressed }) {
    if (pressed === undefined) button.removeAttribute('aria-pressed');
    else button.setAttribute('aria-pressed', pressed);
    const drawn = JSON.stringify([face, pose]);
    if (button.drawn === drawn) return;
    button.drawn = drawn;
    const side = Math.round(SIDE * Math.min(devicePixelRatio, 2));
    this.#gallery.draw(button.firstChild, this.#group, { ...face, pose: { fit: 'slice', ...pose }, width: side, height: side });
  }
}
