// What templates of Vue and Svelte read of the types.
import 'mien-face/svelte';
import 'mien-face/vue';
import type { SvelteHTMLElements } from 'svelte/elements';
import type { GlobalComponents } from 'vue';

type InVue = InstanceType<GlobalComponents['mien-face']>['$props'];
type InSvelte = SvelteHTMLElements['mien-face'];
export const vue: InVue = { seed: 'ada', width: 72, emotion: { joy: 1 }, class: 'avatar', onMienDrawn: ({ detail }) => detail.ms.toFixed(), onMienEnded: ({ detail }) => detail.speech?.trim() };
export const svelte: InSvelte = { seed: 'ada', width: 72, emotion: { joy: 1 }, class: 'avatar', 'onmien-refused': ({ detail }) => detail.what };
// @ts-expect-error there is no such attribute
export const noVue: InVue = { sead: 'ada' };
// @ts-expect-error there is no such attribute
export const noSvelte: InSvelte = { sead: 'ada' };
