// Contributions, hardpoints, masses, motion ratios and findings as tables: the text alternative to the picture.

import { useMemo, useState } from 'preact/hooks';
import type { Triple } from '../engine/protocol';
import { digits, fixed, signed, words } from '../model/numbers';
import { store } from '../model/store';
import { rampColour } from '../view/space';
import { Details } from './details';
import { NumberField } from './field';
import { useStore } from './hooks';

/** Shares below this are counted together. */
const SMALL = 0.0005;

export function Contributions() {
  const { posed, problem } = useStore();
  if (!posed) return null;
  const { report } = posed;
  const all = [
    ...report.bodies.map((b) => ({ name: b.link, share: b.share ?? 0 })),
    ...report.rotors.map((r) => ({ name: `rotor of ${r.joint}`, share: r.share ?? 0 })),
  ].sort((a, b) => b.share - a.share);
  const shown = all.filter((row) => row.share >= SMALL);
  const most = Math.max(1e-12, shown[0]?.share ?? 0);
  if (report.status !== 'finite') return null;
  return (
    <section class={problem ? 'stale' : ''}>
      <h2>Contributions to m̄</h2>
      <table class="shares">
        <colgroup><col class="of-name" /><col /><col class="of-share" /><col class="of-mass" /></colgroup>
        <tbody>
          {shown.map(({ name, share }) => (
            <tr key={name}>
              <th scope="row" title={name}>{words(name)}</th>
              <td class="bar"><span style={{ width: `${(100 * share) / most}%`, background: `#${rampColour(share / most).getHexString()}` }} /></td>
              <td class="n">{fixed(100 * share, 1)} %</td>
              <td class="n soft">{digits(share * report.effective_mass!, 3)} {report.unit}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {shown.length < all.length ? <p class="soft">{all.length - shown.length} further links or frames: less than {SMALL * 100} % each.</p> : null}
    </section>
  );
}

export function Hardpoints() {
  const { scene, selected } = useStore();
  const sheet = scene?.sheet;
  if (!sheet?.hardpoints.length) return null;
  const moved = Object.keys(store.study?.model.move ?? {}).length;
  const decimals = { m: 4, cm: 2, mm: 1, in: 3 }[sheet.unit] ?? 3;
  const step = { m: 0.001, cm: 0.1, mm: 1, in: 0.05 }[sheet.unit] ?? 0.001;
  return (
    <Details title={`Hardpoints, ${sheet.unit}`} startsOpen content={() => (
      <>
        <p class="soft">Drag in the view, or type; arrow keys move by {step} {sheet.unit}. {sheet.axes}.</p>
        <table class="points">
          <thead><tr><th>name</th><th>x</th><th>y</th><th>z</th></tr></thead>
          <tbody>
            {sheet.hardpoints.map(({ name }) => <PointRow key={name} name={name} isSelected={name === selected} decimals={decimals} step={step} />)}
          </tbody>
        </table>
        {moved ? (
          <p class="row"><button onClick={() => {
            const { move, ...model } = store.study!.model;
            void move;
            store.change({ ...store.study!, model }, 'all hardpoints back');
          }}>All hardpoints back ({moved} moved)</button></p>
        ) : null}
      </>
    )} />
  );
}

/** Row of a hardpoint. It is rendered again only after a change of its own, because each result of a drag renders the table. */
function PointRow({ name, isSelected, decimals, step }: { name: string; isSelected: boolean; decimals: number; step: number }) {
  const sheet = store.opened!.scene.sheet!;
  const by = store.moved(name);
  // The scene has the moves of the last result; the numbers follow the study at once.
  const { coordinates } = sheet.hardpoints.find((p) => p.name === name)!;
  return useMemo(() => {
    const initial = initialMove(name);
    return (
      <tr class={isSelected ? 'selected' : ''} onClick={() => store.set({ selected: name })}>
        <th scope="row" title={by.some((x) => x !== 0) ? `Δ ${by.map((x) => signed(x * 1000, 1)).join(', ')} mm` : name}>{name}</th>
        {[0, 1, 2].map((k) => {
          const drawn = coordinates[k] - initial[k];
          return (
            <td key={k}>
              <NumberField label={`${name} ${'xyz'[k]}, ${sheet.unit}`} value={(drawn + by[k]) / sheet.unit_length} decimals={decimals} step={step} changed={by[k] !== 0}
                title={by[k] !== 0 ? `moved by ${signed(by[k] * 1000, 1)} mm` : undefined}
                set={(x) => {
                  const to = [...store.moved(name)] as Triple;
                  to[k] = x * sheet.unit_length - drawn;
                  store.movePoint(name, to, `${name} ${'xyz'[k]}`);
                }} />
            </td>
          );
        })}
      </tr>
    );
  }, [name, isSelected, coordinates, ...by]);
}

/** Displacement that a hardpoint had when the model was opened, m. */
function initialMove(name: string): Triple {
  return store.movedAtOpening[name] ?? [0, 0, 0];
}

/** Unit of moments of inertia, and the number of these units in 1 kg·m². `largest`: largest moment, kg·m². */
function inertiaUnit(largest: number): [string, number] {
  if (largest >= 10) return ['kg·m²', 1];
  return largest >= 1e-3 ? ['kg·cm²', 1e4] : ['kg·mm²', 1e6];
}

export function Masses() {
  const { scene, study } = useStore();
  if (!scene || !study) return null;
  const changes = study.model.link_mass ?? {};
  const links = store.opened!.scene.links.filter((l) => l.mass > 0 || changes[l.name] !== undefined);
  if (!links.length) return null;
  const setMass = (name: string, value: number) => {
    const link_mass = { ...changes, [name]: Math.max(0, Math.round(value * 1e6) / 1e6) };
    store.change({ ...study, model: { ...study.model, link_mass } }, `mass of ${name}`);
  };
  const turned = study.model.link_inertia ?? {};
  const setMoments = (name: string, values: Triple) => {
    const link_inertia = { ...turned, [name]: values };
    store.change({ ...study, model: { ...study.model, link_inertia } }, `moments of inertia of ${name}`);
  };
  const asInFile = (name: string) => {
    const { link_mass, link_inertia, ...rest } = study.model;
    const without = (table: object | undefined) => Object.fromEntries(Object.entries(table ?? {}).filter(([key]) => key !== name));
    const [masses, inertias] = [without(link_mass), without(link_inertia)];
    const model = {
      ...rest, ...(Object.keys(masses).length ? { link_mass: masses } : {}), ...(Object.keys(inertias).length ? { link_inertia: inertias } : {}),
    };
    store.change({ ...study, model }, `${name} as in the file`);
  };
  // The scene contains the changes of the last result, including the moments that are scaled by a changed mass.
  const moments = (name: string) => turned[name] ?? scene.links.find((l) => l.name === name)?.moments;
  const [unit, perUnit] = inertiaUnit(Math.max(0, ...store.opened!.scene.links.flatMap((l) => l.moments ?? [])));
  return (
    <Details title="Masses and moments of inertia" startsOpen={!scene.sheet?.hardpoints.length} content={() => (
      <>
        <table class="points inertias">
          <thead><tr><th /><th>kg</th>{['xx', 'yy', 'zz'].map((axes) => <th key={axes}>I<sub>{axes}</sub>, {unit}</th>)}</tr></thead>
          <tbody>
            {links.map((link) => {
              const { name } = link;
              const about = moments(name);
              const isChanged = changes[name] !== undefined || turned[name] !== undefined;
              return (
                <tr key={name}>
                  <th scope="row" title={name}>
                    {isChanged ? <button class="quiet" onClick={() => asInFile(name)} title="as in the file" aria-label={`mass and inertia of ${name} as in the file`}>↺</button> : null}{name}
                  </th>
                  <td><NumberField label={`mass of ${name}, kg`} value={changes[name] ?? link.mass} decimals={3} step={0.1} changed={changes[name] !== undefined} set={(x) => setMass(name, x)} /></td>
                  {about ? about.map((moment, k) => {
                    const shown = moment * perUnit;
                    const decimals = shown > 0 ? Math.min(5, Math.max(0, 2 - Math.floor(Math.log10(shown)))) : 2;
                    return (
                      <td key={k}>
                        <NumberField label={`${'xyz'[k]} moment of inertia of ${name}, ${unit}`} value={shown} decimals={decimals} step={10 ** (1 - decimals)}
                          changed={turned[name] !== undefined}
                          set={(x) => setMoments(name, about.map((own, i) => Number((i === k ? Math.max(0, x) / perUnit : own).toPrecision(9))) as Triple)} />
                      </td>
                    );
                  }) : <td colSpan={3} />}
                </tr>
              );
            })}
          </tbody>
        </table>
        <p class="soft">Moments about the centre of mass, along the axes of the link. A changed mass scales them in proportion, unless they are changed too.</p>
      </>
    )} />
  );
}

export function Ratios() {
  const { posed, problem } = useStore();
  const ratios = posed?.report.motion_ratios ?? [];
  if (!ratios.length) return null;
  return (
    <section class={problem ? 'stale' : ''}>
      <h2>Motion ratios</h2>
      <table class="plain"><tbody>
        {ratios.map((r) => (
          <tr key={r.link}>
            <th scope="row">{words(r.link)}</th><td class="n">{r.contact_per_wheel === null ? 'infinite' : fixed(r.contact_per_wheel, 4)}</td>
          </tr>
        ))}
      </tbody></table>
      <p class="soft">Closing of the contact per upward travel of the point{ratios.some((r) => !r.one_travel) ? ', in the motion of the impact' : ''}.</p>
    </section>
  );
}

export function Findings() {
  const { findings } = useStore();
  const [open, setOpen] = useState(false);
  const warnings = findings.filter((f) => f.severity !== 'note');
  if (!findings.length) return null;
  const shown = open ? findings : warnings;
  return (
    <section>
      <h2>Findings</h2>
      {shown.map((f, i) => <p key={i} class={`finding ${f.severity}`}>{f.severity === 'note' ? '' : `${f.severity}: `}{f.line ? `line ${f.line}: ` : ''}{f.message}</p>)}
      {findings.length > warnings.length ? (
        <button class="quiet" aria-expanded={open} onClick={() => setOpen(!open)}>{open ? 'Fewer' : `${findings.length - warnings.length} ${findings.length - warnings.length === 1 ? 'note' : 'notes'}`}</button>
      ) : null}
    </section>
  );
}

export function CurveTable() {
  const { curve, driver, posed } = useStore();
  if (!driver || !curve || !('ok' in curve)) return null;
  return (
    <Details title="Curve as a table" content={() => (
      <table class="plain curve-table">
        <thead><tr><th>{driver.label}, {driver.unit.name}</th><th>m̄, {posed?.report.unit ?? 'kg'}</th></tr></thead>
        <tbody>
          {curve.ok.rows.map((row, i) => (
            <tr key={i}><td class="n">{fixed(row.at * driver.unit.perSi, 2)}</td><td class="n" title={row.why ?? ''}>{row.mass === null ? row.status : digits(row.mass, 6)}</td></tr>
          ))}
        </tbody>
      </table>
    )} />
  );
}
