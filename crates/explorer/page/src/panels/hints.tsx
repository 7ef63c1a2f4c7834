// Three hints of the first minute; each is struck out when it is done.

import { store } from '../model/store';
import { useStore } from './hooks';

export function Hints() {
  const { past, variants, scene, hidesHints, choosing } = useStore();
  if (hidesHints || !scene) return null;
  const has = (label: RegExp) => past.some((entry) => label.test(entry.label));
  const isSheet = !!scene.sheet;
  const all: [string, boolean][] = [
    [scene.contacts.length ? 'Choose a contact above' : 'Click a link: contact there', has(/contact/)],
    [isSheet ? 'Drag a ring: m̄ follows' : 'Drag a link: m̄ follows', has(isSheet ? /mm [xyz]|^move / : /^drag /)],
    ['Keep as A, then compare', variants.length > 0],
  ];
  if (choosing || all.every(([, done]) => done)) return null;
  return (
    <p class="hints">
      {all.map(([text, done], i) => <span key={text} class={done ? 'done' : ''}><b>{i + 1}</b>{text}</span>)}
      <button onClick={() => store.set({ hidesHints: true })}>Hide</button>
    </p>
  );
}
