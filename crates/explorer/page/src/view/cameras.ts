// Cameras: perspective for the view in three dimensions, parallel for front, side and top, where lengths can be measured.

import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { ViewName } from '../model/store';

const DIRECTIONS: Record<ViewName, { from: Vector3; up: Vector3 }> = {
  '3d': { from: new Vector3(0.78, 0.86, 0.52), up: new Vector3(0, 0, 1) },
  front: { from: new Vector3(1, 0, 0), up: new Vector3(0, 0, 1) },
  side: { from: new Vector3(0, 1, 0), up: new Vector3(0, 0, 1) },
  top: { from: new Vector3(0, 0, 1), up: new Vector3(1, 0, 0) },
};
const FIELD = 32;
const MARGIN = 1.06;

export class Cameras {
  readonly perspective = new PerspectiveCamera(FIELD, 1, 0.01, 100);
  readonly flat = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
  private readonly controls: Record<'perspective' | 'flat', OrbitControls>;
  private name: ViewName = '3d';
  private centre = new Vector3();
  private radius = 1;
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

  /** Switches the controls off while something else is dragged. */
  enable(on: boolean) {
    this.controls.perspective.enabled = on && this.name === '3d';
    this.controls.flat.enabled = on && this.name !== '3d';
  }

  resize(width: number, height: number) {
    this.size = [width, height];
    this.perspective.aspect = width / height;
    this.perspective.updateProjectionMatrix();
    const half = this.radius * MARGIN;
    const [w, h] = width > height ? [half * width / height, half] : [half, half * height / width];
    Object.assign(this.flat, { left: -w, right: w, top: h, bottom: -h });
    this.flat.updateProjectionMatrix();
  }

  fit(centre: Vector3, radius: number) {
    this.centre.copy(centre);
    this.radius = radius;
    this.show(this.name);
  }

  show(name: ViewName) {
    this.name = name;
    const { from, up } = DIRECTIONS[name];
    const camera = this.camera;
    const [width, height] = this.size;
    const narrow = Math.min(1, width / height);
    const distance = (this.radius * MARGIN) / Math.sin((FIELD / 2) * (Math.PI / 180)) / narrow;
    camera.up.copy(up);
    camera.position.copy(this.centre).addScaledVector(from.clone().normalize(), name === '3d' ? distance : 4 * this.radius);
    const controls = name === '3d' ? this.controls.perspective : this.controls.flat;
    controls.target.copy(this.centre);
    controls.object = camera;
    if (name === '3d') {
      this.perspective.near = distance / 100;
      this.perspective.far = distance * 20;
    } else {
      this.flat.zoom = 1;
      this.flat.near = -20 * this.radius;
      this.flat.far = 20 * this.radius;
    }
    this.resize(width, height);
    this.enable(true);
    camera.lookAt(this.centre);
    camera.updateMatrixWorld();
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
