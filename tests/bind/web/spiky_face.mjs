/** A face file whose one outline crosses itself so often that no picture of it is quick. */
export function spikyFace() {
  const points = Array.from({ length: 20000 }, (_, i) => [((i * 7919) % 2000) / 1000 - 1, ((i * 104729) % 1999) / 1000 - 1]);
  return JSON.stringify({
    format: 'mien-face', format_version: 1, name: 'spikes', canvas: { x: [-1, 1], y: [-1, 1], y_axis: 'up' }, palette: { a: '#204080', b: '#fff7e0' },
    background: 'b', features: [{ name: 'p', kind: 'path', paint: 'a', points }],
  });
}
