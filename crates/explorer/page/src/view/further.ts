// Further results in the view: impulses as arrows, the ellipsoid of directions, the colours of a map.

import { Color, Vector3 } from 'three';
import type { GivenContact } from '../engine/protocol';
import { store } from '../model/store';
import { rampColour } from './space';

/** Longest arrow of an impulse and longest half axis of the ellipsoid, as parts of the radius of the scene. */
const LONGEST_IMPULSE = 0.45;
const LONGEST_AXIS = 0.3;
/** Impulses below this part of the largest are not drawn. */
const SMALL_IMPULSE = 1e-3;
/** Largest ratio of two principal masses drawn to scale; beyond, the axis is drawn as open. */
const MOST_RATIO = 400;
/** Part of the facets at each end of a map that the colours leave out. */
const OUTLIERS = 0.02;
/** Largest ratio of the masses at the ends of the colours: m̄ grows without limit toward an immovable facet. */
const MOST_COLOURS = 100;

/** Impulses on the second link of each joint, and that of the contact, if the impact is shown; of an impact in time, the forces at the
 * displayed moment, each in the direction of its impulse. */
export function impulses(radius: number) {
  const found = store.answers.results.impact;
  if (!store.answers.isShown('impact') || !found || !('ok' in found) || !store.answers.isFresh()) return [];
  const { reactions, impulse, in_time: time } = found.ok;
  const moment = time ? store.answers.momentOf(time) : 0;
  const vector = (r: (typeof reactions)[number]) => r.force.reduce((sum, f, k) => sum.addScaledVector(new Vector3(...r.axes_world[k]), f ?? 0), new Vector3());
  const all = reactions.flatMap((r) => {
    const bearing = time?.bearings.find((b) => b.name === r.name && b.place === r.place);
    if (time && !bearing) return [];
    const by = vector(r);
    return [{ at: new Vector3(...r.point_world), by: bearing ? by.normalize() : by, size: bearing?.force[moment] ?? by.length(), most: bearing?.peak_force ?? by.length(), name: r.name, on: r.on ?? 'ground' }];
  });
  const { point_world, normal_world, link } = store.posed!.report.contact;
  all.push({
    at: new Vector3(...point_world), by: new Vector3(...normal_world).negate(), size: time?.force[moment] ?? impulse, most: time?.peak_force ?? impulse, name: 'contact', on: link,
  });
  const largest = Math.max(1e-12, ...all.map(({ most }) => most));
  return all.filter(({ size }) => size > SMALL_IMPULSE * largest).map(({ at, by, size, name, on }) => ({
    at, by: by.clone().setLength((LONGEST_IMPULSE * radius * size) / largest), title: `${name}: ${size.toPrecision(3)} ${time ? 'N' : 'N·s'} on ${on}`,
  }));
}

/** Half axes of the ellipsoid of directions: lengths in proportion to √m̄. */
export function directions(radius: number) {
  const found = store.answers.results.directions;
  if (!store.answers.isShown('directions') || !found || !('ok' in found) || !store.answers.isFresh()) return [];
  const { principal } = found.ok;
  const lightest = Math.min(...principal.map((p) => p.effective_mass ?? Infinity));
  const heaviest = Math.max(0, ...principal.map((p) => p.effective_mass ?? 0));
  // The heaviest axis has a fixed length, unless the lightest could not be seen.
  const scale = (LONGEST_AXIS * radius) / Math.sqrt(Math.min(heaviest, MOST_RATIO * lightest) || 1);
  return principal.map((p) => {
    const m = p.effective_mass;
    const isBounded = m !== null && m <= MOST_RATIO * lightest;
    const length = p.status === 'massless' ? 0 : isBounded ? scale * Math.sqrt(m) : 1.3 * LONGEST_AXIS * radius;
    const label = m === null ? (p.status === 'immovable' ? '∞' : '0 kg') : `${m.toPrecision(4)} kg`;
    return { half: new Vector3(...p.direction_world).multiplyScalar(length), label, isBounded: isBounded || p.status === 'massless' };
  });
}

/** m̄ of the facets at the ends of the colours: the extremes without outliers. */
export function rangeOfMap(found: Map<number, GivenContact[]>): [number, number] | undefined {
  const all = [...found.values()].flat().map((answer) => answer.effective_mass).filter((m): m is number => m !== null && m > 0).sort((a, b) => a - b);
  if (!all.length) return undefined;
  const low = all[Math.floor(OUTLIERS * (all.length - 1))];
  return [low, Math.min(all[Math.ceil((1 - OUTLIERS) * (all.length - 1))], MOST_COLOURS * low)];
}

/** Colours of the facets, in proportion to the logarithm of m̄. */
export function coloursOfMap(found: Map<number, GivenContact[]>): Map<number, Color[]> {
  const range = rangeOfMap(found);
  const colour = ({ status, effective_mass: m }: GivenContact) => {
    if (m === null || !range) return status === 'massless' ? rampColour(0) : new Color('#6b7785');
    return rampColour(Math.log(m / range[0]) / Math.max(1e-9, Math.log(range[1] / range[0])));
  };
  return new Map([...found].map(([link, masses]) => [link, masses.map(colour)]));
}
