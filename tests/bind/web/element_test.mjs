// node --test element_test.mjs: what a <mien-face> shows, and what is refused, in headless Chromium.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { ada, browser, built, change, drawn, faces, mien, open, page, pages, picture, sentence, shown, shows } from './element_pages.mjs';
import { serve } from './static_server.mjs';

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

test('a page may import the element twice', async () => {
  const on = await open('ada');
  await drawn(on);
  assert.ok(await on.run(async () => (await import('./element.js?again')).MienFace === customElements.get('mien-face')));
  assert.deepEqual(on.faults, []);
});
