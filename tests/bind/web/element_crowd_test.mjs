// node --test element_crowd_test.mjs: many <mien-face> in one page: which are drawn, and when, in headless Chromium.
import assert from 'node:assert/strict';
import test from 'node:test';
import { ada, browser, built, drawn, faces, mien, open, page, pages, picture, server, shown, shows, toon } from './element_pages.mjs';
import { pngPixels } from './png_pixels.mjs';
import { serve } from './static_server.mjs';

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

test('faces that are there play while the page fills', async () => {
  const on = await open('talk');
  await on.until(() => Array.from({ length: 120 }, (_, i) => count(`f${i}`)).every((n) => n > 0));
  const [early, late] = await on.run(() => [0, 100].map((from) => Array.from({ length: 20 }, (_, i) => count(`f${from + i}`)).reduce((a, b) => a + b)));
  assert.ok(early > late + 10, `the first twenty had ${early} pictures, the last ${late}`);
});

test('of many changes the newest is drawn', async () => {
  const on = await open('ada');
  await drawn(on);
  const before = await on.run(() => count('it'));
  await on.run(async () => { for (let i = 1; i <= 200; ++i) it.emotion = { joy: i / 200 }, i % 10 || await new Promise((done) => setTimeout(done)); });
  await shows(on, ada({ emotions: { joy: 1 } }));
  assert.ok(await on.run(() => count('it')) - before <= 25);
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
