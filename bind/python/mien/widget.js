// A face with sliders in a notebook, by anywidget's protocol: render({ model, el }). The model's `values` pose the face. With the
// wasm in the model the page draws by itself, also where no kernel runs; else the kernel draws, and `_picture` is its PNG.

/** The package for pages, as addresses: a notebook has no folder beside its modules. */
function address(files, name) {
  const text = files[name].replace(/'\.\/([\w.]+\.js)'/g, (_, named) => `'${address(files, named)}'`);
  return `data:text/javascript,${encodeURIComponent(text).replaceAll("'", '%27')}`;
}

/** What draws here: (values) => nothing; null where the kernel does. */
async function drawer(model, canvas) {
  const wasm = model.get('_wasm');
  if (!wasm || !wasm.byteLength) return null;
  const { load } = await import(address(model.get('_modules'), 'mien.js'));
  const mien = await load(wasm.buffer ? wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength) : wasm);
  const face = mien.face(model.get('_text'));
  const context = canvas.getContext('2d');
  return (values) => {
    const pixels = face.draw(canvas.width, canvas.height, { set: values });
    context.putImageData(new ImageData(pixels, canvas.width, canvas.height), 0, 0);
  };
}

/** Puts the kernel's picture on the canvas, unless a newer one has come meanwhile. */
async function show(canvas, model) {
  const png = model.get('_picture');
  if (!png || !png.byteLength) return;
  const picture = await createImageBitmap(new Blob([png], { type: 'image/png' }));
  if (model.get('_picture') !== png) return;
  const context = canvas.getContext('2d');
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
}

function slider(model, { name, lo, hi }) {
  const label = document.createElement('label'), input = document.createElement('input'), number = document.createElement('output');
  label.style.cssText = 'display: grid; grid-template-columns: 9em 14em 4em; gap: 0.5em; align-items: center';
  Object.assign(input, { type: 'range', min: lo, max: hi, step: (hi - lo) / 200, value: model.get('values')[name] ?? 0 });
  const tell = () => { number.textContent = Number(input.value).toFixed(2); };
  input.addEventListener('input', () => {
    model.set('values', { ...model.get('values'), [name]: Number(input.value) });
    model.save_changes();
    tell();
  });
  tell();
  label.append(name, input, number);
  return { label, follow: (values) => { input.value = values[name] ?? 0, tell(); } };
}

async function render({ model, el }) {
  const canvas = document.createElement('canvas'), told = document.createElement('p');
  [canvas.width, canvas.height] = model.get('size');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', model.get('label'));
  const sliders = model.get('sliders').map((one) => slider(model, one));
  el.append(canvas, ...sliders.map(({ label }) => label), told);
  let draw = null;
  const update = () => {
    const values = model.get('values');
    for (const one of sliders) one.follow(values);
    try {
      if (draw) draw(values);
      told.textContent = '';
    } catch (error) { told.textContent = error.message; }
  };
  const picture = async () => { if (!draw) await show(canvas, model); };
  model.on('change:values', update);
  model.on('change:_picture', picture);
  try {
    draw = await drawer(model, canvas);
  } catch (error) { told.textContent = error.message; }
  update();
  await picture();
  return () => { model.off('change:values', update), model.off('change:_picture', picture); };
}

export default { render };
