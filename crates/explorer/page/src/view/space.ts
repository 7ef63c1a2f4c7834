// Frames, scales and colours of the view.

import { Color, Matrix4, Quaternion, Vector3 } from 'three';
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

/** Points that enclose everything drawn at a pose, m. */
export function outline(scene: Scene, frames: number[], shapes: (Float32Array | null)[]): Vector3[] {
  const points: Vector3[] = [];
  scene.links.forEach((link, i) => {
    for (const line of link.lines) for (const end of line) points.push(pointAt(frames, i, end));
    if (link.com && link.mass > 0) points.push(pointAt(frames, i, link.com));
    const corners = shapes[i];
    // Some corners of a large mesh suffice for its bounds.
    const step = corners ? 3 * Math.max(1, Math.floor(corners.length / 3 / 600)) : 1;
    for (let k = 0; corners && k + 2 < corners.length; k += step) points.push(pointAt(frames, i, [corners[k], corners[k + 1], corners[k + 2]]));
  });
  for (const wheel of scene.wheels) {
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...wheel.axis).normalize());
    for (let k = 0; k < 12; k++) {
      const spoke = new Vector3(Math.cos((k * Math.PI) / 6), Math.sin((k * Math.PI) / 6), 0).applyQuaternion(turn).multiplyScalar(wheel.radius);
      points.push(pointAt(frames, wheel.link, spoke.add(new Vector3(...wheel.centre)).toArray() as Triple));
    }
  }
  for (const point of scene.sheet?.hardpoints ?? []) points.push(pointAt(frames, point.link, point.point));
  return points.length ? points : [new Vector3(-1, -1, -1), new Vector3(1, 1, 1)];
}

/** Colours of the kept variants, on light and dark ground. */
export const VARIANTS = ['#0b78b8', '#00936b', '#c0609a', '#a87900', '#3f9fd8', '#8a63d2', '#947243', '#6b7785'];

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

/** Contacts at the centres of the facets of a shape along their outward normals: six numbers each, frame of the link. */
export function facetsOf(scene: Scene, shapes: (Float32Array | null)[]): { link: number; name: string; contacts: number[][] }[] {
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  return shapes.flatMap((corners, link) => {
    if (!corners?.length) return [];
    const contacts: number[][] = [];
    for (let k = 0; k + 8 < corners.length; k += 9) {
      a.fromArray(corners, k);
      b.fromArray(corners, k + 3);
      c.fromArray(corners, k + 6);
      const centre = a.clone().add(b).add(c).multiplyScalar(1 / 3);
      const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
      // A facet without an area has no normal.
      contacts.push([...centre.toArray(), ...(normal.length() > 0 ? normal : new Vector3(0, 0, 1)).toArray()]);
    }
    return [{ link, name: scene.links[link].name, contacts }];
  });
}
