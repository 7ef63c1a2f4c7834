// Curve of m̄ over a driver, as SVG: the present design solid, a frozen variant dashed, positions without a result hatched.

import { useRef, useState } from 'preact/hooks';
import type { Curve } from '../engine/protocol';
import { touches, withValue } from '../model/drivers';
import { insideBand, remarks } from '../model/ends';
import { digits, fixed, plain, signed, ticks, words } from '../model/numbers';
import { store } from '../model/store';
import { VARIANTS } from '../view/space';
import { TextField } from './field';
import { useStore } from './hooks';
import { currentValue } from './result';
import { useSize } from './size';

const MARGIN = { left: 70, right: 18, top: 14, bottom: 40 };
/** Width below which the marks of the touches have a line each, pixels. */
const NARROW = 480;
/** Highest value shown, as a multiple of the median: a curve may go to infinity. */
const MOST = 6;

export function CurvePanel() {
  const { driver, drivers, opened } = useStore();
  if (!opened) return null;
  if (!driver) return <section class="curve empty"><p class="soft">No joint with a single position can be set: the model has no curve.</p></section>;
  const failed = store.curve && 'refused' in store.curve ? store.curve.refused.message : undefined;
  return (
    <section class="curve" aria-label={`m̄ over ${driver.label}`}>
      <div class="curve-head">
        <label>effective mass m̄ over{' '}
          <select value={driver.name} onChange={(event) => store.chooseDriver(event.currentTarget.value)}>
            {drivers.map((d) => <option key={d.name} value={d.name}>{d.label}</option>)}
          </select>
        </label>
        <Legend />
        <Bands />
      </div>
      <Remarks />
      {failed ? <p class="box bad">{failed}</p> : <Plot />}
    </section>
  );
}

function Legend() {
  const variants = store.variants.filter((v) => v.curve);
  if (!variants.length) return null;
  return (
    <span class="keys">
      <svg width="26" height="8" aria-hidden="true"><path d="M0 4h26" class="trace now" /></svg> now
      {variants.map((v) => (
        <span key={v.name}><svg width="26" height="8" aria-hidden="true"><path d="M0 4h26" class="trace frozen" style={{ stroke: VARIANTS[v.colour] }} /></svg> {v.name}</span>
      ))}
    </span>
  );
}

/** Target range of m̄, and tolerance of the hardpoints. */
function Bands() {
  const [open, setOpen] = useState(false);
  const { target, tolerance, posed } = store;
  const m = posed?.report.effective_mass ?? 1;
  const unit = posed?.report.unit ?? 'kg';
  if (!open && !target && !tolerance) return <button class="quiet" onClick={() => setOpen(true)}>Target, tolerance …</button>;
  const [low, high] = target ?? [0.9 * m, 1.1 * m];
  const decimals = Math.max(0, 2 - Math.floor(Math.log10(Math.max(Math.abs(m), 1e-9))));
  const field = (label: string, value: number, set: (x: number) => void) => (
    <PlainNumber label={label} value={Number(value.toFixed(decimals))} set={set} />
  );
  return (
    <span class="bands">
      <label><input type="checkbox" checked={target !== undefined} onChange={(event) => store.set({ target: event.currentTarget.checked ? [low, high] : undefined })} /> target</label>
      {target ? <>{field(`target from, ${unit}`, low, (x) => store.set({ target: [x, high] }))}–{field(`target to, ${unit}`, high, (x) => store.set({ target: [low, x] }))} {unit}</> : null}
      {store.scene?.sheet ? (
        <>
          <label><input type="checkbox" checked={tolerance !== undefined} onChange={(event) => store.setTolerance(event.currentTarget.checked ? 0.001 : undefined)} /> tolerance</label>
          {tolerance ? <>±<PlainNumber label="tolerance of the hardpoints, mm" value={Number((tolerance * 1000).toFixed(3))} set={(x) => store.setTolerance(x > 0 ? x / 1000 : undefined)} /> mm</> : null}
        </>
      ) : null}
    </span>
  );
}

function PlainNumber({ label, value, set }: { label: string; value: number; set(x: number): void }) {
  return <TextField class="number" label={label} value={String(value)} set={(text) => {
    const x = Number(text.replace(',', '.'));
    if (Number.isFinite(x)) set(x);
  }} />;
}

/** The curve in words: ends of the travel, change points, and the part of the travel within the target. */
function Remarks() {
  const { driver, ends, target, variation, posed } = store;
  const curve = rowsOf();
  if (!driver || !curve) return null;
  const all = remarks(curve, driver, ends);
  if (target) {
    const parts = insideBand(curve.rows, target).map((part) => part.map((x) => fixed(x * driver.unit.perSi, 1)).join(' to '));
    all.push(parts.length ? `Inside of the target from ${parts.join(', and from ')} ${driver.unit.name}.` : 'Nowhere inside of the target.');
  }
  if (variation?.length && posed) {
    const now = store.positionOf(driver);
    const nearest = variation.reduce((a, b) => (Math.abs(b.at - now) < Math.abs(a.at - now) ? b : a));
    all.push(`Within the tolerance, to first order, m̄ varies by ±${digits(nearest.rss, 3)} ${posed.report.unit} (independent coordinates) and by at most `
      + `±${digits(nearest.worst, 3)} ${posed.report.unit} (all at their limits) at ${fixed(nearest.at * driver.unit.perSi, 1)} ${driver.unit.name}.`);
  }
  return all.length ? <p class="remarks" role="status">{all.join(' ')}</p> : null;
}

export const rowsOf = (): Curve | undefined => (store.curve && 'ok' in store.curve ? store.curve.ok : undefined);

function Plot() {
  const frame = useRef<HTMLDivElement>(null);
  const { width, height } = useSize(frame);
  const [dragging, setDragging] = useState(false);
  const driver = store.driver!;
  const curve = rowsOf();
  const now = currentValue();
  const scale = driver.unit.perSi;
  const [from, to] = driver.range.map((x) => x * scale);
  const shown = [curve, ...store.variants.map((v) => v.curve)].filter((c): c is Curve => !!c);
  const masses = shown.flatMap((c) => c.rows.map((r) => r.mass).filter((m): m is number => m !== null)).sort((a, b) => a - b);
  const report = store.posed?.report;
  const present = report?.effective_mass ?? undefined;
  const { target, variation } = store;
  if (target) masses.push(...target);
  for (const v of variation ?? []) masses.push(v.mass - v.worst, v.mass + v.worst);
  if (present !== undefined) masses.push(present);
  masses.sort((a, b) => a - b);
  const median = masses[Math.floor(masses.length / 2)] ?? 1;
  const high0 = Math.min(masses.at(-1) ?? 1, Math.max(MOST * median, present ?? 0));
  const low0 = masses[0] ?? 0;
  const pad = Math.max(high0 - low0, 1e-3 * Math.abs(high0), 1e-12) * 0.08;
  const [low, high] = [low0 - pad < 0 && low0 >= 0 ? 0 : low0 - pad, high0 + pad];
  const x = (v: number) => MARGIN.left + ((v - from) / (to - from)) * (width - MARGIN.left - MARGIN.right);
  const y = (m: number) => MARGIN.top + ((high - m) / (high - low)) * (height - MARGIN.top - MARGIN.bottom);
  const path = (c: Curve) => {
    let pen = 'M';
    return c.rows.map((row) => {
      // At a change point, the number is a bound and not the limit of the curve.
      if (row.mass === null || row.singular) {
        pen = 'M';
        return '';
      }
      const text = `${pen}${x(row.at * scale).toFixed(1)} ${y(Math.min(row.mass, high * 4)).toFixed(1)}`;
      pen = 'L';
      return text;
    }).join('');
  };
  const yTicks = ticks(low, high, Math.max(3, Math.floor((height - 54) / 30)));
  const yDecimals = Math.max(0, -Math.floor(Math.log10((yTicks[1] ?? 1) - (yTicks[0] ?? 0)) + 1e-9));
  const xTicks = ticks(from, to, Math.max(3, Math.floor((width - 80) / 62)));
  const set = (value: number) => {
    const step = driver.unit.step / scale / 5;
    const inside = Math.min(Math.max(value, driver.range[0]), driver.range[1]);
    store.change(withValue(store.study!, driver, Math.round(inside / step) * step), driver.label);
  };
  const fromPointer = (event: PointerEvent) => {
    const box = frame.current!.getBoundingClientRect();
    const part = (event.clientX - box.left - MARGIN.left) / (width - MARGIN.left - MARGIN.right);
    return driver.range[0] + part * (driver.range[1] - driver.range[0]);
  };
  const around = (by: 'rss' | 'worst') => {
    const edge = (sign: number) => variation!.map((v) => `${x(v.at * scale).toFixed(1)} ${y(v.mass + sign * v[by]).toFixed(1)}`);
    return `M${[...edge(1), ...edge(-1).reverse()].join('L')}Z`;
  };
  const hatched = curve ? gaps(curve) : [];
  const marks = driver.isMotion && driver.name !== 'roll' ? touches(store.contacts) : [];
  const inside = now * scale >= from - 1e-9 && now * scale <= to + 1e-9;
  const label = `${driver.label}, ${driver.unit.name}`;
  return (
    <div
      ref={frame} class={dragging ? 'plot dragging' : 'plot'} role="slider" tabIndex={0} aria-label={`${driver.label} in the curve`}
      aria-valuemin={from} aria-valuemax={to} aria-valuenow={Number(fixed(now * scale, 2).replace('−', '-'))}
      aria-valuetext={`${fixed(now * scale, 1)} ${driver.unit.name}, m̄ ${present === undefined ? (report?.status ?? 'none') : `${digits(present)} ${report?.unit ?? 'kg'}`}`}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        store.begin(driver.label);
        setDragging(true);
        set(fromPointer(event));
      }}
      onPointerMove={(event) => dragging && set(fromPointer(event))}
      onPointerUp={() => {
        setDragging(false);
        store.finish();
      }}
      onPointerCancel={() => {
        setDragging(false);
        store.finish(false);
      }}
      onKeyDown={(event) => {
        const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
        if (!way) return;
        event.preventDefault();
        const step = driver.unit.step / scale;
        // The value of the study: repeated keys come faster than the page is rendered.
        set(Math.round((currentValue() + way * step * (event.shiftKey ? 10 : 1)) / step) * step);
      }}
    >
      <svg width={width} height={height} viewBox={`0 0 ${width} ${height}`} aria-hidden="true" class="figure">
        <defs>
          <pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <path d="M0 0v7" class="hatch" />
          </pattern>
          <clipPath id="inner"><rect x={MARGIN.left} y={MARGIN.top} width={Math.max(0, width - MARGIN.left - MARGIN.right)} height={Math.max(0, height - MARGIN.top - MARGIN.bottom)} /></clipPath>
        </defs>
        {yTicks.map((m) => (
          <g key={m}>
            <path d={`M${MARGIN.left} ${y(m)}H${width - MARGIN.right}`} class="grid" />
            <text x={MARGIN.left - 8} y={y(m) + 4} text-anchor="end">{fixed(m, Math.min(6, yDecimals))}</text>
          </g>
        ))}
        {xTicks.map((v) => (
          <g key={v}>
            <path d={`M${x(v)} ${height - MARGIN.bottom}v5`} class="tick" />
            <text x={x(v)} y={height - MARGIN.bottom + 18} text-anchor="middle">{plain(v).replace('-', '−')}</text>
          </g>
        ))}
        <path d={`M${MARGIN.left} ${height - MARGIN.bottom}H${width - MARGIN.right}`} class="axis" />
        <text x={(MARGIN.left + width - MARGIN.right) / 2} y={height - 5} text-anchor="middle" class="name">{label}</text>
        <text transform={`translate(14,${(MARGIN.top + height - MARGIN.bottom) / 2}) rotate(-90)`} text-anchor="middle" class="name">m̄, {report?.unit ?? 'kg'}</text>
        <g clip-path="url(#inner)">
          {target ? <rect x={MARGIN.left} y={y(target[1])} width={Math.max(0, width - MARGIN.left - MARGIN.right)} height={Math.max(0, y(target[0]) - y(target[1]))} class="target" /> : null}
          {variation?.length ? <><path d={around('worst')} class="within worst" /><path d={around('rss')} class="within" /></> : null}
          {hatched.map(({ from: a, to: b, why }) => (
            <g key={a}>
              <rect x={x(a * scale)} y={MARGIN.top} width={Math.max(2, x(b * scale) - x(a * scale))} height={Math.max(0, height - MARGIN.top - MARGIN.bottom)} fill="url(#hatch)" />
              {x(b * scale) - x(a * scale) > 90 ? <text x={(x(a * scale) + x(b * scale)) / 2} y={MARGIN.top + 16} text-anchor="middle" class="why">{why}</text> : null}
            </g>
          ))}
          {curve?.rows.filter((row) => row.singular).map((row) => <path key={row.at} d={`M${x(row.at * scale)} ${MARGIN.top}V${height - MARGIN.bottom}`} class="change" />)}
          {store.variants.map((v) => v.curve && <path key={v.name} d={path(v.curve)} class="trace frozen" style={{ stroke: VARIANTS[v.colour] }} />)}
          {curve ? <path d={path(curve)} class="trace now" /> : null}
          {marks.map(({ name, travel }, i) => {
            const isRight = x(travel * scale) > width / 2;
            return (
              <g key={`${name}${travel}`} class="touch" data-touch={name} data-travel={travel}>
                <path d={`M${x(travel * scale)} ${MARGIN.top}V${height - MARGIN.bottom}`} />
                <text x={x(travel * scale) + (isRight ? -5 : 5)} y={MARGIN.top + 10 + (width < NARROW ? 14 * i : 0)} text-anchor={isRight ? 'end' : 'start'}>{words(name)} touches, {signed(travel * scale, 1)}</text>
              </g>
            );
          })}
          {inside ? <path d={`M${x(now * scale)} ${MARGIN.top}V${height - MARGIN.bottom}`} class="cursor" /> : null}
          {inside && present !== undefined && !store.problem && !report?.singular_pose ? <circle cx={x(now * scale)} cy={y(present)} r="5.5" class="marker" /> : null}
        </g>
      </svg>
    </div>
  );
}

/** Parts of the range without a finite mass, with the reason. */
function gaps(curve: Curve): { from: number; to: number; why: string }[] {
  const out: { from: number; to: number; why: string }[] = [];
  const { rows } = curve;
  const half = rows.length > 1 ? (rows[1].at - rows[0].at) / 2 : 0;
  rows.forEach((row, i) => {
    if (row.mass !== null) return;
    const why = { unreachable: 'out of reach', immovable: 'immovable', massless: 'massless' }[row.status] ?? 'no result';
    const last = out.at(-1);
    if (last && rows[i - 1]?.mass === null && last.why === why) last.to = row.at + half;
    else out.push({ from: row.at - half, to: row.at + half, why });
  });
  return out;
}
