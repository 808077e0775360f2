// node --test export_test.mjs: what the studio exports is the picture, and so is what it says of other languages.
// MIEN_COMMAND: the command, which is tried where it is given, and Python beside it.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import test, { after } from 'node:test';
import { pathToFileURL } from 'node:url';
import { browse } from './chromium.mjs';
import { pngPixels } from './png_pixels.mjs';
import { serve } from './static_server.mjs';

const built = resolve(process.env.MIEN_WEB ?? 'build/web/bind/web/package');
const root = new URL('../../../', import.meta.url);
const { load } = await import(pathToFileURL(join(built, 'mien.js')));
const mien = await load();
const pages = {};
const server = await serve(built, pages), browser = await browse(), folder = mkdtempSync(join(tmpdir(), 'mien-export-'));
after(async () => { await browser.close(); await server.close(); rmSync(folder, { recursive: true }); });

const CODE = 'AF5C2-938BM-JX', WIDTH = 150, HEIGHT = 150;

/** The studio with somebody in a pose, or at a moment of a clip besides, and Export open. */
async function exporting(style, background, { clips: [clip] = [], time } = {}) {
  const on = await browser.open(`${server.url}/studio/index.html#${CODE}`, { first: 'HTMLAnchorElement.prototype.click = function () { window.saved = this.href; }' });
  await on.until(() => document.documentElement.dataset.ready === '');
  const slide = async (tab, label, value) => {
    await on.run((name) => document.getElementById(`tab-${name}`).click(), tab);
    await on.run((panel, name, to) => {
      const track = [...document.querySelectorAll(`.${panel} .slider`)].find((one) => one.querySelector('label').textContent === name).querySelector('.track');
      track.value = to;
      track.dispatchEvent(new Event('input'));
    }, tab.toLowerCase(), label, value);
  };
  await slide('Shape', 'Age', 61);
  await slide('Feelings', 'Joy', 0.7);
  await slide('Muscles', 'Jaw', 0.4);
  await slide('Pose', 'Turn', 12);
  await on.run(() => document.getElementById('tab-Parts').click());
  await on.run((name) => document.querySelector(`.parts .thumb[title=${name}]`).click(), style);
  await on.run(() => document.getElementById('tab-Colours').click());
  await on.run(() => { const input = [...document.querySelectorAll('.swatch')].find((one) => one.textContent.startsWith('Cloth')).querySelector('input'); input.value = '#3366cc', input.dispatchEvent(new Event('input')); });
  if (clip) await on.run((name, seconds) => {
    const [select, bar] = ['clip', 'bar'].map((one) => document.querySelector(`.timeline [data-for=${one}]`));
    select.value = name, select.dispatchEvent(new Event('change'));
    bar.value = seconds, bar.dispatchEvent(new Event('input'));
  }, clip, time);
  await on.until((wanted) => document.querySelector('.frame').getAttribute('aria-busy') === 'false' && document.getElementById('code').value !== wanted, CODE);
  await on.run(() => document.getElementById('export').click());
  await on.run((width, back) => {
    const form = document.querySelector('dialog form'), tell = (one, value, event) => { one.value = value, one.dispatchEvent(new Event(event)); };
    tell(form.width, width, 'input');
    if (back) tell(form.background, back, 'change');
  }, WIDTH, background);
  const saved = async (what) => {
    await on.run((button) => { window.saved = null, document.querySelector(`[data-do=${button}]`).click(); }, what);
    await on.until(() => window.saved);
    return Buffer.from(await on.run(async () => Array.from(new Uint8Array(await (await fetch(window.saved)).arrayBuffer()))));
  };
  const said = (language) => on.run((name) => {
    [...document.querySelectorAll('[data-for=languages] .chip')].find((one) => one.textContent === name).click();
    return document.querySelector('dialog pre').textContent;
  }, language);
  return { on, saved, said, png: pngPixels(await saved('png')), face: (await saved('face')).toString() };
}
/** In a page: the bytes that its face shows. */
function canvasOf() {
  const from = document.querySelector('mien-face').shadowRoot.querySelector('canvas'), into = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  Object.assign(into.canvas, { width: from.width, height: from.height });
  into.drawImage(from, 0, 0);
  return Array.from(into.getImageData(0, 0, from.width, from.height).data);
}
const POSE = { emotions: { joy: 0.7 }, muscles: { jaw: 0.4 }, set: { yaw: 12, 'palette/cloth': '#3366cc' } };
const equal = (one, other) => assert.equal(Buffer.compare(Buffer.from(one.buffer, one.byteOffset, one.byteLength), Buffer.from(other.buffer, other.byteOffset, other.byteLength)), 0);
/** Equal but for fused multiply-adds: single bytes, by one. */
function alike(one, other) {
  assert.equal(one.length, other.length);
  const differ = Array.from(one, (byte, i) => Math.abs(byte - other[i])).filter((by) => by > 0);
  assert.ok(Math.max(0, ...differ) <= 1 && differ.length < one.length / 1000, `${differ.length} bytes differ, by ${Math.max(0, ...differ)}`);
}
const MOMENT = { clips: ['feelings'], time: 3.123 };
const plain = await exporting('Soft'), ink = await exporting('Ink', '#00000000', MOMENT);

test('the PNG has the bytes of the picture, with transparency, too', () => {
  for (const [of, more] of [[plain, {}], [ink, { ...MOMENT, background: '#00000000' }]]) {
    assert.deepEqual([of.png.width, of.png.height], [WIDTH, HEIGHT]);
    equal(of.png.pixels, mien.face(of.face).draw(WIDTH, HEIGHT, { ...POSE, ...more }));
  }
  assert.ok(ink.png.pixels.some((byte, i) => i % 4 === 3 && byte < 255));
});

test('the SVG is that of the picture, and what it cannot say is shown', async () => {
  for (const [of, style, more] of [[plain, 'Soft', {}], [ink, 'Ink', { ...MOMENT, background: '#00000000' }]]) {
    const wanted = mien.face(of.face).svg(WIDTH, HEIGHT, { ...POSE, ...more }), svg = (await of.saved('svg')).toString();
    assert.equal(svg, wanted.text, style);
    await of.on.until(() => document.querySelector('#exporting [data-for=said]').textContent.startsWith('Saved face.svg, '));
    const told = await of.on.run(() => { const list = document.querySelector('[data-for=simplified]'); return list.hidden ? [] : Array.from(list.children, (one) => one.textContent); });
    assert.deepEqual(told, wanted.simplified.map((one) => `${one}.`));
    const size = await of.on.run(async () => { const image = new Image(); image.src = window.saved, await image.decode(); return [image.width, image.height]; });
    assert.deepEqual(size, [WIDTH, HEIGHT], 'browsers show it');
  }
});

test('its code alone is the face', async () => {
  const code = await plain.on.run(() => document.getElementById('code').value);
  equal(plain.png.pixels, mien.person(code).draw(WIDTH, HEIGHT, POSE));
});

test('JavaScript draws the same bytes', async () => {
  for (const [name, of] of Object.entries({ plain, ink })) {
    const text = (await of.said('JavaScript')).replace("'mien-face'", `'${pathToFileURL(join(built, 'mien.js'))}'`).replace(/await fetch\([^)]*\)/, `new Response(${JSON.stringify(of.face)})`);
    writeFileSync(join(folder, `${name}.mjs`), `${text}\nexport { pixels };`);
    equal(of.png.pixels, (await import(pathToFileURL(join(folder, `${name}.mjs`)))).pixels);
  }
});

test('HTML shows the same bytes', async () => {
  for (const of of [plain, ink]) {
    pages['/snippet.html'] = `<!doctype html><meta charset="utf-8">${await of.said('HTML')}`, pages['/face.face.json'] = of.face;
    const on = await browser.open(`${server.url}/snippet.html`);
    const shows = of === plain ? (now) => Buffer.compare(Buffer.from(now), Buffer.from(plain.png.pixels)) === 0
      : (now) => now.length === ink.png.pixels.length && now.every((byte, i) => i % 4 !== 3 || byte === ink.png.pixels[i]);  // a canvas keeps no colours under transparency
    await on.until(() => customElements.get('mien-face'));
    let is = false;
    for (let i = 0; i < 200 && !is; ++i, await new Promise((done) => setTimeout(done, 100))) is = shows(await on.run(canvasOf));
    assert.ok(is);
  }
});

const command = process.env.MIEN_COMMAND;
const withoutCommand = command ? false : 'MIEN_COMMAND is not given';
test('the command line draws the same picture', { skip: withoutCommand }, async () => {
  symlinkSync(resolve(command), join(folder, 'mien'));
  for (const of of [plain, ink]) {
    writeFileSync(join(folder, 'face.face.json'), of.face);
    execFileSync('sh', ['-c', await of.said('Command line')], { cwd: folder, env: { ...process.env, PATH: `${folder}:${process.env.PATH}` } });
    alike(pngPixels(readFileSync(join(folder, 'face.png'))).pixels, of.png.pixels);
  }
});

const python = command && existsSync('/usr/bin/python3') && spawnSync('/usr/bin/python3', ['-c', 'import numpy']).status === 0;
test('Python draws the same picture', { skip: python ? false : withoutCommand || 'there is no NumPy' }, async () => {
  for (const of of [plain, ink]) {
    writeFileSync(join(folder, 'face.face.json'), of.face);
    const env = { ...process.env, PYTHONPATH: new URL('bind/python', root).pathname, PYTHONDONTWRITEBYTECODE: '1', MIEN_LIBRARY: dirname(resolve(command)) };
    execFileSync('/usr/bin/python3', ['-c', await of.said('Python')], { cwd: folder, env });
    alike(pngPixels(readFileSync(join(folder, 'face.png'))).pixels, of.png.pixels);
  }
});
