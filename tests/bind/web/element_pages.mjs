// What the tests of <mien-face> share: pages of faces in headless Chromium, what they tell, and the pictures they are to show.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, afterEach } from 'node:test';
import { browse } from './chromium.mjs';
import { spikyFace } from './spiky_face.mjs';
import { serve } from './static_server.mjs';

export const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
const { load } = await import(`file://${built}/mien.js`);
export const mien = await load(readFileSync(`${built}/mien.wasm`));
export const toon = readFileSync(new URL('../../../faces/compat/toon.face.json', import.meta.url), 'utf8');

export const TRACK = '0\tsil\n0.1\tm\n0.3\tɑː\n0.6\tf\n0.8\t\n', AT_M = 0.2, AT_AA = 0.5, AT_END = 0.8;
/** A second of silence, as an address. */
const SILENCE = (() => {
  const rate = 8000, head = Buffer.alloc(44);
  head.write('RIFF'), head.writeUInt32LE(36 + rate, 4), head.write('WAVEfmt ', 8), head.writeUInt32LE(16, 16), head.writeUInt16LE(1, 20), head.writeUInt16LE(1, 22);
  head.writeUInt32LE(rate, 24), head.writeUInt32LE(rate, 28), head.writeUInt16LE(1, 32), head.writeUInt16LE(8, 34), head.write('data', 36), head.writeUInt32LE(rate, 40);
  return `data:audio/wav;base64,${Buffer.concat([head, Buffer.alloc(rate, 128)]).toString('base64')}`;
})();

/** Counts what is told, in order, and whether the picture was there then. */
const WATCH = `<script>
  window.told = [], window.refused = [], window.asked = [], window.askedOf = [], window.workers = 0;
  window.Worker = class extends Worker {
    constructor(...given) { super(...given), this.which = window.workers++; }
    postMessage(message, ...more) {
      if (message.pose) window.posed = message.pose, window.asked.push(message.id - 1), window.askedOf.push(this.which);
      super.postMessage(message, ...more);
    }
  };
  let frame = 0;
  requestAnimationFrame(function next() { ++frame, requestAnimationFrame(next); });
  const { putImageData } = CanvasRenderingContext2D.prototype, puts = new WeakMap(), putAt = [];  // in which frame each picture was put there
  CanvasRenderingContext2D.prototype.putImageData = function (...given) { puts.set(this.canvas, frame), putAt.push(frame), putImageData.apply(this, given); };
  addEventListener('mien-drawn', ({ target }) => { told.push({ id: target.id, empty: empty(target), early: frame <= puts.get(target.shadowRoot.querySelector('canvas')) }); });
  addEventListener('mien-refused', ({ target, detail }) => refused.push({ id: target.id, ...detail }));
  function empty(face) {
    const from = face.shadowRoot.querySelector('canvas'), into = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d');
    into.drawImage(from, from.width / 2, from.height / 2, 1, 1, 0, 0, 1, 1);
    return into.getImageData(0, 0, 1, 1).data[3] === 0;
  }
  const count = (id) => told.filter((one) => one.id === id).length;
  const frames = (n) => new Promise((done) => { const next = () => (n-- ? requestAnimationFrame(next) : done()); next(); });
</script><style>body { margin: 0 } #crowd { display: grid; grid-template-columns: repeat(auto-fill, 72px); gap: 4px }</style>`;
export const page = (body, from = '.') => `<!doctype html><meta charset="utf-8">${WATCH}<script type="module" src="${from}/element.js"></script>${body}`;
export const faces = (count, more = '') => Array.from({ length: count }, (_, i) => `<mien-face id="f${i}" seed="person ${i}" width="72" height="72" ${more}></mien-face>`).join('');
export const one = (attributes) => page(`<mien-face id="it" width="72" height="72" ${attributes}></mien-face>`);
export const pages = {
  '/crowd.html': page(`<div id="crowd">${faces(200)}</div>`),
  '/ada.html': one('seed="ada"'), '/nothing.html': one('seed=""'), '/bare.html': one(''), '/playing.html': one('seed="ada" clip="idle" playing'),
  '/column.html': page(Array.from({ length: 40 }, (_, i) => `<div style="height: 200px"><mien-face id="f${i}" seed="${i}" width="72" height="72"></mien-face></div>`).join('')),
  '/hidden.html': page('<div style="display: none"><mien-face id="none" seed="a" width="72" height="72" playing></mien-face></div><mien-face id="hid" hidden seed="b" width="72" height="72"></mien-face><mien-face id="it" seed="ada" width="72" height="72"></mien-face>'),
  '/talk.html': page(`<mien-face id="it" seed="ada" width="72" height="72"></mien-face><div id="crowd">${faces(120, 'clip="idle" playing')}</div>`),
  '/many.html': page('<div id="crowd"></div>'),
  '/early.html': `<!doctype html><meta charset="utf-8">${WATCH}<mien-face id="it" width="72" height="72"></mien-face><script>it.seed = 'ada', it.pose = { emotions: { joy: 1 } };</script><script type="module" src="element.js"></script>`,
  '/spikes.html': page('<mien-face id="spikes" src="spikes.face.json" width="72" height="72" deadline="200"></mien-face><mien-face id="it" seed="ada" width="72" height="72"></mien-face>'), '/spikes.face.json': spikyFace(),
  '/endless.html': page(['endless', 'it'].map((id) => `<mien-face id="${id}" seed="ada" width="72" height="72"></mien-face>`).join('')),
  '/speech.html': page(`<audio id="voice" muted src="${SILENCE}"></audio><mien-face id="it" seed="ada" width="72" height="72" speech="hello.tsv" sound="voice"></mien-face>`), '/hello.tsv': TRACK, '/long.tsv': Array.from({ length: 200 }, (_, i) => `${i / 5}\t${['PP', 'aa'][i % 2]}\n`).join('') + '40\tsil\n',
  '/written.html': page(faces(12).replaceAll(/(id="f[0-5]"[^>]*>)/g, '$1<img alt="">')),
  '/slow.html': page(`<mien-face id="slow" seed="ada" face-style="vinyl" width="600" height="600" clip="idle" playing></mien-face><div id="crowd">${faces(60, 'clip="idle" playing')}</div>`),
  '/file.html': one('src="toon.face.json" face-style="ink"'), '/toon.face.json': toon,
};
export const server = await serve(built, pages);
export const browser = await browse();
afterEach(() => browser.closePages());
after(async () => { await browser.close(); await server.close(); });

export const open = (name, options) => browser.open(`${server.url}/${name}.html`, options);
export const drawn = (on, id = 'it', times = 1) => on.until((which, least) => count(which) >= least, id, times);
export const sentence = async (on) => (await on.until(() => window.refused.at(-1) ?? null));

/** The bytes that a face shows. */
export const shown = async (on, id = 'it') => Buffer.from(await on.run((which) => {
  const from = document.getElementById(which).shadowRoot.querySelector('canvas');
  return Array.from(from.getContext('2d').getImageData(0, 0, from.width, from.height).data);
}, id));
/** The bytes that mien itself draws. */
export function picture(face, pose = {}) {
  const pixels = face.draw(72, 72, pose);
  face.free();
  return pixels;
}
export const ada = (pose, how) => picture(mien.person(mien.code('ada'), how), pose);
export async function shows(on, wanted, id) {
  for (let i = 0; i < 200; ++i, await new Promise((done) => setTimeout(done, 50))) if (Buffer.compare(await shown(on, id), Buffer.from(wanted)) === 0) return;
  assert.fail('it shows something else');
}
/** Changes the face and waits until that is drawn. */
export async function change(on, work, ...args) {
  const before = await on.run(() => count('it'));
  await on.run(work, ...args);
  await drawn(on, 'it', before + 1);
}
