// node --test bundlers_test.mjs: the package as npm packs it, in bundlers and compilers of pages, which
// tools/portable web --bundlers installs. Each makes a page that shows a face in headless Chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { browse } from './chromium.mjs';
import { serve } from './static_server.mjs';

const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
const npm = process.env.MIEN_NPM ?? `${process.cwd()}/build/web/npm`;
const { name: PACKAGE } = JSON.parse(readFileSync(join(built, 'package.json'), 'utf8'));
const here = fileURLToPath(new URL('./bundlers/', import.meta.url)), installed = join(npm, 'node_modules', PACKAGE);
const run = (program, ...args) => execFileSync(process.execPath, [join(npm, 'node_modules', program), ...args], { cwd: npm, encoding: 'utf8', stdio: 'pipe' });
const tool = (name) => import(pathToFileURL(createRequire(join(npm, 'package.json')).resolve(name)).href);

/** Installs what npm would publish: a file that package.json forgets is missing here, too. */
function install() {
  const [{ filename }] = JSON.parse(execFileSync('npm', ['pack', built, '--json', '--pack-destination', npm], { encoding: 'utf8' }));
  rmSync(installed, { recursive: true, force: true });
  mkdirSync(installed, { recursive: true });
  execFileSync('tar', ['xzf', join(npm, filename), '-C', installed, '--strip-components=1']);
}
install();

const MAIN = `import '${PACKAGE}/element';\ndocument.body.insertAdjacentHTML('beforeend', '<mien-face id="it" seed="ada" width="72" height="72"></mien-face>');\n`;
const PAGE = (script) => `<!doctype html><meta charset="utf-8"><body><script>window.refused = []; addEventListener('mien-drawn', () => { window.drawn = true; }); addEventListener('mien-refused', ({ detail }) => refused.push(detail.what))</script><script type="module" src="${script}"></script>`;

/** A folder with a page's source. */
function source(name, script) {
  const folder = join(npm, 'pages', name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(join(folder, 'dist'), { recursive: true });
  writeFileSync(join(folder, 'main.js'), MAIN);
  writeFileSync(join(folder, 'index.html'), PAGE(script));
  return folder;
}

const browser = await browse();
after(() => browser.close());
async function showsFace(url) {
  const on = await browser.open(url);
  const said = await on.until(() => (window.drawn ? 'a face' : window.refused[0]));
  assert.equal(said, 'a face');
  assert.ok(await on.run(() => {
    const { width, height } = it.shadowRoot.querySelector('canvas'), { data } = it.shadowRoot.querySelector('canvas').getContext('2d').getImageData(0, 0, width, height);
    return new Set(data).size > 50;
  }));
  assert.deepEqual(on.faults, []);
  await on.close();
}
async function shows(folder) {
  const server = await serve(folder);
  await showsFace(`${server.url}/index.html`);
  await server.close();
}

test('vite', async () => {
  const folder = source('vite', '/main.js'), { build } = await tool('vite');
  await build({ root: folder, logLevel: 'error', build: { outDir: 'dist' } });
  await shows(join(folder, 'dist'));
});

test('vite while one writes', async () => {
  const folder = source('vite_dev', '/main.js'), { createServer } = await tool('vite');
  const server = await createServer({ root: folder, logLevel: 'error', server: { host: '127.0.0.1', port: 0 }, optimizeDeps: { exclude: [PACKAGE] } });
  await server.listen();
  await showsFace(`http://127.0.0.1:${server.httpServer.address().port}/`);
  await server.close();
});

test('webpack', async () => {
  const folder = source('webpack', 'main.js'), { default: webpack } = await tool('webpack');
  const told = await new Promise((done, fail) => webpack({ mode: 'production', context: folder, entry: './main.js', output: { path: join(folder, 'dist'), filename: 'main.js' } },
    (error, stats) => (error ? fail(error) : done(stats.toJson({ all: false, errors: true, warnings: true })))));
  assert.deepEqual(told.errors, []);
  copyFileSync(join(folder, 'index.html'), join(folder, 'dist/index.html'));
  await shows(join(folder, 'dist'));
});

test('esbuild', async () => {
  const folder = source('esbuild', 'main.js'), { build } = await tool('esbuild');
  await build({ absWorkingDir: folder, entryPoints: ['main.js', `${PACKAGE}/worker.js`, `${PACKAGE}/mien.wasm`].map((one) => ({ in: one, out: one.split('/').at(-1).replace(/\.\w+$/, '') })),
    bundle: true, format: 'esm', minify: true, loader: { '.wasm': 'copy' }, outdir: 'dist' });
  copyFileSync(join(folder, 'index.html'), join(folder, 'dist/index.html'));
  await shows(join(folder, 'dist'));
});

test('rollup', async () => {
  const folder = source('rollup', 'main.js'), { rollup } = await tool('rollup');
  const local = { name: 'here', resolveId: (id) => (id.startsWith(`${PACKAGE}/`) ? join(installed, id.endsWith('.js') ? id.slice(PACKAGE.length) : `${id.slice(PACKAGE.length)}.js`) : null) };
  const bundle = await rollup({ input: { main: join(folder, 'main.js'), worker: `${PACKAGE}/worker.js` }, plugins: [local] });
  await bundle.write({ dir: join(folder, 'dist'), format: 'es', entryFileNames: '[name].js', chunkFileNames: '[name].js' });
  copyFileSync(join(installed, 'mien.wasm'), join(folder, 'dist/mien.wasm'));
  copyFileSync(join(folder, 'index.html'), join(folder, 'dist/index.html'));
  await shows(join(folder, 'dist'));
});

test('tsc --strict over every entry, and over React, Vue, Svelte and Solid', () => {
  const folder = join(npm, 'pages/types');
  rmSync(folder, { recursive: true, force: true });
  cpSync(join(here, 'types'), folder, { recursive: true });
  const examples = [...readFileSync(join(built, 'README.md'), 'utf8').matchAll(/```tsx\n([^]*?)```/g)];
  assert.ok(examples.length > 0);
  for (const [i, [, text]] of examples.entries()) writeFileSync(join(folder, `readme${i}.tsx`), text);
  try {
    run('typescript/bin/tsc', '-p', folder);
  } catch ({ stdout }) { assert.fail(stdout); }
});

test('node loads every entry of the package, as servers do', () => {
  const { exports } = JSON.parse(readFileSync(join(installed, 'package.json'), 'utf8'));
  const entries = Object.keys(exports).filter((one) => !/worker|\.wasm|\.json/.test(one)).map((one) => PACKAGE + one.slice(1));
  const script = `${entries.map((one) => `await import('${one}');`).join('')} const { svg } = await import('${PACKAGE}/svg'); console.log((await svg({ seed: 'ada' })).slice(0, 4));`;
  assert.equal(execFileSync(process.execPath, ['--input-type=module', '-e', script], { cwd: npm, encoding: 'utf8' }), '<svg\n');
});
