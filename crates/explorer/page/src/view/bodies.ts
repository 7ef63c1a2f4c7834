// Bodies in three dimensions: bars or shapes of the links, joints, springs, dampers, stops, wheels, ground.

import {
  BufferAttribute, BufferGeometry, CatmullRomCurve3, Color, CylinderGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh,
  MeshLambertMaterial, Quaternion, SphereGeometry, TubeGeometry, Vector3,
} from 'three';
import type { Scene, Triple } from '../engine/protocol';
import type { Wire } from './overlay';
import { VARIANTS, frame, pointAt, vectorAt } from './space';

const UP = new Vector3(0, 1, 0);
const GREY = '#8793a1';
const DARK = '#4b5563';

/** Radii as parts of the radius of the scene. */
const BAR = 0.016;
const THIN_BAR = 0.008;
const JOINT = 0.022;

/** Matrix that places a body of unit radius and length along y between two points. */
function between(from: Vector3, to: Vector3, radius: number): Matrix4 {
  const along = to.clone().sub(from);
  const length = along.length();
  const turn = new Quaternion().setFromUnitVectors(UP, length > 0 ? along.divideScalar(length) : UP);
  return new Matrix4().compose(from.clone().add(to).multiplyScalar(0.5), turn, new Vector3(radius, Math.max(length, 1e-9), radius));
}

/** Helix of unit length along y and of radius 1, with a wire that is round at the usual length of a spring. */
function spring(): BufferGeometry {
  const [turns, steps, length] = [7, 112, 9];
  const points = Array.from({ length: steps + 1 }, (_, i) => {
    const angle = (2 * Math.PI * turns * i) / steps;
    return new Vector3(Math.cos(angle), length * (i / steps - 0.5), Math.sin(angle));
  });
  return new TubeGeometry(new CatmullRomCurve3(points), 240, 0.17, 7).scale(1, 1 / length, 1);
}

/** Lines of a tyre of radius 1 about y: its edges, and its section at four places. */
function tyre(): Vector3[][] {
  const half = 0.3;
  const profile: [number, number][] = [
    [0.64, -half * 0.8], [0.93, -half], [0.985, -half * 0.8], [1, 0], [0.985, half * 0.8], [0.93, half], [0.64, half * 0.8], [0.64, -half * 0.8],
  ];
  const at = (r: number, y: number, turn: number) => new Vector3(r * Math.cos(turn), y, r * Math.sin(turn));
  const circle = (r: number, y: number) => Array.from({ length: 49 }, (_, k) => at(r, y, (k * Math.PI) / 24));
  const section = (turn: number) => profile.map(([r, y]) => at(r, y, turn));
  return [circle(0.94, -half), circle(0.94, half), ...[0, 1, 2, 3].map((k) => section((k * Math.PI) / 2))];
}

/** Bodies of unit size, the same for every scene: a drag makes a scene for each result. */
const UNIT_BAR = new CylinderGeometry(1, 1, 1, 14);
const UNIT_BALL = new SphereGeometry(1, 14, 10);
const GROUND_CONE = new CylinderGeometry(0.25, 1, 1.6, 4);
const UNIT_SPRING = spring();
const TYRE_LINES = tyre();
const DARK_PART = new MeshLambertMaterial({ color: DARK });
const GREY_PART = new MeshLambertMaterial({ color: GREY });
const PAINTED = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
const DESIGN_LINE = new LineBasicMaterial({ color: '#9aa5b1' });
const VARIANT_LINES = VARIANTS.map((color) => new LineBasicMaterial({ color }));

interface Element { contact: Scene['contacts'][number]; meshes: Mesh[] }

export class Bodies {
  readonly group = new Group();
  /** Groups of the links, by number. */
  readonly links: Group[] = [];
  readonly pickable: Mesh[] = [];
  private materials: MeshLambertMaterial[] = [];
  private elements: Element[] = [];
  private ghosts: LineSegments[] = [];
  /** Geometries of the shapes of this scene. */
  private own: BufferGeometry[] = [];

  /** `former`: bodies of the previous scene. Their materials are reused, because the renderer would prepare new materials for each result
   * of a drag. */
  constructor(private readonly scene: Scene, shapes: (Float32Array | null)[], private readonly radius: number, former?: Bodies) {
    const links = former?.scene.links.length === scene.links.length ? former.materials.splice(0) : [];
    scene.links.forEach((link, i) => {
      const group = new Group();
      group.matrixAutoUpdate = false;
      const material = links[i] ?? new MeshLambertMaterial({ color: GREY, side: DoubleSide });
      const corners = shapes[i];
      if (corners && corners.length) {
        const geometry = this.keep(new BufferGeometry());
        geometry.setAttribute('position', new BufferAttribute(corners, 3));
        geometry.computeVertexNormals();
        this.addLink(group, new Mesh(geometry, material), i);
      } else {
        const width = this.radius * (link.mass > 0 ? BAR : THIN_BAR);
        const ends: Vector3[] = [];
        if (!link.lines.length && link.mass > 0 && link.com) {
          // A body without joints, lines and shape: a ball at its centre of mass.
          const body = new Mesh(UNIT_BALL, material);
          body.position.set(...link.com);
          body.scale.setScalar(3 * width);
          this.addLink(group, body, i);
        }
        for (const line of link.lines) {
          if (this.endsAtPatch(i, line)) continue;
          const [from, to] = line.map((end) => new Vector3(...end));
          const mesh = new Mesh(UNIT_BAR, material);
          mesh.matrixAutoUpdate = false;
          mesh.matrix.copy(between(from, to, width));
          this.addLink(group, mesh, i);
          for (const end of [from, to]) {
            if (ends.some((other) => other.distanceTo(end) < 1e-3 * this.radius)) continue;
            ends.push(end);
            const knob = new Mesh(UNIT_BALL, material);
            knob.position.copy(end);
            knob.scale.setScalar(width);
            this.addLink(group, knob, i);
          }
        }
      }
      this.materials.push(material);
      this.links.push(group);
      this.group.add(group);
    });
    this.addJoints();
    for (const contact of scene.contacts) {
      const count = { spring: 1, damper: 2, stop: 2, patch: 0, other: 0 }[contact.kind];
      const geometry = contact.kind === 'spring' ? UNIT_SPRING : UNIT_BAR;
      const meshes = Array.from({ length: count }, () => new Mesh(geometry, contact.kind === 'stop' ? DARK_PART : GREY_PART));
      for (const mesh of meshes) {
        mesh.matrixAutoUpdate = false;
        this.group.add(mesh);
      }
      this.elements.push({ contact, meshes });
    }
  }

  /** True for the line from a hub to the ground: a direction, not a body. */
  private endsAtPatch(link: number, line: [Triple, Triple]): boolean {
    return this.scene.links.some(({ name }, i) => name.startsWith('contact_patch')
      && line.some((end) => pointAt(this.scene.design, link, end).distanceTo(pointAt(this.scene.design, i, [0, 0, 0])) < 1e-4 * this.radius));
  }

  private keep<T extends BufferGeometry>(geometry: T): T {
    this.own.push(geometry);
    return geometry;
  }

  private addLink(group: Group, mesh: Mesh, link: number) {
    mesh.userData.link = link;
    group.add(mesh);
    this.pickable.push(mesh);
  }

  private addJoints() {
    const add = (link: number, at: Triple, isGround: boolean) => {
      const mesh = new Mesh(isGround ? GROUND_CONE : UNIT_BALL, DARK_PART);
      mesh.position.set(...at);
      mesh.scale.setScalar(this.radius * JOINT * (isGround ? 1.2 : 0.85));
      if (isGround) mesh.rotation.x = Math.PI / 2;
      this.links[link].add(mesh);
    };
    const done = new Set<string>();
    for (const joint of this.scene.joints) {
      if (joint.kind === 'fixed') continue;
      const at = pointAt(this.scene.design, joint.child, [0, 0, 0]);
      const key = at.toArray().map((x) => x.toFixed(4)).join();
      if (done.has(key)) continue;
      done.add(key);
      if (joint.parent === this.scene.root) {
        const root = at.clone().applyMatrix4(frame(this.scene.design, this.scene.root).invert());
        add(this.scene.root, root.toArray() as Triple, true);
      } else {
        add(joint.child, [0, 0, 0], false);
      }
    }
    for (const { ends } of this.scene.closures) {
      for (const [link, at] of ends) if (link !== null && link !== this.scene.root) add(link, at, false);
    }
  }

  /** Outlines of the tyres; with `all`, the bodies as lines too: links, springs, dampers and stops. `colours`: of the links, or null for grey. */
  wires(frames: number[], colours: Color[] | null, all: boolean): Wire[] {
    const colour = (link: number) => (colours?.[link] ? `#${colours[link].getHexString()}` : GREY);
    const { links, wheels, contacts, root } = this.scene;
    const tyres = wheels.flatMap((wheel) => {
      const turn = new Quaternion().setFromUnitVectors(UP, new Vector3(...wheel.axis).normalize());
      const place = new Matrix4().compose(new Vector3(...wheel.centre), turn, new Vector3().setScalar(wheel.radius)).premultiply(frame(frames, wheel.link));
      // The link that has the mass of the wheel.
      const name = links[wheel.link].name.replace('wheel_centre', 'wheel');
      return TYRE_LINES.map((line) => ({
        points: line.map((point) => point.clone().applyMatrix4(place)), colour: colour(links.findIndex((link) => link.name === name)), isThin: true,
      }));
    });
    if (!all) return tyres;
    const bars = links.flatMap((link, i) => link.lines.filter((line) => !this.endsAtPatch(i, line))
      .map((line) => ({ points: line.map((end) => pointAt(frames, i, end)), colour: colour(i), isThin: false })));
    const elements = contacts.filter(({ kind }) => kind === 'spring' || kind === 'damper' || kind === 'stop').map((c) => {
      const [point, other] = [pointAt(frames, c.link, c.point), c.against ?? root];
      const end = c.normal === 'fixed' ? point.clone().addScaledVector(vectorAt(frames, other, c.vector), c.gap ?? 0) : pointAt(frames, other, c.vector);
      return { points: [point, end], colour: GREY, isThin: true };
    });
    return [...bars, ...tyres, ...elements];
  }

  pose(frames: number[]) {
    this.links.forEach((group, i) => {
      group.matrix.copy(frame(frames, i));
      group.matrixWorldNeedsUpdate = true;
    });
    for (const { contact, meshes } of this.elements) {
      const point = pointAt(frames, contact.link, contact.point);
      const against = contact.against ?? this.scene.root;
      const isLine = contact.normal !== 'fixed';
      const seat = isLine ? pointAt(frames, against, contact.vector) : undefined;
      const normal = seat ? seat.clone().sub(point) : vectorAt(frames, against, contact.vector);
      const length = normal.length();
      normal.normalize();
      if (contact.normal === 'away') normal.negate();
      const along = (from: number, to: number, width: number, i: number) =>
        meshes[i]?.matrix.copy(between(point.clone().addScaledVector(normal, from), point.clone().addScaledVector(normal, to), width * this.radius));
      if (contact.kind === 'spring') along(0, length, 0.042, 0);
      if (contact.kind === 'damper') {
        along(0, length, 0.007, 0);
        along(0, 0.55 * length, 0.02, 1);
      }
      if (contact.kind === 'stop') {
        const thick = 0.02 * this.radius;
        const gap = Math.max(seat ? length : (contact.gap ?? 0), 0);
        along(-thick, 0, 0.026, 0);
        along(gap, gap + 0.35 * thick, 0.04, 1);
        if (contact.normal === 'away') meshes[1].visible = false;
      }
    }
  }

  colour(colours: Color[] | null, chosen: number | undefined) {
    this.materials.forEach((material, i) => {
      material.color.copy(colours?.[i] ?? new Color(GREY));
      material.emissive.set(i === chosen ? '#12304a' : '#000000');
    });
  }

  /** Colours of the facets of the links with shapes; undefined for one colour a link. */
  paint(colours: Map<number, Color[]> | undefined) {
    for (const mesh of this.pickable) {
      const own = colours?.get(mesh.userData.link as number);
      const material = this.materials[mesh.userData.link as number];
      if (!own) {
        mesh.material = material;
        continue;
      }
      const values = new Float32Array(9 * own.length);
      own.forEach((colour, i) => {
        for (let k = 0; k < 3; k++) colour.toArray(values, 9 * i + 3 * k);
      });
      mesh.geometry.setAttribute('color', new BufferAttribute(values, 3));
      mesh.material = PAINTED;
    }
  }

  private outline(scene: Scene, frames: number[], material: LineBasicMaterial): LineSegments {
    const ends = scene.links.flatMap((link, i) => link.lines.filter((line) => !this.endsAtPatch(i, line))
      .flatMap((line) => line.map((end) => pointAt(frames, i, end))));
    return new LineSegments(new BufferGeometry().setFromPoints(ends), material);
  }

  /** Thin lines of the design pose, and of the kept variants at their poses. */
  outlines(design: boolean, variants: { scene: Scene; frames: number[]; colour: number }[]) {
    for (const old of this.ghosts) {
      this.group.remove(old);
      old.geometry.dispose();
    }
    this.ghosts = variants.map((v) => this.outline(v.scene, v.frames, VARIANT_LINES[v.colour]));
    if (design) this.ghosts.push(this.outline(this.scene, this.scene.design, DESIGN_LINE));
    if (this.ghosts.length) this.group.add(...this.ghosts);
  }

  dispose() {
    for (const geometry of this.own) geometry.dispose();
    for (const material of this.materials) material.dispose();
    this.outlines(false, []);
  }
}
