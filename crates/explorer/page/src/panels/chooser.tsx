// List of the models of a folder.

import { useEffect, useRef } from 'preact/hooks';
import { store } from '../model/store';
import { useStore } from './hooks';

export function Chooser() {
  const { folder } = useStore();
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (folder) dialog.current?.showModal();
  }, [folder]);
  if (!folder) return null;
  const close = () => store.set({ folder: undefined });
  return (
    <dialog ref={dialog} class="chooser" aria-label="Models of the folder" onClose={close}>
      <h2>{folder.models.length} models in the folder</h2>
      <ul>
        {folder.models.map((model) => {
          const [, place, name] = /^(.*\/)?([^/]*)$/.exec(model.path)!;
          return (
            <li key={model.path}>
              <button onClick={() => void store.openFromFolder(model, folder.files)}>
                <b>{name}</b> <span class="soft">{model.kind}{model.within ? `, included in ${model.within.replace(/.*\//, '')}` : ''}</span>
                {place ? <span class="soft place">{place}</span> : null}
              </button>
            </li>
          );
        })}
      </ul>
      <p class="row"><button onClick={close}>Cancel</button></p>
    </dialog>
  );
}
