// The question: contact and pose.

import { Vector3 } from 'three';
import type { ContactTable, MassReport, Triple } from '../engine/protocol';
import { withValue, givenValue, type Driver } from '../model/drivers';
import { fixed, mass } from '../model/numbers';
import { store } from '../model/store';
import { frame } from '../view/space';
import { NumberField, Slider } from './field';
import { useStore } from './hooks';

const OWN = '\u0000own';
const KINDS = [['stop', 'Stops'], ['spring', 'Springs'], ['damper', 'Dampers'], ['patch', 'Contact patches'], ['other', 'Others']] as const;

/** Result of a named contact when the model was opened. */
function openedValue(report: MassReport | null | undefined): string {
  if (!report) return '';
  return report.status === 'finite' ? `, ${mass(report.effective_mass!, report.effective_mass_error)} ${report.unit}` : `, ${report.status}`;
}

const AXES: [string, Triple][] = [
  ['+x', [1, 0, 0]], ['−x', [-1, 0, 0]], ['+y', [0, 1, 0]], ['−y', [0, -1, 0]], ['+z', [0, 0, 1]], ['−z', [0, 0, -1]],
];

export function ContactPanel() {
  const { scene, study, opened } = useStore();
  if (!scene || !study || !opened) return null;
  const { contact } = study;
  const listed = new Map(opened.contacts?.contacts.map((c) => [c.name, c]) ?? []);
  const choose = (name: string) => {
    if (name === OWN) {
      const own = store.ownContact();
      if (own) store.setContact(own, 'own contact');
      return;
    }
    const { travel, ...pose } = study.pose;
    void travel;
    store.change({ ...study, contact: { at: name }, pose }, `contact ${name}`);
  };
  return (
    <section>
      <h2>Contact</h2>
      {scene.contacts.length ? (
        <label class="line"><span>at</span>
          <select value={contact.at ?? OWN} onChange={(event) => choose(event.currentTarget.value)}>
            {KINDS.map(([kind, label]) => {
              const all = scene.contacts.filter((c) => c.kind === kind);
              return all.length ? (
                <optgroup key={kind} label={label}>
                  {all.map(({ name }) => <option key={name} value={name}>{name}{openedValue(listed.get(name)?.report)}</option>)}
                </optgroup>
              ) : null;
            })}
            <option value={OWN}>another point and normal</option>
          </select>
        </label>
      ) : null}
      {contact.at ? <p class="soft">To define another contact, drag the point or the head of the arrow, or click a link.</p> : <OwnContact contact={contact} />}
    </section>
  );
}

function OwnContact({ contact }: { contact: ContactTable }) {
  const { scene, posed } = store;
  const links = scene!.links.map((l) => l.name);
  const set = (values: Partial<ContactTable>, label: string) => store.setContact({ ...contact, ...values }, label);
  const point = contact.point ?? [0, 0, 0];
  const normal = contact.normal ?? posed?.report.contact.normal_link ?? [0, 0, 1];
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
        {[0, 1, 2].map((k) => (
          <NumberField key={k} label={`point ${'xyz'[k]}, mm, frame of the link`} value={point[k] * 1000} decimals={1} step={1}
            set={(x) => set({ point: point.map((p, i) => (i === k ? Math.round(x * 1e4) / 1e7 : p)) as Triple }, 'contact point')} />
        ))}
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
            {[0, 1, 2].map((k) => (
              <NumberField key={k} label={`end of the line ${'xyz'[k]}, mm, frame of its link`} value={line.point[k] * 1000} decimals={1} step={1}
                set={(x) => set({ along_line: { ...line, point: line.point.map((p, i) => (i === k ? Math.round(x * 1e4) / 1e7 : p)) as Triple } }, 'end of the line')} />
            ))}
          </div>
        </>
      ) : (
        <>
          <div class="line"><span>normal{contact.normal_frame === 'world' ? ', world' : ', link'}</span>
            {[0, 1, 2].map((k) => (
              <NumberField key={k} label={`normal ${'xyz'[k]}`} value={normal[k]} decimals={3} step={0.01}
                set={(x) => {
                  const to = normal.map((n, i) => (i === k ? x : n)) as Triple;
                  if (Math.hypot(...to) > 0) set({ normal: to }, 'contact normal');
                }} />
            ))}
          </div>
          <div class="line"><span>along</span>
            <span class="axes" role="group" aria-label="Normal along an axis of the world">
              {AXES.map(([name, axis]) => (
                <button key={name} aria-pressed={contact.normal_frame === 'world' && axis.every((x, k) => x === normal[k])}
                  onClick={() => set({ normal: axis, normal_frame: 'world' }, `normal ${name}`)}>{name}</button>
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
  const isStop = named?.kind === 'stop';
  const given = drivers.filter((driver) => givenValue(study, driver) !== undefined);
  return (
    <section>
      <h2>Pose</h2>
      <NamedPose />
      {drivers.length ? drivers.map((driver) => <DriverLine key={driver.name} driver={driver} />) : <p class="soft">No joint with a single position can be set.</p>}
      <p class="row">
        {given.length ? (
          <button onClick={() => store.change({ ...study, pose: { ...study.pose, set: {}, travel: [] } }, isStop ? 'to the touch' : 'design position')}>
            {isStop && drivers.some((d) => d.isMotion) ? 'Bring the stop to the touch' : study.pose.file ? `Pose ${study.pose.file}` : 'Design position'}
          </button>
        ) : isStop ? <span class="soft">The stop is at touch. Move the slider for another travel.</span> : null}
      </p>
    </section>
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
