// Where a dragged point snaps to: lines that it is near, and the place where two of them meet. All in face units.
//
// A line is { through: [x, y], along: [dx, dy], why }; `why` is "axis", "partner", "tangent" or "point".

const upright = (x, why) => ({ through: [x, 0], along: [0, 1], why });
const level = (y, why) => ({ through: [0, y], along: [1, 0], why });
const SAME = 1e-9;

/** The line through two points; null if the points coincide. */
function through([x, y], [u, v]) {
  const length = Math.hypot(u - x, v - y);
  return length > SAME ? { through: [x, y], along: [(u - x) / length, (v - y) / length], why: 'tangent' } : null;
}

/** The tangents that a point of a row of points may lie on: those of its neighbours beyond it, and the one between them. */
function tangentsOf(row, at) {
  const one = (by) => row[(at + by + row.length) % row.length];
  if (row.length < 3) return [];
  const pairs = row.length === 3 ? [[1, 2]] : [[1, 2], [-1, -2], [-1, 1]];
  return pairs.map(([from, to]) => through(one(from), one(to))).filter(Boolean);
}

/** All the lines for a point: `axis` is the x about which the face is mirrored, `partner` the point of the other side (or
 *  null), `row` the points of its list, of which it is the one at `at`, `others` all other points. */
export function linesFor({ axis, partner, row, at, others }) {
  const mirror = partner ? [upright(2 * axis - partner[0], 'partner'), level(partner[1], 'partner')] : [];
  return [upright(axis, 'axis'), ...mirror, ...tangentsOf(row, at), ...others.flatMap(([x, y]) => [upright(x, 'point'), level(y, 'point')])];
}

const distance = ({ through: [x, y], along: [dx, dy] }, [u, v]) => Math.abs((u - x) * dy - (v - y) * dx);

function foot({ through: [x, y], along: [dx, dy] }, [u, v]) {
  const t = (u - x) * dx + (v - y) * dy;
  return [x + t * dx, y + t * dy];
}

/** Where two lines meet; null: nowhere in particular. */
function meeting(one, other) {
  const [dx, dy] = one.along, [ex, ey] = other.along, turn = dx * ey - dy * ex;
  if (Math.abs(turn) < 0.1) return null;
  const [x, y] = one.through, [u, v] = other.through, t = ((u - x) * ey - (v - y) * ex) / turn;
  return [x + t * dx, y + t * dy];
}

/** The place that a point at `place` snaps to within `reach`, and the lines that hold it: { place, held }. Nearer lines go
 *  before others, and of equally near ones those that were named first. */
export function snapped(place, lines, reach) {
  const near = lines.map((line) => ({ line, far: distance(line, place) })).filter(({ far }) => far <= reach).sort((a, b) => a.far - b.far).map(({ line }) => line);
  if (!near.length) return { place, held: [] };
  const [first] = near;
  for (const second of near.slice(1)) {
    const met = meeting(first, second);
    if (met && Math.hypot(met[0] - place[0], met[1] - place[1]) <= 1.5 * reach) return { place: met, held: [first, second] };
  }
  return { place: foot(first, place), held: [first] };
}
