// Ends of the range that the linkage reaches, and poses in it without a finite mass, in words.

import type { Curve, CurveRow } from '../engine/protocol';
import type { Driver } from './drivers';
import { fixed } from './numbers';

/** End of the displayed branch: between a reachable and an unreachable row. */
export interface End { side: 'lower' | 'upper'; inside: number; outside: number }

export const isReached = (row: CurveRow) => row.status !== 'unreachable' && row.status !== 'no answer';

/** First and last row of the displayed branch: the uninterrupted reachable rows around a value. */
export function branchRows(rows: CurveRow[], now: number): [number, number] | undefined {
  const nearest = rows.reduce((best, row, i) => (isReached(row) && (best < 0 || Math.abs(row.at - now) < Math.abs(rows[best].at - now)) ? i : best), -1);
  if (nearest < 0) return undefined;
  let [first, last] = [nearest, nearest];
  while (first > 0 && isReached(rows[first - 1])) first--;
  while (last + 1 < rows.length && isReached(rows[last + 1])) last++;
  return [first, last];
}

export function endsOf(rows: CurveRow[], now: number): End[] {
  const range = branchRows(rows, now);
  if (!range) return [];
  const [first, last] = range;
  const out: End[] = [];
  if (first > 0) out.push({ side: 'lower', inside: rows[first].at, outside: rows[first - 1].at });
  if (last + 1 < rows.length) out.push({ side: 'upper', inside: rows[last].at, outside: rows[last + 1].at });
  return out;
}

const shown = (driver: Driver, x: number) => `${fixed(x * driver.unit.perSi, driver.unit.decimals + 1)} ${driver.unit.name}`;

/** Sentences about the curve: its ends, singular poses, and ranges without a finite mass. */
export function remarks(curve: Curve, driver: Driver, ends: End[]): string[] {
  const out = ends.map(({ side, inside }) => (
    `The linkage ends at ${shown(driver, inside)} of ${driver.label}: a dead centre, beyond which the loops do not close. It is the ${side} end.`));
  const of = (status: string, text: string) => {
    const ranges: [number, number][] = [];
    curve.rows.forEach((row, i) => {
      if (row.status !== status) return;
      if (i > 0 && curve.rows[i - 1].status === status) ranges.at(-1)![1] = row.at;
      else ranges.push([row.at, row.at]);
    });
    const texts = ranges.map(([from, to]) => (from === to ? `at ${shown(driver, from)}` : `from ${shown(driver, from)} to ${shown(driver, to)}`));
    if (texts.length) out.push(`${text} ${texts.join(', ')}.`);
  };
  of('immovable', 'Immovable');
  of('massless', 'Massless');
  const singular = curve.rows.filter((row) => row.singular).map((row) => shown(driver, row.at));
  if (singular.length) out.push(`Change points (dashed), at which branches cross and m̄ depends on the branch: ${singular.slice(0, 4).join(', ')}.`);
  return out;
}

/** Parts of the range in which m̄ is within a band: first and last value. */
export function insideBand(rows: CurveRow[], band: [number, number]): [number, number][] {
  const out: [number, number][] = [];
  let open = false;
  for (const row of rows) {
    const isInside = row.mass !== null && row.mass >= band[0] && row.mass <= band[1];
    if (isInside && open) out.at(-1)![1] = row.at;
    else if (isInside) out.push([row.at, row.at]);
    open = isInside;
  }
  return out;
}
