// A text to be edited, with numbers of its lines and a mark at one place. Only what is seen of it is drawn besides the
// text itself, so that it may be long.

const LINE = 20;    // [px], as the style sheet has it
const ABOVE = 3;    // lines that are seen above the place
const TOKENS = /"(?:[^"\\]|\\.)*"?|[^\s,:{}[\]"]+|[^\s]/g;

/** What stands at a place of a line of JSON: [begin, end]. Sentences about syntax speak of the end of a token. */
function tokenAt(line, at) {
  const token = [...line.matchAll(TOKENS)].find(({ 0: text, index }) => index <= at && at < index + text.length);
  return token ? [token.index, token.index + token[0].length] : [at, at + 1];
}

export class TextEditor {
  #root; #area; #numbers; #row; #before; #place = null; #count = 1;
  constructor(root) {
    this.#root = root;
    root.innerHTML = `<pre class="numbers" aria-hidden="true"></pre><div class="sheet"><div class="row" aria-hidden="true" hidden><span></span><mark></mark></div>
      <textarea wrap="off" spellcheck="false" autocapitalize="off" autocomplete="off" aria-label="The file’s text" aria-describedby="broken-what"></textarea></div>`;
    [this.#numbers, this.#row, this.#area] = ['.numbers', '.row', 'textarea'].map((which) => root.querySelector(which));
    this.#before = this.#row.firstChild;
    this.#area.onscroll = () => this.#follow();
    this.#area.oninput = () => this.#edited();
    new ResizeObserver(() => this.#follow()).observe(root);
  }
  get text() { return this.#area.value; }
  set text(text) {
    this.#area.value = text;
    this.#count = text.split('\n').length;
    this.unmark();
  }
  /** Marks what stands at a line and a column [characters], from 1, and goes there. */
  mark({ line, column }) {
    const text = this.text.split('\n')[line - 1] ?? '', [begin, end] = tokenAt(text, [...text].slice(0, column - 1).join('').length);
    const before = text.slice(0, begin), token = text.slice(begin, end);
    this.#place = { line, text, before, token };
    this.#row.hidden = false;
    this.#before.textContent = before, this.#row.lastChild.textContent = token || ' ';
    this.#area.setAttribute('aria-invalid', 'true');
    this.toPlace();
  }
  unmark() {
    this.#place = null, this.#row.hidden = true;
    this.#area.removeAttribute('aria-invalid');
    this.#follow();
  }
  /** Brings the place into view, with the caret at it. */
  toPlace() {
    if (!this.#place) return this.#area.focus();
    const { line, before, token } = this.#place, lines = this.text.split('\n').slice(0, line - 1);
    const at = lines.reduce((sum, one) => sum + one.length + 1, 0) + before.length;
    this.#area.focus({ preventScroll: true });
    this.#area.setSelectionRange(at, at + token.length);
    this.#area.scrollTop = (line - 1 - ABOVE) * LINE;
    const { offsetLeft, offsetWidth } = this.#row.lastChild;
    this.#area.scrollLeft = Math.max(0, offsetLeft + Math.min(offsetWidth, 160) + 24 - this.#area.clientWidth);
    this.#follow();
  }
  /** The mark stays as long as its line does. */
  #edited() {
    const { line, text } = this.#place ?? {}, lines = this.text.split('\n');
    this.#count = lines.length;
    if (line && lines[line - 1] !== text) return this.unmark();
    this.#follow();
  }
  /** Numbers and mark go with the text. */
  #follow() {
    const { scrollTop, scrollLeft, clientHeight } = this.#area, first = Math.floor(scrollTop / LINE);
    const last = Math.min(this.#count, first + Math.ceil(clientHeight / LINE) + 1);
    this.#numbers.textContent = Array.from({ length: Math.max(0, last - first) }, (_, i) => first + i + 1).join('\n');
    this.#numbers.style.transform = `translateY(${first * LINE - scrollTop}px)`;
    this.#root.style.setProperty('--digits', String(this.#count).length);
    if (this.#place) this.#row.style.transform = `translate(${-scrollLeft}px, ${(this.#place.line - 1) * LINE - scrollTop}px)`;
  }
}
