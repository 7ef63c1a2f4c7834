// Export: command, study, Python, files, link.

import { useState } from 'preact/hooks';
import { vary } from '../model/drivers';
import { plain } from '../model/numbers';
import { command, pythonText, studyText } from '../model/texts';
import { ROWS, store } from '../model/store';
import { useStore } from './hooks';
import { rowsOf } from './curve';

export function save(name: string, content: BlobPart, type: string) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Copies a text. A page opened from a file may have no access to the clipboard; then the text is selected and copied. */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = document.createElement('textarea');
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}

const stem = () => store.fileName.replace(/.*[\\/]/, '').replace(/\.[^.]*$/, '') || 'percuss';

export function figureText(): string | undefined {
  const svg = document.querySelector<SVGElement>('.plot svg');
  if (!svg) return undefined;
  const made = svg.cloneNode(true) as SVGElement;
  made.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  // The saved figure does not contain the style sheet of the page, and is on white ground in a dark page too.
  svg.classList.add('paper');
  const originals = [svg, ...svg.querySelectorAll<SVGElement>('*')];
  [made, ...made.querySelectorAll<SVGElement>('*')].forEach((node, i) => {
    const style = getComputedStyle(originals[i]);
    for (const key of ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'font-size', 'font-family', 'font-weight']) {
      node.setAttribute(key, style.getPropertyValue(key));
    }
    node.removeAttribute('class');
  });
  svg.classList.remove('paper');
  return made.outerHTML;
}

export function csvText(): string | undefined {
  const curve = rowsOf();
  if (!curve) return undefined;
  const unit = curve.unit ? ` [${curve.unit}]` : '';
  const lines = curve.rows.map((r) => [plain(r.at), r.status, r.mass ?? '', r.error ?? '', r.gap ?? ''].join(','));
  const quoted = /[",\n]/.test(curve.name) ? `"${curve.name.replaceAll('"', '""')}"` : curve.name;
  return `${quoted}${unit},status,effective_mass [kg],error [kg],gap [m]\n${lines.join('\n')}\n`;
}

/** The page with the present state, as a file. */
function pageText(): string {
  const { study, text, files, fileName, shapes, driver, view } = store;
  const start = JSON.stringify({ model: { name: fileName, text, files, shapes }, study, driver: driver?.name, view }).replaceAll('<', '\\u003c');
  const data = document.documentElement.cloneNode(true) as HTMLElement;
  data.querySelector('#start')!.textContent = start;
  data.querySelector('#app')!.innerHTML = '';
  return `<!DOCTYPE html>\n${data.outerHTML}\n`;
}

/** Saves the sheet with the moved hardpoints and the changed masses. */
export async function saveSheet() {
  const sheet = await store.sheetText();
  if (sheet) save(`${stem()}-changed.toml`, sheet, 'text/plain');
}

export function Away({ png }: { png(): string | undefined }) {
  const { study, driver, scene } = useStore();
  const [tab, setTab] = useState<'Command' | 'Study' | 'Python'>('Command');
  const [copied, setCopied] = useState('');
  if (!study || !scene) return null;
  const text = { Command: () => command(study), Study: () => studyText(study, driver && vary(driver, ROWS)), Python: () => pythonText(study) }[tab]();
  const note = (what: string) => {
    setCopied(what);
    setTimeout(() => setCopied(''), 1500);
  };
  return (
    <section>
      <h2>The same elsewhere</h2>
      <div class="tabs" role="tablist">
        {(['Command', 'Study', 'Python'] as const).map((name) => (
          <button key={name} role="tab" aria-selected={tab === name} onClick={() => setTab(name)}>{name}</button>
        ))}
        <button class="copy" onClick={async () => note((await copy(text)) ? 'Copied' : 'Not permitted')}>{copied || 'Copy'}</button>
      </div>
      <pre class="text" tabIndex={0} aria-label={tab}>{text}</pre>
      <p class="row">
        <button onClick={() => { const csv = csvText(); if (csv) save(`${stem()}-curve.csv`, csv, 'text/csv'); }}>Curve CSV</button>
        <button onClick={() => { const svg = figureText(); if (svg) save(`${stem()}-curve.svg`, svg, 'image/svg+xml'); }}>Curve SVG</button>
        <button onClick={async () => {
          const url = png();
          if (!url) return store.set({ notice: 'This browser draws no picture of the view: it has no WebGL.' });
          const bytes = Uint8Array.from(atob(url.split(',')[1]), (c) => c.charCodeAt(0));
          save(`${stem()}-view.png`, bytes, 'image/png');
        }}>View PNG</button>
        {scene.sheet?.hardpoints.length ? (
          <button onClick={saveSheet}>Changed sheet</button>
        ) : null}
        <button onClick={() => save(`${stem()}.html`, pageText(), 'text/html')}>Save page</button>
      </p>
    </section>
  );
}
