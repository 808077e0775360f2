// What tests of the studio do with its page.
import { browse } from './chromium.mjs';
import { serve } from './static_server.mjs';

export const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
export const root = new URL('../../../', import.meta.url);
export const CODE = 'AF5C2-938BM-JX';

/** { browser, open(options, code), close() }: the package, served, and its studio with somebody in it. */
export async function studioPages() {
  const server = await serve(built), browser = await browse();
  return {
    browser,
    async open(options = {}, code = CODE) {
      const on = await browser.open(`${server.url}/studio/index.html#${code}`, options);
      await on.until(() => document.documentElement.dataset.ready === '');
      return on;
    },
    async close() { await browser.close(), await server.close(); },
  };
}

/** A hash of what the stage shows, once it is there. */
export async function picture(on) {
  await on.until(() => document.querySelector('.frame').getAttribute('aria-busy') === 'false');
  return on.run(() => {
    const canvas = document.querySelector('.frame canvas'), { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let hash = 0;
    for (let i = 0; i < data.length; ++i) hash = Math.imul(hash ^ data[i], 0x9e3779b1) ^ (hash >>> 15);
    return `${canvas.width} ${hash}`;
  });
}
export const show = (on, name) => on.run((tab) => document.getElementById(`tab-${tab}`).click(), name);
export const click = (on, selector) => on.run((what) => document.querySelector(what).click(), selector);
export const focus = (on, selector) => on.run((what) => document.querySelector(what).focus(), selector);
export const code = (on) => on.run(() => document.getElementById('code').value);

/** Sets a slider by its label, as a person would. */
export const slide = (on, panel, label, value) => on.run((where, name, to) => {
  const row = [...document.querySelectorAll(`.${where} .slider`)].find((one) => one.querySelector('label').textContent === name);
  const track = row.querySelector('.track');
  track.value = to;
  track.dispatchEvent(new Event('input'));
}, panel, label, value);

/** Drops a file on the page. */
export const drop = (on, name, text) => on.run((file, content) => {
  const data = new DataTransfer();
  data.items.add(new File([content], file));
  document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
}, name, text);

/** Controls that a screen reader meets and cannot name. */
export async function nameless(on) {
  await on.send('Accessibility.enable');
  const { nodes } = await on.send('Accessibility.getFullAXTree');
  const roles = ['button', 'slider', 'textbox', 'combobox', 'tab', 'tabpanel', 'application', 'ColorWell', 'dialog', 'group'];
  return nodes.filter(({ ignored, role, name }) => !ignored && roles.includes(role?.value) && !name?.value).map(({ role }) => role.value);
}
