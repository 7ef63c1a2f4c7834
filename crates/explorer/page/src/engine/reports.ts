// Reports. Written from their JSON schema: CONTRIBUTING.md. SI units; docs/reference/REPORT_KEYS.md.

export type Triple = [number, number, number];

export interface AlongRecord {
  rows: number; unanswered: number; first_unanswered: number | null; row: number; slowest: SpeedRecord; pose: Record<string, number[]>;
}

export interface AntiRollBarRecord {
  hinges: string[]; stiffness: number;
}

export interface BaseRateRecord {
  angular_before: Triple; linear_before: Triple; angular_after: Triple;
  linear_after: Triple;
}

export interface BearingForceRecord {
  place: 'ground' | 'joint' | 'closure' | 'hold'; name: string; force: number[]; peak_force: number; peak_time: number; estimate: number;
  open_components: [boolean, boolean, boolean];
}

export interface BodyAlone {
  mass: number; restitution: number | null;
}

export interface BodyShare {
  link: string; mass: number; share: number | null;
}

export interface BracketRecord {
  lower: number | null; upper: number | null; is_proved: boolean; boxes: number; positions: number[]; divisions: number[];
}

export interface BushShareRecord {
  bush: string; direction: string; share: number;
}

export interface ComplianceRecord {
  elastic: string; free_mass: number | null; free_status: 'finite' | 'immovable' | 'massless'; residual_compliance: number | null;
  residual_stiffness: number | null; rows: BushShareRecord[]; lower_bounds_hold: boolean; beside: string[];
  rigid_up_to: [number, number] | null; contact: CompliantContactRecord | null;
}

export interface CompliantContactRecord {
  stiffness: number; frequency: number | null; duration: number | null; impulse_change: number | null; force_change: number | null;
  peak_force_per_speed: [number | null, number | null]; peak_force: [number | null, number | null] | null; least_duration: number | null;
  impact: UndampedImpactRecord | null;
}

export interface CompliantEnergyRecord {
  kinetic_before: number; kinetic_after: number; stored: number; dissipated: number; taken_by_contact: number; work_of_other_forces: number;
  residual: number;
}

export interface CompliantImpactRecord {
  restitution: number; end: 'separates' | 'grazes' | 'no-rebound'; duration: number | null; max_penetration: number; peak_force: number;
  impulse: number; impulse_mass: number; loss_frequency: number; with_geometric_stiffness: DirectionChangeRecord | null;
  second_hit: SecondHitRecord | null; energy: CompliantEnergyRecord; elements: ElementForceRecord[]; times: number[]; penetration: number[];
  closing_speed: number[]; force: number[];
}

export interface ConditionsRecord {
  base: string; base_pose: [number, number, number, number, number, number, number] | null; lock: string[]; hold: HoldRecord[];
  armature: Record<string, number[]>; against_mass: number | null; guess: Record<string, string>; travel: TravelRecord[];
}

export interface ContactListReport {
  schema: 'percuss.contacts/1'; percuss: string; inputs: Input[]; contacts: ListedContact[]; diagnostics: DiagnosticRecord[];
}

export interface ContactRecord {
  link: string; against: string | null; point_world: Triple; normal_world: Triple;
  point_link: Triple; normal_link: Triple; is_moment: boolean;
}

export interface DampingReport {
  schema: 'percuss.damp/1'; percuss: string; inputs: Input[]; effective_mass: number; unit: string; is_moment: boolean;
  named_contact: NamedContactRecord | null; stop: StopRecord | null; restitution: number; stiffness: number | null; exponent: number | null;
  stiffness_curve: ForceCurveRecord | null; speed: number | null; law: string; law_alias: string | null; law_is_exact: boolean;
  separation: string | null; damping_ratio: number | null; damping: number | null; dissipation: number | null; loss_factor: number | null;
  achieved_restitution: number; contact_duration: number | null; max_penetration: number | null; time_of_max_penetration: number | null;
  peak_force: number | null; time_of_peak_force: number | null; energy_lost: number | null; rebound_speed: number | null;
  drift: Drift | null; over_stroke: VaryingMassImpact | null; body_alone: BodyAlone | null; exports: Record<string, ExportRecord>;
  diagnostics: DiagnosticRecord[];
}

export interface DiagnosticRecord {
  severity: 'error' | 'warning' | 'note'; code: string; path: string | null; line: number | null; column: number | null;
  element: string | null; message: string;
}

export interface DirectionChangeRecord {
  restitution: number; peak_force: number;
}

export interface DirectionMass {
  direction_link: Triple; direction_world: Triple; status: string; effective_mass: number | null;
  effective_mass_error: number | null;
}

export interface Drift {
  per_metre: number | null; over_penetration: number | null; ends_at: number | null;
}

export interface DriveRecord {
  name: string; value: number; unit: string; work: number;
}

export interface ElementForceRecord {
  element: string; direction: string | null; unit: string; peak_force: number; peak_time: number; peak_force_after: number | null;
  force: number[];
}

export interface EnergyRecord {
  kinetic_before: number; kinetic_after: number; taken_by_contact: number; work_of_other_forces: number; residual: number;
}

export interface ErrorBudgetRecord {
  rounding: number | null; closing: number | null; file: number | null;
}

export interface EstimateRecord {
  links: string[]; mass: number; point_link: Triple; direction: Triple | null;
  motion_ratio: number | null; estimate: number | null; error_percent: number | null; share_left_out: number | null;
}

export interface Explanation {
  effective_mass: number; links: LinkSensitivity[]; rotors: RotorSensitivity[]; points: PointSensitivity[]; most_per_kilogram: MassChange[];
  most_per_millimetre: PointChange[];
}

export interface ExportRecord {
  title: string; law: string; measured: Measurement[]; combines: string; caution: string;
  parameters: Record<string, number | number[] | string>; units: Record<string, string>; snippet: string | null; snippets: Snippet[];
  time_step: number | null; error_bound: number | null; single_precision_error: number | null; penetrations: Penetration[];
  missing: string[]; assumptions: string[]; cannot: string[]; sources: string[]; error: string | null;
}

export interface ExtremesCertificateRecord {
  tolerance: number; mass_tolerance: number; least: BracketRecord | null; most: BracketRecord | null; peak_force: number | null;
  pieces: number | null; omitted: OmittedRowRecord[]; reason: string | null; tree: TreeRecord | null;
}

export interface ForceCurveRecord {
  stop: string | null; deflections: number[]; forces: number[]; coefficients: number[]; exponents: number[];
}

export interface FrictionRecord {
  coefficient: number; law: string; slope: number | null; wedged: boolean; kinematic_restitution: number;
  tangential_impulse_world: Triple; sliding_before_world: Triple;
  sliding_after_world: Triple; phases: PhaseRecord[]; sticking_threshold: number | null; jamming_threshold: number | null;
  laws: LawRecord[];
}

export interface FrictionThresholdsRecord {
  slope: number | null; sticking: number | null; jamming: number | null;
}

export interface GivenContact {
  status: 'finite' | 'immovable' | 'massless' | null; effective_mass: number | null;
}

export interface GreatestSpeedRecord {
  speed: number; joint: string; limit: string;
}

export interface HoldRecord {
  link: string; point: Triple; normal: Triple | null;
}

export interface ImpactLawRecord {
  law: string; stiffness: number | null; exponent: number | null; stiffness_curve: ForceCurveRecord | null; duration: number | null;
  max_penetration: number | null; peak_force: number; mass_in_compression: number | null; direction_changes: boolean;
  mass_change_over_penetration: number | null; motion_force: MotionForceRecord | null;
}

export interface ImpactReport {
  schema: 'percuss.impact/1'; percuss: string; mass: MassReport; restitution: number; closing_speed: number; impulse: number;
  energy_loss: number; friction: FrictionRecord | null; simultaneous: SimultaneousRecord | null; sticking_mass: number | null;
  sticking_status: 'finite' | 'immovable' | 'massless' | null; mass_states: MassStateRecord[]; motion_before: string;
  rates: JointRateRecord[]; base: BaseRateRecord | null; other_body: OtherBodyRecord | null; reactions: ReactionRecord[];
  joint_constraints: JointConstraintRecord[]; reaction_residual: number; contact_law: ImpactLawRecord | null;
  in_time: ImpactTimeRecord | null; greatest_closing_speed: GreatestSpeedRecord | null; limits_without_effect: string[];
  reflected_inertia: ReflectedRecord[]; reflected_over: ReflectedRangeRecord[]; percussion: PercussionRecord[];
  diagnostics: DiagnosticRecord[];
}

export interface ImpactTimeRecord {
  restitution: number; duration: number | null; max_penetration: number; peak_force: number; mass_change: number | null;
  restitution_is_reached: boolean; damping: number | null; dissipation: number | null; loss_factor: number | null;
  one_freedom: VaryingMassImpact | null; gravity_world: Triple; springs: PointSpringRecord[];
  dampers: PointDamperRecord[]; tyres: TyreRecord[]; anti_roll_bars: AntiRollBarRecord[]; joint_springs: JointSpringRecord[];
  drives: DriveRecord[]; effective_weight: number | null; springs_left_out: string[]; with_whole_forces: DirectionChangeRecord | null;
  second_touch: SecondTouchRecord | null; energy: EnergyRecord; loop_gap: number; times: number[]; penetration: number[];
  closing_speed: number[]; force: number[]; effective_mass: (number | null)[]; joints: JointMotionRecord[]; bearings: BearingForceRecord[];
  compliant: CompliantImpactRecord | null;
}

export interface Input {
  path: string; sha256: string;
}

export interface JointConstraintRecord {
  kind: 'lock' | 'mimic' | 'coupling'; name: string; joints: string[]; impulses: (number | null)[]; open_by: string[];
}

export interface JointMotionRecord {
  joint: string; rates: number[][];
}

export interface JointRateRecord {
  joint: string; before: number[]; after: number[]; undetermined: boolean;
}

export interface JointSpringRecord {
  joint: string; stiffness: number; damping: number; force_at_touch: number;
}

export interface KinematicColumn {
  quantity: string; side: string; unit: string; missing: string | null;
}

export interface KinematicLoadCase {
  name: string; acts_at: string; direction: string; left: Triple; right: Triple;
}

export interface KinematicLoads {
  wheels: string; travel_held: boolean; cases: KinematicLoadCase[];
}

export interface KinematicsReport {
  schema: 'percuss.kinematics/1'; percuss: string; inputs: Input[]; derivatives: string; variable: string | null;
  loads: KinematicLoads | null; columns: KinematicColumn[]; rows: (Record<string, number | string | null>)[];
  compliance_matrices: (number[][] | null)[]; diagnostics: DiagnosticRecord[];
}

export interface LawRecord {
  law: string; normal_impulse: number | null; tangential_impulse: number | null; separation_speed: number | null;
  energy_loss: number | null; creates_energy: boolean;
}

export interface LinkSensitivity {
  link: string; mass: number; share: number; per_kilogram: number; per_metre_of_com: Triple | null;
}

export interface ListedContact {
  name: string; kind: string; report: MassReport | null; problem: string | null; remaining_gap: number | null;
}

export interface MassCertificateRecord {
  lower: number | null; upper: number | null; uniqueness: number | null; rows: number; implied: number; omitted: OmittedRowRecord[];
  reason: string | null;
}

export interface MassChange {
  link: string; lowers_by: number;
}

export interface MassReport {
  schema: 'percuss.mass/1'; percuss: string; inputs: Input[]; effective_mass: number | null; unit: string;
  status: 'finite' | 'immovable' | 'massless'; singular_pose: boolean; degrees_of_freedom: number; generic_degrees_of_freedom: number;
  redundant_constraints: number; rank_gap: number | null; route: string; condition: number | null; effective_mass_error: number | null;
  error_budget: ErrorBudgetRecord; bodies: BodyShare[]; rotors: RotorShare[]; other_mass_share: number | null;
  pose: Record<string, number[]>; closure_residual: number | null; closure_inexactness: number | null; characteristic_length: number;
  contact: ContactRecord; named_contact: NamedContactRecord | null; joint_stop: StopRecord | null; conditions: ConditionsRecord;
  other_base: OtherBaseRecord | null; drivers: string[]; assembly_modes: number[]; redundant_loops: string[][];
  branch_limits: (number | null)[]; compliance: ComplianceRecord | null; estimate: EstimateRecord | null;
  motion_ratios: MotionRatioRecord[]; friction_thresholds: FrictionThresholdsRecord | null; explanation: Explanation | null;
  certificate: MassCertificateRecord | null; tolerance: ToleranceReport | null; damper: DampingReport | null;
  diagnostics: DiagnosticRecord[];
}

export interface MassStateRecord {
  state: string; sliding: number | null; sliding_status: 'finite' | 'immovable' | 'massless'; sticking: number | null;
  sticking_status: 'finite' | 'immovable' | 'massless';
}

export interface Measurement {
  engine: string; solver: string; scenes: string; worst: [number | null, number | null, number | null]; by_hand: string | null;
}

export interface MimicJointRecord {
  joint: string; multiplier: number; offset: number; position_error: number;
}

export interface MimicSubstituteRecord {
  joints: MimicJointRecord[]; inertias: number[]; armature: number; largest_error: number;
}

export interface MotionForceRecord {
  place: 'ground' | 'joint' | 'closure' | 'hold'; name: string; force: number; ratio: number;
}

export interface MotionRatioRecord {
  link: string; point: Triple; direction: Triple; contact_per_wheel: number | null; one_travel: boolean;
  held: string | null;
}

export interface NamedContactRecord {
  name: string; kind: string; on: string; element: string | null; gap_as_drawn: number | null; gap: number | null;
  brought_to_touch: boolean; touching: string[]; effective_mass_together: number | null; wheel_travel: WheelTravelRecord[];
}

export interface OmittedRowRecord {
  constraint: string; residual: number;
}

export interface OtherBaseRecord {
  base: string; link: string; effective_mass: number | null; effective_mass_error: number | null;
  status: 'finite' | 'immovable' | 'massless';
}

export interface OtherBodyRecord {
  mass: number; speed_change: number;
}

export interface Penetration {
  solver: string; value: number; unit: string;
}

export interface PercussionRecord {
  joint: string; direction: Triple | null; point_link: Triple; point_world: Triple;
  distance: number; given_ratio: number; remaining_ratio: number; open_components: [boolean, boolean, boolean]; open_by: string[];
  worst_ratio: number | null; worst_point_link: Triple | null;
}

export interface PhaseRecord {
  kind: string; stage: string; normal_impulse: number;
}

export interface PointChange {
  point: string; direction: Triple; lowers_by: number;
}

export interface PointDamperRecord {
  name: string; speeds: number[]; forces: number[];
}

export interface PointMapReport {
  schema: 'percuss.map-point/1'; percuss: string; inputs: Input[]; link: string; point_link: Triple;
  point_world: Triple; principal: DirectionMass[]; directions: DirectionMass[]; against: string | null;
  conditions: ConditionsRecord; singular_pose: boolean; pose: Record<string, number[]>; diagnostics: DiagnosticRecord[];
}

export interface PointSensitivity {
  point: string; per_metre: Triple | null; per_metre_error: number | null;
}

export interface PointSpringRecord {
  name: string; rate: number; force_at_touch: number; force_at_end: number;
}

export interface PosedMass {
  report: MassReport; frames: number[]; velocities: (Triple | null)[];
}

export interface ProvedPatchRecord {
  link: string; patches: number; point: Triple; normal: Triple; edges: (Triple)[];
  is_curved: boolean;
}

export interface ProvedSpeedRecord {
  speed: SpeedRecord | null; is_sharp: boolean; surface: ProvedPatchRecord | null; segments: number | null; slowest_segment: number | null;
  share_above_standard: number | null; certificate: ExtremesCertificateRecord;
}

export interface RatesAfterRecord {
  joint: string; after: number[];
}

export interface ReachableSpeedRecord {
  speed: number; limited_by: string[];
}

export interface ReactionRecord {
  place: 'ground' | 'joint' | 'closure' | 'hold'; name: string; from: string | null; on: string | null;
  point_world: Triple; axes_world: [Triple, Triple, Triple];
  force: [number | null, number | null, number | null]; moment: [number | null, number | null, number | null]; open_by: string[];
  gear: number[]; constraint: (number | null)[]; peak_force: [number | null, number | null, number | null] | null;
  peak_moment: [number | null, number | null, number | null] | null;
}

export interface ReflectedRangeRecord {
  joint: string; unit: string; positions: number[]; free: (number | null)[]; held: (number | null)[]; least: number | null;
  most: number | null; best_constant: number | null; largest_error: number | null; substitute: MimicSubstituteRecord | null;
  substitute_refused_by: string | null;
}

export interface ReflectedRecord {
  joint: string; component: number; direction: string | null; unit: string; free: number | null;
  free_status: 'finite' | 'immovable' | 'massless'; held: number | null; held_status: 'finite' | 'immovable' | 'massless' | null;
  other_drivers: string[];
}

export interface RotorSensitivity {
  joint: string; per_armature: number[];
}

export interface RotorShare {
  joint: string; share: number | null;
}

export interface SafeSpeedReport {
  schema: 'percuss.safe-speed/2'; percuss: string; inputs: Input[]; region: string | null; region_mass: number | null;
  region_stiffness: number | null; region_note: string | null; limited_by: string; force: number | null; energy: number;
  standard: SpeedRecord; reflected: SpeedRecord; reachable: ReachableSpeedRecord | null; normal_world: Triple;
  moving_mass: number; load: number; proved: ProvedSpeedRecord | null; along: AlongRecord | null; diagnostics: DiagnosticRecord[];
}

export interface SampleRecord {
  count: number; unanswered: number; seed: number; mean: number; standard_deviation: number; least: number; greatest: number;
  percentile_2_5: number; percentile_97_5: number;
}

export interface Scene {
  schema: 'percuss.scene/1'; percuss: string; name: string; root: number; links: SceneLink[]; joints: SceneJoint[];
  closures: SceneClosure[]; contacts: SceneContact[]; wheels: SceneWheel[]; motions: string[]; sheet: SceneSheet | null; design: number[];
}

export interface SceneClosure {
  name: string; kind: string; ends: [[number | null, Triple], [number | null, Triple]];
}

export interface SceneContact {
  name: string; kind: 'stop' | 'spring' | 'damper' | 'patch' | 'other'; link: number; point: Triple;
  against: number | null; normal: string; vector: Triple; gap: number | null;
}

export interface SceneHardpoint {
  name: string; coordinates: Triple; to_world: Triple; link: number; point: Triple;
}

export interface SceneJoint {
  name: string; kind: string; parent: number; child: number; axis: Triple | null; limits: [number, number] | null;
  can_be_set: boolean;
}

export interface SceneLink {
  name: string; mass: number; com: Triple | null; moments: Triple | null;
  lines: ([Triple, Triple])[];
}

export interface SceneShapes {
  links: (string | null)[]; diagnostics: DiagnosticRecord[];
}

export interface SceneSheet {
  unit: string; unit_length: number; axes: string; hardpoints: SceneHardpoint[];
}

export interface SceneWheel {
  link: number; centre: Triple; axis: Triple; radius: number;
}

export interface SecondHitRecord {
  time: number; speed: number;
}

export interface SecondTouchRecord {
  time: number; speed: number;
}

export interface SimultaneousLawRecord {
  law: string; impulses: (number | null)[]; opening_speeds: number[]; energy_loss: number | null; creates_energy: boolean;
  rates: RatesAfterRecord[]; refusal: string | null;
}

export interface SimultaneousRecord {
  contacts: TouchingRecord[]; delassus: number[][];
  delassus_axes_world: ([Triple, Triple, Triple])[]; stiffness_ratios: number[];
  contact_exponent: number; laws: SimultaneousLawRecord[]; spread: number | null; sticking: StickingRecord | null;
}

export interface Snippet {
  title: string; language: string; text: string;
}

export interface SpeedRecord {
  robot_mass: number | null; reduced_mass: number | null; speed: number;
}

export interface StickingRecord {
  sticks: boolean[]; normal_impulses: (number | null)[]; tangential_impulses: (number | null)[]; required_friction: (number | null)[];
  least_friction: number | null; friction_suffices: boolean | null; opening_speeds: number[]; energy_loss: number;
  consistent_subsets: number; coordinates: string[]; impact_map: number[][]; rates: RatesAfterRecord[];
}

export interface StopRecord {
  joint: string; motion: 'turn' | 'slide';
}

export interface Tolerance {
  mass: number; com: number; armature: number; point: number;
}

export interface ToleranceParts {
  mass: number; com: number; armature: number; point: number;
}

export interface ToleranceReport {
  effective_mass: number; tolerance: Tolerance; root_sum_square: number; worst_case: number; parts: ToleranceParts;
  samples: SampleRecord | null;
}

export interface TouchingRecord {
  name: string; is_joint_stop: boolean; is_moment: boolean; link: string; point_world: Triple;
  normal_world: Triple; gap: number | null; closing_speed: number; effective_mass: number | null;
  principal_masses: [number | null, number | null, number | null];
  principal_directions_world: [Triple, Triple, Triple];
}

export interface TravelRecord {
  motion: string; link: string | null; point: Triple | null; direction: Triple | null; distance: number;
}

export interface TreeRecord {
  bodies: number[][]; contact: number[]; positions: ([number, number])[]; ranges: (Triple)[];
}

export interface TyreRecord {
  name: string; rate: number; damping: number; force_at_touch: number; leaves_road_at: number | null;
}

export interface UndampedImpactRecord {
  stiffness: number; impulse_mass: number; force_mass: number; restitution: number; duration: number | null;
  most_impulse_mass: number | null;
}

export interface VaryingMassImpact {
  restitution: number; max_penetration: number; mass_at_max_penetration: number; peak_force: number;
}

export interface WheelTravelRecord {
  link: string; travel: number;
}
