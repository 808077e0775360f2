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

test('a clip is as long as mien says; one that goes on and on shows twelve seconds', async () => {
  const { framesOn, shownOf } = await import(new URL('bind/web/studio/clip_time.js', root));
  assert.deepEqual([1.5, 2.25, Infinity, undefined, 0].map(shownOf), [1.5, 2.25, 12, 12, 12]);
  assert.deepEqual([framesOn(0, 1), framesOn(0.033, 1), framesOn(1, -1)], [0.033, 0.067, 0.967]);
  const on = await open(), file = JSON.parse(readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'));
  file.clips = { ...file.clips, nod: { 'gaze.x': { keys: [[0, 0], [1.5, 0.02]] } }, sway: { 'gaze.x': { keys: [[0, 0], [1, 0.02]], period: 2.25 }, 'gaze.y': { keys: [[0, 0]], period: 1.5 } } };
  await drop(on, 'toon.face.json', JSON.stringify(file));
  await on.until((code) => document.getElementById('code').value !== code, CODE);
  const lengths = [];
  for (const clip of ['nod', 'sway', 'idle']) await choose(on, clip), await picture(on), lengths.push(await on.run(() => document.querySelector('.timeline [data-for=length]').textContent));
  assert.deepEqual(lengths, ['/ 1.5 s', '/ 4.5 s', '/ 12 s']);
  assert.deepEqual(on.faults, []);
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
async function changes(on) {
  await click(on, '#export');
  await on.until(() => document.querySelector('#exporting [data-for=changes]').textContent);
  return on.run(() => {
    const [said, patch, left] = ['changes', 'patch', 'left'].map((name) => document.querySelector(`#exporting [data-for=${name}]`));
    const told = { said: said.textContent, patch: patch.hidden ? null : JSON.parse(patch.textContent), left: left.hidden ? '' : left.textContent };
    document.getElementById('exporting').close();
    return told;
  });
}
/** The face's file as Export saves it, and what is said: { text, said }. */
async function savedFace(on) {
  await on.run(() => { HTMLAnchorElement.prototype.click = function () { window.saved = this.href; }; window.saved = null, document.getElementById('export').click(), document.querySelector('[data-do=face]').click(); });
  await on.until(() => window.saved);
  const text = await on.run(async () => (await fetch(window.saved)).text()), said = await on.run(() => document.querySelector('#exporting [data-for=said]').textContent);
  await click(on, '#exporting [data-do=close]');
  return { text, said };
}
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
  const recipe = JSON.parse(mien.recipe(CODE)), whole = patched(recipe, patch);
  // The numbers of a head age together; its choices, apart from a few, stay.
  const parts = patch.filter(({ path }) => path.startsWith('/parts/'));
  assert.ok(parts.length <= 4, JSON.stringify(parts)), assert.ok(Object.keys(recipe.parts).length > 20);
  const was = ({ path }) => path.split('/').slice(1).reduce((now, key) => now?.[key], recipe);
  assert.deepEqual(patch.filter((change) => was(change) === change.value), [], 'nothing stays in it');
  const saved = await savedFace(on);
  assert.deepEqual(whole, JSON.parse(saved.text));
  assert.match(saved.said, /^Saved face\.face\.json\. Left out, for only the pose has it: Joy\./);
  await click(on, '#undo'), await click(on, '#undo'), await click(on, '#undo');
  await picture(on);
  assert.equal((await changes(on)).patch, null);
  assert.deepEqual(on.faults, []);
});

test('what has changed of a file is a patch of it: colours, and points of either side', async () => {
  const { patchOf } = await import(new URL('bind/web/studio/patch.js', root)), mien = await mienOf();
  const text = readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'), file = JSON.parse(text);
  const set = { 'palette/skin': '#88aa66', 'brow.right/spine/0': [-0.1, 0.36], 'ear.left/points/1': [0.6, 0.2], 'head/points/3': [0.52, -0.3], 'halo/center': [0.1, 0.1], yaw: 4 };
  const { text: changed, left } = mien.textWith(text, set), patch = patchOf(file, JSON.parse(changed));
  assert.deepEqual(left, ['yaw'], 'what is the pose\'s');
  assert.deepEqual(patched(file, patch), JSON.parse(changed));
  const { yaw, ...held } = set;
  const drawn = (of, pose) => mien.face(of).draw(160, 90, pose);
  assert.deepEqual(drawn(changed, {}), drawn(text, { set: held }));
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

test('a file is saved as it has become: opened again it is the same picture', async () => {
  const on = await open(), text = readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8');
  await drop(on, 'toon.face.json', text);
  await on.until((code) => document.getElementById('code').value !== code, CODE);
  const before = await picture(on);
  assert.deepEqual(await savedFace(on), { text, said: 'Saved face.face.json.' });
  await show(on, 'Colours');
  await on.run(() => { const input = [...document.querySelectorAll('.swatch')].find((one) => one.textContent.startsWith('Skin')).querySelector('input'); input.value = '#88aa66', input.dispatchEvent(new Event('input')); });
  await click(on, '#points');
  for (const feature of ['mouth', 'brow.right']) {
    await on.run((name) => { const select = document.getElementById('feature'); select.value = name, select.dispatchEvent(new Event('change')); }, feature);
    await on.until((name) => document.querySelector('.points button')?.title.startsWith(name), feature);
    await focus(on, '.points button');
    for (let i = 0; i < 5; ++i) await on.run(() => document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true })));
  }
  await click(on, '#points');
  const changed = await picture(on), { text: saved, said } = await savedFace(on);
  assert.notEqual(changed, before);
  assert.equal(said, 'Saved face.face.json.');
  assert.ok(saved.includes('#88aa66') && saved !== text && Math.abs(saved.length - text.length) < 200, 'all else stays');
  await show(on, 'Pose');
  await slide(on, 'pose', 'Turn', 12);
  const turned = await savedFace(on);
  assert.equal(turned.text, saved);
  assert.equal(turned.said, 'Saved face.face.json. Left out, for only the pose has it: Turn. The command line says it, too.');
  await drop(on, 'again.face.json', saved);
  await on.until(() => document.getElementById('rest').disabled);
  assert.equal(await picture(on), changed);
  assert.equal((await changes(on)).said, 'Nothing: this is still again.face.json as it was opened.');
  assert.deepEqual(on.faults, []);
});

test('a person whose points and colours were changed is saved in full: opened again it is the same picture', async () => {
  const on = await open(), before = await picture(on);
  await show(on, 'Colours');
  await on.run(() => { const input = [...document.querySelectorAll('.swatch')].find((one) => one.textContent.startsWith('Skin')).querySelector('input'); input.value = '#88aa66', input.dispatchEvent(new Event('input')); });
  await click(on, '#points');
  await on.run(() => { const select = document.getElementById('feature'); select.value = 'brow.right', select.dispatchEvent(new Event('change')); });
  await on.until(() => document.querySelector('.points button')?.title.startsWith('brow.right'));
  await focus(on, '.points button');
  for (let i = 0; i < 5; ++i) await on.run(() => document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true })));
  await click(on, '#points');
  const changed = await picture(on), { text, said } = await savedFace(on);
  assert.notEqual(changed, before);
  assert.equal(said, 'Saved face.face.json in full: with the points and colours that you changed, it is no longer made of parts.');
  assert.equal(JSON.parse(text).format_version, 1);
  const mien = await mienOf(), saved = mien.face(text), person = mien.person(CODE), now = saved.vector({}), then = person.vector({});
  const moved = saved.names.filter(({ name, begin, count }) => name.startsWith('brow.right/') && !now.slice(begin, begin + count).every((value, i) => value === then[begin + i]));
  assert.equal(moved.length, 1);
  const set = { 'palette/skin': '#88aa66' };
  for (const { name, begin, count } of moved) set[name] = [...now.slice(begin, begin + count)];
  assert.deepEqual(saved.draw(200, 200), person.draw(200, 200, { set }));
  await drop(on, 'mine.face.json', text);
  await on.until(() => document.getElementById('rest').disabled);
  assert.notEqual(await picture(on), before);
  assert.deepEqual(on.faults, []);
});

test('what SVG cannot say is listed, until something else is saved', async () => {
  const on = await open({ first: 'HTMLAnchorElement.prototype.click = function () { window.saved = this.href }' }), text = readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'), mien = await mienOf();
  await drop(on, 'toon.face.json', text);
  await on.until((code) => document.getElementById('code').value !== code, CODE);
  await click(on, '#export'), await click(on, '#exporting [data-do=svg]');
  await on.until(() => document.querySelector('#exporting [data-for=said]').textContent.startsWith('Saved face.svg, '));
  const size = await on.run(() => ['width', 'height'].map((name) => Number(document.querySelector('#exporting form')[name].value)));
  const { text: svg, simplified } = mien.face(text).svg(...size);
  const listed = () => on.run(() => Array.from(document.querySelectorAll('#exporting [data-for=simplified]:not([hidden]) li'), (one) => one.textContent));
  assert.ok(simplified.length > 0);
  assert.deepEqual(await listed(), simplified.map((one) => `${one}.`));
  assert.equal(await on.run(async () => (await fetch(window.saved)).text()), svg);
  assert.deepEqual(await nameless(on), []);
  await click(on, '#exporting [data-do=png]');
  await on.until(() => document.querySelector('#exporting [data-for=said]').textContent.startsWith('Saved face.png, '));
  assert.deepEqual(await listed(), []);
  await click(on, '#exporting [data-do=svg]');
  await on.until(() => document.querySelector('#exporting [data-for=said]').textContent.startsWith('Saved face.svg, '));
  assert.ok((await listed()).length > 0);
  await click(on, '#exporting [data-do=face]');
  await on.until(() => document.querySelector('#exporting [data-for=said]').textContent.startsWith('Saved face.face.json'));
  assert.deepEqual(await listed(), []);
  assert.deepEqual(on.faults, []);
});

test('the file of a person, opened again, is that person: by the same code, and at rest', async () => {
  const on = await open({}, 'A66CB-AA5S0-14');  // an age of 14 is at no step of a code
  await show(on, 'Parts');
  await on.run(() => [...document.querySelectorAll('.parts .chip')].find((one) => one.textContent === 'Hair').click());
  await on.run(() => document.querySelector('.parts .thumb[title=Bob]').click());
  const rest = await picture(on), known = await on.run(() => document.getElementById('code').value);
  assert.match(known, /^A66CB-AA5S0-.*~/);
  await show(on, 'Feelings');
  await slide(on, 'feelings', 'Joy', 0.5);
  assert.notEqual(await picture(on), rest);
  const { text } = await savedFace(on);
  await drop(on, 'again.face.json', text);
  await on.until(() => document.getElementById('rest').disabled);
  assert.equal(await picture(on), rest);
  assert.equal(await on.run(() => document.getElementById('code').value), known);
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

/** The handles of a feature, chosen by its name: { name: [x, y] } [px]. */
const handles = (on) => on.run(() => Object.fromEntries([...document.querySelectorAll('.points button')].map((one) => { const { x, y, width, height } = one.getBoundingClientRect(); return [one.title, [x + width / 2, y + height / 2]]; })));
async function shaping(on, feature) {
  await click(on, '#follow');
  await picture(on);
  await click(on, '#points');
  await on.run((name) => { const select = document.getElementById('feature'); select.value = name, select.dispatchEvent(new Event('change')); }, feature);
  await on.until((name) => document.querySelector('.points button')?.title.startsWith(`${name}/`), feature);
  return handles(on);
}
const guides = (on) => on.run(() => [...document.querySelectorAll('.guides line:not(.edge)')].map((one) => one.getAttribute('class')).sort());
/** Drags without letting go, by way of the places. */
async function hold(on, places, modifiers = 0) {
  const tell = (type, [x, y]) => on.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1, modifiers });
  await tell('mousePressed', places[0]);
  for (const place of places.slice(1)) await tell('mouseMoved', place);
  return (at = places.at(-1)) => tell('mouseReleased', at);
}

test('a dragged point snaps to the mirror axis, and to where its partner is on the other side', async () => {
  const on = await open();
  const before = await shaping(on, 'brow.left'), frame = await on.run(() => { const { x, y, width } = document.querySelector('.frame').getBoundingClientRect(); return [x + width / 2, y]; });
  const [name] = Object.keys(before), from = before[name];
  let release = await hold(on, [from, [frame[0] + 9, from[1] - 40], [frame[0] + 4, frame[1] + 45]]);
  assert.deepEqual(await guides(on), ['axis']);
  assert.match(await on.run(() => document.getElementById('said').textContent), /is held by the mirror axis/);
  await release();
  assert.deepEqual(await guides(on), []);
  assert.ok(Math.abs((await handles(on))[name][0] - frame[0]) < 0.6);
  release = await hold(on, [(await handles(on))[name], [from[0] + 8, from[1] + 30], [from[0] + 3, from[1] - 3]]);
  assert.deepEqual(await guides(on), ['partner', 'partner']);
  await release();
  const after = (await handles(on))[name];
  assert.ok(Math.hypot(after[0] - from[0], after[1] - from[1]) < 0.6, 'the brows are alike again');
  assert.deepEqual(on.faults, []);
});

test('Alt and the chip suspend snapping, and arrow keys do not snap', async () => {
  const on = await open();
  const before = await shaping(on, 'brow.left'), middle = await on.run(() => { const { x, width } = document.querySelector('.frame').getBoundingClientRect(); return x + width / 2; });
  const [name] = Object.keys(before), from = before[name], near = [middle + 4, from[1] - 60];
  let release = await hold(on, [from, near], 1);
  assert.deepEqual(await guides(on), []);
  await on.send('Input.dispatchKeyEvent', { type: 'keyUp', key: 'Alt', code: 'AltLeft' });
  assert.deepEqual(await guides(on), ['axis'], 'it snaps as soon as Alt is up');
  await release();
  await click(on, '#snap');
  release = await hold(on, [(await handles(on))[name], near]);
  assert.deepEqual(await guides(on), []);
  await release();
  const apart = (await handles(on))[name][0];
  assert.ok(Math.abs(apart - near[0]) < 0.6);
  await click(on, '#snap');
  await on.run((title) => [...document.querySelectorAll('.points button')].find((one) => one.title === title).focus(), name);
  await on.press('ArrowLeft');
  assert.ok((await handles(on))[name][0] < apart - 1);
  assert.deepEqual(await guides(on), []);
  assert.match(await on.run(() => document.getElementById('said').textContent), new RegExp(`^${name}: -?[0-9.]+, -?[0-9.]+$`));
  await click(on, '#points');
  assert.ok(await on.run(() => document.getElementById('snap').hidden && document.getElementById('feature').hidden));
  assert.deepEqual(on.faults, []);
});

test('snapping: the nearest line, two that cross, tangents of the row', async () => {
  const { linesFor, snapped } = await import(new URL('bind/web/studio/snapping.js', root));
  const row = [[0, 0], [1, 1], [2, 0], [3, 1], [4, 4]], lines = linesFor({ axis: 10, partner: [17, 8], row, at: 2, others: [[5, -3]] });
  const at = (place, reach = 0.1) => { const { place: to, held } = snapped(place, lines, reach); return [to.map((one) => Number(one.toFixed(6))), held.map(({ why }) => why).join()]; };
  assert.deepEqual(at([20, 23]), [[20, 23], '']);
  assert.deepEqual(at([9.95, 20]), [[10, 20], 'axis']);
  assert.deepEqual(at([3.04, 7.97]), [[3, 8], 'partner,partner']);
  assert.deepEqual(at([4.96, 30]), [[5, 30], 'point']);
  assert.deepEqual(at([2.2, 1.05]), [[2.2, 1], 'tangent'], 'between its neighbours');
  assert.deepEqual(at([-1.05, -1]), [[-1.025, -1.025], 'tangent'], 'beyond those before it');
  assert.deepEqual(at([10.05, 4.03]), [[10, 4.03], 'axis']);
  assert.deepEqual(at([1.9, -1.96], 0.2)[1], 'tangent', 'beyond those after it');
});

/** What the view of a broken file says and marks. */
const broken = (on) => on.run(() => {
  const dialog = document.getElementById('broken'), area = dialog.querySelector('textarea');
  const [where, what, said] = ['where', 'what', 'said'].map((name) => dialog.querySelector(`[data-for=${name}]`).textContent);
  const mark = dialog.querySelector('.row').hidden ? null : dialog.querySelector('mark').textContent, selected = area.value.slice(area.selectionStart, area.selectionEnd);
  return { open: dialog.open, where, what, said, mark, selected, focused: document.activeElement === area };
});
const rewrite = (on, from, to) => on.run((before, after) => { const area = document.querySelector('#broken textarea'); area.value = area.value.replace(before, after), area.dispatchEvent(new Event('input')); }, from, to);

test('a broken file is shown at its place, is mended there and tried again; the face stays until it works', async () => {
  const on = await open(), before = await picture(on);
  const text = readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8').replace('"side": "left", "paint": "hair"', '"side": "left", "paint": "hiar"').replace('"title": "', '"title": "😀 ');
  await drop(on, 'mine.face.json', text);
  await on.until(() => document.getElementById('broken').open);
  const line = text.split('\n').findIndex((one) => one.includes('"hiar"')) + 1;
  const { where, what, ...seen } = await broken(on);
  assert.match(where, new RegExp(`^Line ${line}, column \\d+, /features/\\d+/paint$`));
  assert.match(what, /hiar.*did you mean "hair"/);
  assert.deepEqual(seen, { open: true, said: '', mark: '"hiar"', selected: '"hiar"', focused: true });
  const numbers = await on.run(() => document.querySelector('#broken .numbers').textContent.split('\n').map(Number));
  assert.ok(numbers.includes(line) && numbers.length < 40, 'the lines around it are seen');
  await rewrite(on, '"hiar"', '"hair" 7');
  assert.equal((await broken(on)).mark, null, 'the mark goes with its line');
  await on.press('Enter', 'Enter', 2);
  await on.until(() => document.querySelector('#broken [data-for=what]').textContent.includes('malformed'));
  assert.equal((await broken(on)).mark, '7');
  assert.equal(await picture(on), before);
  assert.deepEqual(await nameless(on), []);
  await rewrite(on, ' 7', '');
  await click(on, '#broken [data-do=try]');
  await on.until(() => !document.getElementById('broken').open);
  assert.notEqual(await picture(on), before);
  await click(on, '#undo');
  assert.equal(await picture(on), before);
  assert.deepEqual(on.faults, []);
});

test('what was changed in a broken file is not lost by one Escape', async () => {
  const on = await open();
  await drop(on, 'mine.face.json', '{"ä": "ö" "b"');
  await on.until(() => document.getElementById('broken').open);
  assert.equal((await broken(on)).mark, '"b"', 'syntax: the token that was not expected');
  await rewrite(on, '"b"', '"c"');
  await on.press('Escape');
  assert.match((await broken(on)).said, /not saved/);
  await on.press('Escape');
  assert.ok(!(await broken(on)).open);
  assert.match(await on.run(() => document.getElementById('said').textContent), /^mine\.face\.json:1:/);
  await drop(on, 'empty.face.json', '');
  await on.until(() => document.getElementById('broken').open);
  await on.press('Escape');
  assert.ok(!(await broken(on)).open, 'nothing was changed');
  assert.deepEqual(on.faults, []);
});

test('everything about the picture is reached by the keyboard, and seen when it is', async () => {
  const on = await open();
  await choose(on, 'idle');
  await shaping(on, 'brow.left');
  await focus(on, '#feature');
  await on.press('Enter');
  assert.match(await on.run(() => document.activeElement.getAttribute('aria-label')), /^brow\.left\/spine\/0; arrow keys/);
  await on.press('Escape');
  assert.equal(await on.run(() => document.activeElement.id), 'feature');
  await focus(on, '.frame canvas');
  const reached = [];
  for (let i = 0; i < 16; ++i) {
    await on.press('Tab');
    const { name, outline } = await on.run(() => { const now = document.activeElement; return { name: now.id || now.title || now.dataset.for, outline: getComputedStyle(now).outlineStyle }; });
    assert.notEqual(outline, 'none', `${name} is seen`);
    reached.push(name);
  }
  for (const name of ['brow.left/spine/0', 'Play (Space)', 'clip', 'bar', 'moment', 'Loop', 'feature', 'snap', 'points', 'rest']) assert.ok(reached.includes(name), `${name}: ${reached}`);
  await on.press('Escape');
  assert.equal(await on.run(() => document.getElementById('points').getAttribute('aria-pressed')), 'false', 'Escape leaves the points');
  assert.deepEqual(await nameless(on), []);
});

test('nothing is wider than the page, whatever is open', async () => {
  for (const [width, height] of [[1440, 900], [390, 844], [320, 568]]) {
    const on = await open({ width, height });
    const fits = async (what) => assert.ok(await on.run(() => {
      const boxes = [...document.querySelectorAll('dialog[open] form, .timeline, .caption')];
      return document.documentElement.scrollWidth <= innerWidth && boxes.every((one) => one.scrollWidth <= one.clientWidth + 1);
    }), `${what} at ${width}`);
    await choose(on, 'feelings'), await seek(on, 11.733);
    await shaping(on, 'brow.left');
    await fits('points');
    await click(on, '#export');
    await fits('Export');
    await click(on, '#exporting [data-do=close]');
    await drop(on, 'a_file_with_a_name_that_is_longer_than_the_window.face.json', '{"format": "mien-face"');
    await on.until(() => document.getElementById('broken').open);
    await fits('a broken file');
  }
});
