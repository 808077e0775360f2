// What tsc must take, and what it must refuse, of the package's types.
import { load, type AnyNames, type Emotion, type PartNames, type Style } from 'mien-face';
import { describe } from 'mien-face/describe';
import { MienFace } from 'mien-face/element';
import { png } from 'mien-face/png';
import { svg } from 'mien-face/svg';

const face = document.querySelector('mien-face')!;
face.emotion = { joy: 0.8, 'left.surprise': 0.3 };
face.emotion = 'joy=0.8';
face.lookAt = [0, 0, 9];
face.faceStyle = 'ink';
face.playing = true;
face.alt = null;
face.pose = { visemes: { aa: 1 }, set: { 'gaze.x': 0.1, 'palette/skin': '#ffd94a', 'brow.left/spine/1': [0.1, 0.2] }, clips: ['idle', 'idle=0.5'] };
face.addEventListener('mien-drawn', ({ detail }) => detail.ms.toFixed());
face.addEventListener('mien-ended', ({ detail }) => detail.speech?.trim());
face.addEventListener('mien-refused', ({ detail }) => `${detail.where}: ${detail.what}`);
const text: string | null = face.emotion;
// @ts-expect-error the name is misspelt
face.emotion = { joyy: 1 };
// @ts-expect-error there is no such style
face.faceStyle = 'oil';
// @ts-expect-error there is no such key
face.pose = { emotion: { joy: 1 } };
// @ts-expect-error there is no such property
face.emotions = 'joy=1';
// @ts-expect-error it is a number
face.addEventListener('mien-drawn', ({ detail }) => detail.ms.trim());

const own = document.createElement('mien-face') as MienFace<AnyNames>;
own.pose = { emotions: { smirk: 1 } };

const mien = await load(), person = mien.person('A66CB-AA5S0-14', { style: 'ink' });
person.draw(72, 72, { emotions: { joy: 1 } }, { deadline: 100 });
// @ts-expect-error there is no such feeling
person.draw(72, 72, { emotions: { smirk: 1 } });
mien.face('{}').draw(72, 72, { emotions: { smirk: 1 } });
const picture: Blob = await png(72, 72, person.strips(72, 72));
const drawn: string = await svg({ seed: 'ada' }, { width: 72, pose: { emotions: { joy: 1 } } });
const said: string = describe(mien.recipe('A66CB-AA5S0-14'));
const style: Style = mien.parts().styles[0]!, feeling: Emotion = 'joy', hair: PartNames['hair'] = 'bob';
export { drawn, feeling, hair, picture, said, style, text };
