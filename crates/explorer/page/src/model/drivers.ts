// Quantities that move the mechanism: motions of the wheels, and joints that can be set.

import type { Opened, PosedMass, Scene, SceneJoint, Study } from '../engine/protocol';
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

const NAMES: Record<string, string> = { 'wheel-travel': 'wheel travel', heave: 'heave', roll: 'roll' };
/** Range of a wheel without stops, m; of a joint without limits, rad or m. */
const WHEEL_RANGE = 0.05;
const TURN_RANGE = Math.PI;
const SLIDE_RANGE = 0.1;
/** Largest range of the wheel travel up to the stops, m. */
const LONGEST_TRAVEL = 0.3;
const ROUND = 0.005;

function wheelRange(opened: Opened): [number, number] {
  let [low, high] = [0, 0];
  for (const contact of opened.contacts?.contacts ?? []) {
    if (contact.kind !== 'stop') continue;
    for (const { travel } of contact.report?.named_contact?.wheel_travel ?? []) {
      if (Math.abs(travel) > LONGEST_TRAVEL) continue;
      low = Math.min(low, travel);
      high = Math.max(high, travel);
    }
  }
  const outward = (x: number, sign: number) => sign * Math.ceil((Math.abs(x) + ROUND) / ROUND) * ROUND;
  return [low < 0 ? outward(low, -1) : -WHEEL_RANGE, high > 0 ? outward(high, 1) : WHEEL_RANGE];
}

function jointDriver(joint: SceneJoint): Driver | null {
  const turns = joint.kind === 'revolute' || joint.kind === 'continuous';
  if (!joint.can_be_set || !(turns || joint.kind === 'prismatic')) return null;
  const unit = turns ? DEGREE : MILLIMETRE;
  const side = turns ? TURN_RANGE : SLIDE_RANGE;
  const [low, high] = joint.limits ?? [-side, side];
  // With a distant limit, the slider would be too coarse.
  const range: [number, number] = [Math.max(low, -2 * Math.max(side, TURN_RANGE)), Math.min(high, 2 * Math.max(side, TURN_RANGE))];
  if (!(range[0] < range[1])) return null;
  return { name: joint.name, label: joint.name, isMotion: false, unit, range };
}

export function drivers(opened: Opened): Driver[] {
  const { scene } = opened;
  const motions = scene.motions.map((name): Driver => {
    const range = wheelRange(opened);
    const side = Math.min(-range[0], range[1]);
    return {
      name, label: NAMES[name] ?? name, isMotion: true, unit: MILLIMETRE, range: name === 'roll' ? [-side, side] : range,
    };
  });
  const joints = scene.joints.map(jointDriver).filter((driver) => driver !== null);
  // The travel drives the linkage; the rotation of a wheel about its bearing moves no other link.
  return motions.length ? [...motions, ...joints.filter((driver) => driver.name === 'rack')] : joints;
}

/** Driver of the first curve: a motion of the wheels, otherwise the joint nearest to the contact link on its way to the root. */
export function firstDriver(scene: Scene, all: Driver[], link: string | undefined): Driver | undefined {
  if (all[0]?.isMotion) return all[0];
  let at = scene.links.findIndex((l) => l.name === link);
  for (let left = scene.links.length; left > 0; left--) {
    const joint = scene.joints.find((j) => j.child === at);
    if (!joint) break;
    const driver = all.find((d) => d.name === joint.name);
    if (driver) return driver;
    at = joint.parent;
  }
  return all[0];
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

/** The same range in parts, upwards and downwards from the row next to the design pose, at which loops are closed. For each
 * row before the first reachable row, the engine searches for about a second; rows beyond the last reachable row take no time. */
export function varyOutward(driver: Driver, count: number): Part[] {
  const [low, high] = driver.range;
  const step = (high - low) / (count - 1);
  const first = Math.ceil(-low / step - 1e-9);
  const part = (range: [number, number], rows: number, downwards: boolean): Part => ({ text: vary({ ...driver, range }, rows, downwards), downwards });
  // A range has at least two rows.
  if (first < 2) return [part([low, high], count, false)];
  if (first > count - 2) return [part([low, high], count, true)];
  return [part([low + first * step, high], count - first, false), part([low, low + (first - 1) * step], first, true)];
}
