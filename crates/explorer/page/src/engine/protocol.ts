// Replies of the engine. Lengths in m, angles in rad, masses in kg; frames are 12 numbers a link: the rows of the rotation,
// then the position.

import type { ContactListReport, DiagnosticRecord, PosedMass, Scene, SceneShapes, Triple } from './reports';
export type * from './reports';

export interface Refusal { message: string; key: string | null; no_result: boolean; diagnostics: DiagnosticRecord[] }
export type Outcome<T> = { ok: T } | { refused: Refusal };
export interface CurveRow {
  at: number; status: string; mass: number | null; error: number | null; gap: number | null; singular: boolean; why: string | null;
}
export interface Curve { name: string; unit: string; rows: CurveRow[]; diagnostics: DiagnosticRecord[] }
export interface Shown {
  scene: Scene | null; result: Outcome<PosedMass>; frames: number[] | null;
}
export interface Opened {
  scene: Scene; shapes: SceneShapes | null; contact: ContactTable; conditions: ConditionsTable; contacts: ContactListReport | null;
  poses: string[]; diagnostics: DiagnosticRecord[];
}

/** Search for a coordinate or a mass: old and new value in the unit of the sheet or in kg; displacements, m, and masses, kg. */
export interface Found {
  is_reached: boolean; within: number; coordinates: { coordinate: string; unit: string; old: number; new: number }[];
  targets: { required: number; old: number; reached: number }[]; moves: [string, Triple][]; link_masses: [string, number][];
}

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
export interface ConditionsTable { base?: string; lock?: string[]; armature?: Record<string, number[]>; gear_stiffness?: Record<string, number | string | (number | string)[]> }
export interface Study {
  model: ModelTable; contact: ContactTable; pose: PoseTable; conditions: ConditionsTable; hold?: Record<string, unknown>[];
}

export type Request =
  | { do: 'open'; model: ModelTable; text: string; files?: Record<string, string>; shapes?: boolean }
  | { do: 'show'; question: Study }
  | { do: 'curve'; question: Study; vary: string }
  | { do: 'contacts'; question: Study }
  | { do: 'explain'; question: Study }
  | { do: 'solve'; question: Study; unknown: string; mass: number; within: number }
  | { do: 'damp'; question: Study; damping: Record<string, unknown> }
  | { do: 'impact'; question: Study; impact: Record<string, unknown> }
  | { do: 'safe-speed'; question: Study; safe_speed: Record<string, unknown> }
  | { do: 'kinematics'; model: ModelTable; state: Record<string, number>; range?: [string, number[]] }
  | { do: 'map'; question: Study; link: string; contacts: number[][] }
  | { do: 'directions'; question: Study }
  | { do: 'sheet'; model: ModelTable };
