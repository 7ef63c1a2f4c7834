// Quantities that move the mechanism: motions of the wheels, and joints that can be set.

import type { ListedContact, PosedMass, Scene, SceneJoint, Study, Triple } from '../engine/protocol';
import { DEGREE, MILLIMETRE, plain, siValue, type DisplayUnit } from './numbers';

export interface Driver {
  /** Name in the study: a joint, or a motion of the wheels. */
  name: string;
  label: string;
  isMotion: boolean;
  unit: DisplayUnit;
  /** Ends of the slider and of the curve, SI. */
  range: [number, number];
}

/** Joint that steers a suspension. */
export const RACK = 'rack';
const NAMES: Record<string, string> = { 'wheel-travel': 'wheel travel', heave: 'heave', roll: 'roll' };
/** Range of a wheel without stops, m; of a joint without limits, rad or m. */
const WHEEL_RANGE = 0.05;
const TURN_RANGE = Math.PI;
const SLIDE_RANGE = 0.1;
/** Largest range of the wheel travel up to the stops, m. */
const LONGEST_TRAVEL = 0.3;
const ROUND = 0.005;
/** Difference below which two stops touch at the same travel, m. */
const SAME_TRAVEL = 1e-6;

/** Ending of the names of both sides. */
export const SIDE = /_(left|right)$/;

/** Touch of a stop: travel of its wheels, m. The stops of both sides are one touch. */
export interface Touch { name: string; travel: number }

export function touches(contacts: ListedContact[]): Touch[] {
  const all = contacts.flatMap(({ kind, report, name }) => {
    const travels = kind === 'stop' && report?.named_contact?.brought_to_touch ? report.named_contact.wheel_travel.map((wheel) => wheel.travel) : [];
    const travel = travels.reduce((a, b) => a + b, 0) / travels.length;
    return Math.abs(travel) <= LONGEST_TRAVEL ? [{ name: name.replace(SIDE, ''), travel }] : [];
  });
  return all.filter((touch, i) => all.findIndex((other) => other.name === touch.name && Math.abs(other.travel - touch.travel) < SAME_TRAVEL) === i);
}

/** Range of the travel: a tenth beyond the touches of the stops and beyond the travel shown. */
function wheelRange(contacts: ListedContact[], shown: number): [number, number] {
  const travels = [0, ...touches(contacts).map((touch) => touch.travel), Math.abs(shown) <= LONGEST_TRAVEL ? shown : 0];
  const [low, high] = [Math.min(...travels), Math.max(...travels)];
  const room = Math.max(0.1 * (high - low), ROUND);
  return [low < 0 ? Math.floor((low - room) / ROUND) * ROUND : -WHEEL_RANGE, high > 0 ? Math.ceil((high + room) / ROUND) * ROUND : WHEEL_RANGE];
}

function jointDriver(joint: SceneJoint, isToLeft: boolean): Driver | null {
  const turns = joint.kind === 'revolute' || joint.kind === 'continuous';
  if (!joint.can_be_set || !(turns || joint.kind === 'prismatic')) return null;
  const unit = turns ? DEGREE : MILLIMETRE;
  const side = turns ? TURN_RANGE : SLIDE_RANGE;
  const [low, high] = joint.limits ?? [-side, side];
  // With a distant limit, the slider would be too coarse.
  const range: [number, number] = [Math.max(low, -2 * Math.max(side, TURN_RANGE)), Math.min(high, 2 * Math.max(side, TURN_RANGE))];
  if (!(range[0] < range[1])) return null;
  return { name: joint.name, label: joint.name === RACK ? `rack, + ${isToLeft ? 'left' : 'right'}` : joint.name, isMotion: false, unit, range };
}

/** Drivers of a model. `contacts`: results of the named contacts; `shown`: travel of the wheels, m. */
export function drivers(scene: Scene, contacts: ListedContact[], shown = 0): Driver[] {
  const motions = scene.motions.map((name): Driver => {
    const range = wheelRange(contacts, shown);
    const side = Math.min(-range[0], range[1]);
    return {
      name, label: NAMES[name] ?? name, isMotion: true, unit: MILLIMETRE, range: name === 'roll' ? [-side, side] : range,
    };
  });
  // Component of the axis along y of the world, which is to the left.
  const alongY = ({ child, axis }: SceneJoint) => [0, 1, 2].reduce((sum, k) => sum + scene.design[12 * child + 3 + k] * (axis?.[k] ?? 0), 0);
  const joints = scene.joints.map((joint) => jointDriver(joint, alongY(joint) > 0)).filter((driver) => driver !== null);
  // The travel drives the linkage; the rotation of a wheel about its bearing moves no other link.
  return motions.length ? [...motions, ...joints.filter((driver) => driver.name === RACK)] : joints;
}

/** Distance of a point on the axis of a hinge from this axis, m: rounding. */
const ON_AXIS = 1e-9;

/** True for a hinge whose axis contains a point of a link in the design position: the hinge does not move the point. */
function hasOnAxis(scene: Scene, { axis, child, kind }: SceneJoint, link: number, point: Triple): boolean {
  if (kind === 'prismatic' || !axis) return false;
  const turned = (of: number, v: Triple, k: number) => [0, 1, 2].reduce((sum, i) => sum + scene.design[12 * of + 3 * k + i] * v[i], 0);
  const [u, d] = [[0, 1, 2].map((k) => turned(child, axis, k)), [0, 1, 2].map((k) => turned(link, point, k) + scene.design[12 * link + 9 + k] - scene.design[12 * child + 9 + k])];
  return Math.hypot(u[1] * d[2] - u[2] * d[1], u[2] * d[0] - u[0] * d[2], u[0] * d[1] - u[1] * d[0]) < ON_AXIS;
}

/** Driver of the first curve: a motion of the wheels, otherwise the nearest joint on the way from the contact link to the root that moves the contact point. */
export function firstDriver(scene: Scene, all: Driver[], link: string | undefined, point: Triple = [0, 0, 0]): Driver | undefined {
  if (all[0]?.isMotion) return all[0];
  const contact = scene.links.findIndex((l) => l.name === link);
  let [at, nearest]: [number, Driver | undefined] = [contact, undefined];
  for (let left = scene.links.length; left > 0; left--) {
    const joint = scene.joints.find((j) => j.child === at);
    if (!joint) break;
    const driver = all.find((d) => d.name === joint.name);
    if (driver && !hasOnAxis(scene, joint, contact, point)) return driver;
    nearest ??= driver;
    at = joint.parent;
  }
  return nearest ?? all[0];
}

/** Value that a study gives to a driver, SI; undefined if it gives none. */
export function givenValue(study: Study, driver: Driver): number | undefined {
  if (!driver.isMotion) {
    const text = study.pose.set?.[driver.name];
    return text === undefined ? undefined : siValue(text);
  }
  const text = study.pose.travel?.find((t) => t.startsWith(`${driver.name}=`));
  return text === undefined ? undefined : siValue(text.slice(driver.name.length + 1));
}

/** Value of a driver at the displayed pose, SI. */
export function valueOf(driver: Driver, study: Study, posed: PosedMass | undefined): number {
  const given = givenValue(study, driver);
  if (given !== undefined) return given;
  if (!driver.isMotion) return posed?.report.pose[driver.name]?.[0] ?? 0;
  // A stop brought to the touch has its own travel.
  const travels = posed?.report.named_contact?.wheel_travel.map(({ travel }) => travel) ?? [];
  if (!travels.length || study.pose.travel?.length || driver.name === 'roll') return 0;
  return travels.reduce((a, b) => a + b, 0) / travels.length;
}

/** Drivers that move a link: a motion of the wheels, or the joints on the way to the root that can be set, the nearest first. */
export function driversOf(scene: Scene, all: Driver[], link: number): Driver[] {
  if (link === scene.root) return [];
  if (all[0]?.isMotion) return [all[0]];
  const found: Driver[] = [];
  let at = link;
  for (let left = scene.links.length; left > 0; left--) {
    const joint = scene.joints.find((j) => j.child === at);
    if (!joint) break;
    const driver = all.find((d) => d.name === joint.name);
    if (driver) found.push(driver);
    at = joint.parent;
  }
  // A link of a loop may be moved by a joint on the other side of the loop.
  return [...found, ...all.filter((driver) => !found.includes(driver))];
}

function written(value: number, unit: DisplayUnit): string {
  return plain(Number((value * unit.perSi).toFixed(6))) + (unit === DEGREE ? 'deg' : unit.name);
}

/** Study with another value of a driver; `undefined` removes the value. */
export function withValue(study: Study, driver: Driver, value: number | undefined): Study {
  if (driver.isMotion) {
    const kept = (study.pose.travel ?? []).filter((text) => !text.startsWith(`${driver.name}=`));
    const travel = value === undefined ? kept : [...kept, `${driver.name}=${written(value, driver.unit)}`];
    return { ...study, pose: { ...study.pose, travel } };
  }
  const set = { ...study.pose.set };
  if (value === undefined) delete set[driver.name];
  else set[driver.name] = written(value, driver.unit);
  return { ...study, pose: { ...study.pose, set } };
}

/** Range of a curve as the engine reads it; with `downwards`, from its upper end. */
export function vary(driver: Driver, count: number, downwards = false): string {
  const ends = driver.range.map((x) => written(x, driver.unit));
  const [from, to] = downwards ? ends.reverse() : ends;
  return `${driver.name}=${from}:${to}:${count}`;
}

export interface Part { text: string; downwards: boolean }

/** The same range; with loops in parts, upwards and downwards from the row next to the design pose, at which loops are closed. For each
 * row before the first reachable row, the engine searches for about a second; rows beyond the last reachable row take no time. */
export function parts(driver: Driver, count: number, hasLoops: boolean): Part[] {
  if (!hasLoops) return [{ text: vary(driver, count), downwards: false }];
  const [low, high] = driver.range;
  const step = (high - low) / (count - 1);
  const first = Math.ceil(-low / step - 1e-9);
  const part = (range: [number, number], rows: number, downwards: boolean): Part => ({ text: vary({ ...driver, range }, rows, downwards), downwards });
  // A range has at least two rows.
  if (first < 2) return [part([low, high], count, false)];
  if (first > count - 2) return [part([low, high], count, true)];
  return [part([low + first * step, high], count - first, false), part([low, low + (first - 1) * step], first, true)];
}
