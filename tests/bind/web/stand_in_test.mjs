// node --test stand_in_test.mjs: what <mien-face> is to those who hear the page, what stands in it until its first picture, the
// workers of a crowd, and what happens where memory or workers are refused; in headless Chromium.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test, { after, afterEach } from 'node:test';
import { browse } from './chromium.mjs';
import { serve } from './static_server.mjs';

const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
const { load } = await import(`file://${built}/mien.js`), { describe } = await import(`file://${built}/describe.js`), { svg } = await import(`file://${built}/svg.js`);
const mien = await load(readFileSync(`${built}/mien.wasm`)), recipe = (word) => mien.recipe(mien.code(word));
const toon = readFileSync(new URL('../../../faces/compat/toon.face.json', import.meta.url), 'utf8');
const picture = await svg({ seed: 'ada' }, { width: 72, height: 72 });

const WATCH = `<script>
  window.told = [], window.refused = [], window.workers = 0, window.longest = 0;
  window.Worker = class extends Worker { constructor(...given) { super(...given), ++window.workers; } };
  addEventListener('mien-drawn', ({ target }) => told.push({ id: target.id, at: performance.now() }));
  addEventListener('mien-refused', ({ target, detail }) => refused.push({ id: target.id, ...detail }));
  let last = performance.now();
  setInterval(() => { longest = Math.max(longest, performance.now() - last), last = performance.now(); }, 10);
</script><style>body { margin: 0 } #crowd { display: grid; grid-template-columns: repeat(auto-fill, 72px); gap: 4px }</style>`;
const page = (body) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>faces</title>${WATCH}<script type="module" src="element.js"></script>${body}`;
const face = (attributes, inside = '') => `<mien-face id="it" width="72" height="72" ${attributes}>${inside}</mien-face>`;
const crowd = (count, more) => page(`<div id="crowd">${Array.from({ length: count }, (_, i) => `<mien-face id="f${i}" seed="person ${i}" width="72" height="72" ${more}></mien-face>`).join('')}</div>`);
const pages = {
  '/ada.html': page(face('seed="ada"')), '/named.html': page(face('seed="ada" alt="Ada"')), '/mute.html': page(face('seed="ada" alt=""')),
  '/own.html': page(face('seed="ada" aria-label="mine" role="figure"')), '/toon.html': page(face('src="toon.face.json"')), '/toon.face.json': toon,
  '/pausable.html': page(face('seed="ada" alt="Ada" clip="idle" playing pausable')), '/wrong.html': page(face('code="nobody"')), '/misspelt.html': page(face('seed="ada" emotoin="joy=1"')),
  '/svg.html': page(face('seed="ada"', picture)), '/img.html': page(face('seed="ada"', '<img src="ada.svg" alt="Ada, drawn" width="72" height="72">')), '/ada.svg': picture,
  '/stays.html': page(face('code="nobody"', picture)), '/crowd.html': crowd(200, 'deadline="100000"'), '/playing.html': crowd(200, 'clip="idle" playing deadline="100000"'),
};
const server = await serve(built, pages);
const browser = await browse();
afterEach(() => browser.closePages());
after(async () => { await browser.close(); await server.close(); });
const open = (name, options, at = server) => browser.open(`${at.url}/${name}.html`, options);
async function drawn(on, least = 1) {
  const said = await on.until((count) => (window.told.length >= count ? 'drawn' : window.refused.find(({ where }) => where !== 'emotoin')?.what), least);
  assert.equal(said, 'drawn');
}

/** What a screen reader is told of the elements with a role of a picture, a figure or a status. */
async function heard(on) {
  const { nodes } = await on.send('Accessibility.getFullAXTree', {});
  return nodes.filter(({ ignored, role }) => !ignored && ['image', 'img', 'figure', 'status'].includes(role?.value)).map(({ role, name }) => ({ role: role.value.replace('img', 'image'), name: name?.value ?? '' }));
}
const hears = async (name) => { const on = await open(name); await drawn(on); return heard(on); };

test('a neutral picture is that of the neutral code', async () => {
  const how = { width: 72, height: 72 }, calm = mien.neutral(mien.code('ada'));
  assert.equal(await svg({ seed: 'ada' }, { ...how, neutral: true }), await svg(calm, how));
  assert.notEqual(await svg(calm, how), picture);
});

test('who hears the page is told what the face looks like', async () => {
  const on = await open('ada');
  await drawn(on);
  assert.deepEqual(await heard(on), [{ role: 'image', name: describe(recipe('ada')) }]);
  await on.run(() => { told.length = 0, it.emotion = { anger: 1 }; });
  await drawn(on);
  const angry = describe(recipe('ada'), { emotions: { anger: 1 } });
  assert.match(angry, /^an angry/);
  assert.deepEqual(await heard(on), [{ role: 'image', name: angry }]);
  await on.run(() => { told.length = 0, it.emotion = null, it.seed = 'bob'; });
  await drawn(on);
  assert.deepEqual(await heard(on), [{ role: 'image', name: describe(recipe('bob')) }]);
  assert.deepEqual(await hears('toon'), [{ role: 'image', name: describe(toon) }]);
});

test('a page says something else, or that the face only decorates', async () => {
  assert.deepEqual(await hears('named'), [{ role: 'image', name: 'Ada' }]);
  assert.deepEqual(await hears('mute'), []);
  assert.deepEqual(await hears('own'), [{ role: 'figure', name: 'mine' }]);
  assert.deepEqual(await hears('img'), [{ role: 'image', name: 'Ada, drawn' }]);
});

test('a face that plays is stopped and started by the keyboard, for those, too, who want less motion', async () => {
  const on = await open('pausable');
  const wait = () => on.run(() => new Promise((done) => setTimeout(done, 500)));
  const still = async () => { await wait(), await on.run(() => { told.length = 0; }), await wait(); return await on.run(() => told.length) === 0; };
  const pressed = async () => (await on.send('Accessibility.getFullAXTree', {})).nodes.find(({ role }) => role?.value === 'button' || role?.value === 'toggleButton' || role?.value === 'ToggleButton')?.properties.find(({ name }) => name === 'pressed').value.value;
  await drawn(on, 3);
  assert.equal(await pressed(), 'true');
  await on.press('Tab');
  assert.ok(await on.run(() => document.activeElement === it));
  await on.press(' ', 'Space');
  assert.deepEqual([await on.run(() => it.playing), await still(), await pressed()], [false, true, 'false']);
  await on.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  await on.press('Enter');
  await on.run(() => { told.length = 0; });
  await drawn(on, 3);
  await on.press('Enter');
  assert.ok(await still());
});

test('a sentence is heard where there is no picture', async () => {
  const on = await open('wrong');
  await on.until(() => window.refused.length);
  const { nodes } = await on.send('Accessibility.getFullAXTree', {});
  assert.ok(nodes.some(({ ignored, role, name }) => !ignored && role.value === 'StaticText' && /nobody/.test(name.value)));
});

test('an attribute that is misspelt is refused, and the face is drawn', async () => {
  const on = await open('misspelt');
  await drawn(on);
  assert.deepEqual(await on.run(() => window.refused), [{ id: 'it', where: 'emotoin', what: 'there is no such attribute; did you mean "emotion"?' }]);
});

test('what stands in the element gives way to the first picture in one step, and nothing moves', async () => {
  for (const name of ['svg', 'img']) {
    const on = await open(name, { first: `addEventListener('DOMContentLoaded', () => {
      window.seen = [];
      (function look() {
        const [stand, canvas] = [it.firstElementChild, it.shadowRoot?.querySelector('canvas')].map((one) => Boolean(one?.checkVisibility()));
        const { x, y, width, height } = it.getBoundingClientRect(), box = [x, y, width, height].map(Math.round).join();
        seen.push({ stand, canvas, box });
        requestAnimationFrame(look);
      })();
    })` });
    await drawn(on);
    const seen = await on.run(() => window.seen);
    assert.ok(seen.every(({ stand, canvas }) => stand !== canvas), `${name}: one of the two is seen, and never both`);
    assert.ok(seen[0].stand && seen.at(-1).canvas);
    assert.deepEqual([...new Set(seen.map(({ box }) => box))], ['0,0,72,72']);
    assert.deepEqual(on.faults, []);
  }
});

test('what stands in the element stays where no picture can be drawn', async () => {
  const on = await open('stays');
  await on.until(() => window.refused.length);
  assert.deepEqual(await on.run(() => [it.firstElementChild.checkVisibility(), it.shadowRoot.querySelector('canvas').checkVisibility(), it.shadowRoot.querySelector('p').textContent]), [true, false, '']);
});

test('a crowd is drawn by as many workers as there are cores, and one face by one', async () => {
  const on = await open('crowd', { height: 1000, first: "Object.defineProperty(navigator, 'hardwareConcurrency', { value: 3 })" });
  await drawn(on, 200);
  assert.equal(await on.run(() => window.workers), 3);
  assert.deepEqual(await on.run(() => window.refused), []);
  const alone = await open('ada', { first: "Object.defineProperty(navigator, 'hardwareConcurrency', { value: 3 })" });
  await drawn(alone);
  await alone.run(async () => { for (let i = 1; i <= 20; ++i) it.blink = i / 20, await new Promise((done) => setTimeout(done, 20)); });
  assert.equal(await alone.run(() => window.workers), 1);
});

test('a talking face waits for none of two hundred that play', async () => {
  const on = await open('playing', { height: 1000, first: "Object.defineProperty(navigator, 'hardwareConcurrency', { value: 2 })" });
  await drawn(on, 200);
  const between = await on.run(async () => {
    const between = [], face = document.getElementById('f7');
    face.playing = false;
    for (let i = 0; i < 30; ++i) {
      const from = told.length;
      face.viseme = { aa: (i % 10) / 10 };
      while (!told.slice(from).some(({ id }) => id === 'f7')) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
      between.push(told.slice(from).findIndex(({ id }) => id === 'f7'));
    }
    return between.sort((a, b) => a - b);
  });
  assert.ok(between[15] <= 12, `pictures of others before its own: ${between}`);
});

test('where memory is refused, the page says so, and fewer workers do', async () => {
  const refusing = "WebAssembly.instantiate = () => Promise.reject(new RangeError('WebAssembly.instantiate(): Out of memory: Cannot allocate Wasm memory for new instance'));\n";
  const none = await serve(built, { ...pages, '/worker.js': (text) => refusing + text });
  const on = await open('ada', {}, none);
  assert.match(await on.until(() => it.shadowRoot.querySelector('p').textContent), /mien\.wasm: cannot be started: .*memory/);
  await none.close();
  const fewer = await serve(built, { ...pages, '/worker.js': (text) => text.replace('await compile(given)', "await compile(given).then((made) => { if (given) throw new RangeError('out of memory'); return made; })") });
  const crowded = await open('crowd', { height: 1000, first: "Object.defineProperty(navigator, 'hardwareConcurrency', { value: 4 })" }, fewer);
  await drawn(crowded, 200);
  assert.deepEqual(await crowded.run(() => window.refused), []);
  assert.equal(await crowded.run(() => window.workers), 4, 'each is tried once');
  await fewer.close();
});
