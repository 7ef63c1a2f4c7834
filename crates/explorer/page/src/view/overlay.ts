// Marks above the bodies, as SVG: hardpoints, contact arrow with its value, labels, axes, scale; and the bodies as lines in a
// browser without WebGL.

import { Vector3 } from 'three';
import type { Cameras } from './cameras';

const NS = 'http://www.w3.org/2000/svg';

export function element<K extends keyof SVGElementTagNameMap>(
  name: K, attributes: Record<string, string | number>, parent?: Element,
): SVGElementTagNameMap[K] {
  const made = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  parent?.append(made);
  return made;
}

/** Children of a group, as many as asked for: a drawing changes them, which is faster than new ones. */
function reuse<K extends keyof SVGElementTagNameMap>(group: SVGGElement, name: K, count: number): SVGElementTagNameMap[K][] {
  while (group.children.length > count) group.lastChild!.remove();
  while (group.children.length < count) element(name, {}, group);
  return [...group.children] as SVGElementTagNameMap[K][];
}

export interface Mark { name: string; at: Vector3; isMoved: boolean }
/** `reach`: nearest drawn point of the contact link; `far`: other end of its line or cable. */
export interface ContactMark { point: Vector3; normal: Vector3; reach?: Vector3; far?: Vector3; label: string; isStale: boolean }

/** Line in a browser without WebGL. */
export interface Wire { points: Vector3[]; colour: string; isThin: boolean }

/** In a view below this width, the buttons are in a row at the bottom of this height, pixels. */
const NARROW = 600;
const BUTTONS = 48;
/** Distance of a name from its point, and height of a line of text, pixels. */
const NAME_GAP = 10;
const NAME_HEIGHT = 15;
/** Places of a name in the order of preference: side of its point, and lines below it. */
const NAME_PLACES = [[1, 0], [-1, 0], [1, -1], [1, 1], [-1, -1], [-1, 1]];
const ARROW = 74;
const HEAD = 15;
/** A label of a scale: lengths of bars, m. */
const BARS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

export class Overlay {
  readonly svg: SVGSVGElement;
  private wires: SVGGElement;
  private points: SVGGElement;
  private motion: SVGGElement;
  private directions: SVGGElement;
  private impulses: SVGGElement;
  private contact: SVGGElement;
  private label: SVGGElement;
  private names: SVGGElement;
  private axes: SVGGElement;
  private scale: SVGGElement;
  /** Size of the view, pixels: reading it from the page would compute the layout once more for each drawing. */
  private width = 1;
  private height = 1;
  /** Lower end of the part without buttons. */
  private bottom = 1;
  /** View of the axes drawn. */
  private drawnAxes = '';

  constructor(parent: HTMLElement) {
    this.svg = element('svg', { class: 'overlay', 'aria-hidden': 'true' });
    parent.append(this.svg);
    const group = (name: string) => element('g', { class: name }, this.svg);
    this.wires = group('wires');
    this.motion = group('motion');
    this.directions = group('directions');
    this.impulses = group('impulses');
    this.points = group('points');
    this.names = group('names');
    this.contact = group('contact');
    this.label = group('label');
    this.axes = group('axes');
    this.scale = group('scale');
  }

  resize(width: number, height: number) {
    this.width = width;
    this.height = height;
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    this.bottom = height - (width < NARROW ? BUTTONS : 0);
  }

  drawWires(cameras: Cameras, wires: Wire[]) {
    const lines = reuse(this.wires, 'path', wires.length);
    wires.forEach(({ points, colour, isThin }, i) => {
      const path = points.map((point) => {
        const { x, y } = cameras.project(point);
        return `${x.toFixed(1)} ${y.toFixed(1)}`;
      });
      lines[i].setAttribute('d', `M${path.join('L')}`);
      lines[i].setAttribute('class', isThin ? 'thin' : '');
      lines[i].style.stroke = colour;
    });
  }

  drawPoints(cameras: Cameras, marks: Mark[], selected: string | undefined) {
    const circles = reuse(this.points, 'circle', marks.length);
    marks.forEach((mark, i) => {
      const circle = circles[i];
      circle.setAttribute('r', '5');
      const { x, y, visible } = cameras.project(mark.at);
      circle.setAttribute('cx', x.toFixed(1));
      circle.setAttribute('cy', y.toFixed(1));
      circle.setAttribute('class', `${mark.isMoved ? 'moved' : ''} ${mark.name === selected ? 'selected' : ''} ${visible ? '' : 'hidden'}`);
      circle.dataset.point = mark.name;
    });
  }

  /** Names at points, the first before the later ones; a name that would cover another one is left out. */
  drawNames(cameras: Cameras, names: { at: Vector3; text: string }[]) {
    const taken: [number, number, number][] = [];
    const shown = names.flatMap(({ at, text }) => {
      const point = cameras.project(at);
      const width = 6.6 * text.length;
      const places = NAME_PLACES.map(([side, lines]) => [point.x + (side > 0 ? NAME_GAP : -NAME_GAP - width), point.y + lines * NAME_HEIGHT]);
      const free = places.find(([x, y]) => x > 0 && x + width < this.width && !taken.some(([left, right, height]) => x < right && x + width > left && Math.abs(y - height) < NAME_HEIGHT));
      if (!point.visible || !free) return [];
      const [x, y] = free;
      taken.push([x, x + width, y]);
      return [{ x, y, text }];
    });
    const texts = reuse(this.names, 'text', shown.length);
    shown.forEach(({ x, y, text }, i) => {
      texts[i].setAttribute('x', x.toFixed(1));
      texts[i].setAttribute('y', (y + 4).toFixed(1));
      if (texts[i].textContent !== text) texts[i].textContent = text;
    });
  }

  drawMotion(cameras: Cameras, arrows: { at: Vector3; by: Vector3 }[]) {
    this.motion.replaceChildren(...arrows.flatMap(({ at, by }) => {
      const [a, b] = [cameras.project(at), cameras.project(at.clone().add(by))];
      return this.arrow(a.x, a.y, b.x, b.y, 8);
    }));
  }

  /** Arrows with a name for a pointer that rests on them. */
  drawImpulses(cameras: Cameras, arrows: { at: Vector3; by: Vector3; title: string }[]) {
    this.impulses.replaceChildren(...arrows.map(({ at, by, title }) => {
      const [a, b] = [cameras.project(at), cameras.project(at.clone().add(by))];
      const group = element('g', { 'data-impulse': title });
      element('title', {}, group).textContent = title;
      group.append(...this.arrow(a.x, a.y, b.x, b.y, 10));
      return group;
    }));
  }

  /** Ellipsoid by its three principal sections, and its half axes with labels. */
  drawDirections(cameras: Cameras, centre: Vector3, axes: { half: Vector3; label: string; isBounded: boolean }[]) {
    const parts: SVGElement[] = [];
    axes.forEach(({ half, label, isBounded }, i) => {
      const next = axes[(i + 1) % axes.length];
      if (isBounded && next.isBounded) {
        const section = Array.from({ length: 49 }, (_, k) => {
          const turn = (2 * Math.PI * k) / 48;
          const at = centre.clone().addScaledVector(half, Math.cos(turn)).addScaledVector(next.half, Math.sin(turn));
          const { x, y } = cameras.project(at);
          return `${x.toFixed(1)} ${y.toFixed(1)}`;
        });
        parts.push(element('path', { d: `M${section.join('L')}Z` }));
      }
      const [a, b] = [-1, 1].map((sign) => cameras.project(centre.clone().addScaledVector(half, sign)));
      parts.push(element('line', { x1: a.x, y1: a.y, x2: b.x, y2: b.y, class: isBounded ? '' : 'open' }));
      const text = element('text', { x: b.x + 4, y: b.y - 4 });
      text.textContent = label;
      parts.push(text);
    });
    this.directions.replaceChildren(...parts);
  }

  private arrow(x1: number, y1: number, x2: number, y2: number, head: number): SVGElement[] {
    const length = Math.hypot(x2 - x1, y2 - y1);
    if (length < 2) return [];
    const size = Math.min(head, length / 2);
    const [ux, uy] = [(x2 - x1) / length, (y2 - y1) / length];
    const [bx, by] = [x2 - size * ux, y2 - size * uy];
    const w = 0.38 * size;
    return [
      element('line', { x1, y1, x2: bx, y2: by }),
      element('polygon', { points: `${x2},${y2} ${bx - w * uy},${by + w * ux} ${bx + w * uy},${by - w * ux}` }),
    ];
  }

  /** Contact point, normal and value. Returns the position of the tip. */
  drawContact(cameras: Cameras, mark: ContactMark | undefined): Vector3 | undefined {
    if (!mark) {
      this.contact.replaceChildren();
      return undefined;
    }
    const tip = mark.point.clone().addScaledVector(mark.normal, ARROW * cameras.pixel(mark.point));
    const [a, b] = [cameras.project(mark.point), cameras.project(tip)];
    const facing = Math.hypot(b.x - a.x, b.y - a.y) < 12;
    const parts: SVGElement[] = facing
      ? [element('circle', { cx: a.x, cy: a.y, r: 11, class: 'facing' })]
      : this.arrow(a.x, a.y, b.x, b.y, HEAD);
    const dot = element('circle', { cx: a.x, cy: a.y, r: 5.5, class: 'dot' });
    const grip = element('circle', { cx: a.x, cy: a.y, r: 11, class: 'grip', 'data-contact': 'point' });
    const head = element('circle', { cx: b.x, cy: b.y, r: 11, class: 'grip', 'data-contact': 'normal' });
    const width = 8.2 * mark.label.length + 18;
    const { width: all, height } = this;
    // The label is beyond the tip, inside of the view, and off the buttons.
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    const [ux, uy] = facing || length === 0 ? [1, -0.6] : [(b.x - a.x) / length, (b.y - a.y) / length];
    const x = Math.min(Math.max(b.x + ux * (width / 2 + 14) - width / 2, 6), all - width - 6);
    const y = Math.min(Math.max(b.y + uy * 28 - 13, 48), height - 60);
    const base = mark.reach && cameras.project(mark.reach);
    if (base && Math.hypot(base.x - a.x, base.y - a.y) > 3) {
      parts.unshift(element('line', { x1: base.x, y1: base.y, x2: a.x, y2: a.y, class: 'reach' }));
    }
    if (mark.far) {
      const end = cameras.project(mark.far);
      parts.unshift(element('line', { x1: end.x, y1: end.y, x2: a.x, y2: a.y, class: 'rope' }), element('circle', { cx: end.x, cy: end.y, r: 3.5, class: 'dot' }));
    }
    const chip = element('g', { transform: `translate(${x.toFixed(1)},${y.toFixed(1)})`, class: 'chip' });
    element('rect', { width: width.toFixed(0), height: 26, rx: 5 }, chip);
    element('text', { x: (width / 2).toFixed(1), y: 18, 'text-anchor': 'middle' }, chip).textContent = mark.label;
    this.contact.setAttribute('class', `contact ${mark.isStale ? 'stale' : ''}`);
    this.contact.replaceChildren(...parts, dot, ...(facing ? [grip] : [head, grip]), chip);
    return tip;
  }

  /** Name at a position; with a line to the previous position of a dragged point. */
  drawLabel(text: string | undefined, x = 0, y = 0, bad?: { x: number; y: number }) {
    if (!text) {
      this.label.replaceChildren();
      return;
    }
    const width = 7.1 * text.length + 14;
    const all = this.width;
    const left = Math.min(Math.max(x + 12, 4), Math.max(4, all - width - 4));
    const top = Math.max(y - 30, 4);
    const parts: SVGElement[] = bad ? [element('line', { x1: x, y1: y, x2: bad.x, y2: bad.y, class: 'bad' })] : [];
    const group = element('g', { transform: `translate(${left.toFixed(1)},${top.toFixed(1)})` });
    element('rect', { width: width.toFixed(0), height: 22, rx: 4 }, group);
    element('text', { x: 7, y: 15.5 }, group).textContent = text;
    this.label.replaceChildren(...parts, group);
  }

  /** Directions of the axes, which change only with the camera. `signs`: directions along the axes of the world. */
  drawAxes(cameras: Cameras, signs: readonly number[]) {
    const { bottom } = this;
    const [cx, cy] = [44, bottom - 76];
    const turn = cameras.camera.matrixWorldInverse;
    const key = `${bottom} ${signs.join()} ${turn.elements.slice(0, 11).join()}`;
    if (key === this.drawnAxes) return;
    this.drawnAxes = key;
    const parts = (['x', 'y', 'z'] as const).flatMap((name, i) => {
      const v = new Vector3(...[0, 1, 2].map((k) => (k === i ? signs[i] : 0))).transformDirection(turn);
      if (Math.hypot(v.x, v.y) < 0.15) return [];
      const [x, y] = [cx + 26 * v.x, cy - 26 * v.y];
      const text = element('text', { x: cx + 36 * v.x, y: cy - 36 * v.y + 4, 'text-anchor': 'middle' });
      text.textContent = name;
      return [...this.arrow(cx, cy, x, y, 7), text];
    });
    this.axes.replaceChildren(...parts);
  }

  /** Bar of a round length, for the parallel views. */
  drawScale(cameras: Cameras, centre: Vector3, shown: boolean) {
    if (!shown) {
      this.scale.replaceChildren();
      return;
    }
    const { width, bottom } = this;
    const pixel = cameras.pixel(centre);
    const length = BARS.find((l) => l / pixel > 60) ?? BARS.at(-1)!;
    const w = length / pixel;
    const [x, y] = [width - w - 18, bottom - 24];
    const text = element('text', { x: x + w / 2, y: y - 7, 'text-anchor': 'middle' });
    text.textContent = length < 1 ? `${length * 1000} mm` : `${length} m`;
    this.scale.replaceChildren(element('path', { d: `M${x} ${y - 4}v8M${x} ${y}h${w}M${x + w} ${y - 4}v8` }), text);
  }
}
