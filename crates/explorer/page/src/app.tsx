// The page: bar, view, curve, side.

import { useEffect, useRef, useState } from 'preact/hooks';
import { Vector3 } from 'three';
import type { ViewName } from './model/link';
import { store } from './model/store';
import { digits, fixed, words } from './model/numbers';
import { toHash } from './model/link';
import { nextName } from './model/variants';
import { filesOfDrop, filesOfInput } from './model/files';
import { Away, copy } from './panels/away';
import { Chooser } from './panels/chooser';
import { CurvePanel } from './panels/curve';
import { Hints } from './panels/hints';
import { useStore } from './panels/hooks';
import { ContactCards } from './panels/contacts';
import { Result } from './panels/result';
import { Tabs } from './panels/tabs';
import { VariantTable } from './panels/variants';
import { CurveTable, Findings } from './panels/tables';
import { rangeOfMap } from './view/further';
import { rampGradient } from './view/space';
import { View } from './view/view';

const VIEWS: [ViewName, string, string][] = [['3d', '3D', '3'], ['front', 'Front', 'F'], ['side', 'Side', 'S'], ['top', 'Top', 'T']];

export function App() {
  const { failure, opened, refusal } = useStore();
  const view = useRef<View | null>(null);
  const [dropping, setDropping] = useState(false);
  useEffect(() => {
    const key = (event: KeyboardEvent) => {
      const target = event.target as HTMLElement;
      const typing = target.matches('input, select, textarea');
      // Without this, the browser could undo text in a field that does not have the focus.
      const ownUndo = typing && (target as HTMLInputElement).type === 'text' && (store.inGesture || !target.matches('.number'));
      if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z' && !ownUndo) {
        event.preventDefault();
        if (event.shiftKey) store.redo();
        else store.undo();
      } else if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'y' && !typing) {
        event.preventDefault();
        store.redo();
      } else if (event.key === 'Escape') {
        if (store.choosing) store.set({ choosing: false });
        void store.end();
      } else if (!typing && !event.ctrlKey && !event.metaKey && !event.altKey && !store.inGesture) {
        const chosen = VIEWS.find(([, , letter]) => letter === event.key.toUpperCase());
        if (chosen) store.set({ view: chosen[0] });
        if (event.key === '0') view.current?.fit();
      }
    };
    const drop = (event: DragEvent) => {
      event.preventDefault();
      setDropping(false);
      if (event.dataTransfer) void openDropped(event.dataTransfer);
    };
    const over = (event: DragEvent) => {
      event.preventDefault();
      setDropping(!!event.dataTransfer?.types.includes('Files'));
    };
    const leave = (event: DragEvent) => {
      if (!event.relatedTarget) setDropping(false);
    };
    addEventListener('keydown', key);
    addEventListener('drop', drop);
    addEventListener('dragover', over);
    addEventListener('dragleave', leave);
    return () => {
      removeEventListener('keydown', key);
      removeEventListener('drop', drop);
      removeEventListener('dragover', over);
      removeEventListener('dragleave', leave);
    };
  }, []);
  return (
    <div class="page">
      {dropping ? <div class="drop">Drop a model file or a folder</div> : null}
      <Bar />
      <Notice />
      <Chooser />
      {failure ? <main class="message"><div class="box bad"><p><b>No engine.</b> {failure}</p></div></main> : null}
      {refusal ? <Refused /> : null}
      <ContactCards />
      {opened ? (
        <main class="work">
          <Stage view={view} />
          <CurvePanel />
          <aside class="side" aria-label="Question and result">
            <Result />
            <Findings />
            <VariantTable />
            <Tabs />
            <Away png={() => view.current?.png()} />
            <CurveTable />
          </aside>
        </main>
      ) : failure || refusal ? null : <main class="message"><p class="soft">The engine starts …</p></main>}
    </div>
  );
}

async function openFile(file: File) {
  store.set({ notice: undefined });
  await store.open({ name: file.name, text: await file.text() });
}

/** Opens a single dropped file, or a model from several dropped files or folders. */
async function openDropped(data: DataTransfer) {
  try {
    const files = await filesOfDrop(data);
    if (files.length === 1 && !files[0].path.includes('/')) await openFile(files[0].file);
    else if (files.length) await store.openFolder(files);
  } catch (error) {
    store.set({ notice: `The dropped folder cannot be read: ${(error as Error).message}. Choose it by Folder….` });
  }
}

function Bar() {
  const { fileName, past, future, posed, problem, busy, scene, variants } = useStore();
  const input = useRef<HTMLInputElement>(null);
  const folder = useRef<HTMLInputElement>(null);
  useEffect(() => folder.current!.setAttribute('webkitdirectory', ''), []);
  const [copied, setCopied] = useState(false);
  const short = fileName.replace(/.*[\\/]/, '');
  return (
    <header class="bar">
      <b class="brand" title="percuss explorer">{scene?.name ? words(scene.name) : 'percuss explorer'}</b>
      <span class="file" title={scene?.name}>{short}</span>
      {scene?.sheet ? <span class="soft sheet-axes">{scene.sheet.axes}</span> : null}
      <button onClick={() => input.current!.click()}>Open…</button>
      <input ref={input} type="file" hidden accept=".urdf,.xml,.mjcf,.sdf,.world,.toml,.csv,.json" aria-label="Model file"
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          if (file) void openFile(file);
          event.currentTarget.value = '';
        }} />
      <button onClick={() => folder.current!.click()} title="Opens a folder that has the model with its included files and meshes">Folder…</button>
      <input ref={folder} type="file" hidden aria-label="Folder with a model"
        onChange={(event) => {
          const { files } = event.currentTarget;
          if (files?.length) void store.openFolder(filesOfInput(files));
          event.currentTarget.value = '';
        }} />
      {busy ? <span class="busy" role="status">computing … <button onClick={() => void store.end()}>End (Esc)</button></span> : null}
      <span class="grow" />
      <button disabled={!past.length} title={past.at(-1) ? `Undo ${past.at(-1)!.label} (Ctrl Z)` : 'Undo'} onClick={() => store.undo()} aria-label="Undo">↶<span class="wide"> Undo</span></button>
      <button disabled={!future.length} title="Redo (Ctrl Shift Z)" onClick={() => store.redo()} aria-label="Redo">↷<span class="wide"> Redo</span></button>
      <button disabled={!posed || !!problem} onClick={() => store.freeze()} title="Keeps the present design for comparison"><span class="wide">Keep as </span><span class="narrow">Keep </span>{nextName(variants)}</button>
      <button onClick={async () => {
        history.replaceState(null, '', await toHash(store.linked()));
        setCopied(await copy(location.href));
        setTimeout(() => setCopied(false), 1500);
      }} aria-label="Copy link">{copied ? 'Copied' : <><span class="wide">Copy link</span><span class="narrow">Link</span></>}</button>
    </header>
  );
}

function Notice() {
  const { notice } = useStore();
  if (!notice) return null;
  return <p class="notice" role="status">{notice} <button class="quiet" onClick={() => store.set({ notice: undefined })}>Close</button></p>;
}

function Refused() {
  const { refusal, opened } = store;
  return (
    <div class={opened ? 'refused' : 'refused alone'} role="alert">
      <p><b>The model is refused.</b> {refusal!.diagnostics.length ? '' : refusal!.message}</p>
      {refusal!.diagnostics.map((d, i) => <p key={i} class={`finding ${d.severity}`}>{d.path ? `${d.path}${d.line ? `:${d.line}` : ''}: ` : ''}{d.severity}: {d.message}</p>)}
      {opened ? <button onClick={() => store.set({ refusal: undefined })}>Keep the open model</button> : null}
    </div>
  );
}

interface Picked { link: number; at: Vector3; normal: Vector3 }

function Stage({ view }: { view: { current: View | null } }) {
  const { view: name, posed, problem, colours, scene, showsPoints, showsNames, showsMotion, showsDesign } = useStore();
  const element = useRef<HTMLDivElement>(null);
  const [picked, setPicked] = useState<Picked | undefined>();
  useEffect(() => {
    const made = new View(element.current!, (link, at, normal) => setPicked(link === undefined ? undefined : { link, at: at!, normal: normal! }));
    view.current = made;
    // Tests find the marks of the picture by their positions.
    (window as unknown as { percussView: View }).percussView = made;
    return () => made.dispose();
  }, []);
  const most = Math.max(0, ...(posed?.report.bodies.map((b) => b.share ?? 0) ?? []));
  const body = picked && scene?.links[picked.link];
  const share = picked && posed?.report.bodies[picked.link]?.share;
  return (
    <section class="stage" aria-label="Mechanism">
      <div ref={element} class="canvas" role="img" aria-label={describe()} />
      <div class="views" role="group" aria-label="View">
        {VIEWS.map(([id, label, letter]) => (
          <button key={id} aria-pressed={name === id} title={`${label} (${letter})`} onClick={() => store.set({ view: id })}>{label}</button>
        ))}
        <button title="Fit (0)" aria-label="Fit the view" onClick={() => view.current?.fit()}>⤢</button>
      </div>
      <details class="menu">
        <summary>Show</summary>
        <div class="shows" role="group" aria-label="Shown">
        {scene?.sheet ? <Toggle on={showsPoints} label="Hardpoints" set={(on) => store.set({ showsPoints: on })} /> : null}
        <Toggle on={colours === 'share'} label="Shares" title="Colours of the links by their shares of m̄" set={(on) => store.set({ colours: on ? 'share' : 'plain' })} />
        <Toggle on={showsNames} label="Names" title="Names of the links with their shares of m̄" set={(on) => store.set({ showsNames: on })} />
        <Toggle on={showsMotion} label="Motion" title="Velocities of the centres of mass when the gap closes" set={(on) => store.set({ showsMotion: on })} />
        <Toggle on={showsDesign} label="Design pose" set={(on) => store.set({ showsDesign: on })} />
        <Toggle on={store.answers.isShown('directions')} label="Directions" title="Ellipsoid of m̄ over directions at the contact point: its radius is in proportion to √m̄"
          set={(on) => store.answers.show('directions', on)} />
        {store.shapes?.some((shape) => shape) ? (
          <Toggle on={store.answers.isShown('map')} label="Map" title="m̄ of a contact at each facet, along its outward normal" set={(on) => store.answers.show('map', on)} />
        ) : null}
      </div>
      </details>
      <MapLegend />
      {!store.answers.isShown('map') && posed?.report.status === 'finite' && most > 0 && colours === 'share' && !problem ? (
        <div class="legend"><span>share of m̄ 0</span><i style={{ backgroundImage: `linear-gradient(90deg, ${rampGradient()})` }} /><span>{fixed(100 * most, 0)} %</span></div>
      ) : null}
      {body && picked ? (
        <div class="picked" role="dialog" aria-label={body.name}>
          <b>{body.name}</b>
          <span class="soft">{body.mass > 0 ? `${fixed(body.mass, 3)} kg` : 'no mass'}{share ? ` · ${fixed(100 * share, 1)} % of m̄` : ''}</span>
          {picked.link === scene!.root ? null : (
            <button onClick={() => {
              view.current!.contactAt(picked.link, picked.at, picked.normal);
              setPicked(undefined);
            }}>Contact here</button>
          )}
          <button class="quiet" aria-label="Close" onClick={() => setPicked(undefined)}>×</button>
        </div>
      ) : <Hints />}
    </section>
  );
}

function MapLegend() {
  const found = store.answers.results.map;
  if (!store.answers.isShown('map')) return null;
  if (!found) return <div class="legend">computing the map …</div>;
  if ('refused' in found) return <div class="legend">{found.refused.message}</div>;
  const range = rangeOfMap(found.ok);
  if (!range) return <div class="legend">no facet has a finite m̄</div>;
  return (
    <div class="legend" data-map={range.join(' ')}>
      <span>m̄ {digits(range[0], 3)}</span><i style={{ backgroundImage: `linear-gradient(90deg, ${rampGradient()})` }} /><span>{digits(range[1], 3)} kg</span>
    </div>
  );
}

function Toggle({ on, label, title, set }: { on: boolean; label: string; title?: string; set(on: boolean): void }) {
  return <button aria-pressed={on} title={title} onClick={() => set(!on)}>{label}</button>;
}

/** The picture in words. */
function describe(): string {
  const { scene, posed } = store;
  if (!scene) return 'Mechanism';
  const contact = posed?.report.contact;
  const where = contact ? `; contact on ${contact.link} at ${contact.point_world.map((x, k) => fixed(x * store.axes[k] * 1000, 0)).join(', ')} mm` : '';
  return `${scene.name}: ${scene.links.length} links, ${scene.joints.length} joints, ${scene.closures.length} loop closures${where}`;
}
