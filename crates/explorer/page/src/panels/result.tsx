// The result: m̄ with its error bound, the difference from a frozen variant, and each outcome with an explanation and a remedy.

import type { MassReport } from '../engine/protocol';
import { bound, digits, fixed, mass, signed } from '../model/numbers';
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

function Value({ report, stale }: { report: MassReport; stale: boolean }) {
  const { contact, named_contact: named } = report;
  const place = named ? named.name : contact.link;
  const other = contact.against ?? 'ground';
  const m = report.effective_mass;
  const error = report.effective_mass_error;
  const big = report.status === 'immovable' ? '∞' : report.status === 'massless' ? '0' : mass(m!, error);
  return (
    <div class={stale ? 'stale' : ''}>
      <p class="big" role="status" aria-live="polite" data-mass={m ?? report.status}>
        <span class="symbol">m̄{report.singular_pose && m !== null ? ' ≥' : ''}</span> <b>{big}</b> {report.status === 'immovable' ? '' : report.unit}
      </p>
      <p class="sub">
        {report.singular_pose ? <span>a bound for all branches · </span> : report.status === 'finite' && error !== null ? (
          <span title="Upper bound of the error: rounding, closing of the loops, and loops that the file leaves open">± {bound(error)} {report.unit} · </span>
        ) : null}
        at <b>{place}</b>{named ? `: ${contact.link} against ${other}` : ` against ${other}`}
        {named?.brought_to_touch ? <span class="tag">at touch</span> : null}
        {named && named.gap !== null && !named.brought_to_touch ? <span> · gap {fixed(named.gap * 1000, 1)} mm</span> : null}
      </p>
      <Difference m={m} unit={report.unit} />
    </div>
  );
}

function Difference({ m, unit }: { m: number | null; unit: string }) {
  const variant = store.variants.at(-1);
  if (!variant || variant.mass === null || m === null) return null;
  const by = m - variant.mass;
  const decimals = Math.max(0, 3 - Math.floor(Math.log10(Math.max(Math.abs(m), 1e-9))));
  return (
    <p class="difference">
      {signed(by, decimals)} {unit} ({signed((100 * by) / variant.mass, 2)} %) against variant {variant.name} with {digits(variant.mass)} {unit}
    </p>
  );
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
        <p class="soft">Or turn the normal: drag the head of the arrow, or choose another axis below.</p>
      </div>
    );
  }
  if (report.status === 'massless') {
    return (
      <div class="box">
        <p><b>Massless.</b> A motion without mass closes this gap: the link at the contact moves, and no link with mass moves with it.</p>
        <p class="soft">Give the links of this motion a mass (Masses), or turn the normal.</p>
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
