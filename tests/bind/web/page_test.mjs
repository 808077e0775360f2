// node --test page_test.mjs: <mien-face> in headless Chromium, over the package that tools/portable web makes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test, { after, afterEach } from 'node:test';
import { browse } from './chromium.mjs';
import { pictureHashes } from './picture_hashes.mjs';
import { serve } from './static_server.mjs';

const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
const root = new URL('../../../', import.meta.url);
const face = (name) => readFileSync(new URL(`faces/compat/${name}.face.json`, root), 'utf8');
const page = (body) => `<!doctype html><meta charset="utf-8"><script type="module" src="element.js"></script>${body}`;
const pages = {
  '/one.html': page('<mien-face src="toon.face.json" width="160" height="90" time="1.25"></mien-face>'),
  '/code.html': page('<mien-face code="AW506-TPRCQ-A1" width="96" height="54" time="1.25"></mien-face>'),
  '/wrong.html': page('<mien-face code="ZZZZZ-ZZZZZ-ZZ" width="96" height="54"></mien-face>'),
  '/toon.face.json': face('toon'), '/clay.face.json': face('clay'), '/broken.face.json': '{"format": "mien-fac"}',
};
/** A page of examples/, with the package beside it. */
const example = (name) => readFileSync(new URL(`examples/${name}`, root), 'utf8').replaceAll('mien/element.js', '/element.js');

// What FaceLandmarker gives for a face with its mouth open that looks 30 degrees to its left, then for none.
const SEEN = { faceLandmarks: [[{ x: 0.5, y: 0.5, z: 0 }]],
  faceBlendshapes: [{ categories: [['_neutral', 0.01], ['jawOpen', 0.7], ['eyeBlinkLeft', 0.9], ['mouthSmileRight', 0.4]].map(([categoryName, score], index) => ({ index, score, categoryName, displayName: '' })), headIndex: -1, headName: '' }],
  facialTransformationMatrixes: [{ rows: 4, columns: 4, data: [0.8660254, 0, -0.5, 0, 0, 1, 0, 0, 0.5, 0, 0.8660254, 0, 1, 2, -40, 1] }] };
const VISION = `
  export const FilesetResolver = { forVisionTasks: async (folder) => folder };
  export const FaceLandmarker = { async createFromOptions(fileset, options) {
    window.asked = { fileset, ...options };
    let frames = 0;
    return { detectForVideo: (video, at) => { window.looked = ++frames; return frames > 3 ? { faceLandmarks: [], faceBlendshapes: [], facialTransformationMatrixes: [] } : ${JSON.stringify(SEEN)}; } };
  } };`;
Object.assign(pages, { '/camera/index.html': example('camera/index.html'), '/camera/mediapipe/vision_bundle.mjs': VISION,
  '/camera/still.html': page('<mien-face seed="ada" width="320" height="320"></mien-face>').replace('"element.js"', '"/element.js"'),
  '/talk/index.html': example('talk/index.html'), '/talk/hello.TextGrid': example('talk/hello.TextGrid') });
const server = await serve(built, pages);
const browser = await browse();
afterEach(() => browser.closePages());
after(async () => { await browser.close(); await server.close(); });

/** The bytes that a page's only face shows, or those of the one that a selector finds. */
const shown = async (on, which = 'mien-face') => Uint8Array.from(await on.run(async (selector) => {
  const { shadowRoot } = document.querySelector(selector), from = shadowRoot.querySelector('canvas');
  const into = Object.assign(document.createElement('canvas'), { width: from.width, height: from.height }).getContext('2d');
  into.drawImage(from, 0, 0);
  return Array.from(into.getImageData(0, 0, from.width, from.height).data);
}, which));

/** Waits until the face shows what is asked for: a worker's picture reaches the page a little after it is told. */
async function shows(on, wanted, said) {
  for (let i = 0; i < 100; ++i, await new Promise((done) => setTimeout(done, 100))) if (wanted(await shown(on))) return;
  assert.fail(`it does not show ${said}`);
}
const sameAs = (bytes) => (now) => Buffer.compare(Buffer.from(now), Buffer.from(bytes)) === 0;
const otherThan = (bytes) => (now) => !sameAs(bytes)(now);
const hashed = (hash) => (now) => hashes.of(now) === hash;

/** Does something to the face and waits for the event; returns its detail. */
const then = (on, name, change, ...args) => on.run(`async (name, ...args) => {
  const face = document.querySelector('mien-face');
  const told = new Promise((done) => face.addEventListener(name, ({ detail }) => done(detail), { once: true }));
  (${change})(face, ...args);
  return Promise.race([told, new Promise((done) => setTimeout(() => done(null), 60000))]);
}`, name, ...args);
const drawn = (on) => on.until(() => {
  const face = document.querySelector('mien-face');
  if (face.dataset.watched === undefined) face.dataset.watched = '', face.addEventListener('mien-drawn', () => { face.dataset.drawn = ''; }), face.redraw();
  return face.dataset.drawn !== undefined;
});
const hashes = pictureHashes();

test('a face is drawn with the bytes of a machine without fused multiply-adds', async () => {
  const on = await browser.open(`${server.url}/one.html`);
  await drawn(on);
  await shows(on, hashed(hashes.told('toon', 160, 'linear')), 'these bytes');
  const told = await then(on, 'mien-drawn', (face) => face.setAttribute('src', 'clay.face.json'));
  assert.ok(told.ms > 0);
  await shows(on, hashed(hashes.told('clay', 160, 'linear')), 'these bytes');
  assert.deepEqual(on.faults, []);
});

test('a person is drawn with these bytes, at the pixels of the display', async () => {
  const on = await browser.open(`${server.url}/code.html`);
  await drawn(on);
  await shows(on, hashed(hashes.told('AW506-TPRCQ-A1', 96, 'linear')), 'these bytes');
  const fine = await browser.open(`${server.url}/code.html`, { dots: 2 });
  await drawn(fine);
  await shows(fine, (now) => now.length === 192 * 108 * 4, 'twice the pixels');
  assert.equal(await fine.run(() => document.querySelector('mien-face').getBoundingClientRect().width), 96);
});

test('emotions move the picture, and rest is rest again', async () => {
  const on = await browser.open(`${server.url}/code.html`);
  await drawn(on);
  await shows(on, hashed(hashes.told('AW506-TPRCQ-A1', 96, 'linear')), 'these bytes');
  const rest = await shown(on);
  await then(on, 'mien-drawn', (face) => face.setAttribute('emotion', 'joy=1'));
  await shows(on, otherThan(rest), 'something else');
  await then(on, 'mien-drawn', (face) => face.removeAttribute('emotion'));
  await shows(on, sameAs(rest), 'the same');
  await then(on, 'mien-drawn', (face) => { face.pose = { lookAt: [-3, 1, 2] }; });
  await shows(on, otherThan(rest), 'something else');
});

test('clips play while the page stays awake', async () => {
  const on = await browser.open(`${server.url}/code.html`);
  await drawn(on);
  const frames = await on.run(() => new Promise((done) => {
    const face = document.querySelector('mien-face');
    let count = 0;
    face.addEventListener('mien-drawn', () => { if (++count === 5) done(count); });
    face.removeAttribute('time'), face.setAttribute('playing', '');
  }));
  assert.equal(frames, 5);
});

test('an unknown code is a sentence, and the old face stays', async () => {
  const on = await browser.open(`${server.url}/code.html`);
  await drawn(on);
  await shows(on, hashed(hashes.told('AW506-TPRCQ-A1', 96, 'linear')), 'these bytes');
  const before = await shown(on);
  const said = await then(on, 'mien-refused', (face) => face.setAttribute('code', 'AW506-TPRCQ-A2'));
  assert.match(said.where + said.what, /AW506-TPRCQ-A2/);
  assert.ok(said.what.length > 10);
  const name = await then(on, 'mien-refused', (face) => { face.removeAttribute('code'), face.setAttribute('src', 'broken.face.json'); });
  assert.match(name.where, /^broken\.face\.json:1/);
  const gone = await then(on, 'mien-refused', (face) => face.setAttribute('src', 'nowhere.face.json'));
  assert.match(gone.what, /404/);
  const setting = await then(on, 'mien-refused', (face) => face.setAttribute('set', 'gaze.z=1'));
  assert.match(setting.what, /did you mean "gaze\.x"/);
  await shows(on, sameAs(before), 'the same');
});

test('where nothing was drawn yet, the sentence stands in the page', async () => {
  const on = await browser.open(`${server.url}/wrong.html`);
  const said = await on.until(() => document.querySelector('mien-face').shadowRoot.querySelector('[role=status]').textContent);
  assert.match(said, /ZZZZZ-ZZZZZ-ZZ/);
  await then(on, 'mien-drawn', (face) => face.setAttribute('code', 'AW506-TPRCQ-A1'));
  assert.equal(await on.run(() => document.querySelector('mien-face').shadowRoot.querySelector('[role=status]').textContent), '');
});

test('a face that is taken out and put back is drawn again; one that is moved keeps its picture', async () => {
  const on = await browser.open(`${server.url}/code.html`);
  await drawn(on);
  await shows(on, hashed(hashes.told('AW506-TPRCQ-A1', 96, 'linear')), 'these bytes');
  const before = await shown(on);
  await on.run(() => { document.body.append(document.querySelector('mien-face')); });
  await shows(on, sameAs(before), 'the same');
  await on.run(async () => { window.kept = document.querySelector('mien-face'); window.kept.remove(); await new Promise((done) => setTimeout(done, 50)); });
  await on.run(() => new Promise((done) => { window.kept.addEventListener('mien-drawn', done, { once: true }); document.body.append(window.kept); }));
  await shows(on, sameAs(before), 'the same');
  assert.deepEqual(on.faults, []);
});

test('without OffscreenCanvas the page itself shows the same bytes', async () => {
  const on = await browser.open(`${server.url}/one.html`, { first: 'delete HTMLCanvasElement.prototype.transferControlToOffscreen' });
  await drawn(on);
  await shows(on, hashed(hashes.told('toon', 160, 'linear')), 'these bytes');
});

test('without lanes of 128 bits the page says so', async () => {
  const old = await serve(built, { ...pages, '/mien.js': (text) => `WebAssembly.validate = () => false;\n${text}` });
  const on = await browser.open(`${old.url}/one.html`);
  assert.match(await on.until(() => document.querySelector('mien-face').shadowRoot.querySelector('[role=status]').textContent), /SIMD/);
  await old.close();
});

test('without WebAssembly at all the page says so', async () => {
  const bare = await browse('--js-flags=--jitless');
  const on = await bare.open(`${server.url}/one.html`);
  assert.match(await on.until(() => document.querySelector('mien-face').shadowRoot.querySelector('[role=status]').textContent), /WebAssembly/);
  await bare.close();
});

test('where mien.wasm is not there the page says so', async () => {
  const half = await serve(built, { ...pages, '/worker.js': (text) => text.replace('compile(given)', 'compile("nowhere.wasm")') });
  const on = await browser.open(`${half.url}/one.html`);
  assert.match(await on.until(() => document.querySelector('mien-face').shadowRoot.querySelector('[role=status]').textContent), /nowhere\.wasm: cannot be fetched: 404/);
  await half.close();
});

const readme = readFileSync(new URL('bind/web/README.md', root), 'utf8');
const examples = (language) => [...readme.matchAll(new RegExp(`\`\`\`${language}\n([^]*?)\`\`\``, 'g'))].map(([, text]) => text);

test('the README draws its examples', async () => {
  const silence = Buffer.from('UklGRiQAAABXQVZFZm10IBAAAAABAAEAQB8AAEAfAAABAAgAZGF0YQAAAAA=', 'base64').toString('latin1');
  const given = `<script>var textOfATrack = '0\tm\n0.5\taa\n', audio = { currentTime: 0.2 }, video = null, now = 0, heard = 0;
    var landmarker = { detectForVideo: () => ({ faceBlendshapes: [{ categories: [{ categoryName: 'jawOpen', score: 0.7 }] }] }) };
    addEventListener('mien-drawn', () => ++heard);</script>`.replaceAll('\t', '\\t').replaceAll('\n0', '\\n0').replaceAll("\n'", "\\n'");
  const found = examples('html');
  assert.ok(found.length >= 4);
  for (const html of found) {
    const body = html.includes('<mien-face') ? html : `<mien-face seed="ada" width="72" height="72"></mien-face>${html}`;
    const own = await serve(built, { '/readme.html': `<!doctype html><meta charset="utf-8">${given}<script type="module" src="element.js"></script>${body}`, '/hello.TextGrid': '0\tm\n0.5\taa\n', '/hello.wav': silence });
    const on = await browser.open(`${own.url}/readme.html`, { first: "addEventListener('mien-refused', ({ detail }) => console.error(detail.where, detail.what))" });
    await on.until(() => window.heard > 0);
    await shows(on, (now) => new Set(now).size > 50, 'a face');
    assert.deepEqual(on.faults, [], html);
    await own.close();
  }
});

test('the README runs its scripts', async () => {
  const { name, exports } = JSON.parse(readFileSync(`${built}/package.json`, 'utf8'));
  const imports = Object.fromEntries(Object.entries(exports).map(([entry, to]) => [name + entry.slice(1), to.default ?? to]));
  const given = `import { load as loads } from '${name}'; let { mien, words } = await (async () => { const mien = await loads(); return { mien, words: mien.inFull(mien.recipe('A66CB-AA5S0-14')) }; })();`;
  const found = examples('js');
  assert.ok(found.length >= 4);
  for (const script of found) {
    const alone = /^import/m.test(script) ? script : `${given}\n${script}`;
    const own = await serve(built, { '/script.html': `<!doctype html><script type="importmap">${JSON.stringify({ imports })}</script><script>for (const name of ['error', 'unhandledrejection']) addEventListener(name, () => { window.fault = name; });</script><script type="module">${alone}\nwindow.ran = typeof pixels === 'undefined' ? 1 : pixels.length;</script>` });
    const on = await browser.open(`${own.url}/script.html`);
    const ran = await on.until(() => window.ran ?? window.fault);
    assert.deepEqual(on.faults, [], script);
    if (script.includes('pixels')) assert.equal(ran, 640 * 360 * 4);
    await own.close();
  }
});

test('the page with a camera shows what MediaPipe sees', async () => {
  const on = await browser.open(`${server.url}/camera/index.html`, { first: `navigator.mediaDevices.getUserMedia = async () => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 8, height: 8 }), context = canvas.getContext('2d');
    let count = 0;
    setInterval(() => { context.fillStyle = ['red', 'blue'][++count % 2], context.fillRect(0, 0, 8, 8); }, 50);
    return canvas.captureStream(20); };` });
  await drawn(on);
  const rest = await shown(on);
  await on.run(() => { document.querySelector('#start').click(); });
  await on.until(() => window.looked > 5);
  assert.equal(await on.run(() => document.querySelector('#refused').value), '');
  assert.deepEqual(await on.run(() => [asked.runningMode, asked.outputFaceBlendshapes, asked.outputFacialTransformationMatrixes]), ['VIDEO', true, true]);
  const still = await browser.open(`${server.url}/camera/still.html`);
  await drawn(still);
  await shows(still, sameAs(rest), 'the same person at rest');
  await then(still, 'mien-drawn', (face, seen) => face.follow(seen), SEEN);
  await shows(still, otherThan(rest), 'the frame');
  await shows(on, sameAs(await shown(still)), 'the last face that was seen');
  assert.deepEqual(on.faults, []);
});

test('the page with a camera says what is not there', async () => {
  const bare = await serve(built, { ...pages, '/camera/mediapipe/vision_bundle.mjs': null });
  const on = await browser.open(`${bare.url}/camera/index.html`);
  await drawn(on);
  await on.run(() => { document.querySelector('#start').click(); });
  assert.match(await on.until(() => document.querySelector('#refused').value), /vision_bundle/);
  await bare.close();
});

test('the page that talks follows the moment of its sound', async () => {
  const on = await browser.open(`${server.url}/talk/index.html`);
  await drawn(on);
  const rest = await shown(on);
  await on.run((bytes) => new Promise((done) => {  // two seconds of silence
    voice.addEventListener('seeked', done, { once: true });
    voice.addEventListener('loadedmetadata', () => { voice.currentTime = 0.6; }, { once: true });
    voice.src = URL.createObjectURL(new Blob([Uint8Array.from(bytes), new Uint8Array(32000).fill(128)], { type: 'audio/wav' }));
  }), [82, 73, 70, 70, 36, 125, 0, 0, 87, 65, 86, 69, 102, 109, 116, 32, 16, 0, 0, 0, 1, 0, 1, 0, 128, 62, 0, 0, 128, 62, 0, 0, 1, 0, 8, 0, 100, 97, 116, 97, 0, 125, 0, 0]);
  await shows(on, otherThan(rest), 'an open mouth');
  assert.equal(await on.run(() => document.querySelector('#refused').value), '');
  assert.deepEqual(on.faults, []);
});

test('the demo shows a crowd', async () => {
  const on = await browser.open(`${server.url}/demo.html`);
  assert.equal(await on.until(() => document.querySelectorAll('mien-face').length), 12);
  await drawn(on);
  assert.deepEqual(on.faults, []);
});
