// A dragged link: its driver follows the pointer, and the loops follow the driver.

import { Vector3 } from 'three';
import type { Triple } from '../engine/protocol';
import { withValue, type Driver } from '../model/drivers';
import { branchRows } from '../model/ends';
import { store } from '../model/store';
import type { Cameras } from './cameras';
import { pointAt } from './space';

/** Difference of the driver for the first direction of the point, as a part of the range. */
const PROBE = 0.002;
/** Longest step of the driver between two answers, as a part of the range. */
const LONGEST_STEP = 0.08;
/** Motion of the point on the screen over the range of a driver, pixels: enough to choose the driver (a bar that turns about its own
 * axis has less), and the least for a direction. */
const CLEAR_MOTION = 120;
const LEAST_MOTION = 8;
/** Largest number of joints that are tried before the first result. */
const MOST_DRIVERS = 8;

export class Pull {
  private driver: Driver | undefined;
  /** Two poses that are known: values of the driver with the frames. */
  private known: [{ value: number; frames: number[] }, { value: number; frames: number[] }] | undefined;
  private ends: [number, number] = [0, 0];

  constructor(private readonly drivers: Driver[], private readonly link: number, private readonly point: Triple) {}

  place(frames: number[]): Vector3 {
    return pointAt(frames, this.link, this.point);
  }

  /** Chooses the first driver that moves the point on the screen, and the direction of this motion. */
  async probe(cameras: Cameras) {
    const frames = store.frames!;
    const at = cameras.project(this.place(frames));
    let largest = LEAST_MOTION;
    for (const driver of this.drivers.slice(0, MOST_DRIVERS)) {
      const value = store.positionOf(driver);
      const step = PROBE * (driver.range[1] - driver.range[0]);
      let beside = value + step;
      let other = await store.framesAt(driver, beside);
      if (!other) {
        beside = value - step;
        other = await store.framesAt(driver, beside);
      }
      if (!other) continue;
      const to = cameras.project(this.place(other));
      const motion = Math.hypot(to.x - at.x, to.y - at.y) / PROBE;
      if (motion < largest) continue;
      largest = motion;
      // The drag stays on the displayed branch, whose ends are known only for the driver of the curve.
      const rows = store.curve && 'ok' in store.curve ? store.curve.ok.rows : [];
      const range = branchRows(rows, value);
      this.ends = range && store.driver === driver ? [rows[range[0]].at, rows[range[1]].at] : driver.range;
      this.driver = driver;
      this.known = [{ value: beside, frames: other }, { value, frames }];
      if (motion > CLEAR_MOTION) return;
    }
  }

  /** Moves the driver so that the point is as near to the pointer as the motion permits. */
  toward(cameras: Cameras, pointer: { x: number; y: number }) {
    const { driver } = this;
    if (!this.known || !driver) return;
    const span = driver.range[1] - driver.range[0];
    const present = store.answered && store.positionOf(driver);
    const last = this.known[1];
    if (present !== undefined && store.answered === store.study && Math.abs(present - last.value) > 1e-6 * span) {
      this.known = [last, { value: present, frames: store.frames! }];
    }
    const [a, b] = this.known;
    const [from, at] = [cameras.project(this.place(a.frames)), cameras.project(this.place(b.frames))];
    const by = b.value - a.value;
    const [tx, ty] = [(at.x - from.x) / by, (at.y - from.y) / by];
    const square = tx * tx + ty * ty;
    if (square * span * span < LEAST_MOTION ** 2) return;
    const wanted = ((pointer.x - at.x) * tx + (pointer.y - at.y) * ty) / square;
    const step = Math.min(Math.max(wanted, -LONGEST_STEP * span), LONGEST_STEP * span);
    const value = Math.min(Math.max(b.value + step, this.ends[0]), this.ends[1]);
    store.change(withValue(store.study!, driver, value), `drag ${store.scene!.links[this.link].name}`);
  }
}
