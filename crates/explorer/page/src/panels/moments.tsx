// Impact in time: force of the contact and of the bearings, played with their arrows in the view.

import { useEffect, useState } from 'preact/hooks';
import type { ImpactTimeRecord } from '../engine/protocol';
import { digits, fixed, words } from '../model/numbers';
import { store } from '../model/store';

/** Duration of the playing, ms. */
const PLAYED = 4000;
/** Part of the peak force below which a bearing is only counted. */
const SMALL_FORCE = 0.02;
/** Relative difference of the peaks of one force. */
const SAME_FORCE = 1e-9;
const [WIDTH, HEIGHT, LEFT, TOP, BOTTOM] = [340, 130, 46, 8, 20];

export function Moments({ found }: { found: ImpactTimeRecord }) {
  const { answers } = store;
  const [playing, setPlaying] = useState(false);
  const { times, force, penetration } = found;
  const now = answers.momentOf(found);
  const last = times.length - 1;
  const show = (i: number) => {
    answers.moment = i;
    store.changed();
  };
  useEffect(() => {
    if (!playing) return;
    let frame = 0;
    const begun = performance.now();
    const step = (at: number) => {
      const time = (Math.min((at - begun) / PLAYED, 1)) * times[last];
      show(Math.max(0, times.findLastIndex((t) => t <= time)));
      if (time < times[last]) frame = requestAnimationFrame(step);
      else setPlaying(false);
    };
    frame = requestAnimationFrame(step);
    return () => cancelAnimationFrame(frame);
  }, [playing, found]);
  // Fixed joints in a row have the same force.
  const bearings = [...found.bearings].sort((a, b) => b.peak_force - a.peak_force)
    .filter((b, i, all) => i === 0 || Math.abs(b.peak_force - all[i - 1].peak_force) > SAME_FORCE * b.peak_force);
  const shown = bearings.filter((b) => b.peak_force >= SMALL_FORCE * found.peak_force);
  const acting = [...found.springs, ...found.dampers, ...found.drives].map(({ name }) => words(name)).join(', ');
  const most = Math.max(found.peak_force, ...shown.map((b) => b.peak_force)) || 1;
  const x = (t: number) => LEFT + (t / times[last]) * (WIDTH - LEFT - 6);
  const y = (f: number) => HEIGHT - BOTTOM - (Math.max(0, f) / most) * (HEIGHT - BOTTOM - TOP);
  const path = (forces: number[]) => `M${forces.map((f, i) => `${x(times[i]).toFixed(1)} ${y(f).toFixed(1)}`).join('L')}`;
  const text = `${fixed(times[now] * 1000, 2)} ms, contact force ${digits(force[now], 4)} N, compression ${fixed(penetration[now] * 1000, 2)} mm`;
  return (
    <div class="moments">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} class="figure" role="img" aria-label={`Forces over ${fixed(times[last] * 1000, 1)} ms; the largest is ${digits(most, 4)} N`}>
        <path d={`M${LEFT} ${y(most)}H${WIDTH - 6}`} class="grid" /><path d={`M${LEFT} ${TOP}V${HEIGHT - BOTTOM}H${WIDTH - 6}`} class="axis" fill="none" />
        <text x={LEFT - 4} y={y(most) + 8} text-anchor="end">{digits(most, 3)} N</text><text x={LEFT - 4} y={HEIGHT - BOTTOM} text-anchor="end">0</text>
        <text x={WIDTH - 6} y={HEIGHT - 5} text-anchor="end">{fixed(times[last] * 1000, 1)} ms</text>
        {shown.slice(0, 3).map((b) => <path key={b.name + b.place} d={path(b.force)} class="bearing" />)}
        <path d={path(force)} class="contact-force" />
        <path d={`M${x(times[now])} ${TOP}V${HEIGHT - BOTTOM}`} class="cursor" />
      </svg>
      <p class="row player">
        <button aria-label={playing ? 'Pause' : 'Play'} onClick={() => setPlaying(!playing)}>{playing ? '❚❚' : '▶'}</button>
        <input type="range" min="0" max={last} step="1" value={now} aria-label="time of the impact" aria-valuetext={text}
          onInput={(event) => { setPlaying(false); show(Number(event.currentTarget.value)); }} />
      </p>
      <p class="told" role="status" data-force={force[now]}>{text}</p>
      <table class="plain">
        <caption>forces in the bearings, N; directions of the arrows as at the touch</caption>
        <thead><tr><th>bearing</th><th>now</th><th>peak</th></tr></thead>
        <tbody>{shown.map((b) => (
          <tr key={b.name + b.place}><th scope="row">{words(b.name)}</th><td class="n">{digits(b.force[now], 3)}</td><td class="n">{digits(b.peak_force, 3)}</td></tr>
        ))}</tbody>
      </table>
      <p class="soft">{acting ? `Besides the contact, these act: ${acting}.` : 'The contact force alone acts: neither gravity nor springs.'}{
        found.springs_left_out.length ? ` Left out: ${found.springs_left_out.map(words).join(', ')}.` : ''}</p>
      {bearings.length > shown.length ? <p class="soft">{bearings.length - shown.length} further bearings have less than {SMALL_FORCE * 100} % of the force of the contact.</p> : null}
    </div>
  );
}
