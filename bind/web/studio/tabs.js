// Tabs as screen readers know them: arrows go from one to the next. A panel is filled when it is shown.

/** { update(), choose(name), panel(name) }. `panels`: classes by name, made with (root, studio), updated with (document, opened). */
export function tabs(list, place, panels, studio) {
  const names = Object.keys(panels), made = {};
  let chosen = names[0];
  for (const name of names) {
    const tab = Object.assign(document.createElement('button'), { type: 'button', textContent: name, id: `tab-${name}` });
    const panel = Object.assign(document.createElement('div'), { className: `panel ${name.toLowerCase()}`, id: `panel-${name}`, tabIndex: -1 });
    tab.setAttribute('role', 'tab'), tab.setAttribute('aria-controls', panel.id);
    panel.setAttribute('role', 'tabpanel'), panel.setAttribute('aria-labelledby', tab.id);
    tab.onclick = () => choose(name);
    list.append(tab), place.append(panel);
    made[name] = new panels[name](panel, studio);
  }
  list.addEventListener('keydown', (event) => {
    const at = names.indexOf(chosen), to = { ArrowRight: at + 1, ArrowLeft: at - 1 + names.length, Home: 0, End: names.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    choose(names[to % names.length]);
    document.getElementById(`tab-${chosen}`).focus();
  });
  function choose(name) {
    chosen = name;
    for (const one of names) {
      const tab = document.getElementById(`tab-${one}`);
      tab.setAttribute('aria-selected', one === name), tab.tabIndex = one === name ? 0 : -1;
      document.getElementById(`panel-${one}`).hidden = one !== name;
    }
    document.getElementById(`tab-${name}`).scrollIntoView({ block: 'nearest', inline: 'nearest' });
    place.scrollTop = 0;
    update();
  }
  function update() {
    if (studio.opened) made[chosen].update(studio.document, studio.opened);
  }
  choose(chosen);
  return { update, choose, panel: (name) => made[name] };
}
