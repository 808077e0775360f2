// node typed.mjs FOLDER: writes what tools know of the package in FOLDER, out of attributes.js and of mien.wasm: the names that
// people's faces know as types (names.d.ts), the element's attributes as properties (attributes.d.ts), <mien-face> for React,
// Vue, Svelte and Solid, custom-elements.json, which editors read, and the package's name for the studio.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = process.argv[2];
const at = (name) => pathToFileURL(join(folder, name)).href;
const { ATTRIBUTES, propertyOf } = await import(at('attributes.js'));
const { load } = await import(at('mien.js'));
const mien = await load(readFileSync(join(folder, 'mien.wasm')));
const made = (comment, text) => `// ${comment} Made by typed.mjs.\n\n${text}`;
const write = (name, text) => writeFileSync(join(folder, name), text);

/** Lines of at most 120 letters. */
function union(name, words, comment) {
  const lines = [''];
  for (const word of words) {
    const next = ` | ${JSON.stringify(word)}`;
    if (lines.at(-1).length + next.length > 118) lines.push('');
    lines[lines.length - 1] += next;
  }
  return `/** ${comment} */\nexport type ${name} =\n${lines.map((line) => ` ${line}`).join('\n')};\n`;
}

function names() {
  const { families, numbers, styles } = mien.parts(), face = mien.person(mien.code('types'));
  const known = face.names.map(({ name }) => name), clips = face.clips;
  face.free();
  const sets = { Emotion: 'emotion', Muscle: 'muscle', Viseme: 'viseme', Arkit: 'arkit', Facs: 'facs', Vrm: 'vrm', Azure: 'azure' };
  const of = (set) => known.filter((name) => name.startsWith(`${set}.`)).map((name) => name.slice(set.length + 1));
  const found = Object.entries(sets).map(([type, set]) => union(type, of(set), `Of the set "${set}".`));
  const settings = known.filter((name) => !name.includes('/'));
  const parts = families.map(({ name, parts: all }) => `  ${JSON.stringify(name)}: ${all.map((part) => JSON.stringify(part)).join(' | ')};\n`).join('');
  return made('What people are made of and what their faces know, by name.', [...found,
    union('Setting', settings, 'What can be set, beside a face\'s own points and colours.'), union('Clip', clips, 'Clips of people.'),
    union('Style', styles, 'How a person is painted.'), union('NumberName', numbers.map(({ name }) => name), 'Numbers of recipes.'),
    `/** Parts of recipes, by family. */\nexport interface PartNames {\n${parts}}\nexport type Family = keyof PartNames;\n`].join('\n'));
}

const all = Object.entries(ATTRIBUTES).map(([name, { is, says }]) => ({ name, property: propertyOf(name), is, says }));

function attributes() {
  const read = ({ is }) => (is === 'boolean' ? 'boolean' : 'string | null');
  const accessors = all.map((one) => `  /** ${one.says.replace('*/', '')} */\n  get ${one.property}(): ${read(one)};\n  set ${one.property}(value: ${one.is} | null | undefined);\n`);
  const props = all.flatMap(({ name, property, is }) => [...new Set([property, name])].map((key) => `  ${/^\w+$/.test(key) ? key : `'${key}'`}?: ${is} | null;\n`));
  return made("The attributes of <mien-face>, as properties of the element and as what pages' frameworks give it.",
    `import type { AnyNames, Names, Pose, Style, Values, Weights } from './mien.js';\n
export class MienFaceAttributes<N extends AnyNames = Names> extends HTMLElement {\n${accessors.join('')}}\n
export interface MienFaceProps<N extends AnyNames = Names> {\n${props.join('')}  pose?: Pose<N> | null;\n}\n`);
}

/** <mien-face> among the elements that a framework's templates know. */
const FRAMEWORKS = {
  react: `import type { HTMLAttributes, Ref } from 'react';
import type { Drawn, Ended, MienFace, MienFaceProps, Refused } from './element.js';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'mien-face': Omit<HTMLAttributes<MienFace>, keyof MienFaceProps> & MienFaceProps & {
        ref?: Ref<MienFace>;
        key?: string | number | bigint | null;
        class?: string;
        'onmien-drawn'?: (event: CustomEvent<Drawn>) => void;
        'onmien-ended'?: (event: CustomEvent<Ended>) => void;
        'onmien-refused'?: (event: CustomEvent<Refused>) => void;
      };
    }
  }
}
`,
  vue: `import type { HTMLAttributes } from 'vue';
import type { Drawn, Ended, MienFace, MienFaceProps, Refused } from './element.js';

declare module 'vue' {
  interface GlobalComponents {
    'mien-face': new () => MienFace & {
      $props: Omit<HTMLAttributes, keyof MienFaceProps> & MienFaceProps & {
        onMienDrawn?: (event: CustomEvent<Drawn>) => void;
        onMienEnded?: (event: CustomEvent<Ended>) => void;
        onMienRefused?: (event: CustomEvent<Refused>) => void;
      };
    };
  }
}
`,
  svelte: `import type { HTMLAttributes } from 'svelte/elements';
import type { Drawn, Ended, MienFace, MienFaceProps, Refused } from './element.js';

declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'mien-face': Omit<HTMLAttributes<MienFace>, keyof MienFaceProps> & MienFaceProps & {
      'onmien-drawn'?: (event: CustomEvent<Drawn>) => void;
      'onmien-ended'?: (event: CustomEvent<Ended>) => void;
      'onmien-refused'?: (event: CustomEvent<Refused>) => void;
    };
  }
}
`,
  solid: `import type { JSX } from 'solid-js';
import type { Drawn, Ended, MienFace, MienFaceProps, Refused } from './element.js';

declare module 'solid-js' {
  namespace JSX {
    interface IntrinsicElements {
      'mien-face': Omit<HTMLAttributes<MienFace>, keyof MienFaceProps> & MienFaceProps & {
        'on:mien-drawn'?: (event: CustomEvent<Drawn>) => void;
        'on:mien-ended'?: (event: CustomEvent<Ended>) => void;
        'on:mien-refused'?: (event: CustomEvent<Refused>) => void;
      };
    }
  }
}
`,
};

function manifest() {
  const fields = [...all.map(({ name, property, is, says }) => ({ kind: 'field', name: property, type: { text: is }, description: says, attribute: name, reflects: true })),
    { kind: 'field', name: 'pose', type: { text: 'Pose' }, description: 'a pose of more than attributes can say; attributes come on top' }];
  const methods = [['speak', 'speaks a track or a take, or shows one of its moments', [['track', 'string | null'], ['time', 'number']]],
    ['follow', 'the face as a camera saw an actor\'s', [['frame', 'Frame | null']]], ['redraw', 'draws once more', []]];
  const events = [['mien-drawn', 'Drawn', 'the picture is on the screen: detail.ms'], ['mien-ended', 'Ended', 'a track that ran by the face\'s own clock is over: detail.speech'],
    ['mien-refused', 'Refused', 'a place and a sentence: detail.where, detail.what']];
  return { schemaVersion: '1.0.0', readme: 'README.md', modules: [{ kind: 'javascript-module', path: 'element.js',
    declarations: [{ kind: 'class', customElement: true, name: 'MienFace', tagName: 'mien-face', superclass: { name: 'HTMLElement' },
      description: 'A drawn face: a person by a code or a word, or a face of a file.',
      attributes: all.map(({ name, is, says }) => ({ name, type: { text: is }, description: says, fieldName: propertyOf(name) })),
      members: [...fields, ...methods.map(([name, description, parameters]) => ({ kind: 'method', name, description, parameters: parameters.map(([one, text]) => ({ name: one, type: { text } })) }))],
      events: events.map(([name, type, description]) => ({ name, type: { text: `CustomEvent<${type}>` }, description })),
      slots: [{ name: '', description: 'what is shown until the first picture: an <img> or <svg> of a server' }],
      cssParts: [{ name: 'canvas', description: 'the picture' }, { name: 'refused', description: 'the sentence where there is no picture' }] }],
    exports: [{ kind: 'custom-element-definition', name: 'mien-face', declaration: { name: 'MienFace', module: 'element.js' } },
      { kind: 'js', name: 'MienFace', declaration: { name: 'MienFace', module: 'element.js' } }] }] };
}

write('names.d.ts', names());
write('attributes.d.ts', attributes());
for (const [name, text] of Object.entries(FRAMEWORKS)) write(`${name}.d.ts`, made(`<mien-face> in templates of ${name[0].toUpperCase()}${name.slice(1)}.`, `${text}\nexport * from './element.js';\n`));
write('custom-elements.json', `${JSON.stringify(manifest(), null, 1)}\n`);
const { name } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
write('studio/package_name.js', `// What npm installs; made by typed.mjs of package.json.\nexport const PACKAGE = '${name}';\n`);
