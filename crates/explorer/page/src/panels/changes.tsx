// What changes m̄ most, and the search for the coordinate or the mass that gives m̄ a value.

import { useMemo, useState } from 'preact/hooks';
import type { Explanation } from '../engine/protocol';
import { digits, fixed, signed, words } from '../model/numbers';
import { store } from '../model/store';
import { useStore } from './hooks';

const MOST_POINTS = 6;
const MOST_LINKS = 4;

/** Coordinates of hardpoints and masses of links with the largest rates of m̄. */
export function Changes() {
  const { explanation, explained, study, problem, posed, scene } = useStore();
  const isStale = !!problem || explained !== study;
  // A drag does not render the tables again.
  const tables = useMemo(() => rates(explanation, isStale), [explanation, isStale]);
  if (!posed || posed.report.status !== 'finite') return null;
  const most = explanation && sorted(explanation)[0];
  return (
    <section>
      <h2>What changes m̄ most</h2>
      {tables}
      {scene?.sheet?.hardpoints.length ? <Target suggested={most ? `${most.point}.${most.axis}` : undefined} /> : null}
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

/** Search for the coordinate or the mass at which m̄ has a value. */
function Target({ suggested }: { suggested: string | undefined }) {
  const { posed, scene, problem } = store;
  const [mass, setMass] = useState('');
  const [chosen, setChosen] = useState('');
  const [within, setWithin] = useState('20');
  const [told, setTold] = useState('');
  const sheet = scene!.sheet!;
  const unknown = chosen || suggested || `${sheet.hardpoints[0].name}.x`;
  // Each result of a drag has another scene with the same names.
  const options = useMemo(
    () => [
      ...sheet.hardpoints.flatMap((p) => ['x', 'y', 'z'].map((axis) => <option key={p.name + axis} value={`${p.name}.${axis}`}>{words(p.name)} {axis}</option>)),
      ...scene!.links.filter((l) => l.mass > 0).map((l) => <option key={l.name} value={`${l.name}.mass`}>mass of {words(l.name)}</option>),
    ],
    [sheet.hardpoints.map((p) => p.name).join()],
  );
  const number = (text: string) => Number(text.replace(',', '.'));
  const [required, range] = [number(mass), number(within) / 1000];
  const run = async () => {
    setTold('Searching …');
    const found = await store.solve(unknown, required, range);
    if (typeof found === 'string') return setTold(found);
    const [{ coordinate, unit, old, new: to }] = found.coordinates;
    const move = `${words(coordinate)} from ${fixed(old, 2)} to ${fixed(to, 2)} ${unit} (${signed(to - old, 2)})`;
    setTold(found.is_reached ? `Changed ${move}.`
      : `Not reached within ${unit === 'kg' ? 'half of the mass' : `${within} mm`}. Nearest: ${digits(found.targets[0].reached)} kg with ${move}; nothing was changed.`);
  };
  return (
    <form class="target-search" onSubmit={(event) => { event.preventDefault(); void run(); }}>
      <h3>Solve for a target</h3>
      <label class="line"><span>m̄, kg</span>
        <input class="setting" type="text" inputMode="decimal" autocomplete="off" placeholder={digits(posed!.report.effective_mass! * 0.95, 4)} value={mass}
          onInput={(event) => setMass(event.currentTarget.value)} />
      </label>
      <label class="line"><span>by changing</span>
        <select value={unknown} onChange={(event) => setChosen(event.currentTarget.value)}>
          {options}
        </select>
      </label>
      <label class="line"><span>by at most, mm</span>
        <input class="setting" type="text" inputMode="decimal" autocomplete="off" value={within} onInput={(event) => setWithin(event.currentTarget.value)} />
      </label>
      <p class="row"><button disabled={!!problem || !(required > 0) || !(range > 0)}>Solve</button></p>
      {told ? <p class="told" role="status">{told}</p> : null}
    </form>
  );
}
