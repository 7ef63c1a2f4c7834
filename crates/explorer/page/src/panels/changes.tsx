// What changes m̄ most.

import { useMemo } from 'preact/hooks';
import type { Explanation } from '../engine/protocol';
import { digits, words } from '../model/numbers';
import { store } from '../model/store';
import { useStore } from './hooks';

const MOST_POINTS = 6;
const MOST_LINKS = 4;

/** Coordinates of hardpoints and masses of links with the largest rates of m̄. */
export function Changes() {
  const { explanation, explained, study, problem, posed } = useStore();
  const isStale = !!problem || explained !== study;
  // A drag does not render the tables again.
  const tables = useMemo(() => rates(explanation, isStale), [explanation, isStale]);
  if (!posed || posed.report.status !== 'finite') return null;
  return (
    <section>
      <h2>What changes m̄ most</h2>
      {tables}
    </section>
  );
}

/** Rates of m̄ by the coordinates of the hardpoints, kg/mm, the largest first. */
const sorted = (explanation: Explanation) => explanation.points
  .flatMap((p) => (p.per_metre ?? []).map((rate, k) => ({ point: p.point, axis: 'xyz'[k], rate: rate / 1000 })))
  .sort((a, b) => Math.abs(b.rate) - Math.abs(a.rate));

function rates(explanation: Explanation | null | undefined, isStale: boolean) {
  if (!explanation) return <p class="soft">{explanation === null ? 'Sensitivities need a single finite m̄.' : isStale ? 'Computing …' : ''}</p>;
  const unit = store.posed?.report.unit;
  const points = sorted(explanation).slice(0, MOST_POINTS);
  const links = [...explanation.links].sort((a, b) => b.per_kilogram - a.per_kilogram).slice(0, MOST_LINKS);
  const most = Math.max(1e-15, ...points.map(({ rate }) => Math.abs(rate)));
  return (
    <div class={isStale ? 'stale' : ''}>
      {points.length ? (
        <table class="shares tornado">
          <caption>{unit} per +1 mm of a hardpoint, {store.scene?.sheet?.axes}</caption>
          <colgroup><col class="of-point" /><col /><col class="of-mass" /></colgroup>
          <tbody>
            {points.map(({ point, axis, rate }) => (
              <tr key={point + axis}>
                <th scope="row"><button class="quiet" title="Show the hardpoint" onClick={() => store.set({ selected: point, showsPoints: true })}>{words(point)} {axis}</button></th>
                <td class="bar"><span class={rate < 0 ? 'down' : 'up'} style={{ width: `${(50 * Math.abs(rate)) / most}%` }} /></td>
                <td class="n">{rate < 0 ? '−' : '+'}{digits(Math.abs(rate), 3)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
      <table class="plain">
        <caption>{unit} per −1 kg of a link</caption>
        <tbody>{links.map((l) => <tr key={l.link}><th scope="row">{words(l.link)}</th><td class="n">−{digits(l.per_kilogram, 3)}</td></tr>)}</tbody>
      </table>
    </div>
  );
}
