// The result: m̄ with its meaning and pose, and each outcome with an explanation and a remedy.

import type { MassReport } from '../engine/protocol';
import { bound, digits, fixed, mass, signed, words } from '../model/numbers';
import { withValue } from '../model/drivers';
import { store } from '../model/store';
import { useStore } from './hooks';

export function Result() {
  const { posed, problem, study, opened } = useStore();
  if (!opened || !study) return null;
  const report = posed?.report;
  return (
    <section class="result" aria-label="Result">
      {report ? <Value report={report} stale={problem !== undefined} /> : null}
      {problem ? <Problem /> : null}
      {report && !problem ? <Explained report={report} /> : null}
    </section>
  );
}

/** Travel that is shown as more than 0.0 mm, m. */
const LEAST_TRAVEL = 5e-5;
/** Error bound relative to m̄ from which it is shown. */
const LARGE_ERROR = 1e-6;

function Value({ report, stale }: { report: MassReport; stale: boolean }) {
  const { contact, named_contact: named } = report;
  const m = report.effective_mass;
  const error = report.effective_mass_error;
  const big = report.status === 'immovable' ? '∞' : report.status === 'massless' ? '0' : mass(m!, error);
  const bounded = `± ${bound(error ?? 0)} ${report.unit}: rounding, closing of the loops, and loops that the file leaves open`;
  return (
    <div class={stale ? 'stale' : ''}>
      <p class="kind">{contact.is_moment ? 'effective inertia' : 'effective mass'} <i>m̄</i> at <b>{words(named ? named.name : contact.link)}</b></p>
      <p class="big" role="status" aria-live="polite" data-mass={m ?? report.status} title={m !== null && error !== null ? bounded : undefined}>
        {report.singular_pose && m !== null ? <span class="symbol">≥ </span> : null}<b>{big}</b> {report.status === 'immovable' ? '' : report.unit}
      </p>
      <p class="sub">{sentence(report)}</p>
      <p class="sub"><span class="tag">{pose(report)}</span></p>
      {report.singular_pose ? <p class="sub">a bound for all branches</p> : m && error !== null && error > LARGE_ERROR * m ? <p class="sub">{bounded}</p> : null}
      {report.other_base ? (
        <p class="sub">With the {words(report.other_base.link)} {report.other_base.base === 'floating' ? 'free' : 'fixed'}: <b>{
          report.other_base.effective_mass === null ? report.other_base.status : `${mass(report.other_base.effective_mass, report.other_base.effective_mass_error)} ${report.unit}`}</b>.</p>
      ) : null}
      {named?.effective_mass_together != null ? (
        <p class="sub both">Both stops ({[named.name, ...named.touching].map(words).join(', ')}), closing together: <b>{mass(named.effective_mass_together, error)} {report.unit}</b> each.</p>
      ) : null}
    </div>
  );
}

/** Meaning of the number. */
function sentence({ contact, conditions, named_contact: named, motion_ratios, status, unit, effective_mass: m, effective_mass_error: error }: MassReport) {
  // A fixed base does not move.
  const all = store.scene!.links.reduce((sum, link, i) => sum + (i === store.scene!.root && conditions.base === 'fixed' ? 0 : link.mass), 0);
  const ratio = motion_ratios.find((r) => r.contact_per_wheel !== null && r.link.startsWith('wheel_centre'))?.contact_per_wheel;
  const other = `the ${contact.against ? words(contact.against) : 'ground'}`;
  const strikes = status !== 'finite' || contact.is_moment ? ''
    : named?.kind === 'spring' || named?.kind === 'damper' ? `The ${words(named.name)} feels the mechanism of ${digits(all, 4)} kg like a mass of ${mass(m!, error, 4)} ${unit}.`
      : `The mechanism of ${digits(all, 4)} kg strikes ${named ? `the ${words(named.name)}` : other} like a mass of ${mass(m!, error, 4)} ${unit}.`;
  const travels = ratio != null ? ` It moves ${fixed(Math.abs(ratio), 4)} times as far as the wheel.` : '';
  return `${strikes}${travels} Between the ${words(contact.link)} and ${other}.`;
}

/** Pose of the result in words. */
function pose({ named_contact: named, conditions }: MassReport): string {
  const travels = [...new Set((named?.wheel_travel ?? []).filter(({ travel }) => Math.abs(travel) > LEAST_TRAVEL).map(({ travel }) => `${fixed(Math.abs(travel) * 1000, 1)} mm ${travel < 0 ? 'down' : 'up'}`))];
  const given = store.study!.pose;
  const where = named?.brought_to_touch ? 'at the touch' : Object.keys(given.set ?? {}).length || given.travel?.length || given.file ? 'at the pose shown' : 'at the design position';
  return [
    where, travels.length ? `wheel ${travels.join(', ')}` : '',
    named?.gap != null && !named.brought_to_touch ? named.gap < 0 ? `${fixed(-named.gap * 1000, 1)} mm beyond the touch` : `gap ${fixed(named.gap * 1000, 1)} mm` : '', `base ${conditions.base}`,
  ].filter(Boolean).join(' · ');
}

/** Reason why the study has no result. */
function Problem() {
  const { problem, driver, study } = store;
  const reached = driver && store.curve && 'ok' in store.curve
    ? store.curve.ok.rows.filter((row) => row.status !== 'unreachable' && row.status !== 'no answer') : [];
  // Another travel is no remedy for a refused change.
  const ends = reached.length && problem!.no_result ? ([reached[0].at, reached.at(-1)!.at] as const) : undefined;
  return (
    <div class="box bad" role="alert">
      <p><b>{problem!.no_result ? 'No result here.' : 'Refused.'}</b> {problem!.message}</p>
      {store.posed ? <p class="soft">The last result is shown in grey.</p> : null}
      <p class="row">
        {ends && driver && ends.map((end, i) => (
          <button key={i} onClick={() => store.change(withValue(study!, driver, end), `to the end of ${driver.label}`)}>
            {driver.label} to {fixed(end * driver.unit.perSi, 1)} {driver.unit.name}
          </button>
        ))}
        {store.lastLabel ? <button onClick={() => (store.inGesture ? store.finish(false) : store.undo())}>Undo “{store.lastLabel}”</button> : null}
      </p>
    </div>
  );
}

/** Outcome in words. */
function Explained({ report }: { report: MassReport }) {
  const { study, driver } = store;
  if (report.status === 'immovable') {
    const locked = study!.conditions.lock ?? [];
    const held = study!.hold?.length ?? 0;
    return (
      <div class="box">
        <p>
          <b>Immovable.</b> No motion that the joints and loops permit closes this gap, so the contact acts as on a wall.
          {locked.length ? ` Locked joints: ${locked.join(', ')}.` : ''}{held ? ` Held points: ${held}.` : ''}
        </p>
        <p class="row">
          {locked.map((joint) => (
            <button key={joint} onClick={() => store.change({ ...study!, conditions: { ...study!.conditions, lock: locked.filter((l) => l !== joint) } }, `unlock ${joint}`)}>
              Unlock {joint}
            </button>
          ))}
          {held ? <button onClick={() => store.change({ ...study!, hold: [] }, 'release all points')}>Release the held points</button> : null}
          {study!.conditions.base !== 'floating' ? (
            <button onClick={() => store.change({ ...study!, conditions: { ...study!.conditions, base: 'floating' } }, 'free the base')}>Let the base move freely</button>
          ) : null}
        </p>
        <p class="soft">Or turn the normal: drag the head of the arrow, or choose another axis in the tab Result.</p>
      </div>
    );
  }
  if (report.status === 'massless') {
    return (
      <div class="box">
        <p><b>Massless.</b> A motion without mass closes this gap: the link at the contact moves, and no link with mass moves with it.</p>
        <p class="soft">Give the links of this motion a mass (tab Design), or turn the normal.</p>
      </div>
    );
  }
  if (report.singular_pose) {
    const limits = report.branch_limits.map((m) => (m === null ? 'immovable' : `${digits(m)} ${report.unit}`));
    return (
      <div class="box warn">
        <p>
          <b>Singular pose.</b> Branches of the linkage cross or end here, and m̄ depends on the branch
          {limits.length ? `: ${limits.join(', ')} along the branches.` : '.'}
        </p>
        {driver ? (
          <p class="row">
            {[-1, 1].map((way) => {
              const at = currentValue() + (way * driver.unit.step) / driver.unit.perSi / 5;
              return (
                <button key={way} onClick={() => store.change(withValue(study!, driver, at), 'off the singular pose')}>
                  {signed((way * driver.unit.step) / 5, 1)} {driver.unit.name} of {driver.label}
                </button>
              );
            })}
          </p>
        ) : null}
      </div>
    );
  }
  return null;
}

/** Value of the driver of the curve at the pose shown, SI. */
export function currentValue(): number {
  const { driver, study } = store;
  return driver && study ? store.positionOf(driver) : 0;
}
