// node --test element_test.mjs: many <mien-face> in one page, in headless Chromium: which are drawn, when, and what is refused.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test, { after, afterEach } from 'node:test';
import { browse } from './chromium.mjs';
import { pngPixels } from './png_pixels.mjs';
import { spikyFace } from './spiky_face.mjs';
import { serve } from './static_server.mjs';

const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
const { load } = await import(`file://${built}/mien.js`);
const mien = await load(readFileSync(`${built}/mien.wasm`));
const toon = readFileSync(new URL('../../../faces/compat/toon.face.json', import.meta.url), 'utf8');

const TRACK = '0\tsil\n0.1\tm\n0.3\tɑː\n0.6\tf\n0.8\t\n', AT_M = 0.2, AT_AA = 0.5, AT_END = 0.8;
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
const page = (body, from = '.') => `<!doctype html><meta charset="utf-8">${WATCH}<script type="module" src="${from}/element.js"></script>${body}`;
const faces = (count, more = '') => Array.from({ length: count }, (_, i) => `<mien-face id="f${i}" seed="person ${i}" width="72" height="72" ${more}></mien-face>`).join('');
const one = (attributes) => page(`<mien-face id="it" width="72" height="72" ${attributes}></mien-face>`);
const pages = {
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
const server = await serve(built, pages);
const browser = await browse();
afterEach(() => browser.closePages());
after(async () => { await browser.close(); await server.close(); });

const open = (name, options) => browser.open(`${server.url}/${name}.html`, options);
const drawn = (on, id = 'it', times = 1) => on.until((which, least) => count(which) >= least, id, times);
const sentence = async (on) => (await on.until(() => window.refused.at(-1) ?? null));

/** The bytes that a face shows. */
const shown = async (on, id = 'it') => Buffer.from(await on.run((which) => {
  const from = document.getElementById(which).shadowRoot.querySelector('canvas');
  return Array.from(from.getContext('2d').getImageData(0, 0, from.width, from.height).data);
}, id));
/** The bytes that mien itself draws. */
function picture(face, pose = {}) {
  const pixels = face.draw(72, 72, pose);
  face.free();
  return pixels;
}
const ada = (pose, how) => picture(mien.person(mien.code('ada'), how), pose);
async function shows(on, wanted, id) {
  for (let i = 0; i < 200; ++i, await new Promise((done) => setTimeout(done, 50))) if (Buffer.compare(await shown(on, id), Buffer.from(wanted)) === 0) return;
  assert.fail('it shows something else');
}
/** Changes the face and waits until that is drawn. */
async function change(on, work, ...args) {
  const before = await on.run(() => count('it'));
  await on.run(work, ...args);
  await drawn(on, 'it', before + 1);
}

test('two hundred avatars come one by one, and are on the screen when that is told', async () => {
  const on = await open('crowd', { width: 1280, height: 1000 });
  await on.until(() => window.told.length >= 20);
  const { data } = await on.send('Page.captureScreenshot', { format: 'png' });
  const { told, filled } = await on.run(() => ({ told: window.told.length, filled: [...document.querySelectorAll('mien-face')].filter((face) => !empty(face)).length }));
  assert.ok(filled >= 20 && filled < 150, `${filled} of 200 are there when the twentieth is told`);
  assert.ok(told <= filled);
  const { width, pixels } = pngPixels(Buffer.from(data, 'base64'));
  const white = (x, y) => [0, 1, 2].every((c) => pixels[4 * (y * width + x) + c] === 255);
  const seen = Array.from({ length: 16 }, (_, i) => [76 * i + 36, 50]).filter(([x, y]) => !white(x, y)).length;
  assert.equal(seen, 16, `${seen} of the first row are on the screen`);
  await on.until(() => window.told.length >= 200);
  const all = await on.run(() => window.told);
  assert.deepEqual(all.filter(({ empty, early }) => empty || early), []);
  assert.equal(new Set(all.map(({ id }) => id)).size, 200);
  assert.deepEqual(on.faults, []);
});

test('what is in view comes first, then what is near; what is far is not drawn', async () => {
  const on = await browser.open(`${server.url}/column.html`, { width: 800, height: 600, first: 'history.scrollRestoration = "manual"; addEventListener("DOMContentLoaded", () => scrollTo(0, 4000))' });
  await on.until(() => window.told.length >= 6);
  await on.run(() => frames(60));
  const order = (await on.run(() => window.told.map(({ id }) => Number(id.slice(1)))));
  assert.deepEqual((await on.run(() => window.asked)).slice(0, 3), [20, 21, 22]);  // they may overtake each other in their workers
  assert.ok(order.every((i) => i >= 19 && i <= 24), `drawn were ${order}`);
  await on.run(() => scrollTo(0, 0));
  await drawn(on, 'f0');
});

test('faces with nothing in them come before those where a picture stands', async () => {
  const on = await open('written');
  await on.until(() => window.told.length >= 12);
  const asked = await on.run(() => window.asked.slice(1, 6));  // the first one while the others were not known
  assert.ok(asked.every((which) => which >= 6), `after the first one were asked for: ${asked}`);
});

test('what is hidden is not drawn until it is shown', async () => {
  const on = await open('hidden');
  await drawn(on);
  await on.run(() => frames(60));
  assert.deepEqual(await on.run(() => window.told.map(({ id }) => id)), ['it']);
  await on.run(() => { document.querySelector('div').style.display = '', document.getElementById('hid').hidden = false; });
  await drawn(on, 'hid');
  await drawn(on, 'none', 3);
});

test('clips rest out of view, and in a page in the background', async () => {
  const on = await open('playing');
  await drawn(on, 'it', 3);
  const still = async (rest, wake) => {
    await on.run(rest);
    await on.run(() => frames(10));
    const before = await on.run(() => count('it'));
    await on.run(() => frames(60));
    assert.equal(await on.run(() => count('it')), before);
    await on.run(wake);
    await drawn(on, 'it', before + 3);
  };
  await still(() => { it.style.marginTop = '3000px'; }, () => { it.style.marginTop = ''; });
  await still(() => { it.hidden = true; }, () => { it.hidden = false; });
  const turn = (away) => { Object.defineProperty(document, 'hidden', { configurable: true, get: () => away }), document.dispatchEvent(new Event('visibilitychange')); };
  await still(`() => (${turn})(true)`, `() => (${turn})(false)`);
});

test('who wants less motion sees the face at rest', async () => {
  const on = await open('ada');
  await drawn(on);
  const wanted = (less) => on.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: less ? 'reduce' : 'no-preference' }] });
  await wanted(true);
  await change(on, () => { it.clip = 'idle', it.playing = true; });
  await on.run(() => frames(30));
  await shows(on, ada());
  const before = await on.run(() => count('it'));
  await on.run(() => frames(30));
  assert.equal(await on.run(() => count('it')), before);
  await wanted(false);
  await drawn(on, 'it', before + 3);
});

test('a face that talks waits for no crowd', async () => {
  const on = await open('talk', { width: 1280, height: 1000 });
  await drawn(on);
  const waits = await on.run(async () => {
    const waits = [];
    for (let i = 0; i < 30; ++i) {
      const before = window.told.length, mine = count('it');
      it.pose = { visemes: { aa: (i % 10) / 10 } };
      while (count('it') === mine) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
      waits.push(window.told.slice(before).findIndex(({ id }) => id === 'it'));
    }
    return waits.sort((a, b) => a - b);
  });
  // Several pictures may be shown by one frame: those count, too.
  assert.ok(waits[15] <= 6 && waits[29] <= 20, `it waited for ${waits} others`);
  const others = await on.run(() => window.told.filter(({ id }) => id !== 'it').length);
  assert.ok(others > 20, 'and the crowd does not stand still');
});

test('a track that runs goes before a crowd that plays, and no longer than it runs', async () => {
  const on = await open('talk', { width: 1280, height: 1000 });
  await drawn(on);
  const speak = async (track) => {
    const before = await on.run((speech) => (Object.assign(it, { clip: ['idle'], playing: true, speech }), count('it')), track);
    await drawn(on, 'it', before + 2);  // it has begun
  };
  /** Of the next sixty pictures. */
  const its = () => on.run(async () => {
    const before = window.told.length, mine = count('it');
    while (window.told.length < before + 60) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
    return count('it') - mine;
  });
  await speak('long.tsv');
  const talking = await its();
  assert.ok(talking >= 15, `of 60 pictures ${talking} were its own`);
  await speak('hello.tsv');
  await on.run(() => new Promise((done) => setTimeout(done, 3000)));  // it ends long before
  const silent = await its();
  assert.ok(silent <= 4, `of 60 pictures after its track ${silent} were its own`);
  // While it talked, the other worker has read the crowd.
  const [both, first] = await on.run(() => [window.workers, window.askedOf.slice(-100).filter((which) => which === 0).length]);
  assert.ok(both === 1 || (first >= 20 && first <= 80), `of 100 pictures the first worker has drawn ${first}`);
});

test('who waits for the end of a track without a sound is told once', async () => {
  const on = await open('playing');
  await drawn(on);
  const ended = await on.run(async () => {
    const ended = [], begin = performance.now(), speak = async (speech) => {
      const before = count('it');
      it.speech = speech;
      while (count('it') < before + 2) await new Promise((done) => it.addEventListener('mien-drawn', done, { once: true }));
    };
    it.addEventListener('mien-ended', ({ detail }) => ended.push([detail.speech, performance.now() - begin]));
    await speak('long.tsv');  // another one takes its place, and nobody is told of it
    await speak('hello.tsv');
    await new Promise((done) => setTimeout(done, 2500));
    return ended;
  });
  assert.deepEqual(ended.map(([speech]) => speech), ['hello.tsv']);
  assert.ok(ended[0][1] > 1000 * AT_END, `after ${ended[0][1]} ms of a track of ${AT_END} s`);
});

test('a face that has talked has no turns to give back', async () => {
  const on = await open('talk', { width: 1280, height: 1000 });
  await on.until(() => new Set(window.told.map(({ id }) => id)).size > 120);  // both workers have read some
  const [talking, after] = await on.run(async () => {
    const wait = (ms) => new Promise((done) => setTimeout(done, ms)), before = count('it');
    Object.assign(it, { clip: ['idle'], playing: true, speech: 'long.tsv' });
    await wait(4000);
    it.speech = null;
    await wait(200);
    const then = count('it');
    await wait(2500);
    return [then - before, count('it') - then];
  });
  assert.ok(talking > 40 && after > 0, `of ${talking} pictures while it talked, ${after} came afterwards`);
});

test('a slow face has its turns in a crowd', async () => {
  const on = await open('slow', { width: 1280, height: 1000 });
  await drawn(on, 'slow', 2);
  const longest = await on.run(async () => {
    const gaps = [];
    for (let last = performance.now(); gaps.length < 4;) {
      await new Promise((done) => slow.addEventListener('mien-drawn', done, { once: true }));
      gaps.push(performance.now() - last), last = performance.now();
    }
    return [Math.max(...gaps), slow.cost];
  });
  assert.ok(longest[0] < 3000, `a picture of ${longest[1]} ms came once in ${longest[0]} ms`);
});

test('a track rests with its face, and tells its end when it has been spoken', async () => {
  const on = await open('playing');
  await drawn(on, 'it', 2);
  const [resting, ended, of] = await on.run(async (track) => {
    const wait = (ms) => new Promise((done) => setTimeout(done, ms)), ended = [];
    it.addEventListener('mien-ended', ({ detail }) => ended.push([detail.speech, performance.now()]));
    it.speak(track);
    await wait(300);
    it.playing = false;
    await wait(1500);
    const resting = ended.length, again = performance.now();
    it.playing = true;
    await wait(1500);
    return [resting, ended.map(([, at]) => at - again), ended.map(([of]) => of)];
  }, TRACK);
  assert.equal(resting, 0);
  assert.deepEqual(of, [null]);
  assert.ok(ended[0] > 800 && ended[0] < 1450, `it ended ${ended[0]} ms after it went on`);
});

test('a track ends for those who want less motion, too', async () => {
  const on = await open('playing');
  await drawn(on);
  await on.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  const [after, drawings] = await on.run(async (track) => {
    await new Promise((done) => setTimeout(done, 300));
    const begin = performance.now(), before = count('it');
    it.speak(track);
    await new Promise((done) => it.addEventListener('mien-ended', done, { once: true }));
    return [performance.now() - begin, count('it') - before];
  }, TRACK);
  assert.ok(after > 1000 && after < 4000, `it ended after ${after} ms`);
  assert.ok(drawings <= 2, `${drawings} pictures of a face at rest`);
});

test('a face that plays turns to an emotion in a moment, one at rest at once', async () => {
  const on = await open('playing');
  await drawn(on, 'it', 5);
  const felt = () => on.run(async () => {
    const felt = [];
    it.emotion = { joy: 0.8 };
    for (const begin = performance.now(); performance.now() - begin < 1000; await frames(1)) if (window.posed.emotions) felt.push(Number(window.posed.emotions.joy));
    return felt;
  });
  const seen = await felt();
  assert.ok(new Set(seen.filter((joy) => joy > 0 && joy < 0.8)).size >= 3 && seen.at(-1) === 0.8, `${seen}`);
  assert.ok(seen.every((joy, i) => i === 0 || joy >= seen[i - 1]), `${seen}`);
  await on.run(() => { it.playing = false, it.emotion = null; });
  await on.until(() => !window.posed.emotions);
  assert.deepEqual([...new Set(await felt())], [0.8]);
});

test('where pictures are rare the lids stay open, unless the page shuts them', async () => {
  const blinks = (on) => on.run(async () => {
    const found = new Set();
    for (const begin = performance.now(); performance.now() - begin < 1500; await frames(1)) found.add(String(window.posed.set?.blink));
    return [...found];
  });
  const one = await open('playing');
  await drawn(one, 'it', 10);
  assert.deepEqual(await blinks(one), ['undefined']);
  await one.run(() => Object.defineProperty(it, 'cost', { get: () => 600, set() {} }));  // as a slow face has
  await one.until(() => window.posed.set?.blink === 0);
  await one.run(() => { it.blink = 0.3; });
  await one.until(() => window.posed.set?.blink === '0.3');
});

test('what is refused of a face that plays is told once', async () => {
  const on = await open('playing');
  await drawn(on, 'it', 3);
  await on.run(() => { it.emotion = 'joyy=1'; });
  assert.equal((await sentence(on)).where, 'joyy=1', 'not as it is on its way');
  await on.run(() => new Promise((done) => setTimeout(done, 500)));
  assert.equal(await on.run(() => window.refused.length), 1);
  await on.run(() => { it.emotion = 'joyyy=1'; });
  await on.until(() => window.refused.length === 2);
});

test('pictures of a crowd that plays are shown together, and those of one face at once', async () => {
  /** How many frames of the page show the next pictures. */
  const shownIn = (on, count) => on.run(async (count) => {
    const before = putAt.length;
    while (putAt.length < before + count) await frames(1);
    return new Set(putAt.slice(before, before + count)).size;
  }, count);
  const crowd = await open('talk', { width: 1280, height: 1000 });
  await drawn(crowd);
  await crowd.run(() => new Promise((done) => setTimeout(done, 2000)));  // each has a rate
  const together = await shownIn(crowd, 100);
  assert.ok(together <= 40, `100 pictures of a crowd in ${together} frames`);
  const one = await open('playing');
  await drawn(one, 'it', 10);
  assert.equal(await shownIn(one, 20), 20);
});

test('a face that plays lives by its own clock while it speaks, and while its sound waits', async () => {
  const on = await open('speech');
  await on.run(() => { voice.currentTime = 0.2, it.clip = ['idle'], it.playing = true; });
  const moment = () => on.run(() => (window.posed.motions ? [window.posed.time, window.posed.time - window.posed.motions[0].begin] : null));
  await on.until(() => window.posed?.time > 0 && window.posed.motions);
  const [then, mouth] = await moment();
  await on.until((since) => window.posed.time > since + 0.5, then);
  const [, later] = await moment();
  assert.ok(Math.abs(mouth - 0.2) < 1e-9 && Math.abs(later - 0.2) < 1e-9, `the mouth is at ${mouth}, then at ${later}`);
  await on.run((track) => { it.sound = it.speech = null, it.speak(track, 0.4); }, TRACK);
  await on.until(() => Math.abs(window.posed.time - window.posed.motions?.[0].begin - 0.4) < 1e-9);
  await on.run(() => { it.speak(null), it.pose = { time: 7 }; });
  await on.until(() => window.posed.time === 7);  // who says the moment is heard, even of a face that plays
});

test('speech follows its sound, its time or a shape', async () => {
  const on = await open('speech');
  const at = (time) => ada({ motions: [TRACK], time });
  await drawn(on);
  for (const time of [AT_M, AT_AA]) {
    await on.run((to) => { voice.currentTime = to; }, time);
    await shows(on, at(time));
  }
  assert.notDeepEqual(at(AT_M), at(AT_AA));
  const before = await on.run(() => count('it'));
  await on.run(() => { voice.currentTime = 0; return voice.play(); });
  await drawn(on, 'it', before + 4);
  await on.until(() => voice.ended);
  await on.run(() => { it.sound = null, it.time = 0.5; });
  await shows(on, at(AT_AA));
  await on.run(() => { it.speech = null, it.time = null, it.viseme = { aa: 1, PP: 0.5 }; });
  await shows(on, ada({ visemes: { aa: 1, PP: 0.5 } }));
  await on.run(() => { refused.length = 0, it.speech = 'nothing.tsv'; });
  assert.deepEqual(await sentence(on), { id: 'it', where: 'nothing.tsv', what: 'cannot be fetched: 404' });
  await on.run(() => { refused.length = 0, it.sound = 'no one'; });
  assert.deepEqual(await sentence(on), { id: 'it', where: 'sound', what: 'nothing here has the id "no one"' });
});

test('without a sound speech begins when it is set, on a face that plays', async () => {
  const on = await open('playing'), begun = () => on.run(async () => {
    const before = count('it'), since = window.posed.time;
    it.speech = 'hello.tsv';
    while (count('it') < before + 3) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
    return { since, begin: window.posed.motions?.[0].begin, time: window.posed.time };
  });
  await on.until(() => window.posed?.time > 0.6);
  const first = await begun();
  assert.ok(first.begin >= first.since && first.begin < first.time, `set at ${first.since}, it begins at ${first.begin} where ${first.time} is now`);
  await on.until((from) => window.posed.time > from + 0.6, first.begin);
  const again = await begun();
  assert.ok(again.begin >= again.since, 'again when it is set again');
  await on.run(() => { it.speech = null; });
  await on.until(() => window.posed.motions === undefined);
});

test('faces that are there play while the page fills', async () => {
  const on = await open('talk');
  await on.until(() => Array.from({ length: 120 }, (_, i) => count(`f${i}`)).every((n) => n > 0));
  const [early, late] = await on.run(() => [0, 100].map((from) => Array.from({ length: 20 }, (_, i) => count(`f${from + i}`)).reduce((a, b) => a + b)));
  assert.ok(early > late + 10, `the first twenty had ${early} pictures, the last ${late}`);
});

test('a face that speaks and follows by methods shows that', async () => {
  const on = await open('ada');
  await drawn(on);
  await change(on, (track) => it.speak(track, 0.2), TRACK);
  await shows(on, ada({ motions: [TRACK], time: AT_M }));
  const seen = { faceBlendshapes: [{ categories: [{ categoryName: '_neutral', score: 0.9 }, { categoryName: 'jawOpen', score: 0.7 }] }] };
  await change(on, (result) => it.follow(result), seen);
  await shows(on, ada({ arkit: { jawOpen: 0.7 } }));
  await change(on, () => it.follow(null));
  await shows(on, ada());
});

test('of many changes the newest is drawn', async () => {
  const on = await open('ada');
  await drawn(on);
  const before = await on.run(() => count('it'));
  await on.run(async () => { for (let i = 1; i <= 200; ++i) it.emotion = { joy: i / 200 }, i % 10 || await new Promise((done) => setTimeout(done)); });
  await shows(on, ada({ emotions: { joy: 1 } }));
  assert.ok(await on.run(() => count('it')) - before <= 25);
});

test('a neutral face is that of the neutral code', async () => {
  const on = await open('ada');
  await drawn(on);
  const before = await shown(on), code = mien.neutral(mien.code('ada'));
  await change(on, () => { it.neutral = true; });
  const neutral = await shown(on);
  assert.notDeepEqual(neutral, before);
  await change(on, (calm) => { it.neutral = null, it.seed = null, it.code = calm; }, code);
  assert.deepEqual(await shown(on), neutral);
});

test('a seed is a person, and so is a long one; an empty one is refused', async () => {
  const on = await open('ada');
  await drawn(on);
  await shows(on, ada());
  await change(on, () => { it.seed = 'ä'.repeat(1e6); });
  await shows(on, picture(mien.person(mien.code('ä'.repeat(1e6)))));
  const empty = await open('nothing');
  assert.deepEqual(await sentence(empty), { id: 'it', where: 'seed', what: 'expected a word, got none' });
});

test('style, blink and look-at are attributes and properties', async () => {
  const on = await open('ada');
  await drawn(on);
  await change(on, () => it.setAttribute('face-style', 'ink'));
  await shows(on, ada({}, { style: 'ink' }));
  await change(on, () => { it.faceStyle = null, it.blink = 0.5; });
  await shows(on, ada({ set: { blink: 0.5 } }));
  await change(on, () => { it.setAttribute('blink', ''); });
  await shows(on, ada({ set: { blink: 1 } }));
  await change(on, () => { it.blink = undefined, it.lookAt = [-3, 1, 2]; });
  await shows(on, ada({ lookAt: [-3, 1, 2] }));
  assert.equal(await on.run(() => it.getAttribute('look-at')), '-3, 1, 2');
  await change(on, () => { it.lookAt = null, it.emotion = { joy: 1, 'left.surprise': 0.5 }, it.set = { 'gaze.x': 0.02 }, it.background = '#102030'; });
  await shows(on, ada({ emotions: { joy: 1, 'left.surprise': 0.5 }, set: { 'gaze.x': 0.02 }, background: '#102030' }));
  assert.equal(await on.run(() => `${it.emotion}|${it.playing}|${it.code}|${it.style.color}`), 'joy=1, left.surprise=0.5|false|null|');
  await on.run(() => { it.faceStyle = 'inkk'; });
  assert.match((await sentence(on)).what, /did you mean "ink"/);
  const file = await open('file');
  assert.match((await sentence(file)).what, /only recipes/);
});

test('properties that were set before the element was known count', async () => {
  const on = await open('early');
  await drawn(on);
  await shows(on, ada({ emotions: { joy: 1 } }));
});

test('what a pose does not know is refused', async () => {
  const on = await open('ada');
  await drawn(on);
  for (const [pose, where, what] of [[{ emotion: { joy: 1 } }, 'pose.emotion', /did you mean "emotions"/], [{ clips: 'idle' }, 'pose.clips', /a list/], [{ emotions: 'joy' }, 'pose.emotions', /weights/]]) {
    const before = await on.run((given) => { const before = refused.length; it.pose = given; return before; }, pose);
    const said = await on.until((from) => refused[from], before);
    assert.equal(said.where, where);
    assert.match(said.what, what);
  }
  await on.run(() => { refused.length = 0, it.pose = { then: () => {} }; });
  assert.match((await sentence(on)).what, /clone/);
  await change(on, () => { it.pose = null; });
  await shows(on, ada());
  for (const [name, value] of [['width', 'wide'], ['width', '-3'], ['look-at', '1, 2'], ['time', 'now']]) {
    await on.run((key, said) => { refused.length = 0, it.setAttribute(key, said); }, name, value);
    assert.ok((await sentence(on)).what.length > 10);
    await change(on, (key) => { it.setAttribute('width', 72), key === 'width' || it.removeAttribute(key); }, name);
  }
});

test('the element comes from another origin', async () => {
  const far = await serve(built, {}, { 'Access-Control-Allow-Origin': '*' });
  const near = await serve(built, { '/far.html': page('<mien-face id="it" seed="ada" width="72" height="72"></mien-face>', far.url) });
  const on = await browser.open(`${near.url}/far.html`);
  await drawn(on);
  await shows(on, ada());
  assert.deepEqual(near.asked.filter((path) => /js|wasm/.test(path)), []);
  assert.deepEqual(on.faults, []);
  await near.close(), await far.close();
});

test('a worker that cannot be started is refused, for each face once, and tried again when it is asked for', async () => {
  for (const elsewhere of [false, true]) {
    const changed = { ...pages, '/worker.js': null, '/other.html': page(faces(5)) };
    const far = await serve(built, changed, { 'Access-Control-Allow-Origin': '*' });
    const near = await serve(built, { '/other.html': page(faces(5), elsewhere ? far.url : '.'), '/worker.js': null });
    const on = await browser.open(`${near.url}/other.html`);
    await on.until(() => window.refused.length >= 5);
    await on.run(() => frames(60));
    const all = await on.run(() => window.refused);
    assert.equal(all.length, 5);
    for (const { where, what } of all) assert.match(where, /worker\.js$/), assert.match(what, /cannot be started/);
    await near.close(), await far.close();
  }
  const changed = { ...pages, '/worker.js': null }, late = await serve(built, changed);
  const on = await browser.open(`${late.url}/ada.html`);
  await sentence(on);
  delete changed['/worker.js'];
  await on.run(() => it.redraw());
  await drawn(on);
  await shows(on, ada());
  await late.close();
});

test('a picture that takes longer than its deadline is refused, and the others are drawn', async () => {
  const on = await open('spikes');
  await drawn(on);
  await shows(on, ada());
  await on.until(() => window.refused.length > 0);
  assert.deepEqual(await on.run(() => window.refused), [{ id: 'spikes', where: 'deadline', what: 'drawing took longer than 200 ms' }]);
  const workers = await on.run(() => window.workers);
  assert.ok(workers <= await on.run(() => navigator.hardwareConcurrency), 'the worker ends the drawing itself');
  await on.run(() => { refused.length = 0, it.setAttribute('deadline', 'soon'); });
  assert.equal((await sentence(on)).what, 'expected milliseconds above 0');
  await change(on, () => { it.deadline = null; });
});

test('a worker that does not end is replaced', async () => {
  const worker = `import './its_worker.js';
    const its = onmessage;
    onmessage = (event) => { while (event.data.source?.seed === 'endless'); its(event); };`;
  const its = await serve(built, { ...pages, '/worker.js': worker, '/its_worker.js': readFileSync(`${built}/worker.js`, 'utf8') });
  const on = await browser.open(`${its.url}/endless.html`);
  await drawn(on, 'endless'), await drawn(on);
  const workers = await on.run(() => window.workers);
  await on.run(() => { endless.deadline = 300, endless.seed = 'endless'; });
  await on.until(() => window.refused.length > 0);
  assert.deepEqual(await on.run(() => window.refused), [{ id: 'endless', where: 'deadline', what: 'drawing took longer than 300 ms' }]);
  await change(on, () => { it.blink = 1; });
  await shows(on, ada({ set: { blink: 1 } }));
  await on.run(() => { endless.deadline = null, endless.seed = 'bob'; });
  await shows(on, picture(mien.person(mien.code('bob'))), 'endless');
  assert.equal(await on.run(() => window.workers), workers + 1);
  await its.close();
});

test('faces may go, come back and become others while they are drawn', async () => {
  const on = await open('crowd', { width: 1280, height: 1000 });
  await on.until(() => window.told.length >= 3);
  await on.run(async () => {
    const all = [...document.querySelectorAll('mien-face')];
    for (const [i, face] of all.entries()) {
      if (i % 4 === 0) face.remove();
      if (i % 4 === 1) face.remove(), await 0, crowd.append(face);
      if (i % 4 === 2) face.seed = 'ada';
      if (i % 20 === 0) await new Promise((done) => setTimeout(done, 5));
    }
    window.told = [];
  });
  await on.until(() => [...document.querySelectorAll('mien-face')].every((face) => !empty(face)));
  await on.run(() => frames(10));
  await shows(on, ada(), 'f2');
  await shows(on, ada(), 'f198');
  await shows(on, picture(mien.person(mien.code('person 197'))), 'f197');
  assert.ok((await on.run(() => window.told.map(({ id }) => Number(id.slice(1))))).every((i) => i % 4 !== 0));
  assert.deepEqual(await on.run(() => window.refused), []);
  assert.deepEqual(on.faults, []);
});

test('a face that becomes another while it is drawn shows and tells nothing of the old one', async () => {
  const on = await open('bare');
  const asked = await on.run(async () => {
    const asked = [], { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message) {
      postMessage.call(this, message);
      if (message.begin) return;
      asked.push(message.source?.seed ?? message.source?.code);
      if (asked.at(-1) === 'bob') it.seed = null, it.code = 'nobody';
      if (asked.at(-1) === 'nobody') it.code = null, it.seed = 'ada';
    };
    it.seed = 'bob';
    await new Promise((done) => it.addEventListener('mien-drawn', done, { once: true }));
    return asked;
  });
  assert.deepEqual(asked, ['bob', 'nobody', 'ada']);
  assert.equal(Buffer.compare(await shown(on), Buffer.from(ada())), 0);
  assert.deepEqual(await on.run(() => window.refused), []);
});

test('ten thousand faces in one page: those in view are drawn, and the page answers', async () => {
  const on = await open('many');
  const longest = await on.run(async () => {
    for (let i = 0; i < 10000; ++i) crowd.append(Object.assign(document.createElement('mien-face'), { id: `f${i}`, seed: i, width: 72, height: 72 }));
    await frames(3);
    let longest = 0, last = performance.now();
    const beat = setInterval(() => { longest = Math.max(longest, performance.now() - last), last = performance.now(); }, 20);
    while (!window.told.some(({ id }) => id === 'f20')) await frames(1);
    clearInterval(beat);
    return longest;
  });
  assert.ok(longest < 3000, `the page stood still for ${longest} ms`);
  await on.run(() => { crowd.replaceChildren(); });
  await on.run(() => frames(10));
  assert.ok(await on.run(() => window.told.length) < 400);
  assert.deepEqual(on.faults, []);
});

test('faces of one file fetch it once, when they are near', async () => {
  const face = '<mien-face src="toon.face.json" width="72" height="72"></mien-face>';
  const own = await serve(built, { ...pages, '/three.html': page(`${face.repeat(3)}<div style="height: 4000px"></div><mien-face id="far" src="far.face.json" width="72" height="72"></mien-face>`), '/far.face.json': toon });
  const on = await browser.open(`${own.url}/three.html`);
  await on.until(() => window.told.length >= 3);
  await on.run(() => frames(30));
  assert.deepEqual(own.asked.filter((path) => path.endsWith('.json')), ['/toon.face.json']);
  await on.run(() => scrollTo(0, 4000));
  await drawn(on, 'far');
  await own.close();
});

test('faces that the worker has put away are read again', async () => {
  const on = await open('many');
  await on.run(() => { for (let i = 0; i < 300; ++i) crowd.append(Object.assign(document.createElement('mien-face'), { id: `f${i}`, seed: `person ${i}`, width: 24, height: 24 })); });
  await on.until(() => window.told.length >= 300);
  const first = await on.run(() => window.told[0].id), word = `person ${first.slice(1)}`;
  await on.run((id) => { document.getElementById(id).width = 72, document.getElementById(id).height = 72; }, first);
  await shows(on, picture(mien.person(mien.code(word))), first);
  assert.deepEqual(await on.run(() => window.refused), []);
});

test('a page may import the element twice', async () => {
  const on = await open('ada');
  await drawn(on);
  assert.ok(await on.run(async () => (await import('./element.js?again')).MienFace === customElements.get('mien-face')));
  assert.deepEqual(on.faults, []);
});
