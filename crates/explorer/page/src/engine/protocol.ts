// Replies of the engine. Lengths in m, angles in rad, masses in kg; frames are 12 numbers a link: the rows of the rotation,
// then the position.

export type Triple = [number, number, number];

export interface SceneLink {
  name: string; mass: number; com: Triple | null; lines: [Triple, Triple][];
  /** Moments of inertia about the centre of mass, kg·m². */
  moments: Triple | null;
}
export interface SceneJoint {
  name: string; kind: string; parent: number; child: number; axis: Triple | null;
  limits: [number, number] | null; can_be_set: boolean;
}
export interface SceneContact {
  name: string; kind: 'stop' | 'spring' | 'damper' | 'patch' | 'other'; link: number; point: Triple;
  against: number | null; normal: 'fixed' | 'toward' | 'away'; vector: Triple; gap: number | null;
}
export interface SceneHardpoint { name: string; coordinates: Triple; to_world: Triple; link: number; point: Triple }
export interface SceneSheet { unit: string; unit_length: number; axes: string; hardpoints: SceneHardpoint[] }
export interface Scene {
  percuss: string; name: string; root: number; links: SceneLink[]; joints: SceneJoint[];
  closures: { name: string; kind: string; ends: [[number | null, Triple], [number | null, Triple]] }[];
  contacts: SceneContact[]; wheels: { link: number; centre: Triple; axis: Triple; radius: number }[];
  motions: string[]; sheet: SceneSheet | null; design: number[];
}

export interface Finding {
  severity: 'error' | 'warning' | 'note'; code: string; path: string | null; line: number | null; message: string;
}
export interface Share { share: number | null }
export interface MassReport {
  /** kg; kg·m² for the stop of a joint that turns. */
  unit: string;
  effective_mass: number | null; status: 'finite' | 'immovable' | 'massless'; singular_pose: boolean;
  degrees_of_freedom: number; effective_mass_error: number | null;
  error_budget: { rounding: number | null; closing: number | null; file: number | null };
  bodies: (Share & { link: string })[]; rotors: (Share & { joint: string })[];
  pose: Record<string, number[]>; closure_residual: number | null; route: string; condition: number | null;
  contact: {
    link: string; against: string | null; point_world: Triple; normal_world: Triple; point_link: Triple; normal_link: Triple;
  };
  named_contact: {
    name: string; kind: string; gap_as_drawn: number | null; gap: number | null; brought_to_touch: boolean;
    touching: string[]; wheel_travel: { link: string; travel: number }[];
  } | null;
  branch_limits: (number | null)[];
  motion_ratios: { link: string; contact_per_wheel: number | null; one_travel: boolean }[];
  diagnostics: Finding[];
}
export interface Posed { report: MassReport; frames: number[]; velocities: (Triple | null)[] }
export interface Refusal { message: string; key: string | null; no_result: boolean; diagnostics: Finding[] }
export type Outcome<T> = { ok: T } | { refused: Refusal };
export interface CurveRow {
  at: number; status: string; mass: number | null; error: number | null; gap: number | null; singular: boolean; why: string | null;
}
export interface Curve { name: string; unit: string; rows: CurveRow[]; diagnostics: Finding[] }
export interface Shown {
  scene: Scene | null; result: Outcome<Posed>; frames: number[] | null; curve: Outcome<Curve> | null;
}
export interface ListedContact { name: string; kind: string; report: MassReport | null; problem: string | null }
export interface Opened {
  scene: Scene; shapes: { links: (string | null)[]; diagnostics: Finding[] } | null; contact: ContactTable; conditions: ConditionsTable;
  contacts: { contacts: ListedContact[] } | null; poses: string[]; diagnostics: Finding[];
}
export interface Explanation {
  links: { link: string; mass: number; per_kilogram: number }[];
  points: { point: string; per_metre: Triple | null }[];
}

export interface Simulator {
  title: string; law: string; cannot: string[]; caution: string; error: string | null; snippet: string | null;
  snippets: { text: string }[]; time_step: number | null; error_bound: number | null; assumptions: string[]; missing: string[];
}
export interface DampingReport {
  /** Mass, kg; inertia of the stop of a joint that turns, kg·m². */
  effective_mass: number; stop: { joint: string; motion: 'turn' | 'slide' } | null;
  damping_ratio: number | null; damping: number | null; dissipation: number | null; achieved_restitution: number;
  contact_duration: number | null; max_penetration: number | null; peak_force: number | null; energy_lost: number | null;
  rebound_speed: number | null; exports: Record<string, Simulator>; diagnostics: Finding[];
}
export interface Reaction {
  place: string; name: string; from: string | null; on: string | null; point_world: Triple; axes_world: [Triple, Triple, Triple];
  force: [number | null, number | null, number | null]; open_by: string[];
}
export interface ImpactReport {
  impulse: number; closing_speed: number; energy_loss: number; sticking_mass: number | null; reactions: Reaction[];
  reaction_residual: number; diagnostics: Finding[];
}
export interface SafeSpeed { robot_mass: number | null; reduced_mass: number | null; speed: number }
export interface SafeSpeedReport {
  region: string | null; region_mass: number | null; standard: SafeSpeed; reflected: SafeSpeed; diagnostics: Finding[];
}
export interface KinematicsReport {
  columns: { quantity: string; side: string; unit: string; missing: string | null }[];
  rows: ({ variable: number | null; problem: string | null } & Record<string, number | string | null>)[];
}
export interface GivenContact { status: string | null; effective_mass: number | null }
export interface DirectionMass { direction_world: Triple; status: string; effective_mass: number | null }
export interface Directions { principal: DirectionMass[]; point_world: Triple }

// Tables of a study.
export interface ModelTable {
  path: string; move?: Record<string, Triple>; link_mass?: Record<string, number>; link_inertia?: Record<string, Triple>; [key: string]: unknown;
}
export interface ContactTable {
  at?: string; link?: string; point?: Triple; normal?: Triple; along_line?: { link: string; point: Triple };
  turning_normal?: boolean; cable?: boolean; frame?: string; normal_frame?: string; against?: string; against_mass?: number;
  [key: string]: unknown;
}
export interface PoseTable { set?: Record<string, string>; guess?: Record<string, string>; travel?: string[]; file?: string }
export interface ConditionsTable { base?: string; lock?: string[]; armature?: Record<string, number[]> }
export interface Study {
  model: ModelTable; contact: ContactTable; pose: PoseTable; conditions: ConditionsTable; hold?: Record<string, unknown>[];
}

export type Request =
  | { do: 'open'; model: ModelTable; text: string; files?: Record<string, string>; shapes?: boolean }
  | { do: 'show'; question: Study; vary?: string }
  | { do: 'explain'; question: Study }
  | { do: 'damp'; question: Study; damping: Record<string, unknown> }
  | { do: 'impact'; question: Study; impact: Record<string, unknown> }
  | { do: 'safe-speed'; question: Study; safe_speed: Record<string, unknown> }
  | { do: 'kinematics'; model: ModelTable; state: Record<string, number>; range?: [string, number[]] }
  | { do: 'map'; question: Study; link: string; contacts: number[][] }
  | { do: 'directions'; question: Study }
  | { do: 'sheet'; model: ModelTable };
