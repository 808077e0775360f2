// node --test studio_tools_test.mjs: the studio's time line, points that snap, what has changed, and broken files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test, { after, afterEach } from 'node:test';
import { click, CODE, drop, focus, nameless, picture, root, slide, show, studioPages } from './studio_page.mjs';

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
