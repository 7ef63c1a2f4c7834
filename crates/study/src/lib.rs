//! Queries about a model and their results, shared by the command line and the other interfaces.
//!
//! [`Model::load`] reads a file. [`mass()`] computes one contact and returns a [`MassReport`]; [`sweep()`] computes a contact
//! over a range, row by row; [`map()`] over the surfaces of links; [`check()`] describes a model in a [`CheckReport`]. Reports
//! serialise to the JSON format for scripts. This crate does not write to a terminal.

mod answer;
mod answer_findings;
mod assumptions;
mod changes;
mod check;
mod closure_text;
mod compare;
mod csv_records;
mod curvature;
mod damped_contact;
mod damping;
mod damping_question;
mod design;
mod drawn;
mod driver;
mod error;
mod estimate;
mod explain;
mod far_point;
mod field;
mod finding;
mod findings;
mod following;
mod given_pose;
mod given_travel;
mod holds;
mod in_lanes;
mod joint_stop;
mod line;
mod map;
mod map_question;
mod map_report;
mod mass;
mod mass_report;
mod measure;
mod model;
mod motion_ratio;
mod parquet_bounds;
mod parquet_source;
mod parquet_table;
mod penetration;
mod point_map;
mod posing;
mod position;
mod positions;
mod quantity;
mod question;
mod random_rows;
mod reach;
mod record;
mod refusal;
mod row_source;
mod rows;
mod safe_speed;
mod setting;
mod sheet;
mod shown;
mod simulators;
mod stages;
mod starter;
mod study_damping;
mod study_file;
mod study_keys;
mod study_map;
mod study_mass;
mod study_safe_speed;
mod study_schema;
mod study_sweep;
mod study_text;
mod study_value;
mod sweep;
mod sweep_report;
mod swept;
mod table_columns;
mod table_error;
mod thresholds;
mod tolerance;
mod trajectory;
mod travel;
mod variant;
mod varied_values;
mod vary;

/// Contact laws, simulators and safe speeds, for the interfaces that use them.
pub use percuss_contact as contact;

pub use answer_findings::{pose_findings, response_findings, row_findings};
pub use assumptions::Assumptions;
pub use changes::Changes;
pub use check::{CheckReport, ClosureRecord, JointRecord, LinkRecord, check};
pub use compare::{CompareError, ComparisonReport, ComparisonRow, Design, DesignRecord, compare};
pub use damped_contact::{damp_contact, damp_stop};
pub use damping::{BodyAlone, DamperRecord, DampingReport, Drift, damp, damper, impact_history};
pub use damping_question::{DampingQuestion, check_units};
pub use design::DesignError;
pub use drawn::{DrawnLink, DrawnMechanism, drawn_at};
pub use error::{Fault, StudyError};
pub use estimate::EstimateRecord;
pub use explain::{
    Explanation, LinkSensitivity, MassChange, PointChange, PointSensitivity, RotorSensitivity, explain,
};
pub use field::{Field, Names};
pub use given_pose::{GivenPose, GivenPoseError};
pub use given_travel::{GivenTravel, GivenTravelError};
pub use joint_stop::{JointStop, StopEnd, StopRecord};
pub use map::map;
pub use map_question::{MapLinks, MapQuestion, MapShapes};
pub use map_report::{
    Extreme, FacetRecord, LeftOut, LinkMap, MapAnswer, MapReport, OrientationRecord, SkinFacets,
};
pub use mass::{mass, mass_drawn, mass_with_damper};
pub use mass_report::{
    BodyShare, ConditionsRecord, ContactRecord, HoldRecord, MassReport, RotorShare, Status, TravelRecord,
};
pub use measure::{Measure, Measured};
pub use model::{Input, Model, Origin};
pub use motion_ratio::MotionRatioRecord;
pub use point_map::{DirectionMass, PointMapReport, map_point};
pub use position::GivenPosition;
pub use positions::{PoseLayout, Positions};
pub use quantity::{Dimension, Quantity, QuantityError, parse_list, parse_triple};
pub use question::{EstimateQuestion, Hold, MassQuestion, Normal, RatioPoint, UPWARDS};
pub use record::DiagnosticRecord;
pub use row_source::{PositionFile, RowSource};
pub use safe_speed::{
    AlongRecord, Limit, LimitError, SafeSpeedQuestion, SafeSpeedReport, SpeedRecord, StatedLimits,
    safe_speed, safe_speed_along, safe_speed_directions,
};
pub use sheet::Sheet;
pub use simulators::ExportRecord;
pub use starter::starting_study;
pub use study_file::{StudyDamping, StudyFile, StudyFileError, StudySweep};
pub use study_keys::{StudyKeys, UnknownKey};
pub use study_map::{StudyMap, StudyMapQuestion};
pub use study_mass::StudyMass;
pub use study_safe_speed::StudySafeSpeed;
pub use study_schema::{study_keys, study_schema};
pub use study_sweep::{StudyFigure, StudyTable, TableUnit};
pub use sweep::{Sweep, sweep, sweep_report};
pub use sweep_report::{Continuation, SweepEnd, SweepHeading, SweepReport, SweepRow};
pub use table_error::{TableError, TableFault};
pub use tolerance::{
    SampleRecord, Sampling, Tolerance, ToleranceError, ToleranceParts, ToleranceReport, tolerate,
};
pub use variant::Variant;
pub use varied_values::{VariedColumn, VariedValues};
pub use vary::{Varied, Vary, VaryError};
