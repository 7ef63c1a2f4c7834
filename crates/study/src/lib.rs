//! A question about a model, and its answer: what the command line, and later the other faces, share.
//!
//! [`Model::load`] reads a file; [`mass()`] answers one contact with a [`MassReport`]; [`sweep()`] answers it over a range,
//! row by row; [`map()`] over the surfaces of links; [`check()`] says what is in a model with a [`CheckReport`]. Reports serialise to the JSON that scripts rely
//! on. Nothing here writes to a terminal.

mod answer;
mod assumptions;
mod check;
mod closure_text;
mod csv_records;
mod damped_contact;
mod damping;
mod damping_question;
mod drawn;
mod driver;
mod error;
mod estimate;
mod far_point;
mod field;
mod finding;
mod findings;
mod following;
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
mod parquet_bounds;
mod parquet_source;
mod parquet_table;
mod point_map;
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
mod simulators;
mod stages;
mod study_file;
mod study_text;
mod study_value;
mod sweep;
mod sweep_report;
mod swept;
mod table_columns;
mod table_error;
mod thresholds;
mod trajectory;
mod travel;
mod varied_values;
mod vary;

/// Contact laws, simulators and safe speeds, for the faces that name them.
pub use percuss_contact as contact;

pub use assumptions::Assumptions;
pub use check::{CheckReport, ClosureRecord, JointRecord, LinkRecord, check};
pub use damped_contact::{damp_contact, damp_stop};
pub use damping::{BodyAlone, DamperRecord, DampingReport, Drift, damp, damper, impact_history};
pub use damping_question::DampingQuestion;
pub use drawn::DrawnLink;
pub use error::{Fault, StudyError};
pub use estimate::EstimateRecord;
pub use field::{Field, Names};
pub use joint_stop::{JointStop, StopEnd, StopRecord};
pub use map::map;
pub use map_question::{MapLinks, MapQuestion, MapShapes};
pub use map_report::{
    Extreme, FacetRecord, LeftOut, LinkMap, MapAnswer, MapReport, OrientationRecord, SkinFacets,
};
pub use mass::{mass, mass_drawn, mass_with_damper};
pub use mass_report::{
    BodyShare, ConditionsRecord, ContactRecord, HoldRecord, MassReport, RotorShare, Status,
};
pub use measure::{Measure, Measured};
pub use model::{Input, Model};
pub use point_map::{DirectionMass, PointMapReport, map_point};
pub use position::GivenPosition;
pub use positions::{PoseLayout, Positions};
pub use quantity::{Dimension, Quantity, QuantityError, parse_list, parse_triple};
pub use question::{EstimateQuestion, Hold, MassQuestion, Normal};
pub use record::DiagnosticRecord;
pub use row_source::{PositionFile, RowSource};
pub use safe_speed::{Limit, SafeSpeedQuestion, SafeSpeedReport, SpeedRecord, safe_speed};
pub use simulators::ExportRecord;
pub use study_file::{StudyFile, StudyFileError};
pub use sweep::{Sweep, sweep, sweep_report};
pub use sweep_report::{Continuation, SweepEnd, SweepHeading, SweepReport, SweepRow};
pub use table_error::{TableError, TableFault};
pub use varied_values::{VariedColumn, VariedValues};
pub use vary::{Varied, Vary, VaryError};
