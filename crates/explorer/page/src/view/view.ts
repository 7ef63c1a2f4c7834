// View of the mechanism: draws the bodies and marks of the store, and turns gestures into changes of the study.

import { AmbientLight, DirectionalLight, GridHelper, HemisphereLight, Line3, Matrix4, Raycaster, Scene as Stage, Vector3, WebGLRenderer } from 'three';
import type { Scene, Triple } from '../engine/protocol';
import { fixed, mass, signed, words } from '../model/numbers';
import { driversOf } from '../model/drivers';
import { store } from '../model/store';
import { Bodies } from './bodies';
import { Cameras, POINT_RADIUS } from './cameras';
import { Overlay, type Mark } from './overlay';
import { coloursOfMap, directions, impulses } from './further';
import { Pull } from './pull';
import { decodeShape, facetsOf, frame, intoLink, outline, pointAt, rampColour } from './space';

/** Nearest distance to a mark that counts as a hit, pixels: mouse and finger. */
const REACH = { mouse: 12, touch: 24 };
/** Radius of the dot of the contact, pixels. */
const DOT = 6;
/** Movement that makes a press a drag, pixels. */
const SLOP = 4;
/** Step of a dragged hardpoint, m. */
const SNAP = 0.001;
/** Angle within which a dragged normal takes the direction of an axis, rad. */
const SNAP_ANGLE = 0.1;

/** Space for the arrow of the contact, as a part of the radius of the scene. */
const ARROW_ROOM = 0.25;
/** Share of m̄ from which a link is named. */
const LEAST_SHARE = 0.003;
const MOST_TIMES = 400;

interface Drag {
  what: 'point' | 'contact' | 'normal' | 'link';
  name: string;
  /** World position at the start. */
  at: Vector3;
  /** Displacement or contact at the start. */
  start: Triple;
  held: 'x' | 'y' | 'z' | null;
  frames: number[];
  moved: boolean;
  /** True if the study had no result before. */
  hadProblem: boolean;
  /** Driver of a dragged link. */
  pull?: Pull;
}

export class View {
  webgl = true;
  private renderer: WebGLRenderer | undefined;
  private stage = new Stage();
  private grid: GridHelper | undefined;
  private bodies: Bodies | undefined;
  private cameras: Cameras;
  private overlay: Overlay;
  private shown: { scene?: Scene; shapes?: unknown; view?: string; fitted?: unknown; map?: unknown; mapped?: unknown; pose?: string; answered?: unknown; isInside?: boolean } = {};
  private shapes: (Float32Array | null)[] = [];
  private centre = new Vector3();
  private radius = 1;
  private tip: Vector3 | undefined;
  private drag: Drag | undefined;
  private press: { x: number; y: number } | undefined;
  private pointer: { x: number; y: number } | undefined;
  private hovered: string | undefined;
  private box = new DOMRect();
  private pending = false;
  /** All that the last rendering shows; empty to render again. */
  private rendered: unknown[] = [];
  /** Times of drawings, ms. */
  private times: number[] = [];
  private stop: () => void;
  private observer: ResizeObserver;

  constructor(private readonly element: HTMLElement, private readonly picked: (link: number | undefined, at?: Vector3, normal?: Vector3) => void) {
    const surface = document.createElement('div');
    surface.className = 'surface';
    element.append(surface);
    try {
      this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
      // The shaders are those of three.js; a check waits until the compiler of the driver has finished.
      this.renderer.debug.checkShaderErrors = false;
      this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
      this.renderer.domElement.addEventListener('webglcontextlost', (event) => {
        event.preventDefault();
        this.renderer = undefined;
        this.webgl = false;
        store.set({ notice: 'The graphics of this browser stopped; the mechanism is drawn as lines.' });
      });
      surface.append(this.renderer.domElement);
    } catch {
      this.webgl = false;
    }
    this.stage.add(new HemisphereLight('#ffffff', '#aab4c0', 2.2), new AmbientLight('#ffffff', 0.35));
    const sun = new DirectionalLight('#ffffff', 1.6);
    sun.position.set(3, 4, 6);
    this.stage.add(sun);
    this.cameras = new Cameras(surface, () => this.invalidate());
    this.overlay = new Overlay(element);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(element);
    surface.addEventListener('pointerdown', this.down, { capture: true });
    surface.addEventListener('pointermove', this.move);
    surface.addEventListener('pointerup', this.up);
    surface.addEventListener('pointercancel', this.cancel);
    surface.addEventListener('pointerleave', () => this.hover(undefined));
    addEventListener('keydown', this.key);
    this.stop = store.listen(() => this.invalidate());
    this.resize();
  }

  dispose() {
    this.stop();
    this.observer.disconnect();
    removeEventListener('keydown', this.key);
    this.bodies?.dispose();
    this.renderer?.dispose();
    this.element.replaceChildren();
  }

  /** Picture of the view as a PNG address; undefined without WebGL. */
  png(): string | undefined {
    if (!this.renderer) return undefined;
    this.rendered = [];
    this.draw();
    return this.renderer.domElement.toDataURL('image/png');
  }

  /** Shows the mechanism at its pose, and the contact. */
  fit() {
    const { scene, frames, posed } = store;
    if (!scene || !frames) return;
    const points = outline(scene, frames, this.shapes);
    if (posed) {
      const point = new Vector3(...posed.report.contact.point_world);
      points.push(point, point.clone().addScaledVector(new Vector3(...posed.report.contact.normal_world), ARROW_ROOM * this.radius));
    }
    const far = this.farEnd(frames);
    if (far) points.push(far);
    this.cameras.fit(points);
    this.invalidate();
  }

  private resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height) return;
    this.renderer?.setSize(width, height);
    this.rendered = [];
    this.cameras.resize(width, height);
    this.overlay.resize(width, height);
    if (!this.shown.fitted && this.shown.scene) this.fit();
    this.invalidate();
  }

  invalidate() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      const begun = performance.now();
      this.draw();
      this.times.push(performance.now() - begun);
      if (this.times.length > MOST_TIMES) this.times.shift();
    });
  }

  private build(scene: Scene) {
    const isNewModel = this.shown.fitted !== store.opened;
    if (this.shown.shapes !== store.shapes || isNewModel) {
      this.shapes = (store.shapes ?? []).map(decodeShape);
      this.shown.shapes = store.shapes;
      store.answers.facets = facetsOf(scene, this.shapes);
    }
    if (this.bodies) this.stage.remove(this.bodies.group);
    if (isNewModel) {
      const points = outline(scene, scene.design, this.shapes);
      const low = points.reduce((a, p) => a.clone().min(p), points[0]);
      const high = points.reduce((a, p) => a.clone().max(p), points[0]);
      this.centre = low.clone().add(high).multiplyScalar(0.5);
      // A single point has no size.
      this.radius = high.distanceTo(low) / 2 || POINT_RADIUS;
      this.shown.fitted = store.opened;
      this.fit();
      this.addGrid(scene);
    }
    this.bodies = new Bodies(scene, this.shapes, this.radius, this.bodies);
    this.stage.add(this.bodies.group);
    this.shown.scene = scene;
  }

  private addGrid(scene: Scene) {
    if (this.grid) {
      this.stage.remove(this.grid);
      this.grid.dispose();
    }
    const step = 10 ** Math.floor(Math.log10(this.radius));
    const half = Math.ceil((2.2 * this.radius) / step) * step;
    const isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    this.grid = new GridHelper(2 * half, Math.round((2 * half) / step), ...(isDark ? ['#48525e', '#2c343d'] : ['#b8c1cc', '#dde2e8']));
    this.grid.rotation.x = Math.PI / 2;
    const wheel = scene.wheels[0];
    const floor = wheel ? pointAt(scene.design, wheel.link, wheel.centre).z - wheel.radius : this.centre.z - 0.75 * this.radius;
    this.grid.position.set(Math.round(this.centre.x / step) * step, Math.round(this.centre.y / step) * step, floor);
    this.stage.add(this.grid);
  }

  private draw() {
    const { scene, frames, posed, problem } = store;
    if (!scene || !frames) return;
    const former = this.shown.scene === scene ? undefined : this.bodies;
    if (this.shown.scene !== scene) this.build(scene);
    if (this.shown.view !== store.view) {
      this.shown.view = store.view;
      this.cameras.show(store.view);
      if (this.grid) this.grid.visible = store.view === '3d';
    }
    // A pose of the model may be far from the former one.
    const pose = store.answered?.pose.file;
    if (this.shown.pose !== pose && store.answered === store.study) {
      this.shown.pose = pose;
      this.fit();
    }
    if (store.isIdle && posed) {
      // The view follows a contact that leaves it, unless the user has moved the camera.
      const { x, y } = this.cameras.project(new Vector3(...posed.report.contact.point_world));
      const isInside = x > 0 && y > 0 && x < this.element.clientWidth && y < this.element.clientHeight;
      const hasLeft = !isInside && this.shown.isInside && this.shown.answered !== store.answered;
      if (hasLeft) this.fit();
      this.shown.isInside = isInside || hasLeft;
      this.shown.answered = store.answered;
    }
    const bodies = this.bodies!;
    bodies.pose(frames);
    const shares = posed?.report.bodies.map((body) => body.share);
    const most = Math.max(1e-12, ...(shares ?? []).map((share) => share ?? 0));
    const byShare = store.colours === 'share' && shares?.some((share) => share !== null) && !problem;
    const colours = byShare ? scene.links.map((_, i) => rampColour((shares![i] ?? 0) / most)) : null;
    bodies.colour(colours, undefined);
    this.colourMap();
    bodies.outlines(store.showsDesign, store.variants.filter((v) => v.study !== store.answered));
    this.render();
    // Only after the new bodies exist: shader programs without users are deleted and would be compiled again.
    former?.dispose();
    this.overlay.drawWires(this.cameras, bodies.wires(frames, colours, !this.webgl));
    this.overlay.drawAxes(this.cameras, store.axes);
    this.overlay.drawScale(this.cameras, this.centre, store.view !== '3d');
    this.overlay.drawPoints(this.cameras, store.showsPoints ? this.marks() : [], store.selected);
    this.overlay.drawNames(this.cameras, store.showsNames && posed && !problem ? this.names(frames) : []);
    this.overlay.drawImpulses(this.cameras, problem ? [] : impulses(this.radius));
    this.overlay.drawDirections(this.cameras, posed ? new Vector3(...posed.report.contact.point_world) : this.centre, problem ? [] : directions(this.radius));
    this.overlay.drawMotion(this.cameras, store.showsMotion && posed && !problem ? this.motion(frames) : []);
    this.tip = this.overlay.drawContact(this.cameras, posed && {
      point: new Vector3(...posed.report.contact.point_world),
      normal: new Vector3(...posed.report.contact.normal_world),
      reach: this.reach(frames),
      far: this.farEnd(frames),
      label: this.value(),
      isStale: problem !== undefined,
    });
    this.drawLabel();
  }

  /** Renders the bodies, unless the last rendering shows the same: curves, lists and the pointer change only the marks. */
  private render() {
    const { camera } = this.cameras;
    camera.updateMatrixWorld();
    const shown = [
      store.scene, store.frames, store.posed, store.problem, store.colours, store.showsDesign, store.variants, store.answered, this.shown.map,
      ...camera.projectionMatrix.elements, ...camera.matrixWorld.elements,
    ];
    if (shown.length === this.rendered.length && shown.every((value, i) => value === this.rendered[i])) return;
    this.rendered = shown;
    this.renderer?.render(this.stage, camera);
  }

  /** Drawn point of the contact link nearest to the contact; undefined for a link with a shape. */
  private reach(frames: number[]): Vector3 | undefined {
    const { scene, posed } = store;
    const { link: name, point_world } = posed!.report.contact;
    const link = scene!.links.findIndex((l) => l.name === name);
    if (link < 0 || this.shapes[link]?.length) return undefined;
    const point = new Vector3(...point_world);
    const nearest = scene!.links[link].lines.map(([a, b]) => {
      const line = new Line3(pointAt(frames, link, a), pointAt(frames, link, b));
      return line.closestPointToPoint(point, true, new Vector3());
    });
    return nearest.sort((a, b) => a.distanceTo(point) - b.distanceTo(point))[0];
  }

  /** Other end of the line or the cable of the contact. */
  private farEnd(frames: number[]): Vector3 | undefined {
    const line = store.study?.contact.along_line;
    const link = store.scene!.links.findIndex((l) => l.name === line?.link);
    return line && link >= 0 ? pointAt(frames, link, line.point) : undefined;
  }

  /** Links with their shares, the largest first, at their centres of mass. */
  private names(frames: number[]) {
    const { scene, posed } = store;
    return scene!.links.flatMap((link, i) => {
      const share = posed!.report.bodies[i]?.share ?? 0;
      return share >= LEAST_SHARE && link.com ? [{ share, at: pointAt(frames, i, link.com), text: `${words(link.name)} ${fixed(100 * share, share < 0.095 ? 1 : 0)} %` }] : [];
    }).sort((a, b) => b.share - a.share);
  }

  /** Name of the contact; without a finite m̄, the outcome. */
  private value(): string {
    const { report } = store.posed!;
    if (report.status === 'immovable') return 'm̄ = ∞';
    if (report.status === 'massless') return `m̄ = 0 ${report.unit}`;
    const named = report.named_contact;
    return named ? `${words(named.name)}${named.brought_to_touch ? ', at the touch' : ''}` : `m̄ ${mass(report.effective_mass!, report.effective_mass_error)} ${report.unit}`;
  }

  private marks(): Mark[] {
    const { scene, frames } = store;
    return (scene?.sheet?.hardpoints ?? []).map((point) => ({
      name: point.name,
      at: pointAt(frames!, point.link, point.point),
      isMoved: store.moved(point.name).some((x) => x !== 0),
    }));
  }

  private motion(frames: number[]) {
    const { scene, posed } = store;
    const fastest = Math.max(1e-12, ...posed!.velocities.map((v) => (v ? Math.hypot(...v) : 0)));
    const length = (0.35 * this.radius) / fastest;
    return scene!.links.flatMap((link, i) => {
      const v = posed!.velocities[i];
      if (!link.com || !v || Math.hypot(...v) < 1e-6 * fastest) return [];
      return [{ at: pointAt(frames, i, link.com), by: new Vector3(...v).multiplyScalar(length) }];
    });
  }

  private colourMap() {
    const found = store.answers.isShown('map') ? store.answers.results.map : undefined;
    const shown = found && 'ok' in found ? found.ok : undefined;
    if (this.shown.map === shown && this.shown.mapped === this.bodies) return;
    this.shown.map = shown;
    this.shown.mapped = this.bodies;
    this.bodies!.paint(shown && coloursOfMap(shown));
  }

  private drawLabel() {
    const name = this.drag?.what === 'point' ? this.drag.name : (this.hovered ?? store.selected);
    const mark = name ? this.marks().find((m) => m.name === name) : undefined;
    if (!mark || !store.showsPoints) {
      this.overlay.drawLabel(undefined);
      return;
    }
    const by = store.moved(mark.name).map((x) => x * 1000);
    const moved = by.some((x) => x !== 0) ? `  Δ ${by.map((x) => signed(x, 1)).join(' ')} mm` : '';
    const at = this.cameras.project(mark.at);
    const bad = store.problem && this.drag?.what === 'point' && this.pointer ? this.pointer : undefined;
    this.overlay.drawLabel(mark.name + moved, at.x, at.y, bad);
  }

  // ---- gestures ------------------------------------------------------------------------------------------------------

  /** Position of the pointer in the view. During a drag, the position of the view is not read again, because the browser would
   * compute the layout for each event. */
  private at(event: PointerEvent) {
    if (!this.drag) this.box = this.element.getBoundingClientRect();
    return { x: event.clientX - this.box.left, y: event.clientY - this.box.top };
  }

  private hit(x: number, y: number, kind: string): { what: Drag['what']; name: string } | undefined {
    const reach = REACH[kind === 'mouse' ? 'mouse' : 'touch'];
    const found: { what: Drag['what']; name: string; d: number }[] = [];
    const add = (what: Drag['what'], name: string, at: Vector3, handicap = 0) => {
      const p = this.cameras.project(at);
      const d = Math.hypot(p.x - x, p.y - y) + handicap;
      if (p.visible && d < reach) found.push({ what, name, d });
    };
    if (store.posed) {
      if (this.tip) add('normal', 'normal', this.tip, -2);
      // The dot of the contact covers the ring of a hardpoint at the same place.
      add('contact', 'contact', new Vector3(...store.posed.report.contact.point_world), -DOT);
    }
    if (store.showsPoints) for (const mark of this.marks()) add('point', mark.name, mark.at);
    return found.sort((a, b) => a.d - b.d)[0];
  }

  private down = (event: PointerEvent) => {
    if (event.button !== 0 || !store.frames) return;
    const { x, y } = this.at(event);
    this.press = { x, y };
    if (store.choosing) return;
    const hit: { what: Drag['what']; name: string; pull?: Pull } | undefined = this.hit(x, y, event.pointerType) ?? this.linkAt(x, y);
    if (!hit) return;
    // Otherwise the camera would turn as well.
    this.cameras.enable(false);
    event.stopImmediatePropagation();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    const mark = hit.what === 'point' ? this.marks().find((m) => m.name === hit.name) : undefined;
    const contact = store.posed?.report.contact;
    if (hit.pull) {
      const { pull } = hit;
      this.drag = { what: 'link', name: hit.name, held: null, moved: false, frames: store.frames, hadProblem: false, at: pull.place(store.frames), start: [0, 0, 0], pull };
      store.begin(`drag ${hit.name}`);
      void pull.probe(this.cameras);
      return;
    }
    this.drag = {
      ...hit, held: null, moved: false, frames: store.frames, hadProblem: store.problem !== undefined,
      at: mark ? mark.at : hit.what === 'normal' ? this.tip!.clone() : new Vector3(...contact!.point_world),
      start: mark ? store.moved(hit.name) : hit.what === 'normal' ? contact!.normal_world : contact!.point_link,
    };
    store.begin(hit.what === 'point' ? `move ${hit.name}` : hit.what === 'normal' ? 'turn the normal' : 'move the contact');
    if (mark) store.set({ selected: hit.name });
  };

  private move = (event: PointerEvent) => {
    const at = this.at(event);
    this.pointer = at;
    if (!this.drag) {
      if (event.pointerType === 'mouse' && event.buttons === 0) this.hover(this.hit(at.x, at.y, 'mouse'));
      return;
    }
    if (!this.drag.moved && this.press && Math.hypot(at.x - this.press.x, at.y - this.press.y) < SLOP) return;
    this.drag.moved = true;
    if (this.drag.pull) this.drag.pull.toward(this.cameras, at);
    else if (this.drag.what === 'point') this.dragPoint(at, event.altKey);
    else if (this.drag.what === 'contact') this.dragContact(at);
    else this.dragNormal(at);
    this.invalidate();
  };

  /** Link under the pointer with the driver that moves it; undefined for the background and for links without a driver. */
  private linkAt(x: number, y: number): { what: 'link'; name: string; pull: Pull } | undefined {
    const found = this.bodies && this.cast(x, y);
    const drivers = found ? driversOf(store.scene!, store.drivers, found.link) : [];
    if (!found || !drivers.length) return undefined;
    const point = found.at.clone().applyMatrix4(frame(store.frames!, found.link).invert());
    return { what: 'link', name: store.scene!.links[found.link].name, pull: new Pull(drivers, found.link, point.toArray() as Triple) };
  }

  private hover(hit: { what: string; name: string } | undefined) {
    const name = hit?.what === 'point' ? hit.name : undefined;
    this.element.style.cursor = store.choosing ? 'crosshair' : hit ? 'grab' : '';
    if (name !== this.hovered) {
      this.hovered = name;
      this.invalidate();
    }
  }

  private dragPoint({ x, y }: { x: number; y: number }, isFine: boolean) {
    const drag = this.drag!;
    const point = store.opened!.scene.sheet!.hardpoints.find((p) => p.name === drag.name)!;
    const by = this.cameras.inPlane(x, y, drag.at).sub(drag.at);
    // Away from the design position, the displacement is turned back with the link.
    const design = intoLink(drag.frames, point.link, by).transformDirection(
      this.designTurn(point.link)).multiplyScalar(by.length());
    const step = isFine ? SNAP / 10 : SNAP;
    const moved = [0, 1, 2].map((k) => {
      const along = design.getComponent(k) * point.to_world[k];
      if (drag.held && 'xyz'[k] !== drag.held) return drag.start[k];
      return Math.round((drag.start[k] + along) / step) * step;
    }) as Triple;
    store.movePoint(drag.name, moved, `move ${drag.name}`);
  }

  private designTurn(link: number) {
    const f = store.opened!.scene.design.slice(12 * link, 12 * link + 9);
    return new Matrix4().set(f[0], f[1], f[2], 0, f[3], f[4], f[5], 0, f[6], f[7], f[8], 0, 0, 0, 0, 1);
  }

  private dragContact({ x, y }: { x: number; y: number }) {
    // The end of a line or a cable moves, its direction follows.
    const given = store.study?.contact;
    const own = given?.along_line && !given.frame ? given : store.ownContact();
    if (!own?.link) return;
    const link = store.scene!.links.findIndex((l) => l.name === own.link);
    const surface = this.shapes[link]?.length ? this.cast(x, y, link) : undefined;
    const contact = { ...own };
    if (surface) contact.point = this.pointIn(link, surface.at);
    if (surface && !own.along_line) {
      contact.normal = this.normalIn(link, surface.normal);
      delete contact.normal_frame;
    } else if (!surface) {
      contact.point = this.pointIn(link, this.cameras.inPlane(x, y, this.drag!.at));
    }
    store.setContact(contact, 'move the contact');
  }

  private pointIn(link: number, at: Vector3): Triple {
    const origin = pointAt(store.frames!, link, [0, 0, 0]);
    return intoLink(store.frames!, link, at.clone().sub(origin)).toArray().map((v) => Math.round(v * 1e4) / 1e4 + 0) as Triple;
  }

  private normalIn(link: number, normal: Vector3): Triple {
    return intoLink(store.frames!, link, normal).toArray().map((v) => Math.round(v * 1e5) / 1e5 + 0) as Triple;
  }

  private dragNormal({ x, y }: { x: number; y: number }) {
    const own = store.ownContact();
    if (!own) return;
    const point = new Vector3(...store.posed!.report.contact.point_world);
    const length = this.drag!.at.distanceTo(point);
    const { origin, direction } = this.cameras.ray(x, y);
    // Nearest point of the ray to the sphere of the arrow head.
    const foot = origin.clone().addScaledVector(direction, point.clone().sub(origin).dot(direction));
    const off = foot.distanceTo(point);
    const normal = foot.sub(point);
    if (off < length) normal.addScaledVector(direction, -Math.sqrt(length * length - off * off));
    normal.normalize();
    for (const axis of [0, 1, 2]) {
      const unit = new Vector3().setComponent(axis, Math.sign(normal.getComponent(axis)) || 1);
      if (normal.angleTo(unit) < SNAP_ANGLE) normal.copy(unit);
    }
    const rounded = normal.toArray().map((v) => Math.round(v * 1e4) / 1e4 + 0) as Triple;
    store.setContact({ ...own, normal: rounded, normal_frame: 'world' }, 'turn the normal');
  }

  private cast(x: number, y: number, link?: number): { link: number; at: Vector3; normal: Vector3 } | undefined {
    const { origin, direction } = this.cameras.ray(x, y);
    const ray = new Raycaster(origin, direction);
    this.bodies!.group.updateMatrixWorld(true);
    const meshes = this.bodies!.pickable.filter((mesh) => link === undefined || mesh.userData.link === link);
    const found = ray.intersectObjects(meshes, false)[0];
    if (!found?.face) return undefined;
    const normal = found.face.normal.clone().transformDirection(found.object.matrixWorld);
    if (normal.dot(direction) > 0) normal.negate();
    return { link: found.object.userData.link as number, at: found.point, normal };
  }

  private up = (event: PointerEvent) => {
    const at = this.at(event);
    const isClick = this.press && Math.hypot(at.x - this.press.x, at.y - this.press.y) < SLOP;
    const drag = this.drag;
    this.drag = undefined;
    this.cameras.enable(true);
    if (drag) {
      const by = drag.what === 'point' ? store.moved(drag.name).map((x, k) => (x - drag.start[k]) * 1000) : [];
      const text = by.map((x, k) => (Math.abs(x) > 1e-6 ? `${signed(x, 1)} mm ${'xyz'[k]}` : '')).filter(Boolean).join(' ');
      // A refused position of a hardpoint is reverted.
      const label = text ? `${drag.name} ${text}` : undefined;
      if (drag.what === 'link' && isClick) {
        store.finish(false);
        this.pickAt(at.x, at.y);
      } else if (drag.what === 'point' && !drag.hadProblem) void store.finishAnswered(drag.moved, label);
      else store.finish(drag.moved, label);
    } else if (isClick && store.choosing) {
      const found = this.bodies && this.cast(at.x, at.y);
      if (found && found.link !== store.scene!.root) {
        store.choosing = false;
        this.contactAt(found.link, found.at, found.normal);
      }
    } else if (isClick && this.bodies && !this.hit(at.x, at.y, event.pointerType)) {
      this.pickAt(at.x, at.y);
    }
    this.press = undefined;
    this.invalidate();
  };

  private pickAt(x: number, y: number) {
    const found = this.cast(x, y);
    if (found) this.picked(found.link, found.at, found.normal);
    else {
      store.set({ selected: undefined });
      this.picked(undefined);
    }
  }

  private cancel = () => {
    if (!this.drag) return;
    this.drag = undefined;
    this.cameras.enable(true);
    store.finish(false);
  };

  private key = (event: KeyboardEvent) => {
    if (!this.drag) return;
    if (event.key === 'Escape') this.cancel();
    const axis = event.key.toLowerCase();
    if (axis === 'x' || axis === 'y' || axis === 'z') this.drag.held = this.drag.held === axis ? null : axis;
  };

  /** Contact at a point of the world on a link. */
  contactAt(link: number, at: Vector3, normal: Vector3) {
    const isShape = (this.shapes[link]?.length ?? 0) > 0;
    store.setContact({
      link: store.scene!.links[link].name, point: this.pointIn(link, at),
      normal: isShape ? this.normalIn(link, normal) : (normal.toArray().map((v) => Math.round(v * 1e4) / 1e4 + 0) as Triple),
      ...(isShape ? {} : { normal_frame: 'world' }),
    }, `contact on ${store.scene!.links[link].name}`);
  }

  // ---- for tests -----------------------------------------------------------------------------------------------------

  /** True if the result of the newest study is drawn. */
  isSettled(): boolean {
    return !this.pending && store.isIdle;
  }

  /** Resolves when all computations for the study are finished, including those that are omitted during a drag. */
  rested(): Promise<void> {
    return store.rested();
  }

  /** Median times of a question with its reply, and of a drawing, ms; earlier times are deleted. */
  takeTimes(): { answer: number; draw: number; count: number } {
    const median = (times: number[]) => [...times].sort((a, b) => a - b)[Math.floor(times.length / 2)] ?? 0;
    const found = { answer: median(store.times), draw: median(this.times), count: store.times.length };
    store.times.length = 0;
    this.times.length = 0;
    return found;
  }

  state() {
    const { scene, frames, problem, study, answers, ends, variation, drivers, curve } = store;
    return {
      scene, frames, study, curve, ends, variation, problem: problem?.message, memory: store.engine?.memory,
      values: Object.fromEntries(drivers.map((driver) => [driver.name, store.positionOf(driver)])),
      results: { ...answers.results, map: undefined },
    };
  }

  /** Link that a drag from this position of the page moves. */
  linkUnder(x: number, y: number): number | undefined {
    const box = this.element.getBoundingClientRect();
    const [dx, dy] = [x - box.left, y - box.top];
    return this.hit(dx, dy, 'mouse') ? undefined : this.cast(dx, dy)?.link;
  }

  /** Position of a point of a link on the screen, pixels of the page. */
  onScreen(link: string, point: Triple): { x: number; y: number } {
    const i = store.scene!.links.findIndex((l) => l.name === link);
    const box = this.element.getBoundingClientRect();
    const { x, y } = this.cameras.project(pointAt(store.frames!, i, point));
    return { x: x + box.left, y: y + box.top };
  }
}
