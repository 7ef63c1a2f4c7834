// The question: contact and pose.

import { Vector3 } from 'three';
import type { ContactTable, Triple } from '../engine/protocol';
import { SIDE, touches, withValue, givenValue, type Driver } from '../model/drivers';
import { fixed, signed, words } from '../model/numbers';
import { store } from '../model/store';
import { frame, intoLink, pointAt, vectorAt } from '../view/space';
import { NumberField, Slider } from './field';
import { useStore } from './hooks';

/** Difference below which two travels are the same for the user, m. */
const NEAR = 5e-5;
const AXES: [string, Triple][] = [
  ['+x', [1, 0, 0]], ['−x', [-1, 0, 0]], ['+y', [0, 1, 0]], ['−y', [0, -1, 0]], ['+z', [0, 0, 1]], ['−z', [0, 0, -1]],
];

/** Coordinates of a link as the page shows them: of a sheet, in its axes and at the design position; otherwise, in the frame of the link. */
function shownFrame(name: string | undefined) {
  const { scene, axes } = store;
  const link = scene!.links.findIndex((l) => l.name === name);
  const turned = (p: Vector3): Triple => p.toArray().map((x, k) => Math.round(x * axes[k] * 1e7) / 1e7 + 0) as Triple;
  const world = (p: Triple) => new Vector3(...p.map((x, k) => x * axes[k]));
  if (!scene!.sheet || link < 0) return { words: 'frame of the link', point: (p: Triple) => p, toPoint: (p: Triple) => p, normal: (n: Triple) => n, toNormal: (n: Triple) => n };
  const rounded = (p: Vector3) => p.toArray().map((x) => Math.round(x * 1e7) / 1e7 + 0) as Triple;
  return {
    words: 'axes of the sheet, as drawn',
    point: (p: Triple) => turned(pointAt(scene!.design, link, p)),
    toPoint: (p: Triple) => rounded(world(p).applyMatrix4(frame(scene!.design, link).invert())),
    normal: (n: Triple) => turned(vectorAt(scene!.design, link, n)),
    toNormal: (n: Triple) => rounded(intoLink(scene!.design, link, world(n))),
  };
}

/** Three fields of a point, mm. */
function PointFields({ label, link, point, set }: { label: string; link: string | undefined; point: Triple; set(point: Triple): void }) {
  const own = shownFrame(link);
  const shown = own.point(point);
  return (
    <>
      {[0, 1, 2].map((k) => (
        <NumberField key={k} label={`${label} ${'xyz'[k]}, mm, ${own.words}`} value={shown[k] * 1000} decimals={1} step={1} title={own.words}
          set={(x) => set(own.toPoint(shown.map((p, i) => (i === k ? Math.round(x * 1e4) / 1e7 : p)) as Triple))} />
      ))}
    </>
  );
}

/** Point and direction of a contact that the model does not name. */
export function ContactPanel() {
  const { scene, study } = useStore();
  if (!scene || !study || study.contact.at) return null;
  return <section><h2>Contact</h2><OwnContact contact={study.contact} /></section>;
}

function OwnContact({ contact }: { contact: ContactTable }) {
  const { scene, posed } = store;
  const links = scene!.links.map((l) => l.name);
  const set = (values: Partial<ContactTable>, label: string) => store.setContact({ ...contact, ...values }, label);
  const point = contact.point ?? [0, 0, 0];
  const normal = contact.normal ?? posed?.report.contact.normal_link ?? [0, 0, 1];
  const isWorld = contact.normal_frame === 'world';
  const own = shownFrame(contact.link);
  /** Direction between the axes of the world and those of the sheet. */
  const turned = (n: Triple) => n.map((x, k) => x * store.axes[k] + 0) as Triple;
  const shownNormal = isWorld ? turned(normal) : own.normal(normal);
  const line = contact.along_line;
  // The other side of a cable is the link of its end.
  const other = contact.against ?? (contact.cable && line ? line.link : '');
  const direction = !line ? 'normal' : contact.cable ? 'cable' : contact.turning_normal ? 'turning' : 'line';
  const direct = (kind: string) => {
    const rest = { ...contact };
    for (const key of ['normal', 'normal_frame', 'along_line', 'turning_normal', 'cable']) delete rest[key];
    if (kind === 'normal') store.setContact({ ...rest, normal: posed?.report.contact.normal_link ?? [0, 0, 1] }, 'contact along a normal');
    else {
      const far = line ?? farEnd(contact);
      store.setContact({ ...rest, along_line: far, ...(kind === 'cable' ? { cable: true } : kind === 'turning' ? { turning_normal: true } : {}) }, `contact along ${kind === 'cable' ? 'a cable' : 'a line'}`);
    }
  };
  return (
    <>
      <label class="line"><span>link</span>
        <select value={contact.link} onChange={(event) => set({ link: event.currentTarget.value }, `contact on ${event.currentTarget.value}`)}>
          {links.map((name) => <option key={name}>{name}</option>)}
        </select>
      </label>
      <div class="line"><span>point, mm</span>
        <PointFields label="point" link={contact.link} point={point} set={(to) => set({ point: to }, 'contact point')} />
      </div>
      <label class="line"><span>direction</span>
        <select value={direction} onChange={(event) => direct(event.currentTarget.value)}>
          <option value="normal">normal</option>
          <option value="line">line to a point, of a stop</option>
          <option value="turning">line to a point, of a spring</option>
          <option value="cable">cable to a point</option>
        </select>
      </label>
      {line ? (
        <>
          <label class="line"><span>to link</span>
            <select value={line.link} onChange={(event) => set({ along_line: { ...line, link: event.currentTarget.value } }, 'end of the line')}>
              {links.filter((name) => name !== contact.link).map((name) => <option key={name}>{name}</option>)}
            </select>
          </label>
          <div class="line"><span>to point, mm</span>
            <PointFields label="end of the line" link={line.link} point={line.point} set={(to) => set({ along_line: { ...line, point: to } }, 'end of the line')} />
          </div>
        </>
      ) : (
        <>
          <div class="line"><span>normal{scene!.sheet ? '' : isWorld ? ', world' : ', link'}</span>
            {[0, 1, 2].map((k) => (
              <NumberField key={k} label={`normal ${'xyz'[k]}`} value={shownNormal[k]} decimals={3} step={0.01}
                title={scene!.sheet ? `axes of the sheet, ${isWorld ? 'at the pose shown' : 'as drawn'}` : undefined}
                set={(x) => {
                  const to = shownNormal.map((n, i) => (i === k ? x : n)) as Triple;
                  if (Math.hypot(...to) > 0) set({ normal: isWorld ? turned(to) : own.toNormal(to) }, 'contact normal');
                }} />
            ))}
          </div>
          <div class="line"><span>along</span>
            <span class="axes" role="group" aria-label={`Normal along an axis of the ${scene!.sheet ? 'sheet' : 'world'}`}>
              {AXES.map(([name, axis]) => (
                <button key={name} aria-pressed={isWorld && axis.every((x, k) => x === shownNormal[k])}
                  onClick={() => set({ normal: turned(axis), normal_frame: 'world' }, `normal ${name}`)}>{name}</button>
              ))}
            </span>
          </div>
        </>
      )}
      <label class="line"><span>against</span>
        <select value={other} onChange={(event) => set({ against: event.currentTarget.value || undefined }, 'other side')}>
          <option value="">ground</option>
          {links.filter((name) => name !== contact.link).map((name) => <option key={name}>{name}</option>)}
        </select>
      </label>
    </>
  );
}

/** Point of the other side on the normal of the contact shown, at a distance that is easy to see: the first end of a line. */
function farEnd(contact: ContactTable): { link: string; point: Triple } {
  const { scene, frames, posed } = store;
  const against = scene!.links.findIndex((l) => l.name === contact.against);
  const link = against >= 0 ? against : scene!.root;
  const { point_world: p, normal_world: n } = posed!.report.contact;
  const size = Math.hypot(...p) || 1;
  const to = new Vector3(...p).addScaledVector(new Vector3(...n), 0.3 * size).applyMatrix4(frame(frames!, link).invert());
  return { link: scene!.links[link].name, point: to.toArray().map((x) => Math.round(x * 1e3) / 1e3 + 0) as Triple };
}

/** List of the named poses of the model, such as keyframes; the drivers start from the selected pose. */
function NamedPose() {
  const { study, opened } = store;
  if (!opened!.poses?.length) return null;
  const { file, set, travel, ...pose } = study!.pose;
  void set;
  void travel;
  return (
    <label class="line"><span>pose</span>
      <select value={file ?? ''} onChange={(event) => {
        const name = event.currentTarget.value;
        store.change({ ...study!, pose: name ? { ...pose, file: name } : pose }, name ? `pose ${name}` : 'design position');
      }}>
        <option value="">all joints at 0</option>
        {opened!.poses.map((name) => <option key={name} value={name}>{name}</option>)}
      </select>
    </label>
  );
}

export function PosePanel() {
  const { drivers, study, scene } = useStore();
  if (!study || !scene) return null;
  const named = scene.contacts.find((c) => c.name === study.contact.at);
  const given = drivers.filter((driver) => givenValue(study, driver) !== undefined);
  const wheels = drivers[0]?.isMotion ? drivers[0] : undefined;
  return (
    <section>
      <h2>Pose</h2>
      <NamedPose />
      {drivers.length ? drivers.map((driver) => <DriverLine key={driver.name} driver={driver} />) : <p class="soft">No joint with a single position can be set.</p>}
      {wheels ? <Snaps wheels={wheels} stop={named?.kind === 'stop' ? named.name.replace(SIDE, '') : undefined} /> : given.length ? (
        <p class="row"><button onClick={() => store.change({ ...study, pose: { ...study.pose, set: {}, travel: [] } }, 'design position')}>
          {study.pose.file ? `Pose ${study.pose.file}` : 'Design position'}
        </button></p>
      ) : null}
    </section>
  );
}

/** Buttons to the design position and to the touches. `stop`: the chosen stop, which touches without a given travel. */
function Snaps({ wheels, stop }: { wheels: Driver; stop: string | undefined }) {
  const { study, contacts } = store;
  const now = store.positionOf(wheels);
  const all = [{ name: 'design position', travel: 0 }, ...touches(contacts)].sort((a, b) => a.travel - b.travel);
  return (
    <p class="row">{all.map(({ name, travel }) => {
      const to = name === stop ? { ...study!, pose: { ...study!.pose, travel: [] } } : withValue(study!, wheels, travel);
      return (
        <button key={name} aria-pressed={Math.abs(now - travel) < NEAR} onClick={() => store.change(to, name === 'design position' ? name : `touch of the ${words(name)}`)}>
          {words(name)} {signed(travel * 1000, 1)}
        </button>
      );
    })}</p>
  );
}

function DriverLine({ driver }: { driver: Driver }) {
  const { study } = store;
  const { unit } = driver;
  const value = store.positionOf(driver);
  const set = (x: number) => store.change(withValue(study!, driver, x), driver.label);
  const shown = value * unit.perSi;
  return (
    <div class="driver">
      <span class="name" title={driver.label}>{driver.label}</span>
      <Slider label={driver.label} value={shown} range={[driver.range[0] * unit.perSi, driver.range[1] * unit.perSi]} step={unit.step}
        text={`${fixed(shown, 1)} ${unit.name}`} set={(x) => set(x / unit.perSi)} />
      <NumberField label={`${driver.label}, ${unit.name}`} value={shown} decimals={unit.decimals} step={unit.step} set={(x) => set(x / unit.perSi)} />
      <span class="unit">{unit.name}</span>
    </div>
  );
}
