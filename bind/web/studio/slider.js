// A number with a name, a track and a field. Both take the keyboard; the field takes exact values.

import { digits } from './words.js';

let count = 0;

/** { row, set(value) }. `hint`: what the name says to few. `rest`: where a double click and the field's clearing go. `changed(value)` hears every step. */
export function slider({ label, hint, lo, hi, rest, step = (hi - lo) / 200, changed }) {
  const row = document.createElement('div'), id = `slider-${++count}`;
  row.className = 'slider';
  row.innerHTML = `<label for="${id}"></label><input class="field" type="text" inputmode="decimal" autocomplete="off"><input class="track" type="range" id="${id}">`;
  const [name, field, track] = row.children;
  name.textContent = label;
  if (hint) name.dataset.hint = hint;
  field.setAttribute('aria-label', `${label}, exactly`);
  Object.assign(track, { min: lo, max: hi, step: 'any' });
  let value = rest;
  const show = () => {
    track.value = value, field.value = digits(value, lo, hi);
    const at = (x) => (x - lo) / (hi - lo);
    row.style.setProperty('--from', Math.min(at(rest), at(value))), row.style.setProperty('--to', Math.max(at(rest), at(value)));
    row.classList.toggle('moved', value !== rest);
  };
  const take = (wanted) => { value = Math.min(hi, Math.max(lo, wanted)), show(), changed(value); };
  track.oninput = () => take(Math.abs(track.valueAsNumber - rest) < (hi - lo) / 120 ? rest : track.valueAsNumber);
  track.onkeydown = (event) => {
    const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (by) event.preventDefault(), take(value + by * step);
  };
  name.ondblclick = track.ondblclick = () => take(rest);
  field.onchange = () => {
    const wanted = field.value.trim() === '' ? rest : Number(field.value.replace(',', '.'));
    Number.isFinite(wanted) ? take(wanted) : show();
  };
  field.onfocus = () => field.select();
  show();
  return { row, set(given) { if (given !== value) value = given, show(); } };
}
