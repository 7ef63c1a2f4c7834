// Cameras: perspective for the view in three dimensions, parallel for front, side and top, where lengths can be measured.

import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { ViewName } from '../model/link';

const DIRECTIONS: Record<ViewName, { from: Vector3; up: Vector3 }> = {
  '3d': { from: new Vector3(0.78, 0.86, 0.52), up: new Vector3(0, 0, 1) },
  front: { from: new Vector3(1, 0, 0), up: new Vector3(0, 0, 1) },
  side: { from: new Vector3(0, 1, 0), up: new Vector3(0, 0, 1) },
  top: { from: new Vector3(0, 0, 1), up: new Vector3(1, 0, 0) },
};
const FIELD = 32;
/** Part of the view that the mechanism takes: names and the arrow need the rest. */
const FILLED = 0.78;
/** The same in a low view, where buttons cover a larger part. */
const FILLED_LOW = 0.7;
const LOW = 420;
const FITTING_STEPS = 6;
/** Radius of a scene of one point, m. */
export const POINT_RADIUS = 0.5;

export class Cameras {
  readonly perspective = new PerspectiveCamera(FIELD, 1, 0.01, 100);
  readonly flat = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
  private readonly controls: Record<'perspective' | 'flat', OrbitControls>;
  private name: ViewName = '3d';
  private centre = new Vector3();
  private radius = 1;
  private points: Vector3[] = [];
  private size: [number, number] = [1, 1];

  constructor(element: HTMLElement, changed: () => void) {
    const make = (camera: Camera, rotates: boolean) => {
      const controls = new OrbitControls(camera, element);
      controls.enableRotate = rotates;
      controls.enableDamping = false;
      controls.zoomToCursor = true;
      if (!rotates) controls.mouseButtons.LEFT = 2;
      if (!rotates) controls.touches.ONE = 1;
      controls.addEventListener('change', changed);
      return controls;
    };
    this.perspective.up.set(0, 0, 1);
    this.controls = { perspective: make(this.perspective, true), flat: make(this.flat, false) };
    this.controls.flat.enabled = false;
  }

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.name === '3d' ? this.perspective : this.flat;
  }

  /** Disables the controls while a mark or a link is dragged. */
  enable(on: boolean) {
    this.controls.perspective.enabled = on && this.name === '3d';
    this.controls.flat.enabled = on && this.name !== '3d';
  }

  resize(width: number, height: number) {
    this.size = [width, height];
    this.perspective.aspect = width / height;
    this.perspective.updateProjectionMatrix();
    const half = this.radius;
    Object.assign(this.flat, { left: (-half * width) / height, right: (half * width) / height, top: half, bottom: -half });
    this.flat.updateProjectionMatrix();
  }

  /** Shows all of these points. */
  fit(points: Vector3[]) {
    this.points = points;
    const low = points.reduce((a, p) => a.clone().min(p), points[0]);
    const high = points.reduce((a, p) => a.clone().max(p), points[0]);
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.radius = high.distanceTo(low) / 2 || POINT_RADIUS;
    this.show(this.name);
  }

  show(name: ViewName) {
    this.name = name;
    const { from, up } = DIRECTIONS[name];
    const camera = this.camera;
    const controls = name === '3d' ? this.controls.perspective : this.controls.flat;
    const direction = from.clone().normalize();
    this.resize(...this.size);
    camera.up.copy(up);
    this.flat.zoom = 1;
    this.flat.near = -20 * this.radius;
    this.flat.far = 20 * this.radius;
    this.perspective.near = this.radius / 50;
    this.perspective.far = this.radius * 200;
    this.flat.updateProjectionMatrix();
    this.perspective.updateProjectionMatrix();
    let distance = this.radius / Math.tan((FIELD / 2) * (Math.PI / 180));
    const target = this.centre.clone();
    for (let step = 0; step < FITTING_STEPS; step++) {
      camera.position.copy(target).addScaledVector(direction, distance);
      camera.lookAt(target);
      camera.updateMatrixWorld();
      const seen = this.points.map((p) => p.clone().project(camera));
      const [x0, x1] = [Math.min(...seen.map((p) => p.x)), Math.max(...seen.map((p) => p.x))];
      const [y0, y1] = [Math.min(...seen.map((p) => p.y)), Math.max(...seen.map((p) => p.y))];
      if (x1 === x0 && y1 === y0) break;
      const most = Math.max(x1 - x0, y1 - y0) / 2 / (this.size[1] < LOW ? FILLED_LOW : FILLED);
      // The middle of the picture goes to the middle of the view.
      const depth = target.clone().project(camera).z;
      const middle = new Vector3((x0 + x1) / 2, (y0 + y1) / 2, depth).unproject(camera);
      target.copy(middle);
      if (name === '3d') distance *= most;
      else this.flat.zoom /= Math.max(most, 1e-9);
      this.flat.updateProjectionMatrix();
    }
    camera.position.copy(target).addScaledVector(direction, distance);
    camera.lookAt(target);
    camera.updateMatrixWorld();
    controls.target.copy(target);
    controls.object = camera;
    this.enable(true);
    controls.update();
  }

  /** Length of one pixel at a point, m. */
  pixel(at: Vector3): number {
    if (this.name !== '3d') return (this.flat.top - this.flat.bottom) / this.flat.zoom / this.size[1];
    const depth = at.clone().sub(this.perspective.position).dot(this.perspective.getWorldDirection(new Vector3()));
    return (2 * Math.abs(depth) * Math.tan((FIELD / 2) * (Math.PI / 180))) / this.size[1];
  }

  /** Position on the screen, pixels; `visible` false behind the camera. */
  project(at: Vector3): { x: number; y: number; visible: boolean } {
    const p = at.clone().project(this.camera);
    const [width, height] = this.size;
    return { x: ((p.x + 1) / 2) * width, y: ((1 - p.y) / 2) * height, visible: p.z > -1 && p.z < 1 };
  }

  /** Ray through a pixel: origin and unit direction. */
  ray(x: number, y: number): { origin: Vector3; direction: Vector3 } {
    const [width, height] = this.size;
    const [a, b] = [(2 * x) / width - 1, 1 - (2 * y) / height];
    const near = new Vector3(a, b, -1).unproject(this.camera);
    const far = new Vector3(a, b, 1).unproject(this.camera);
    return { origin: near, direction: far.sub(near).normalize() };
  }

  /** Point under a pixel in the plane of the screen through a point. */
  inPlane(x: number, y: number, through: Vector3): Vector3 {
    const { origin, direction } = this.ray(x, y);
    const normal = this.camera.getWorldDirection(new Vector3());
    const t = through.clone().sub(origin).dot(normal) / direction.dot(normal);
    return origin.addScaledVector(direction, t);
  }
}
