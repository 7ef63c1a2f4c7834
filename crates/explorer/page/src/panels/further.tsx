// Further results: kinematics of the wheels, damper and simulator, impact, safe speed. A panel requests its result only while its tab is
// displayed and it is open.

import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import type { DiagnosticRecord, KinematicsReport, Outcome } from '../engine/protocol';
import { LIMITS, type Kind, type Results, type TextSetting } from '../model/answers';
import { digits, fixed, signed, words } from '../model/numbers';
import { store } from '../model/store';
import { commandOf, kinematicsCommand } from '../model/texts';
import { copy } from './away';
import { Details } from './details';
import { TextField } from './field';
import { useStore } from './hooks';
import { Moments } from './moments';

const TOOLS = [
  'mujoco', 'drake', 'gazebo', 'gazebo-classic', 'ode', 'bullet', 'physx', 'rapier', 'chrono', 'adams', 'simscape', 'dart', 'opensim', 'exudyn',
  'newton', 'jolt',
];
const LAWS = ['kelvin-voigt', 'hunt-crossley'];
const REGIONS = ['skull', 'face', 'neck', 'back', 'chest', 'abdomen', 'pelvis', 'upper-arm', 'lower-arm', 'hand', 'thigh', 'lower-leg'];

function Panel<K extends Kind>({ kind, title, missing, children, result, command }: {
  kind: K; title: string; missing?: string; children?: ComponentChildren; result(found: Results[K]): ComponentChildren; command(): string;
}) {
  useStore();
  const { answers } = store;
  const found = answers.results[kind] as Outcome<Results[K]> | undefined;
  return (
    <details class={`further ${kind}`} open={answers.isOpen(kind)} onToggle={(event) => answers.fold(kind, event.currentTarget.open)}>
      <summary><h2>{title}</h2></summary>
      {answers.isShown(kind) ? children : null}
      {answers.leftOut[kind]?.length ? <p class="soft">Keys of the study that this panel leaves out: {answers.leftOut[kind].join(', ')}.</p> : null}
      <div class={store.problem || !answers.isFresh() ? 'stale' : ''}>
        {missing ? <p class="soft">{missing}</p> : !found ? (answers.isShown(kind) ? <p class="soft">Computing …</p> : null)
          : 'refused' in found ? <p class="box warn">{found.refused.message}</p>
            : <>{result(found.ok)}<WarningsOfPanel of={found.ok} /><CommandOfPanel text={command()} /></>}
      </div>
    </details>
  );
}

/** Warnings of a result that the list of findings on the page does not contain. */
function WarningsOfPanel({ of }: { of: unknown }) {
  const shown = new Set(store.findings.map((finding) => finding.message));
  const found = [of].flat().flatMap((report) => (report as { diagnostics?: DiagnosticRecord[] }).diagnostics ?? []);
  const texts = new Set(found.filter((finding) => finding.severity === 'warning' && !shown.has(finding.message)).map((finding) => finding.message));
  return <>{[...texts].map((text) => <p key={text} class="finding warning">{text}</p>)}</>;
}

/** Command with the numbers of a panel. */
function CommandOfPanel({ text }: { text: string }) {
  const [copied, setCopied] = useState('');
  return (
    <details class="command">
      <summary>The same as a command</summary>
      <pre class="text" tabIndex={0}>{text}</pre>
      <button onClick={async () => {
        setCopied((await copy(text)) ? 'Copied' : 'Not permitted');
        setTimeout(() => setCopied(''), 1500);
      }}>{copied || 'Copy'}</button>
    </details>
  );
}

function Field({ name, label, hint }: { name: TextSetting; label: string; hint?: string }) {
  return (
    <label class="line"><span>{label}</span>
      <TextField class="setting" hint={hint} value={store.answers.settings[name]} set={(text) => store.answers.set({ [name]: text })} />
    </label>
  );
}

/** Options of a list, including the selected value, which can come from a study. */
function withChosen(of: readonly (string | [string, string])[], chosen: string) {
  return of.some((entry) => (typeof entry === 'string' ? entry : entry[0]) === chosen) ? of : [...of, chosen];
}

function Choice({ name, label, of }: { name: TextSetting; label: string; of: readonly (string | [string, string])[] }) {
  return (
    <label class="line"><span>{label}</span>
      <select value={store.answers.settings[name]} onChange={(event) => store.answers.set({ [name]: event.currentTarget.value })}>
        {withChosen(of, store.answers.settings[name]).map((entry) => {
          const [value, text] = typeof entry === 'string' ? [entry, entry] : entry;
          return <option key={value} value={value}>{text}</option>;
        })}
      </select>
    </label>
  );
}

function Rows({ of }: { of: [string, string | null][] }) {
  return (
    <table class="plain"><tbody>
      {of.filter(([, value]) => value !== null).map(([name, value]) => <tr key={name}><th scope="row">{name}</th><td class="n">{value}</td></tr>)}
    </tbody></table>
  );
}

const quantity = (x: number | null, scale: number, unit: string) => (x === null ? null : `${digits(x * scale, 4)} ${unit}`);

/** Texts of a damper that slides, and of one that turns: mass, damping, dissipation, force, penetration with its scale, speed. */
const SLIDES = { mass: ['mass at the stop', 'kg'], damping: 'N·s/m', dissipation: 's/m', force: ['peak force', 'N'], depth: [1000, 'mm'], speed: 'm/s', stiffness: '200 N/mm', fast: '1 m/s' } as const;
const TURNS = {
  mass: ['inertia at the stop', 'kg·m²'], damping: 'N·m·s/rad', dissipation: 's/rad', force: ['peak moment', 'N·m'], depth: [180 / Math.PI, '°'], speed: 'rad/s',
  stiffness: '2000 Nm/rad', fast: '1 rad/s',
} as const;

/** Stops of the joints with limits, as values of the setting. */
function jointStops(): { value: string; label: string; isTurn: boolean }[] {
  return (store.scene?.joints ?? []).flatMap(({ name, kind, limits }) => {
    const isTurn = kind === 'revolute' || kind === 'continuous';
    if (!limits || !(isTurn || kind === 'prismatic')) return [];
    return (['lower', 'upper'] as const).map((end, i) => ({
      value: `${name}:${end}`, isTurn, label: `${end} stop of ${name}, ${isTurn ? `${fixed((limits[i] * 180) / Math.PI, 1)}°` : `${fixed(limits[i] * 1000, 1)} mm`}`,
    }));
  });
}

/** Contact of the damper: that of the page, or the stop of a joint, with units of its motion. */
function StopChoice() {
  const stops = jointStops();
  if (!stops.length) return null;
  const { settings } = store.answers;
  const turns = (value: string) => stops.some((stop) => stop.value === value && stop.isTurn);
  return (
    <label class="line"><span>contact</span>
      <select value={settings.stop} onChange={(event) => {
        const stop = event.currentTarget.value;
        const units = turns(stop) ? TURNS : SLIDES;
        store.answers.set({ stop, ...(turns(stop) === turns(settings.stop) ? {} : { stiffness: units.stiffness, speed: units.fast }) });
      }}>
        <option value="">the contact shown</option>
        {stops.map(({ value, label }) => <option key={value} value={value}>{label}</option>)}
      </select>
    </label>
  );
}

export function DamperPanel() {
  const { further } = store.answers.settings;
  return (
    <Panel kind="damper" title="Damper and simulator" command={() => commandOf('damper', store.study!, store.answers.settings)} result={({ exports, ...damper }) => {
      const units = damper.stop?.motion === 'turn' ? TURNS : SLIDES;
      return (
        <>
          <Rows of={[
            [units.mass[0], damper.stop ? quantity(damper.effective_mass, 1, units.mass[1]) : null],
            ['damping c', quantity(damper.damping, 1, units.damping)],
            ['damping ratio', damper.damping_ratio === null ? null : digits(damper.damping_ratio, 4)],
            ['dissipation d', quantity(damper.dissipation, 1, units.dissipation)],
            ['restitution of the law', digits(damper.achieved_restitution, 4)],
            [units.force[0], quantity(damper.peak_force, 1, units.force[1])],
            ['compression', quantity(damper.max_penetration, units.depth[0], units.depth[1])],
            ['contact time', quantity(damper.contact_duration, 1000, 'ms')],
            ['rebound speed', quantity(damper.rebound_speed, 1, units.speed)],
            ['energy lost', quantity(damper.energy_lost, 1, 'J')],
          ]} />
          {Object.entries(exports).map(([name, tool]) => (
            <div key={name} class="simulator">
              <h3>{tool.title}</h3>
              {tool.error ? <p class="box warn">{tool.error}</p> : null}
              {tool.snippet ? <pre class="text" tabIndex={0} aria-label={`parameters for ${tool.title}`}>{tool.snippet}</pre> : null}
              {tool.time_step !== null ? <p>Time step at most {digits(tool.time_step * 1000, 3)} ms.</p> : null}
              {[...tool.cannot, ...tool.missing].map((text) => <p key={text} class="soft">{text}</p>)}
              {tool.caution ? <p class="soft">{tool.caution}</p> : null}
            </div>
          ))}
        </>
      );
    }}>
      <StopChoice />
      <Field name="restitution" label="restitution" />
      <Field name="stiffness" label="stiffness" hint="200 N/mm" />
      <Field name="speed" label="speed" hint="1 m/s" />
      <Choice name="law" label="law" of={LAWS} />
      <Choice name="tool" label="simulator" of={TOOLS} />
      {Object.keys(further).length ? <p class="soft">From the study: {Object.entries(further).map(([name, value]) => `${name} = ${value}`).join(', ')}.</p> : null}
    </Panel>
  );
}

/** Ratio to the impulse of the contact below which an impulse is a rounding error, and below which its row is in the closed table. */
const [NO_IMPULSE, SMALL_IMPULSE] = [1e-9, 0.02];

export function ImpactPanel() {
  return (
    <Panel kind="impact" title="Impact" command={() => commandOf('impact', store.study!, store.answers.settings)} result={(found) => {
      const size = (force: (number | null)[]) => (force.some((f) => f === null) ? null : Math.hypot(...(force as number[])));
      const rows = found.reactions.map((r) => ({ name: r.name, place: r.place, on: r.on, size: size(r.force), open: r.open_by }))
        .sort((a, b) => (b.size ?? Infinity) - (a.size ?? Infinity));
      const above = (part: number) => rows.filter((r) => r.size === null || r.size > part * found.impulse);
      const [some, large] = [above(NO_IMPULSE), above(SMALL_IMPULSE)];
      const tableRow = (r: (typeof rows)[number]) => (
        <tr key={r.place + r.name}>
          <th scope="row" title={r.on ?? 'ground'}>{words(r.name)}</th>
          <td class="n">{r.size === null ? <span title={`left open by ${r.open.join(', ')}`}>not determined</span> : digits(r.size, 3)}</td>
        </tr>
      );
      return (
        <>
          <Rows of={[
            ['impulse', quantity(found.impulse, 1, 'N·s')],
            ['energy lost', quantity(found.in_time?.energy.taken_by_contact ?? found.energy_loss, 1, 'J')],
            ['mass of a point that sticks', quantity(found.sticking_mass, 1, 'kg')],
            ['peak force', quantity((found.in_time ?? found.contact_law)?.peak_force ?? null, 1, 'N')],
            ['compression', quantity((found.in_time ?? found.contact_law)?.max_penetration ?? null, 1000, 'mm')],
            ['contact time', quantity((found.in_time ?? found.contact_law)?.duration ?? null, 1000, 'ms')],
            ['restitution reached', quantity(found.in_time?.restitution ?? null, 1, '')],
          ]} />
          {found.in_time ? <Moments found={found.in_time} /> : <>
          <table class="plain">
            <caption>impulses of joints, N·s; arrows in the view: on the second link</caption>
            <tbody>{large.map(tableRow)}</tbody>
          </table>
          {some.length > large.length ? (
            <Details title={`${some.length - large.length} with less than ${100 * SMALL_IMPULSE} %`} content={() => <table class="plain"><tbody>{some.slice(large.length).map(tableRow)}</tbody></table>} />
          ) : null}
          {rows.length > some.length ? <p class="soft">{rows.length - some.length} further joints or frames have no impulse.</p> : null}
          </>}
        </>
      );
    }}>
      <Field name="impactRestitution" label="restitution" />
      <Field name="impactSpeed" label="speed" hint="1 m/s" />
      <Field name="impactStiffness" label="stiffness" hint={store.scene?.sheet ? 'curve of the sheet, or 200 N/mm' : '200 N/mm'} />
      <label class="line"><span>in time</span>
        <input type="checkbox" checked={store.answers.settings.impactInTime !== ''} onChange={(event) => store.answers.set({ impactInTime: event.currentTarget.checked ? 'yes' : '' })} />
      </label>
      <p class="soft">Before the impact, the mechanism moves with v*, the motion of least energy with this closing speed.</p>
    </Panel>
  );
}

export function SafeSpeedPanel() {
  const { answers } = store;
  const unit = { force: 'N', pressure: 'N/cm2', energy: 'J', momentum: 'N·s' }[answers.settings.limit] ?? '';
  return (
    <Panel kind="safe" title="Safe speed" missing={answers.settings.limitValue.trim() ? undefined : 'Give the limit of your edition of the standard.'} command={() => commandOf('safe', store.study!, store.answers.settings)} result={([found]) => (
      <>
        <p class="speed"><b>{fixed(found.reflected.speed, 3)}</b> m/s <span class="soft">for m̄ {found.reflected.robot_mass === null ? '= ∞' : `${digits(found.reflected.robot_mass, 4)} kg`}</span></p>
        <Rows of={[
          ['for the mass of the standard', `${fixed(found.standard.speed, 3)} m/s`],
          ['its mass', quantity(found.standard.robot_mass, 1, 'kg')],
          ['mass of the body region', quantity(found.region_mass, 1, 'kg')],
        ]} />
      </>
    )}>
      <Choice name="region" label="region" of={[['', 'held, cannot move'], ...REGIONS]} />
      <Choice name="limit" label="limit" of={LIMITS} />
      <Field name="limitValue" label={`${answers.settings.limit}, ${unit}`} hint="from your standard" />
      {answers.settings.limit === 'pressure' ? <Field name="area" label="area, cm²" /> : null}
      <Field name="load" label="load, kg" />
    </Panel>
  );
}

/** Quantities at the top of the table. */
const FIRST = ['camber', 'toe', 'caster', 'kingpin_inclination', 'scrub_radius', 'half_track_change', 'roll_centre_height', 'camber_gradient', 'toe_gradient'];
const UNITS: Record<string, [string, number, number]> = {
  rad: ['°', 180 / Math.PI, 3], m: ['mm', 1000, 2], 'rad/m': ['°/m', 180 / Math.PI, 2], 'N/m': ['N/mm', 1e-3, 2], N: ['N', 1, 1], kg: ['kg', 1, 3], Hz: ['Hz', 1, 3],
};

export function KinematicsPanel() {
  if (!store.opened?.scene.sheet || !store.opened.scene.motions.length) return null;
  return (
    <Panel kind="kinematics" title="Camber, toe, motion ratios" command={() => kinematicsCommand(store.study!, store.state())} result={(found) => {
      const row = found.rows[0];
      if (row?.problem) return <p class="box warn">{row.problem}</p>;
      const base = store.variants.at(-1)?.kinematics;
      const name = (c: KinematicsReport['columns'][number]) => (c.side ? `${c.quantity}_${c.side}` : c.quantity);
      const shown = found.columns.filter((c) => typeof row?.[name(c)] === 'number');
      const rank = (c: { quantity: string }) => {
        const at = FIRST.indexOf(c.quantity);
        return at >= 0 ? at : c.quantity.includes('motion_ratio') ? FIRST.length : FIRST.length + 1;
      };
      return (
        <table class="plain">
          <thead><tr><th>quantity</th><th>value</th>{base ? <th>Δ {store.variants.at(-1)!.name}</th> : null}</tr></thead>
          <tbody>{[...shown].sort((a, b) => rank(a) - rank(b)).map((column) => {
            const [unit, scale, decimals] = UNITS[column.unit] ?? ['', 1, 4];
            const value = row[name(column)] as number;
            const before = base?.rows[0]?.[name(column)];
            return (
              <tr key={name(column)} data-quantity={name(column)} data-value={value}>
                <th scope="row">{name(column).replaceAll('_', ' ')}</th>
                <td class="n">{fixed(value * scale, decimals)} {unit}</td>
                {base ? <td class="n soft">{typeof before === 'number' ? signed((value - before) * scale, decimals) : ''}</td> : null}
              </tr>
            );
          })}</tbody>
        </table>
      );
    }}>
      <p class="soft">At the pose shown, from the sheet; every bush is rigid.</p>
    </Panel>
  );
}
