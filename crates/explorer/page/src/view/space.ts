// Frames, scales and colours of the view.

import { Color, Matrix4, Vector3 } from 'three';
import type { Scene, Triple } from '../engine/protocol';

/** Frame of a link in a list of frames. */
export function frame(frames: number[], link: number): Matrix4 {
  const f = frames.slice(12 * link, 12 * link + 12);
  return new Matrix4().set(f[0], f[1], f[2], f[9], f[3], f[4], f[5], f[10], f[6], f[7], f[8], f[11], 0, 0, 0, 1);
}

export function pointAt(frames: number[], link: number, point: Triple): Vector3 {
  return new Vector3(...point).applyMatrix4(frame(frames, link));
}

export function vectorAt(frames: number[], link: number, vector: Triple): Vector3 {
  return new Vector3(...vector).transformDirection(frame(frames, link)).multiplyScalar(Math.hypot(...vector));
}

/** Vector of the world in the frame of a link. */
export function intoLink(frames: number[], link: number, vector: Vector3): Vector3 {
  const length = vector.length();
  return length === 0 ? vector.clone() : vector.clone().transformDirection(frame(frames, link).transpose().setPosition(0, 0, 0)).multiplyScalar(length);
}

/** Centre and radius of everything drawn at the design pose, m. */
export function extent(scene: Scene, shapes: (Float32Array | null)[]): { centre: Vector3; radius: number } {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const add = (at: Vector3) => {
    low.min(at);
    high.max(at);
  };
  scene.links.forEach((link, i) => {
    for (const line of link.lines) for (const end of line) add(pointAt(scene.design, i, end));
    const corners = shapes[i];
    // Every corner of a large mesh would take long; the extent needs only some.
    const step = corners ? 3 * Math.max(1, Math.floor(corners.length / 3 / 2000)) : 1;
    for (let k = 0; corners && k + 2 < corners.length; k += step) add(pointAt(scene.design, i, [corners[k], corners[k + 1], corners[k + 2]]));
  });
  for (const wheel of scene.wheels) {
    const at = pointAt(scene.design, wheel.link, wheel.centre);
    const r = new Vector3().setScalar(wheel.radius);
    add(at.clone().add(r));
    add(at.clone().sub(r));
  }
  for (const point of scene.sheet?.hardpoints ?? []) add(pointAt(scene.design, point.link, point.point));
  if (!(high.x >= low.x)) return { centre: new Vector3(), radius: 1 };
  const radius = Math.max(high.clone().sub(low).length() / 2, 1e-6);
  return { centre: low.add(high).multiplyScalar(0.5), radius };
}

const RAMP = ['#c3ced9', '#e3b98d', '#e08a3c', '#b83a0f'].map((c) => new Color(c));

/** Colour of a share, 0 to 1 of the largest share. */
export function rampColour(x: number): Color {
  const at = Math.min(Math.max(x, 0), 1) * (RAMP.length - 1);
  const i = Math.min(Math.floor(at), RAMP.length - 2);
  return RAMP[i].clone().lerp(RAMP[i + 1], at - i);
}

export function rampGradient(): string {
  return RAMP.map((c) => `#${c.getHexString()}`).join(', ');
}

/** Triangles of a link in the page: base64 of 32-bit floats. */
export function decodeShape(text: string | null): Float32Array | null {
  if (!text) return null;
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}
