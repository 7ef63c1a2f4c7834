import { useEffect, useReducer } from 'preact/hooks';
import { store } from '../model/store';

/** Renders a component again when the store changes. */
export function useStore() {
  const [, render] = useReducer((count: number, _: void) => count + 1, 0);
  useEffect(() => store.listen(() => render()), []);
  return store;
}
