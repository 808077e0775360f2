// What has changed of a face file, as a JSON patch (RFC 6902), and as a file: colours and points that a pose sets.

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

/** The list that a slice is in, of a feature: "points/3" is [points, 3]. */
function placeIn(feature, slice) {
  const keys = slice.split('/'), last = keys.pop(), list = keys.reduce((now, key) => now?.[key], feature);
  return list?.[last] === undefined ? null : { list, last };
}

/** The point where another was; what else is said of it ("bend") stays. */
const pointAt = (before, [x, y]) => [x, y, ...before.slice(2)];

/** A point of a side, and where it is on the other. */
const mirrored = (point, mirrorX) => (Array.isArray(point) && Number.isFinite(point[0]) ? [2 * mirrorX - point[0] || 0, ...point.slice(1)] : point);

/** The feature's own object of a side, into which that side's points are written in its real coordinates. */
function sideOf(feature, side, key, mirrorX) {
  const own = feature[side] ??= {}, turn = (value) => (Array.isArray(value?.[0]) ? value.map(turn) : side === feature.side ? value : mirrored(value, mirrorX));
  own[key] ??= structuredClone(turn(feature[key]));
  return own;
}

/** Puts a point into its feature; false: the file does not hold it as a point of its own. */
function putPoint(features, name, value, mirrorX) {
  const { base, side, slice } = name.match(/^(?<base>[^/]+?)(\.(?<side>left|right))?\/(?<slice>.+)$/)?.groups ?? {};
  const feature = features?.find((one) => one.name === base && Boolean(one.side) === Boolean(side));
  if (!feature) return false;
  const place = placeIn(side ? sideOf(feature, side, slice.split('/')[0], mirrorX) : feature, slice);
  if (!place || !Number.isFinite(place.list[place.last][0])) return false;  // "@brow/spine/0" is a point of another feature
  place.list[place.last] = pointAt(place.list[place.last], value);
  return true;
}

/** A face file with what a pose sets of it: { file, left }: `left` are the names that no file can hold. */
export function withSettings(file, set, mirrorX) {
  const changed = structuredClone(file), left = [];
  for (const [name, value] of Object.entries(set)) {
    const colour = name.startsWith('palette/') ? name.slice('palette/'.length) : null;
    const before = structuredClone(changed.features);
    if (colour !== null && changed.palette?.[colour] !== undefined) changed.palette[colour] = value;
    else if (!Array.isArray(value) || !putPoint(changed.features, name, value, mirrorX)) changed.features = before, left.push(name);
  }
  return { file: changed, left };
}
