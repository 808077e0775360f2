// The field on top of every page: finds sections of the docs by their words, the title's before the text's.
const field = document.querySelector('#search input'), found = document.getElementById('found'), root = document.documentElement.dataset.root;
let sections;

async function find(text) {
  sections ??= (await fetch(`${root}search.json`)).json();
  const words = text.toLowerCase().split(/\s+/).filter(Boolean), all = await sections;
  const worth = ({ title, text: body }) => words.reduce((sum, word) => {
    const here = (title.toLowerCase().includes(word) ? 5 : 0) + Math.min(3, body.toLowerCase().split(word).length - 1);
    return here ? sum + here : -Infinity;
  }, 0);
  const best = words.length ? all.map((one) => ({ one, worth: worth(one) })).filter((each) => each.worth > 0).sort((a, b) => b.worth - a.worth).slice(0, 12) : [];
  if (text !== field.value) return;
  found.replaceChildren(...best.map(({ one }) => {
    const item = document.createElement('li'), link = Object.assign(document.createElement('a'), { href: root + one.address, textContent: one.title });
    const at = Math.max(0, one.text.toLowerCase().indexOf(words[0]) - 40);
    item.append(link, Object.assign(document.createElement('small'), { textContent: `${one.page}: …${one.text.slice(at, at + 140)}…` }));
    return item;
  }));
}
field.oninput = () => find(field.value);
field.onkeydown = ({ key }) => {
  if (key === 'Escape') field.value = '', found.replaceChildren();
  if (key === 'Enter') found.querySelector('a')?.click();
};
