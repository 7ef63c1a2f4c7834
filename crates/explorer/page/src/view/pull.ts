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
/** Shortest motion of the point on the screen that gives a direction, pixels per part of the range. */
const LEAST_MOTION = 8;

export class Pull {
  /** Two poses that are known: values of the driver with the frames. */
  private known: [{ value: number; frames: number[] }, { value: number; frames: number[] }] | undefined;
  private ends: [number, number];

  constructor(private readonly driver: Driver, private readonly link: number, private readonly point: Triple) {
    const rows = store.curve && 'ok' in store.curve ? store.curve.ok.rows : [];
    const range = branchRows(rows, store.positionOf(driver));
    // The branch shown is not left; its ends are known only for the driver of the curve.
    this.ends = range && store.driver === driver ? [rows[range[0]].at, rows[range[1]].at] : driver.range;
  }

  place(frames: number[]): Vector3 {
    return pointAt(frames, this.link, this.point);
  }

  /** Finds the direction in which the point moves with the driver. */
  async probe() {
    const { driver } = this;
    const value = store.positionOf(driver);
    const frames = store.frames!;
    const step = PROBE * (driver.range[1] - driver.range[0]);
    for (const by of [step, -step]) {
      const other = await store.framesAt(driver, value + by);
      if (other) {
        this.known ??= [{ value: value + by, frames: other }, { value, frames }];
        return;
      }
    }
  }

  /** Moves the driver so that the point is as near to the pointer as the motion permits. */
  toward(cameras: Cameras, pointer: { x: number; y: number }) {
    if (!this.known) return;
    const span = this.driver.range[1] - this.driver.range[0];
    const present = store.answered && store.positionOf(this.driver);
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
    store.change(withValue(store.study!, this.driver, value), `drag ${store.scene!.links[this.link].name}`);
  }
}
