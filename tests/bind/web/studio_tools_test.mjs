// node --test studio_tools_test.mjs: the studio's time line, points that snap, what has changed, and broken files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import test, { after, afterEach } from 'node:test';
import { built, click, CODE, drop, focus, nameless, picture, root, slide, show, studioPages } from './studio_page.mjs';

const { browser, open, close } = await studioPages();
afterEach(() => browser.closePages());
after(close);

const BAR = '.timeline [data-for=bar]', PLAY = '.timeline [data-for=play]';
const choose = (on, clip) => on.run((name) => { const select = document.querySelector('.timeline select'); select.value = name, select.dispatchEvent(new Event('change')); }, clip);
const seek = (on, time) => on.run((to) => { const bar = document.querySelector('.timeline [data-for=bar]'); bar.value = to, bar.dispatchEvent(new Event('input')); }, time);
const moment = (on) => on.run(() => Number(document.querySelector('.timeline [data-for=moment]').value));
const playing = (on) => on.run(() => document.querySelector('.timeline [data-for=play]').getAttribute('aria-label') === 'Pause');

test('a clip is looked through: every moment is a picture, and at rest it is left', async () => {
  const on = await open();
  await click(on, '#follow');
  const rest = await picture(on);
  assert.ok(await on.run((bar) => document.querySelector(bar).disabled, BAR), 'without a clip there is no time');
  await choose(on, 'feelings');
  assert.equal(await picture(on), rest, 'it begins at rest');
  await seek(on, 3.5);
  const surprised = await picture(on);
  assert.notEqual(surprised, rest);
  assert.equal(await moment(on), 3.5);
  await click(on, '#undo');
  assert.equal(await picture(on), rest);
  await click(on, '#redo');
  assert.equal(await picture(on), surprised);
  await on.run(() => { const field = document.querySelector('.timeline [data-for=moment]'); field.value = '9,5', field.dispatchEvent(new Event('change')); });
  assert.notEqual(await picture(on), surprised);
  assert.equal(await moment(on), 9.5);
  await click(on, '#rest');
  assert.equal(await picture(on), rest);
  assert.equal(await on.run(() => document.querySelector('.timeline select').value), '');
  assert.deepEqual(on.faults, []);
});

test('the time line goes by the keyboard: frames, seconds, its ends, and the space bar plays', async () => {
  const on = await open();
  await choose(on, 'feelings');
  await focus(on, BAR);
  const pressed = async (key, modifiers = 0) => { await on.press(key, key, modifiers); return moment(on); };
  assert.equal(await pressed('ArrowRight'), 0.033);
  assert.equal(await pressed('ArrowRight'), 0.067);
  assert.equal(await pressed('ArrowLeft'), 0.033);
  assert.equal(await pressed('ArrowRight', 8), 1.033);
  assert.equal(await pressed('End'), 12);
  assert.equal(await pressed('Home'), 0);
  assert.match(await on.run((bar) => document.querySelector(bar).getAttribute('aria-valuetext'), BAR), /^0\.00 of 12 seconds$/);
  await on.press(' ', 'Space');
  assert.ok(await playing(on));
  await on.until(() => Number(document.querySelector('.timeline [data-for=moment]').value) > 0.2);
  await on.press(' ', 'Space');
  assert.ok(!await playing(on));
  const stopped = await moment(on), shown = await picture(on);
  assert.ok(stopped > 0.2);
  await seek(on, 0), await picture(on), await seek(on, stopped);
  assert.equal(await picture(on), shown, 'it stopped at the moment that it says');
  assert.deepEqual(await nameless(on), []);
  assert.deepEqual(on.faults, []);
});

test('Play takes the first clip; without a loop it stops at the end; Export stops it', async () => {
  const on = await open();
  await click(on, PLAY);
  assert.ok(await playing(on));
  assert.equal(await on.run(() => document.querySelector('.timeline select').value), 'idle');
  await click(on, '#export');
  assert.ok(!await playing(on));
  const time = await moment(on);
  assert.match(await on.run(() => document.querySelector('#exporting pre').textContent), new RegExp(`--clip idle --time ${time} `));
  await on.press('Escape');
  await click(on, '.timeline [data-for=loop]');
  await seek(on, 11.9);
  await click(on, PLAY);
  await on.until((play) => document.querySelector(play).getAttribute('aria-label') === 'Play', PLAY);
  assert.equal(await moment(on), 12);
  await drop(on, 'male.face.json', readFileSync(new URL('faces/compat/male.face.json', root), 'utf8'));
  await on.until(() => document.querySelector('.timeline').classList.contains('empty'));
  assert.deepEqual(on.faults, []);
});

test('a clip is as long as its keys; one that goes on and on shows twelve seconds', async () => {
  const { clipLength, framesOn } = await import(new URL('bind/web/studio/clip_time.js', root));
  const text = JSON.stringify({ clips: { nod: { pitch: { keys: [[0, 0], [1.5, 4]] } }, beat: { tracks: { blink: { keys: [[0, 0]], period: 2.25 } } }, sway: { yaw: { sine: { amplitude: 3 } } } } });
  assert.deepEqual(['nod', 'beat', 'sway', 'none'].map((clip) => clipLength(text, clip)), [1.5, 2.25, 12, 12]);
  assert.equal(clipLength(readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'), 'idle'), 12);
  assert.deepEqual([framesOn(0, 1), framesOn(0.033, 1), framesOn(1, -1)], [0.033, 0.067, 0.967]);
});

/** A JSON value with a patch's operations done, as RFC 6902 says. */
function patched(value, patch) {
  const whole = structuredClone(value);
  for (const { op, path, value: to } of patch) {
    const keys = path.split('/').slice(1).map((key) => key.replaceAll('~1', '/').replaceAll('~0', '~')), last = keys.pop(), of = keys.reduce((now, key) => now[key], whole);
    assert.equal(last in of, op !== 'add', `${op} ${path}`);
    if (op === 'remove') delete of[last];
    else of[last] = to;
  }
  return whole;
}
/** What Export says has changed: { said, patch, left }. */
const changes = (on) => on.run(() => {
  document.getElementById('export').click();
  const [said, patch, left] = ['changes', 'patch', 'left'].map((name) => document.querySelector(`#exporting [data-for=${name}]`));
  const told = { said: said.textContent, patch: patch.hidden ? null : JSON.parse(patch.textContent), left: left.hidden ? '' : left.textContent };
  document.getElementById('exporting').close();
  return told;
});
const mienOf = async () => (await import(new URL(`file://${resolve(built)}/mien.js`))).load();

test('what has changed of a person is a patch of the recipe of their code', async () => {
  const on = await open(), mien = await mienOf();
  assert.deepEqual(await changes(on), { said: `Nothing: this is still the recipe of ${CODE}.`, patch: null, left: '' });
  await show(on, 'Shape');
  await slide(on, 'shape', 'Age', 61);
  await show(on, 'Parts');
  await on.run(() => document.querySelector('.parts .thumb[title=Ink]').click());
  await show(on, 'Feelings');
  await slide(on, 'feelings', 'Joy', 0.7);
  await picture(on);
  const { said, patch, left } = await changes(on);
  assert.match(said, new RegExp(`^A JSON patch \\(RFC 6902\\) of ${patch.length} changes to the recipe of ${CODE}:$`));
  assert.match(left, /: Joy\.$/);
  assert.ok(patch.some(({ path }) => path === '/numbers/age') && patch.some(({ path, value }) => path === '/style' && value === 'ink'));
  assert.ok(patch.length < 20, 'it is small');
  const whole = patched(JSON.parse(mien.recipe(CODE)), patch);
  await on.run(() => { HTMLAnchorElement.prototype.click = function () { window.saved = this.href; }; document.querySelector('[data-do=face]').click(); });
  assert.deepEqual(whole, JSON.parse(await on.run(async () => (await fetch(window.saved)).text())));
  await click(on, '#undo'), await click(on, '#undo'), await click(on, '#undo');
  await picture(on);
  assert.equal((await changes(on)).patch, null);
  assert.deepEqual(on.faults, []);
});

test('what has changed of a file is a patch of it: colours, and points of either side', async () => {
  const { patchOf, withSettings } = await import(new URL('bind/web/studio/patch.js', root)), mien = await mienOf();
  const text = readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'), file = JSON.parse(text);
  const set = { 'palette/skin': '#88aa66', 'brow.right/spine/0': [-0.1, 0.36], 'ear.left/points/1': [0.6, 0.2], 'head/points/3': [0.52, -0.3], 'halo/center': [0.1, 0.1], 'upper_lid.left/spine/0': [0, 0], yaw: 4 };
  const { file: changed, left } = withSettings(file, set, 0), patch = patchOf(file, changed);
  assert.deepEqual(left, ['upper_lid.left/spine/0', 'yaw'], 'a point of another feature, and what is the pose\'s');
  assert.deepEqual(patched(file, patch), changed);
  const { yaw, 'upper_lid.left/spine/0': shared, ...held } = set;
  const drawn = (of, pose) => mien.face(JSON.stringify(of)).draw(160, 90, pose).slice();
  assert.deepEqual(drawn(changed, {}), drawn(file, { set: held }));
  const on = await open();
  await drop(on, 'toon.face.json', text);
  await on.until((code) => document.getElementById('code').value !== code, CODE);
  assert.equal((await changes(on)).said, 'Nothing: this is still toon.face.json as it was opened.');
  await show(on, 'Colours');
  await on.run(() => { const input = [...document.querySelectorAll('.swatch')].find((one) => one.textContent.startsWith('Skin')).querySelector('input'); input.value = '#88aa66', input.dispatchEvent(new Event('input')); });
  await picture(on);
  assert.deepEqual((await changes(on)).patch, [{ op: 'replace', path: '/palette/skin', value: '#88aa66' }]);
  assert.deepEqual(on.faults, []);
});

test('patches: keys with slashes and tildes, what is gone, lists of another length', async () => {
  const { patchOf, patchText } = await import(new URL('bind/web/studio/patch.js', root));
  const before = { 'a/b': 1, '~': [1, 2], gone: null, list: [1], same: { x: [0] } }, after = { 'a/b': 2, '~': [1, 3], list: [1, 2], same: { x: [0] }, new: { y: 1 } };
  const patch = patchOf(before, after);
  assert.deepEqual(patch.map(({ op, path }) => `${op} ${path}`), ['remove /gone', 'replace /a~1b', 'replace /~0/1', 'replace /list', 'add /new']);
  assert.deepEqual(patched(before, patch), after);
  assert.equal(patchText(patchOf(after, after)), '[]');
  assert.deepEqual(JSON.parse(patchText(patch)), patch);
});
