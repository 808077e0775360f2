// node part_features.mjs PARTS FOLDER: writes FOLDER/studio/part_features.js, the features that each family's parts have, so
// that the studio knows where to change what was clicked on.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [parts, folder] = process.argv.slice(2);
const families = {}, whose = {};
const names = readdirSync(parts, { recursive: true, withFileTypes: true });
for (const entry of names.filter(({ name }) => name.endsWith('.part.json'))) {
  const { family, features = [] } = JSON.parse(readFileSync(join(entry.parentPath ?? entry.path, entry.name), 'utf8'));
  for (const { name } of features) {
    if ((whose[name] ??= family) !== family) throw new Error(`${entry.name}: the feature ${name} is of ${whose[name]}, too`);
    (families[family] ??= new Set()).add(name);
  }
}
const lines = Object.keys(families).sort().map((family) => `  ${family}: '${[...families[family]].sort().join(' ')}',\n`);
writeFileSync(join(folder, 'studio/part_features.js'), `// Features by the family of their part; made by part_features.mjs.\nexport const PART_FEATURES = {\n${lines.join('')}};\n`);
