// The same question elsewhere: command, study, Python. All three come from the tables of the study.

import type { Study } from '../engine/protocol';
import type { Settings } from './answers';
import { plain } from './numbers';

const quote = (text: string) => (/^[A-Za-z0-9_\-+.,:=/%@]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
const triple = (values: readonly number[]) => values.map(plain).join(',');

type Flag = [string, string?];

/** List of flags, and a function that adds a flag if its value is given. */
function list() {
  const out: Flag[] = [];
  const one = (flag: string, value: string | number | undefined) => {
    if (value !== undefined && value !== '') out.push([flag, String(value)]);
  };
  return { out, one };
}

function modelFlags({ model }: Study): Flag[] {
  const { out, one } = list();
  for (const [point, by] of Object.entries(model.move ?? {})) one('--move', `${point}=${triple(by)}`);
  for (const [link, mass] of Object.entries(model.link_mass ?? {})) one('--link-mass', `${link}=${plain(mass)}`);
  for (const [link, moments] of Object.entries(model.link_inertia ?? {})) one('--link-inertia', `${link}=${triple(moments)}`);
  for (const [link, com] of Object.entries((model.link_com ?? {}) as Record<string, number[]>)) one('--link-com', `${link}=${triple(com)}`);
  return out;
}

function contactFlags({ contact }: Study): Flag[] {
  const { out, one } = list();
  one('--at', contact.at);
  one('--link', contact.link);
  if (contact.point) one('--point', triple(contact.point));
  if (contact.normal) one('--normal', triple(contact.normal));
  if (contact.along_line) one('--along-line', `${contact.along_line.link}:${triple(contact.along_line.point)}`);
  if (contact.turning_normal) out.push(['--turning-normal']);
  if (contact.cable) out.push(['--cable']);
  one('--frame', contact.frame);
  one('--normal-frame', contact.normal_frame);
  one('--against', contact.against);
  one('--against-mass', contact.against_mass);
  return out;
}

function poseFlags({ pose, conditions, hold }: Study): Flag[] {
  const { out, one } = list();
  one('--pose', pose.file);
  for (const [joint, value] of Object.entries(pose.set ?? {})) one('--set', `${joint}=${value}`);
  for (const [joint, value] of Object.entries(pose.guess ?? {})) one('--guess', `${joint}=${value}`);
  for (const travel of pose.travel ?? []) {
    const motion = /^(wheel-travel|heave|roll)=(.*)$/.exec(travel);
    if (motion) one(`--${motion[1]}`, motion[2]);
    else one('--travel', travel);
  }
  for (const joint of conditions.lock ?? []) one('--lock', joint);
  for (const [joint, values] of Object.entries(conditions.armature ?? {})) one('--armature', `${joint}=${[values].flat().map(plain).join(',')}`);
  for (const [joint, values] of Object.entries(conditions.gear_stiffness ?? {})) one('--gear-stiffness', `${joint}=${[values].flat().map((x) => typeof x === 'number' ? plain(x) : x).join(',')}`);
  one('--base', conditions.base);
  for (const h of (hold ?? []) as { link: string; point: number[]; normal?: number[] }[]) {
    one('--hold', `${h.link}:${triple(h.point)}${h.normal ? `:${triple(h.normal)}` : ''}`);
  }
  return out;
}

/** Command on a model. A value may begin with a minus, so it is joined to its flag. */
function commandText(name: string, study: Study, flags: Flag[]): string {
  const parts = flags.map(([flag, value]) => (value === undefined ? flag : `${flag}=${quote(value)}`));
  return [`percuss ${name} ${quote(study.model.path)}`, ...parts].join(' \\\n    ');
}

/** Command that prints the number shown. */
export function command(study: Study): string {
  return commandText('mass', study, [...modelFlags(study), ...contactFlags(study), ...poseFlags(study)]);
}

/** Command with the numbers of the damper, the impact or the safe speed. */
export function commandOf(kind: 'damper' | 'impact' | 'safe', study: Study, s: Settings): string {
  const question = [...modelFlags(study), ...contactFlags(study), ...poseFlags(study)];
  const { out, one } = list();
  switch (kind) {
    case 'damper':
      one('--limit', s.stop);
      one('--restitution', s.restitution.trim());
      one('--stiffness', s.stiffness.trim());
      one('--speed', s.speed.trim());
      one('--law', s.law);
      one('--for', s.tool);
      for (const [name, value] of Object.entries(s.further)) one(`--${name.replaceAll('_', '-')}`, String(value));
      return commandText('damp --mass-from', study, [...(s.stop ? [...modelFlags(study), ...poseFlags(study)] : question), ...out]);
    case 'impact':
      one('--restitution', s.impactRestitution.trim());
      one('--speed', s.impactSpeed.trim() || '1 m/s');
      one('--stiffness', s.impactStiffness.trim());
      if (s.impactInTime) out.push(['--in-time']);
      return commandText('impact', study, [...question, ...out]);
    case 'safe':
      one('--region', s.region);
      one(`--${s.limit}`, s.limitValue.trim());
      if (s.limit === 'pressure') one('--area', s.area.trim());
      one('--load', s.load.trim());
      return commandText('safe-speed', study, [...question, ...out]);
  }
}

/** Command with the kinematics of the wheels: values of the motions, m. */
export function kinematicsCommand(study: Study, state: Record<string, number>): string {
  const values = Object.entries(state).map(([name, value]): Flag => [`--${name}`, plain(value)]);
  return commandText('kinematics', study, [...modelFlags(study), ...values]);
}

const toml = (value: unknown): string => {
  if (Array.isArray(value)) return `[${value.map(toml).join(', ')}]`;
  if (typeof value === 'number') return plain(value);
  if (typeof value === 'object' && value !== null) {
    return `{ ${Object.entries(value).map(([k, v]) => `${key(k)} = ${toml(v)}`).join(', ')} }`;
  }
  return JSON.stringify(value);
};
const key = (name: string) => (/^[A-Za-z0-9_-]+$/.test(name) ? name : JSON.stringify(name));

function section(head: string, entries: object): string {
  const lines = Object.entries(entries).filter(([, v]) => {
    if (v === undefined || v === null || v === false) return false;
    return !(typeof v === 'object' && Object.keys(v).length === 0);
  });
  return lines.length ? `${head}\n${lines.map(([k, v]) => `${key(k)} = ${toml(v)}`).join('\n')}\n` : '';
}

/** Study file in TOML; `vary`: range of the curve. */
export function studyText(study: Study, vary: string | undefined): string {
  return [
    section('[model]', study.model),
    section('[contact]', study.contact),
    section('[pose]', study.pose),
    section('[conditions]', study.conditions),
    ...(study.hold ?? []).map((h) => section('[[hold]]', h)),
    vary ? section('[sweep]', { vary, output: 'curve.csv' }) : '',
  ].filter(Boolean).join('\n');
}

/** Python statements that write the study and run it. */
export function pythonText(study: Study): string {
  return [
    'import pathlib, percuss',
    `pathlib.Path("study.toml").write_text("""${studyText(study, undefined).replaceAll('\\', '\\\\')}""")`,
    'report = percuss.run_study("study.toml")',
    'print(report["effective_mass"])',
  ].join('\n');
}
