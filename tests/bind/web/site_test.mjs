// node --test site_test.mjs: the pages that tools/site makes, in headless Chromium: live faces, the search, no broken links.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { appendFileSync, cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, afterEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { browse } from './chromium.mjs';
import { serve } from './static_server.mjs';

const root = fileURLToPath(new URL('../../../', import.meta.url)), folder = mkdtempSync(join(tmpdir(), 'mien-site-'));
execFileSync('/usr/bin/python3', [join(root, 'tools/site'), '-o', join(folder, 'site')]);
const server = await serve(join(folder, 'site'));
const browser = await browse();
afterEach(() => browser.closePages());
after(async () => { await browser.close(); await server.close(); rmSync(folder, { recursive: true }); });
const open = (name) => browser.open(`${server.url}/${name}`, { first: "window.drawn = new Set(); addEventListener('mien-drawn', ({ target }) => drawn.add(target))" });

test('gallery, parts and playground show faces', async () => {
  for (const [name, least] of [['gallery.html', 12], ['parts.html#glasses', 5], ['playground.html?code=A66CB-AA5S0-14', 2]]) {
    const on = await open(name);
    await on.until((count) => window.drawn.size >= count, least);
    assert.deepEqual(on.faults, [], name);
  }
});

test('the playground tells what is refused, and runs nothing', async () => {
  const on = await open('playground.html');
  await on.run(() => {
    const field = document.getElementById('text');
    field.value = '<mien-face seed="ada" emotion="joyy=1" onclick="window.ran = 1"></mien-face><img src="x" onerror="window.ran = 1"><script>window.ran = 1</script>', field.dispatchEvent(new Event('input'));
  });
  assert.match(await on.until(() => document.getElementById('refused').value), /did you mean "joy"/);
  assert.deepEqual(await on.run(() => [window.ran ?? null, document.querySelector('#stage mien-face').hasAttribute('onclick')]), [null, false]);
});

test('the search finds sections of the docs', async () => {
  const on = await open('index.html');
  await on.run(() => { const field = document.querySelector('#search input'); field.value = 'changing a file', field.dispatchEvent(new Event('input')); });
  const address = await on.until(() => document.querySelector('#found a')?.href);
  assert.match(address, /face-format\.html#changing-a-file$/);
  await on.go(address);
  assert.match(await on.run(() => document.querySelector(location.hash).tagName), /^H\d$/);
  assert.deepEqual(on.faults, []);
});

test('a link that leads nowhere is an error', () => {
  const tree = join(folder, 'tree');
  for (const name of ['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'LICENSE', 'THIRD_PARTY.md', 'SECURITY.md', 'docs', 'bind/web', 'tools', 'examples', 'faces']) cpSync(join(root, name), join(tree, name), { recursive: true });
  appendFileSync(join(tree, 'docs/README.md'), '\n[x](nowhere.md) [y](rig.md#nowhere)\n');
  const { status, stderr } = spawnSync('/usr/bin/python3', [join(tree, 'tools/site')], { encoding: 'utf8', env: { ...process.env, MIEN_WEB: process.env.MIEN_WEB } });
  assert.equal(status, 1);
  assert.match(stderr, /docs\/README\.md: there is no docs\/nowhere\.md\n.*docs\/rig\.html has no section #nowhere/s);
});
