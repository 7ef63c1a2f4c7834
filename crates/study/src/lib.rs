#![doc = include_str!("../README.md")]
//!
//! [`Model::load`] reads a file. [`mass()`] computes one contact and returns a [`MassReport`]; [`sweep()`] computes a contact
//! over a range, row by row; [`map()`] over the surfaces of links; [`check()`] describes a model in a [`CheckReport`]. This crate does not
//! write to a terminal.

mod checks;
mod damper;
mod evaluation;

mod map;
mod model;
mod pose;
mod question;
mod reports;
mod study_file;
mod sweep;
mod tables;
mod thresholds;
mod values;

/// Contact laws, simulators and safe speeds, for the interfaces that use them.
pub use percuss_contact as contact;

pub use checks::design_variant::DesignError;
pub use checks::model_check::{
    CheckReport, ClosureRecord, JointRecord, LinkRecord, RelationTermRecord, check,
};
pub use checks::response_findings::{matrix_findings, pose_findings, response_findings, row_findings};
pub use damper::compliance::{
    BushShareRecord, ComplianceRecord, CompliantContactRecord, UndampedImpactRecord,
};
pub use damper::damped_contact::{damp_contact, damp_stop};
pub use damper::damping::{BodyAlone, DamperRecord, DampingReport, Drift, damp, damper, impact_history};
pub use damper::response::{ComplexSeries, ModeRecord, ModeShareRecord, ResponseReport, response};
pub use damper::restitution::{ReboundRecord, RestRecord, RestitutionReport, restitution, restitution_at};
pub use damper::simulators::ExportRecord;
pub use evaluation::certificate::{
    BracketRecord, ExtremesCertificateRecord, MassCertificateRecord, OmittedRowRecord, TreeRecord,
};
pub use evaluation::estimate::EstimateRecord;
pub use evaluation::friction_thresholds::FrictionThresholdsRecord;
pub use evaluation::motion_ratio::MotionRatioRecord;
pub use evaluation::named_contact::{NamedContactRecord, WheelTravelRecord};
pub use evaluation::status::Status;
pub use map::given_contacts::{GivenContact, given_contact_masses};
pub use map::map_report::{
    Extreme, FacetRecord, LinkMap, MapAnswer, MapReport, OmittedLink, OrientationRecord, SkinFacets,
};
pub use map::point_map::{DirectionMass, PointMapReport, map_point};
pub use map::surface_map::map;
pub use model::changes::Changes;
pub use model::loading::{Input, Model, Origin, SheetPoint};
pub use model::record::DiagnosticRecord;
pub use model::sheet::Sheet;
pub use percuss_units::{Dimension, Quantity, QuantityError, Unit, parse_list, parse_triple};
pub use pose::positions::{JointDisplacement, PoseLayout, Positions};
pub use question::errors::question_error::{Fault, StudyError};
pub use question::errors::refusal::InvalidKey;
pub use question::errors::table_error::{TableError, TableFault};
pub use question::link_points::{EstimateQuestion, Hold, RatioPoint, UPWARDS};
pub use question::mass_question::MassQuestion;
pub use question::names::Names;
pub use question::pose_file::{GivenPose, GivenPoseError};
pub use question::row_source::{PositionFile, RowSource};
pub use question::spelled_contact::{FurtherContact, JointStop, StopEnd, StopRecord, contact_of_text};
pub use question::tables::contact::{BaseName, ConditionsTable, ContactTable, FrameName, PoseTable};
pub use question::tables::damping::restitution::{RestitutionQuestion, ToolParameter};
pub use question::tables::damping::{DampingQuestion, LawName, SeparationName, Tools};
pub use question::tables::exports::{CodeQuestion, LanguageName};
pub use question::tables::exports::{ConversionQuestion, ExportQuestion, ModelFormat};
pub use question::tables::extremes::{
    ExtremesQuestion, GivenNormals, GivenPath, GivenQuantity, GivenRange, Keep,
};
#[cfg(feature = "flags")]
pub use question::tables::headings;
pub use question::tables::identify::{DamperFormName, IdentifyQuestion};
pub use question::tables::impact::{ImpactQuestion, PercussionRequest, RestitutionLawName, SheetSprings};
pub use question::tables::kinematics::{
    AxlePosition, KinematicVariable, KinematicsQuestion, TargetsQuestion, VehicleData, WheelLoads,
};
pub use question::tables::map::{MapQuestion, MapShapes};
pub use question::tables::mass::{GivenTolerance, MassOptions, Sampling, Tolerance, ToleranceError};
pub use question::tables::model::{Acceptable, CheckQuestion, ModelTable};
pub use question::tables::response::{FrequencyRange, ResponseQuestion};
pub use question::tables::safe_speed::{Limit, LimitError, SafeSpeedQuestion};
pub use question::tables::sweep::{
    AxisLimits, DecimalSign, StudyFigure, StudyTable, SweepQuestion, TableUnit,
};
pub use question::travel::given_travel::{GivenTravel, GivenTravelError};
pub use question::travel::moved::{LongTravelError, Moved, WheelMotion};
pub use question::travel::varied_values::{PathPlace, VariedColumn, VariedValues};
pub use question::travel::vary::{Varied, Vary, VaryError};
pub use reports::answer_mass::{mass, mass_with_drawing, requested_mass};
pub use reports::assumptions::Assumptions;
pub use reports::compare::design_changes::{ChangeKind, DesignChange};
pub use reports::compare::{CompareError, ComparisonReport, ComparisonRow, Design, DesignRecord, compare};
pub use reports::contact_list::{ContactListReport, ListedContact, contact_list, contact_list_of};
pub use reports::drawing::drawn_mechanism::{
    DrawnElement, DrawnLink, DrawnMechanism, DrawnPoint, draw_mechanism,
};
pub use reports::drawing::scene::{
    Frames, PosedMass, Scene, SceneClosure, SceneContact, SceneHardpoint, SceneJoint, SceneLink, SceneShapes,
    SceneSheet, SceneWheel, link_frames, mass_with_frames, scene, scene_shapes,
};
pub use reports::explain::{
    Explanation, LinkSensitivity, MassChange, PointChange, PointSensitivity, RotorSensitivity, explain,
};
pub use reports::exports::change_record::ChangeRecord;
pub use reports::exports::code::{CodeError, CodeReport, TextFile, generate_code};
pub use reports::exports::conversion::{ConversionError, ConversionReport, convert};
pub use reports::exports::impact::{ImpactExportError, export};
pub use reports::exports::impact_report::ExportReport;
pub use reports::impact::additions::{GreatestSpeedRecord, PercussionRecord};
pub use reports::impact::extremes::{
    ExtremePosition, ExtremeRecord, ExtremesReport, KeptRecord, PathRecord, extremes,
};
pub use reports::impact::friction::{FrictionRecord, LawRecord, PhaseRecord};
pub use reports::impact::identification::{
    ComparedMass, IdentificationReport, MassExplanation, MeasuredImpact, identify_contact,
    identify_contact_of,
};
pub use reports::impact::in_time::compliant::{
    CompliantEnergyRecord, CompliantImpactRecord, ContactEndName, ElementForceRecord, SecondHitRecord,
};
pub use reports::impact::in_time::forces::{
    AntiRollBarRecord, DirectionChangeRecord, DriveRecord, JointSpringRecord, PointDamperRecord,
    PointSpringRecord, TyreRecord,
};
pub use reports::impact::in_time::{
    BearingForceRecord, EnergyRecord, ImpactTimeRecord, JointMotionRecord, SecondTouchRecord,
};
pub use reports::impact::masses::MassStateRecord;
pub use reports::impact::reactions::{
    JointConstraintKind, JointConstraintRecord, ReactionPlace, ReactionRecord,
};
pub use reports::impact::reflected::{
    MimicJointRecord, MimicSubstituteRecord, ReflectedRangeRecord, ReflectedRecord, ReflectedReport,
    reflected_inertias,
};
pub use reports::impact::report::{
    BaseRateRecord, ImpactLawRecord, ImpactReport, JointRateRecord, OtherBodyRecord, impact,
};
pub use reports::impact::simultaneous::{
    RatesAfterRecord, SimultaneousLawRecord, SimultaneousRecord, StickingRecord, TouchingRecord,
};
pub use reports::kinematics::changed_sheet::changed_sheet;
pub use reports::kinematics::errors::KinematicsError;
pub use reports::kinematics::load_cases::{KinematicLoadCase, KinematicLoads};
pub use reports::kinematics::report::{KinematicColumn, KinematicsReport, KinematicsRow, kinematics};
pub use reports::kinematics::target_question::{KinematicTarget, SearchUnknown, TargetSearch};
pub use reports::kinematics::target_search::{FoundCoordinate, ReachedTarget, TargetReport, search_targets};
pub use reports::mass_report::{
    BodyShare, ConditionsRecord, ContactRecord, HoldRecord, MassReport, OtherBaseRecord, RotorShare,
    TravelRecord,
};
pub use reports::pose_at_stop::{pose_at_stop, pose_at_stop_with_findings};
pub use reports::safe_speed::proved::{ProvedPatchRecord, ProvedSpeedRecord};
pub use reports::safe_speed::report::{AlongRecord, ReachableSpeedRecord, SafeSpeedReport, safe_speeds};
pub use reports::safe_speed::speed::SpeedRecord;
pub use reports::tolerance::{
    SampleRecord, ToleranceEffect, ToleranceParts, ToleranceReport, tolerance_report,
};
pub use study_file::additions::{StudyAdditions, WithAdditions};
pub use study_file::answer::{AskError, MapResult, RequestReport, report_schema, requested_map};
pub use study_file::contacts::{StudyContact, contact_names};
pub use study_file::file::{StudyFile, StudyFileError};
pub use study_file::keys::{StudyKeys, UnknownKey};
pub use study_file::report::StudyReport;
pub use study_file::request::ask;
pub use study_file::schema::{study_key_page, study_keys, study_schema};
pub use study_file::starter::{starting_contact, starting_study};
pub use study_file::tables_of_page::{PageTables, PanelTables, VariantTables};
pub use study_file::text::StudyTables;
pub use study_file::variant::Variant;
pub use sweep::row_gradient::{GradientLayout, RowGradient};
pub use sweep::sweep_report::{Continuation, SweepEnd, SweepHeading, SweepReport, SweepRow};
pub use sweep::sweep_rows::{Sweep, sweep, sweep_report};
pub use values::drives::{GivenGearLimits, GivenSpring};
pub use values::force_curve::{ForceCurveRecord, GivenCurve};
#[cfg(feature = "flags")]
pub use values::named::point_shift;
pub use values::point_force::{GivenDrive, GivenPointDamper, GivenPointSpring};
pub use values::position::GivenPosition;
#[cfg(feature = "flags")]
pub use values::quantities::is_number_flag;
pub use values::quantities::{
    Area, Energy, Force, Length, LinkPoint, Mass, Moments, Momentum, Plain, Point, PositiveMass, Pressure,
    Ratio, Speed, Stiffness, Time, Vector,
};
pub use values::rates::GivenRates;
