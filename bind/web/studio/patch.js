// What has changed of a face file, as a JSON patch (RFC 6902).

const isObject = (value) => value !== null && typeof value === 'object';
const isSame = (one, other) => JSON.stringify(one) === JSON.stringify(other);
const pointer = (path, key) => `${path}/${String(key).replaceAll('~', '~0').replaceAll('/', '~1')}`;

/** The operations that make one JSON value into another. Lists of another length are replaced as a whole. */
export function patchOf(before, after, path = '') {
  if (isSame(before, after)) return [];
  const areLists = Array.isArray(before) && Array.isArray(after) && before.length === after.length;
  const areObjects = isObject(before) && isObject(after) && !Array.isArray(before) && !Array.isArray(after);
  if (!areLists && !areObjects) return [{ op: 'replace', path, value: after }];
  const gone = Object.keys(before).filter((key) => !(key in after)).map((key) => ({ op: 'remove', path: pointer(path, key) }));
  const stays = Object.keys(after).flatMap((key) => (key in before ? patchOf(before[key], after[key], pointer(path, key)) : [{ op: 'add', path: pointer(path, key), value: after[key] }]));
  return [...gone, ...stays];
}

const operationText = (one) => ` {${Object.entries(one).map(([key, value]) => `"${key}": ${JSON.stringify(value)}`).join(', ')}}`;
/** An operation a line, as people read it. */
export const patchText = (patch) => (patch.length ? `[\n${patch.map(operationText).join(',\n')}\n]` : '[]');
